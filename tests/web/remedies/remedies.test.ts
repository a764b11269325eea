import {describe, expect, it} from 'vitest';

import type {SingleProblem} from '@/model/design/solve-problem.js';
import type {ResultSeam, SeamReason, SolveResult} from '@/model/result/result.js';
import {groupWithMirrors, proposals} from '@/remedies/proposals.js';
import {remediesOf} from '@/remedies/remedies.js';
import {withRemedy} from '@/remedies/remedy.js';
import {
  plainMetrics,
  plainPrint,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';

/**
 * A skirt of two large panels, and a band in two halves on them: all squares, sewn side to side.
 */
const names = ['front', 'back', 'band_front', 'band_back'];
const joins: readonly (readonly [number, number, SeamReason | undefined])[] = [
  [0, 1, undefined],
  [0, 1, undefined],
  [0, 2, 'grain'],
  [1, 3, 'grain'],
  [2, 3, undefined],
];

/**
 * @param high  offset of the second piece of every seam with a reason from where it would match
 * [cm]
 */
function skirt(high: number, more: Partial<SolveResult> = {}, all = joins): SolveResult {
  const [template] = squarePair().seams;
  if (!template) throw new Error('no seam');
  const pieces = names.map((name, k) =>
    squarePiece(name, {alignment: {angle: 0, translation: [-4 * k, k < 2 ? 0 : high]}}),
  );
  const seams = all.map(([a, b, why]): ResultSeam => ({
    ...template,
    a: {piece: a, vertices: [0, 1]},
    b: {piece: b, vertices: [0, 1]},
    ...(why && {why}),
  }));
  const lying = pieces.map((piece) => ({
    ...piece,
    alignment: {...piece.alignment, translation: [0, piece.alignment.translation[1]] as const},
  }));
  return {
    ...{format: 'seamwise-result/1', units: 'cm', print: plainPrint, search: [], symmetries: []},
    ...{pieces: lying, seams, metrics: plainMetrics, notes: [], ...more},
  };
}

const problem: SingleProblem = {
  garment: '{}',
  print: plainPrint,
  options: {grain: {default: 'on'}, unmatched: [7]},
};
const only = (why: SeamReason): SolveResult => skirt(1, {}, [[0, 1, why], ...joins.slice(0, 2)]);

describe('what is proposed', () => {
  it('is nothing where no seam stays off', () => {
    expect(proposals(problem, skirt(0, {}, joins.slice(0, 2)))).toEqual([]);
  });

  it('is nothing where each try would be a long one, for the number of pieces', () => {
    const [piece] = skirt(1).pieces;
    if (!piece) throw new Error('no piece');
    const more = (count: number) => [...skirt(1).pieces, ...Array<typeof piece>(count).fill(piece)];
    expect(proposals(problem, {...skirt(1), pieces: more(200)})).toEqual([]);
    expect(proposals(problem, {...skirt(1), pieces: more(20)})).not.toEqual([]);
  });

  it('turns the band, not the panels, with its other half', () => {
    expect(proposals(problem, skirt(1))).toEqual([
      {
        ...{kind: 'turn', pieces: ['band_front', 'band_back'], seams: [2, 3]},
        change: {
          options: {grain: {default: 'on', pieces: {band_front: 'across', band_back: 'across'}}},
        },
      },
    ]);
  });

  it('turns the mirror image of a band with it, and each band by itself where they are apart', () => {
    const apart = joins.slice(0, 4);
    expect(proposals(problem, skirt(1, {}, apart)).map(({pieces}) => pieces)).toEqual([
      ['band_front'],
      ['band_back'],
    ]);
    const pairs = [[0, 0]] as const;
    const map = {angle: 0, translation: [0, 0]} as const;
    const symmetric = skirt(
      1,
      {symmetries: [{kind: 'pair', pieces: [2, 3], map, pairs}]},
      apart.slice(0, 3),
    );
    expect(proposals(problem, symmetric).map(({pieces}) => pieces)).toEqual([
      ['band_front', 'band_back'],
    ]);
  });

  it('turns back what lies across, and keeps what else is said of the piece', () => {
    const grain = {
      default: 'on',
      pieces: {band_front: {lock: 'across', toleranceDeg: 3}, front: 'free'},
    };
    const [turn] = proposals({...problem, options: JSON.stringify({grain})}, skirt(1));
    expect(turn?.change.options?.grain?.pieces).toEqual({
      ...{band_front: {lock: 'on', toleranceDeg: 3}, band_back: 'across', front: 'free'},
    });
  });

  it('turns no piece that lies at any angle anyway, nor one that is pinned', () => {
    const pins = Object.fromEntries(
      names.map((name) => [name, {angle: 0, translation: [0, 0]}] as const),
    );
    expect(proposals({...problem, options: {pins}}, skirt(1))).toEqual([]);
    expect(proposals({...problem, options: {grain: {default: 'free'}}}, skirt(1))).toEqual([]);
  });

  it('leaves gathers out besides what is left out already', () => {
    expect(proposals(problem, only('gather'))[0]).toMatchObject({
      ...{kind: 'ungather', seams: [0], change: {options: {unmatched: [7, 0]}}},
    });
  });

  it('takes a print with mirrors on the same repeat, or one of half the repeat', () => {
    expect(proposals(problem, only('group'))[0]?.change).toEqual({print: {group: 'pmm'}});
    for (const why of ['size', 'others'] as const) {
      expect(proposals(problem, only(why))[0]?.change).toEqual({print: {w1: [5, 0], w2: [0, 5]}});
    }
    expect(proposals(problem, only('locked'))).toEqual([]);
  });

  it('knows no print with mirrors on a slanted repeat', () => {
    expect(groupWithMirrors({group: 'p2', w1: [8, 0], w2: [3, 9]})).toBeUndefined();
    expect(groupWithMirrors({group: 'p3', w1: [8, 0], w2: [4, 4 * Math.sqrt(3)]})).toBe('p6m');
    expect(groupWithMirrors({group: 'p6m', w1: [8, 0], w2: [4, 4 * Math.sqrt(3)]})).toBeUndefined();
  });
});

describe('what helps', () => {
  const tried = (answer: SolveResult, asked: SingleProblem[] = []) =>
    remediesOf(problem, skirt(1), (changed) => {
      asked.push(changed);
      return Promise.resolve(answer);
    });

  it('is said with the mean along its seams, before and after', async () => {
    const asked: SingleProblem[] = [];
    const [remedy, ...more] = await tried(skirt(0.05), asked);
    expect(more).toEqual([]);
    expect(remedy).toMatchObject({kind: 'turn', pieces: ['band_front', 'band_back']});
    expect(remedy?.before).toBeCloseTo(1, 12);
    expect(remedy?.after).toBeCloseTo(0.05, 12);
    expect(asked).toEqual([withRemedy(problem, remedy?.change ?? {})]);
    expect(asked[0]?.options).toMatchObject({unmatched: [7]});
  });

  it('is not what helps little', async () => {
    expect(await tried(skirt(0.8))).toEqual([]);
  });

  it('is not what makes the whole worse', async () => {
    const worse = skirt(0.1);
    const pieces = worse.pieces.map((piece, k) =>
      k === 0 ? {...piece, alignment: {angle: 0, translation: [3, 0.1] as const}} : piece,
    );
    expect(await tried({...worse, pieces})).toEqual([]);
  });

  it('is not what cannot be solved', async () => {
    const failing = remediesOf(problem, skirt(1), () => Promise.reject(new Error('no')));
    expect(await failing).toEqual([]);
  });

  it('is looked for until somebody has enough of it', async () => {
    const enough = new AbortController();
    const reason = new Error('enough');
    const search = remediesOf(
      problem,
      skirt(1),
      () => {
        enough.abort(reason);
        return Promise.resolve(skirt(0));
      },
      {signal: enough.signal},
    );
    await expect(search).rejects.toBe(reason);
  });

  it('leaves out the gathers where the others gain by it', async () => {
    const before = skirt(1, {}, [[0, 2, 'gather'], ...joins.slice(0, 2)]);
    const after = {
      ...before,
      seams: before.seams.map((seam, k) => ({...seam, matched: k !== 0})),
    };
    const [remedy] = await remediesOf(problem, before, () => Promise.resolve(after));
    expect(remedy).toMatchObject({kind: 'ungather', after: 0});
    expect(remedy?.before).toBeCloseTo(1 / 3, 12);
  });
});
