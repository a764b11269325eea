import {execFileSync} from 'node:child_process';

import {expect, it} from 'vitest';

import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const fine = {garment: sample('patchwork-jacket'), print: checks, options: {edgeLengthCm: 0.1}};
const small = {garment: twoStrips(2), print: checks};

/** Solves both in a process of its own, whose memory no earlier solve has grown. */
const script = `
  import {solve} from 'seamwise/node';
  const [fine, small] = JSON.parse(process.argv[1]);
  WebAssembly.Memory.prototype.grow = () => { throw new RangeError('no memory to be had'); };
  const {name, code, message} = await solve(fine).then(() => ({}), (error) => error);
  const {metrics} = await solve(small);
  console.log(JSON.stringify({name, code, message, seed: metrics.seed}));
`;

it('memory that runs out fails a solve in one sentence, and the next one succeeds', () => {
  const problems = JSON.stringify([fine, small]);
  const out = execFileSync(process.execPath, ['--input-type=module', '-e', script, problems], {
    encoding: 'utf8',
  });
  expect(JSON.parse(out)).toEqual({
    name: 'SolverError',
    code: 'internal',
    message: 'There is not enough memory for this problem.',
    seed: 1,
  });
});
