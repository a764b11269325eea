import * as fc from 'fast-check';
import {
  solve,
  SolverError,
  type GarmentCodeSpecification,
  type SolveOptions,
  type Symmetries,
} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {strays, symmetricPieces} from '../../support/results/check-garment.js';
import {violations} from '../../support/results/check-result.js';
import {cases, sampleOf} from '../../support/level.js';
import {damagedProblem, problem, type ProblemText} from '../../support/garments/random-problems.js';
import {checks, sample, twoStrips} from '../../support/garments/samples.js';

/** One sentence on one line, for any quoted input. */
const sentence = /^[^\s\p{Cc}][^\p{Cc}\u2028\u2029]*\.$/u;

/** Outcome of a solve: 'solved', or the failure's code. Throws for forbidden outcomes. */
async function ending(problem: ProblemText): Promise<string> {
  let result;
  try {
    result = await solve(problem, {signal: AbortSignal.timeout(60_000)});
  } catch (error) {
    if (!(error instanceof SolverError)) throw error;
    expect(error.code).not.toBe('internal');
    expect(error.message).toMatch(sentence);
    return error.code;
  }
  const options = JSON.parse(problem.options) as SolveOptions;
  expect(violations(result, options)).toEqual([]);
  expect(strays(result, JSON.parse(problem.garment) as GarmentCodeSpecification)).toEqual([]);
  if (!['auto', 'none'].includes(problem.symmetry) && problem.method !== 'ws19') {
    const {asked, found} = symmetricPieces(result, JSON.parse(problem.symmetry) as Symmetries);
    expect(found).toEqual(asked);
  }
  return 'solved';
}

/** Solves `count` problems, always the same ones. @returns the number of each outcome */
async function solveMany(problems: fc.Arbitrary<ProblemText>, seed: number, count: number) {
  const endings = new Map<string, number>();
  await fc.assert(
    fc.asyncProperty(problems, async (one) => {
      const end = await ending(one);
      endings.set(end, (endings.get(end) ?? 0) + 1);
    }),
    {seed, numRuns: count},
  );
  return (end: string) => endings.get(end) ?? 0;
}

describe('a solve ends in a sound result or in one clear sentence', () => {
  it('for garments, prints, symmetries and options of all kinds', async () => {
    const count = await solveMany(problem, 1, cases(25, 600));
    expect(count('solved')).toBeGreaterThan(cases(18, 500));
  }, 600_000);

  it('for files with something wrong in them', async () => {
    const count = await solveMany(damagedProblem, 2, cases(80, 1500));
    expect(count('solved')).toBeGreaterThan(cases(8, 200));
    expect(count('notJson')).toBeGreaterThan(cases(4, 100));
    expect(count('number')).toBeGreaterThan(cases(2, 50));
  }, 600_000);
});

/**
 * A panel that mirrors onto itself with a residual of 0.0976 cm: the maximum for a symmetry, on a
 * small piece.
 */
const almostSymmetric: GarmentCodeSpecification = {
  pattern: {
    panels: {
      sail: {
        vertices: [
          [-12.634, 5.2134],
          [-11.725, 3.1707],
          [-13.263, 1.1353],
        ],
        edges: [
          {endpoints: [0, 1]},
          {
            endpoints: [1, 2],
            curvature: {
              type: 'cubic',
              params: [
                [-12.1059, 2.089],
                [-12.5288, 1.7952],
              ],
            },
          },
          {endpoints: [2, 0]},
        ],
      },
    },
    stitches: [],
  },
  properties: {curvature_coords: 'absolute', units_in_meter: 100},
};

const explicit = {symmetries: [{kind: 'piece', piece: 'sail'}]} as const;

describe('a piece that is nearly symmetric', () => {
  it.each([
    ['lines would get kinks', {edgeLengthCm: 0.5}, /kinks .*edgeLengthCm/],
    ['it may not move enough', {maxChangeCm: 0.01}, /maxChangeCm to 0\.\d+/],
  ])('is left as it is, or refused when asked for, where %s', async (_, options, remedy) => {
    const problem = {garment: almostSymmetric, print: checks, options};
    const result = await solve(problem);
    expect(violations(result, options)).toEqual([]);
    expect(result.symmetries).toEqual([]);
    expect(result.notes.join()).toMatch(/piece 'sail' is dropped/);
    await expect(solve({...problem, symmetry: explicit})).rejects.toMatchObject({
      code: 'symmetryDoesNotMirror',
      message: expect.stringMatching(remedy) as string,
    });
  });

  it('is made exactly symmetric where that keeps its lines', async () => {
    const {left} = twoStrips().pattern.panels;
    if (!left) throw new Error('no strip');
    const vertices = left.vertices.map(([x, y]) => [x + 0.006 * y, y] as const);
    const garment = {pattern: {panels: {sail: {...left, vertices}}, stitches: []}};
    const result = await solve({garment, print: checks, symmetry: explicit});
    expect(violations(result)).toEqual([]);
    expect(result.symmetries).toHaveLength(1);
    expect(result.metrics.maxMovedCm).toBeGreaterThan(0.01);
  });
});

describe('a greatest change of nothing at all', () => {
  it.each(sampleOf(1, ['gathered-skirt', 'tee', 'princess-dress'] as const))(
    'leaves the %s as it was drafted',
    async (name) => {
      const options = {maxChangeCm: 0};
      const result = await solve({garment: sample(name), print: checks, options});
      expect(violations(result, options)).toEqual([]);
      expect(result.symmetries).not.toEqual([]);
      expect(result.metrics.fit).toBeLessThan(result.metrics.fitRandom);
    },
  );

  it('leaves seams as they are whose sides bend differently', async () => {
    const {left, right} = twoStrips(10).pattern.panels;
    if (!left || !right) throw new Error('no strips');
    const edges = left.edges.map((edge, k) =>
      k === 1 ? {...edge, curvature: [0.3, -0.2] as const} : edge,
    );
    const {pattern} = twoStrips(10);
    const garment = {pattern: {...pattern, panels: {left: {...left, edges}, right}}};
    const print = {...checks, group: 'p1' as const};
    const options = {maxChangeCm: 0};
    const result = await solve({garment, print, symmetry: 'none', options});
    expect(violations(result, options)).toEqual([]);
    expect(result.metrics.maxMovedCm).toBe(0);
  });
});

it('messages keep to one line whatever they quote', async () => {
  const names = [
    'front\nback',
    'front\r\u2028back',
    '\u0000\u007f\u0085',
    `${'front '.repeat(50)}\n`,
  ];
  for (const name of names) {
    const options = JSON.stringify({plain: [name]});
    const failure: unknown = await solve({garment: twoStrips(), print: checks, options}).catch(
      (error: unknown) => error,
    );
    expect(failure).toMatchObject({message: expect.stringMatching(sentence) as string});
  }
});
