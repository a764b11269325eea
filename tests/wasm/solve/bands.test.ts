/**
 * Bands with the grain along them, as in files of other programs; their seams cannot match as
 * drafted.
 */
import {readFileSync} from 'node:fs';

import {remedies, solve, type SingleProblem, type SolveResult} from 'seamwise/node';
import {expect, it} from 'vitest';

import {withRemedy} from '@/remedies/remedy.js';

interface Drafted {
  readonly pattern: {
    readonly panels: Record<
      string,
      {vertices: readonly (readonly [number, number])[]; grain?: unknown}
    >;
  };
}

const file = (path: string): string =>
  readFileSync(new URL(`../../../public/${path}`, import.meta.url), 'utf8');

/** A sample on grain, with the grain of some of its pieces set lengthwise. */
function lengthwise(garment: string, bands: readonly string[], print = 'pmm'): SingleProblem {
  const drafted = JSON.parse(file(`garments/${garment}-m.json`)) as Drafted;
  for (const name of bands) {
    const panel = drafted.pattern.panels[name];
    if (!panel) throw new Error(`There is no ${name}.`);
    const [xs, ys] = [panel.vertices.map(([x]) => x), panel.vertices.map(([, y]) => y)];
    const y = (Math.min(...ys) + Math.max(...ys)) / 2;
    panel.grain = {
      line: [
        [Math.min(...xs), y],
        [Math.max(...xs), y],
      ],
    };
  }
  return {
    garment: JSON.stringify(drafted),
    print: file(`prints/${print}.json`),
    options: {grain: {default: 'on'}},
  };
}

/**
 * Greatest deviation of a piece's outline, drafted as a straight band along x, from its lines. [cm]
 */
function bent({pieces}: SolveResult, name: string): number {
  const {rest = [], shape = [], outline = []} = pieces.find((piece) => piece.name === name) ?? {};
  return Math.max(...outline.map((v) => Math.abs((shape[v]?.[1] ?? NaN) - (rest[v]?.[1] ?? NaN))));
}

/** Mean mismatch of each seam of a piece. [cm] */
const meansAt = ({seams, pieces}: SolveResult, name: string): number[] =>
  seams.flatMap(({a, b, local}) =>
    [a, b].some(({piece}) => pieces[piece]?.name === name) ? [local?.final ?? NaN] : [],
  );

it('keeps the apron’s waistband straight, says why it misses, and knows that turning it helps', async () => {
  const problem = lengthwise('apron', ['waistband']);
  const result = await solve(problem);
  expect(bent(result, 'waistband')).toBeLessThan(0.1);
  expect(result.seams.slice(0, 2).map(({why, line}) => [why, line])).toEqual([
    ['grain', 'drafted'],
    ['grain', 'drafted'],
  ]);
  expect(Math.min(...meansAt(result, 'waistband'))).toBeGreaterThan(0.6);

  const [remedy, ...others] = await remedies(problem, result);
  expect(others).toEqual([]);
  expect(remedy).toMatchObject({kind: 'turn', pieces: ['waistband'], seams: [0, 1]});
  const turned = await solve(withRemedy(problem, remedy?.change ?? {}));
  expect(Math.max(...meansAt(turned, 'waistband'))).toBeLessThan(0.1);
  expect(bent(turned, 'waistband')).toBeLessThan(0.1);
  expect(remedy?.before).toBeGreaterThan(0.6);
  expect(remedy?.after).toBeLessThan(0.1);
});

it('bends no waistband to a gathered skirt, and offers to leave the gathers out', async () => {
  const bands = ['waistband_front', 'waistband_back'];
  const problem = lengthwise('gathered-skirt', bands);
  const result = await solve(problem);
  for (const band of bands) expect(bent(result, band)).toBeLessThan(0.1);
  const gathers = result.seams.flatMap(({why}, seam) => (why === 'gather' ? [seam] : []));
  expect(gathers).toEqual([4, 5]);
  const [remedy] = await remedies(problem, result);
  expect(remedy).toMatchObject({kind: 'ungather', seams: gathers});
  const without = await solve(withRemedy(problem, remedy?.change ?? {}));
  expect(without.metrics.localCm?.final).toBeCloseTo(remedy?.after ?? NaN, 9);
  expect(without.metrics.localCm?.final).toBeLessThan(0.1);
});

it('bends neither stand nor cuffs of a shirt, and turns the stand', async () => {
  const bands = ['stand', 'cuff_left', 'cuff_right'];
  const problem = lengthwise('shirt', bands);
  const result = await solve(problem);
  for (const band of bands) expect(bent(result, band)).toBeLessThan(0.1);
  const found = await remedies(problem, result);
  const turn = found.find(({kind, pieces}) => kind === 'turn' && pieces.includes('stand'));
  expect(turn?.after).toBeLessThan(0.6 * (turn?.before ?? 0));
  expect(turn?.pieces.some((piece) => /front|back|sleeve/.test(piece))).toBe(false);
});
