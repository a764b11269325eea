import {prove, solve, type Problem, type Proof} from 'seamwise/node';
import {expect, it} from 'vitest';

import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const onGrain = (garment: Problem['garment']): Problem => ({
  garment,
  print: {group: 'pmm', w1: [9, 0], w2: [0, 13]},
  options: {grain: {default: 'on'}},
});

it('proves more and more, in the end that no placing misses by less than the one a solve finds', async () => {
  const problem = onGrain(sample('tee'));
  const {metrics} = await solve(problem);
  const told: Proof[] = [];
  const proof = await prove(problem, {onProof: (proof) => told.push(proof)});
  expect(proof).toEqual({bound: 1, searchCost: metrics.searchCost});
  const bounds = told.map(({bound}) => bound);
  expect(bounds).toEqual([...new Set(bounds)].sort((a, b) => a - b));
  expect(bounds.at(-1)).toBe(1);
});

it('lets solves go before, and ends when it is told to', async () => {
  const stop = new AbortController();
  const free: Problem = {...onGrain(sample('princess-dress')), symmetry: 'none', options: {}};
  const ended = prove(free, {signal: stop.signal}).catch((reason: unknown) => reason);
  const alone = await solve({garment: twoStrips(), print: checks});
  expect(alone.metrics.fit).toBeLessThan(1e-6);
  stop.abort('enough');
  expect(await ended).toBe('enough');
});

it('says what is wrong with a problem as a solve does', async () => {
  await expect(prove({garment: '{}', print: checks})).rejects.toMatchObject({code: 'notAGarment'});
});
