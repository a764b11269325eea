import {solve} from 'seamwise/node';
import {afterEach, expect, it, vi} from 'vitest';

import {checks, sample, twoStrips} from '../../support/garments/samples.js';

afterEach(() => {
  vi.restoreAllMocks();
});

it('memory that runs out fails a solve in one sentence, and the next one succeeds', async () => {
  vi.spyOn(WebAssembly.Memory.prototype, 'grow').mockImplementation(() => {
    throw new RangeError('no memory to be had');
  });
  const fine = {garment: sample('patchwork-jacket'), print: checks, options: {edgeLengthCm: 0.1}};
  await expect(solve(fine)).rejects.toMatchObject({
    name: 'SolverError',
    code: 'internal',
    message: 'There is not enough memory for this problem.',
  });
  expect((await solve({garment: twoStrips(2), print: checks})).metrics).toBeDefined();
});
