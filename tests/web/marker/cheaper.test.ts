import type {MarkerGarment} from '@/model/design/marker-garment.js';
import {describe, expect, it} from 'vitest';

import {cheaperLays} from '@/marker/cheaper.js';
import {markerOrder, type MarkerOrder} from '@/marker/problem.js';
import type {MarkerSettings} from '@/marker/settings.js';
import {layPlan} from '@/marker/plan.js';
import {layShifted, plainBound, type Lay} from '@/marker/shifted.js';
import {minus, norm, rotated, type Alignment, type Point} from '@/model/geometry/vectors.js';
import type {MarkerAnswer, MarkerProblem} from '@/model/result/marker-search.js';
import type {SolveOptions} from '@/model/design/options.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {ResultSeam, SolveResult} from '@/model/result/result.js';
import {rectangle, resultOf} from '../../support/marker/laid-rectangles.js';
import {at} from '../../support/plane.js';
import {offNormaliser} from '../../support/marker/plan-print.js';
import {plainMetrics} from '../../support/garments/two-squares.js';

const p2: Print = {group: 'p2', w1: [10, 0], w2: [2, 12]};

/** A garment whose front and back are sewn together, like its sleeves; a pocket is not sewn. */
function garment(print: Print = p2, more: Partial<SolveResult> = {}): SolveResult {
  const joined = (a: number, b: number): ResultSeam => ({
    ...{a: {piece: a, vertices: [1, 2]}, b: {piece: b, vertices: [0, 3]}},
    ...{weight: 1, matched: true, lengthRatio: 1, kind: 'continuous', mismatch: [0]},
  });
  const placed = (angle: number, ...translation: readonly [number, number]): Alignment => ({
    angle,
    translation,
  });
  return resultOf(
    print,
    [
      rectangle('front', 30, 40, placed(0, 1, 2)),
      rectangle('sleeve_left', 20, 30, placed(Math.PI, 3, 1)),
      rectangle('back', 30, 41, placed(0, -29, 2)),
      rectangle('sleeve_right', 20, 31, placed(Math.PI, 23, 1)),
      rectangle('pocket', 9, 8, placed(0, 4, 4)),
    ],
    {seams: [joined(0, 2), joined(1, 3)], ...more},
  );
}

const orderOf = (settings: Partial<MarkerSettings> = {}, print = p2): MarkerOrder =>
  markerOrder([{result: garment(print)}], {
    ...{widthCm: 140, shift: 'component', phaseCm: 3, widthsCm: []},
    ...settings,
  });

const answerOf = ({pieces, phasesCm}: MarkerProblem, lengthCm: number): MarkerAnswer => ({
  ...{lengthCm, printOrigin: [phasesCm[0] ?? 0, 0], boundCm: lengthCm, proven: true},
  places: pieces.map(() => ({angle: 0, translation: [30, 30]})),
  ...{freeLengthCm: 80, phaseLengthsCm: phasesCm.map(() => lengthCm), widthLengthsCm: []},
});

/** Shift of the print under each piece. */
const shiftsIn = ({problem}: MarkerOrder, {pieces}: MarkerProblem): readonly Point[] =>
  pieces.map(({alignment}, k) => {
    const before = at(problem.pieces, k).alignment;
    return rotated(minus(before.translation, alignment.translation), -alignment.angle);
  });

const isMoved = (shift: Point): boolean => norm(shift) > 1e-9;

describe('the print moves under joined pieces', () => {
  it('by one shift for all of them, after which it meets itself as before', async () => {
    const order = orderOf();
    expect(order.components).toEqual([
      [0, 2],
      [1, 3],
    ]);
    const asked: MarkerProblem[] = [];
    const lay: Lay = (problem) => {
      asked.push(problem);
      const moved = shiftsIn(order, problem).map(isMoved);
      return Promise.resolve(
        answerOf(problem, moved[1] === true ? 90 : moved[0] === true ? 95 : 100),
      );
    };
    const stages: number[] = [];
    const laid = await lay(order.problem, {});
    const {answer, order: shifted} = await layShifted(order, laid, lay, {
      onProgress: ({fraction}) => stages.push(fraction),
    });
    for (const problem of asked) {
      const [front, left, back, right, pocket] = shiftsIn(order, problem);
      expect(norm(minus(front ?? [9, 9], back ?? [0, 0]))).toBeLessThan(1e-9);
      expect(norm(minus(left ?? [9, 9], right ?? [0, 0]))).toBeLessThan(1e-9);
      expect(norm(pocket ?? [9, 9])).toBeLessThan(1e-9);
      for (const by of [front, left]) expect(offNormaliser(p2, by ?? [9, 9])).toBeLessThan(1e-9);
    }
    expect(shiftsIn(order, shifted.problem).map(isMoved)).toContain(true);
    expect(answer).toMatchObject({lengthCm: 90, proven: false, freeLengthCm: 80});
    expect(asked.at(-1)?.effort).toBe(1); // the first one's effort
    expect(asked.slice(1, -1).every(({effort}) => effort < 0.1)).toBe(true);
    expect(stages).toEqual([...stages].sort((one, other) => one - other));
    // the bound is the same for all positions of the print
    expect(answer.boundCm).toBeCloseTo(plainBound(order.problem), 9);
    expect(plainBound(order.problem)).toBeCloseTo(45, 1); // the back with its hem
  });

  it('stays where nothing is gained, and says no more that it is proven', async () => {
    const order = orderOf();
    const lay: Lay = (problem) => Promise.resolve(answerOf(problem, 100));
    const laid = answerOf(order.problem, 100);
    const stays = await layShifted(order, laid, lay);
    expect(stays.order).toBe(order);
    expect(stays.answer).toMatchObject({lengthCm: 100, proven: false});
    const failing: Lay = () => Promise.reject(new Error('no place'));
    expect((await layShifted(order, laid, failing)).answer.lengthCm).toBe(100);
    const gone = new AbortController();
    gone.abort(new DOMException('', 'AbortError'));
    await expect(layShifted(order, laid, failing, gone)).rejects.toThrow(DOMException);
  });

  it('of a single component only where somebody says where the print starts', async () => {
    const count = async (order: MarkerOrder): Promise<number> => {
      let asked = 0;
      const lay: Lay = (problem) => {
        asked += 1;
        return Promise.resolve(answerOf(problem, 100));
      };
      await layShifted(order, answerOf(order.problem, 100), lay);
      return asked;
    };
    expect(await count(orderOf())).toBe(1 + 2 * 3); // three shifts of two components
    const {phaseCm, ...open} = {...orderSettings, phaseCm: 0};
    expect(phaseCm).toBe(0);
    const order = markerOrder([{result: garment()}], open);
    expect(await count(order)).toBe(1 + 3);
    expect(
      await count(orderOf({}, {...p2, group: 'p6', w1: [10, 0], w2: [5, 8.660254037844386]})),
    ).toBe(0);
    expect(await count(orderOf({effort: 0}))).toBe(0);
    // only a few of continuous shifts are tried
    expect(await count(orderOf({}, {...p2, group: 'p1'}))).toBe(1 + 2 * 10);
  });

  it('keeps a proof of loose pieces only where there are no shifts between those that are tried', async () => {
    const proven = async (print: Print): Promise<boolean> => {
      const order = markerOrder([{result: garment(print, {seams: []})}], orderSettings);
      const lay: Lay = () => Promise.reject(new Error('not asked'));
      return (await layShifted(order, answerOf(order.problem, 100), lay)).answer.proven;
    };
    const square = {w1: [10, 0], w2: [0, 10]} as const;
    expect(await proven({group: 'p4m', ...square})).toBe(true);
    expect(await proven({group: 'pm', ...square})).toBe(false);
  });
});

const orderSettings: MarkerSettings = {widthCm: 140, shift: 'component', widthsCm: []};

describe('other designs that fit as well', () => {
  const means = (final: number): SolveResult['metrics'] => ({
    ...plainMetrics,
    localCm: {drafted: 2, placed: 1, final, worst: 2},
  });
  /** Design n is shifted on the print by n cm. */
  const others = [1, 2, 3, 4, 5].map((n) => ({
    pieces: garment().pieces.map(
      ({
        alignment: {
          angle,
          translation: [x, y],
        },
      }): Alignment => ({
        angle,
        translation: [x + n, y],
      }),
    ),
    ...{placedCm: 1, expectedCm: 0.4},
  }));
  const result = garment(p2, {metrics: means(0.4), otherAlignments: others});
  const problem = {
    garment: '{}',
    print: p2,
    options: '{"maxChangeCm": 2, "otherAlignments": true}',
  };
  const nthOf = ({pieces}: MarkerProblem): number => (pieces[0]?.alignment.translation[0] ?? 0) - 1;
  const lengths = [100, 80, 85, 100, 90, 99.5];
  const lay: Lay = (asked) => {
    const isKept = asked.pieces.every(({shifts}) => shifts.length === 0);
    return Promise.resolve(answerOf(asked, isKept ? (lengths[nthOf(asked)] ?? 100) : 100));
  };
  const settings: MarkerSettings = {widthCm: 140, phaseCm: 3, widthsCm: []};
  const offers = (laid: MarkerGarment, finals: readonly number[]) => {
    const solved: SolveOptions[] = [];
    const order = markerOrder([laid], settings);
    const plan = layPlan(order, answerOf(order.problem, 100));
    return cheaperLays(
      {garments: [laid], settings, print: p2, plan: {...plan, lengthCm: 100}},
      {
        lay,
        solve: ({options}) => {
          const asked = options as SolveOptions;
          solved.push(asked);
          const pieces = result.pieces.map((piece) => ({
            ...piece,
            alignment: asked.pins?.[piece.name] ?? piece.alignment,
          }));
          const nth = (pieces[0]?.alignment.translation[0] ?? 0) - 1;
          const final = finals[nth];
          return final === undefined
            ? Promise.reject(new Error('cannot be sewn'))
            : Promise.resolve({...result, pieces, metrics: means(final)});
        },
      },
    ).then((found) => ({solved, designs: found.filter(({kind}) => kind === 'design')}));
  };

  it('are offered once they are solved, with their fit', async () => {
    const {designs, solved} = await offers({result, problem}, [0.4, 0.42, 0.4, 0.4, 0.4]);
    expect(designs).toEqual([
      {
        ...{kind: 'design', lengthCm: 80},
        design: {
          ...{result: 0, meanCm: 0.42, insteadOfCm: 0.4},
          pins: Object.fromEntries(
            result.pieces.map(({name}, k) => [name, at(at(others, 0).pieces, k)]),
          ),
        },
      },
    ]);
    expect(solved).toHaveLength(3); // the shortest ones
    expect(solved[0]).toMatchObject({maxChangeCm: 2, otherAlignments: false});
  });

  it('are none that fit worse, or cannot be solved', async () => {
    const worse = await offers({result, problem}, [0.4, 0.46, 0.44, 0.4, 0.4]);
    expect(worse.designs.map(({lengthCm}) => lengthCm)).toEqual([85]);
    const none = await offers({result, problem}, []);
    expect(none.designs).toEqual([]);
  });

  it('are looked for where they are told and can be solved', async () => {
    expect((await offers({result}, [])).solved).toEqual([]);
    const {otherAlignments, ...untold} = result;
    expect(otherAlignments).toHaveLength(5);
    expect((await offers({result: untold, problem}, [])).solved).toEqual([]);
    const {designs} = await offers({result: untold, problem, others}, [0.4, 0.4, 0.4, 0.4, 0.4]);
    expect(designs[0]?.lengthCm).toBe(80);
  });
});
