/** The page's rules about groups, compared with the solver's. */
import {expect, it} from 'vitest';

import {solve, type Problem, type SolverError} from 'seamwise/node';

import {groupsThatCarry} from '@/model/print/repeat.js';

const square = {
  vertices: [
    [-5, 0],
    [5, 0],
    [5, 10],
    [-5, 10],
  ] as const,
  edges: ([0, 1, 2, 3] as const).map((k) => ({endpoints: [k, (k + 1) % 4] as const})),
};

const problem: Problem = {
  garment: {pattern: {panels: {left: square, right: square}, stitches: []}},
  print: {group: 'p1', w1: [10, 0], w2: [0, 10]},
};

it.each([
  ['piece', {kind: 'piece', piece: 'left'}],
  ['pair', {kind: 'pair', pieces: ['left', 'right']}],
] as const)('names the groups that carry a %s as the solver does', async (kind, symmetry) => {
  const {code, message} = await solve({...problem, symmetry: {symmetries: [symmetry]}}).then(
    () => ({code: 'none', message: ''}),
    (error: unknown) => error as SolverError,
  );
  expect(code).toBe('symmetryGroup');
  expect(message).toContain(groupsThatCarry(kind).join(', '));
});
