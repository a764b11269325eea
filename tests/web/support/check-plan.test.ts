import {determinant} from '@/model/geometry/plane-map.js';
import {groupNames} from '@/model/base/core-tables.js';
import {describe, expect, it} from 'vitest';

import type {LaidPlacement, LayPlan} from '@/model/result/marker-plan.js';
import {onPiece, plus, type Point} from '@/model/geometry/vectors.js';
import {type Print} from '@/model/print/repeating-print.js';
import {latticeVectors} from '@/model/print/repeat.js';
import {printElements} from '@/model/print/wallpaper.js';
import {planComplaints} from '../../support/marker/check-plan.js';
import {boardOf, shortestLength} from '../../support/marker/complete-search.js';
import {placementOf, planOf, rectangle, resultOf} from '../../support/marker/laid-rectangles.js';
import {at, greatest} from '../../support/plane.js';
import {offNormaliser, turnsOf, warpPeriod} from '../../support/marker/plan-print.js';
import type {PlanRules} from '../../support/marker/plan-rules.js';
import {outlineOf, ringDistance, sharedArea} from '../../support/marker/rings.js';

const print: Print = {group: 'p2', w1: [8, 0], w2: [0, 8]};
const front = rectangle('front', 20, 10, {angle: Math.PI, translation: [3, 2]});
const back = rectangle('back', 10, 10, {angle: 0, translation: [-1, 4]});
const results = [resultOf(print, [front, back])];
const rules: PlanRules = {turns: () => 'half'};
// the front turned upright by the print's half turn: its cut corners at (4.2, 1), (26.2, 13)
const origin: Point = [8.2, 4];

const lie = (piece: number, i: number, j: number, turn: number): LaidPlacement =>
  placementOf(results, origin, {piece, repeats: [i, j], turn});

const good = planOf(results, [lie(0, 0, 0, Math.PI), lie(1, 3, 0, 0)], {printOrigin: origin});

/** The same plan in other fabric coordinates, from 0. */
const lowered = (plan: LayPlan): LayPlan => {
  const lowest = Math.min(...plan.placements.flatMap(({cut}) => cut.map(([, y]) => y)));
  return moved(plan, [0, -lowest]);
};

const moved = (plan: LayPlan, by: Point): LayPlan => ({
  ...plan,
  printOrigin: plan.printOrigin && plus(plan.printOrigin, by),
  placements: plan.placements.map((one) => shifted(one, by)),
});

const shifted = (one: LaidPlacement, by: Point): LaidPlacement => ({
  ...one,
  translation: plus(one.translation, by),
  cut: one.cut.map((p) => plus(p, by)),
});

/** Changes one of the placements; all figures stay. */
const withOne = (
  plan: LayPlan,
  which: number,
  change: (one: LaidPlacement) => LaidPlacement,
): LayPlan => ({
  ...plan,
  placements: plan.placements.map((one, k) => (k === which ? change(one) : one)),
});

const turnedAbout = (one: LaidPlacement, centre: Point, angle: number): LaidPlacement => {
  const turn = (p: Point): Point =>
    onPiece({angle, translation: centre}, [p[0] - centre[0], p[1] - centre[1]]);
  return {
    ...one,
    angle: one.angle + angle,
    translation: turn(one.translation),
    cut: one.cut.map(turn),
  };
};

const plan = lowered(good);

describe('a plan made by hand', () => {
  it('is as it should be', () => {
    expect(planComplaints(plan, results, rules)).toEqual([]);
  });

  it('may lie on shifts of the print that leave its symmetries, where that is asked', () => {
    const half: Point = [4, 0];
    const placements = [0, 1].map((piece) =>
      placementOf(results, origin, {
        ...{piece, repeats: [1 + 2 * piece, 0], shift: half},
        turn: piece === 0 ? Math.PI : 0,
      }),
    );
    const lain = lowered(planOf(results, placements, {printOrigin: origin}));
    expect(planComplaints(lain, results, {...rules, shift: 'component'})).toEqual([]);
    expect(planComplaints(lain, results, rules)).toEqual([
      expect.stringMatching(/^front of 0\.0: the print is 4 cm off$/),
      expect.stringMatching(/^back of 0\.0: the print is 4 cm off$/),
    ]);
  });

  it('may have pieces without a place, and several garments', () => {
    const {placements} = plan;
    const other = placements.map((one) => ({...shifted(one, [0, 16]), copy: 1}));
    const both = planOf(results, [...placements, at(other, 0)], {
      printOrigin: plan.printOrigin,
      unplaced: [{result: 0, copy: 1, piece: 'back'}],
    });
    expect(planComplaints(both, results, {...rules, copies: 2})).toEqual([]);
  });

  it('may be as long as whole repeats', () => {
    const whole = {...rules, wholeRepeats: true};
    const long = (lengthCm: number): LayPlan => ({
      ...{...plan, lengthCm, boundCm: lengthCm, phases: [{phaseCm: 8.2, lengthCm}]},
      useShare: plan.useShare * (plan.lengthCm / lengthCm),
    });
    expect(planComplaints(long(16), results, whole)).toEqual([]);
    expect(planComplaints(long(24), results, whole)).toEqual(['a whole repeat lies empty']);
    expect(planComplaints(plan, results, whole).join()).toMatch(/not whole repeats/);
  });
});

const damaged: readonly (readonly [string, LayPlan, RegExp, Partial<PlanRules>?])[] = [
  ['no number', {...plan, boundCm: NaN}, /not finite/],
  ['another print', {...plan, print: {...plan.print, w1: [9, 0]}}, /another print/],
  ['a piece left out', {...plan, placements: plan.placements.slice(1)}, /front of 0.0 is missing/],
  ['a stranger', withOne(plan, 0, (one) => ({...one, piece: 'sleeve'})), /no such piece/],
  ['a garment too many', withOne(plan, 0, (one) => ({...one, copy: 1})), /nobody asked for it/],
  [
    'a piece laid twice',
    {...plan, placements: [...plan.placements, shifted(at(plan.placements, 0), [0, 16])]},
    /laid twice/,
  ],
  [
    'a piece laid and said not to be',
    {...plan, unplaced: [{result: 0, copy: 0, piece: 'back'}]},
    /laid twice/,
  ],
  [
    'a cut line that is another one',
    withOne(plan, 1, (one) => ({...one, cut: one.cut.map((p) => plus(p, [3, 0]))})),
    /sewn lines leave/,
  ],
  [
    'a place that is another one',
    withOne(plan, 1, (one) => ({...one, translation: plus(one.translation, [8, 0])})),
    /sewn lines leave/,
  ],
  ['another allowance', {...plan, allowanceCm: 1.5}, /an allowance of 1/],
  ['a larger allowance', {...plan, allowanceCm: 0.5}, /allowances of 1/],
  [
    'a mirrored piece',
    withOne(plan, 1, (one) => ({...one, cut: one.cut.toReversed()})),
    /runs clockwise/,
  ],
  ['a piece off the print', withOne(plan, 1, (one) => shifted(one, [2, 0])), /print is 2.*cm off/],
  [
    'a piece a hair off the print',
    withOne(plan, 1, (one) => shifted(one, [2e-6, 0])),
    /back.*print is 0.000002.* cm off/,
  ],
  [
    'a piece off along the fabric',
    withOne(plan, 1, (one) => shifted(one, [0, -1])),
    /print is 1.* cm off/,
  ],
  [
    'another origin of the print',
    {...plan, printOrigin: plus(plan.printOrigin ?? [0, 0], [1, 0])},
    /print is 1.* cm off/,
  ],
  [
    'a turn that the print has not',
    withOne(plan, 1, (one) => turnedAbout(one, [34, 6], Math.PI / 2)),
    /print is turned/,
    {turns: () => 'any'},
  ],
  ['a slight turn', withOne(plan, 1, (one) => turnedAbout(one, [34, 6], 1e-6)), /print is turned/],
  [
    'grain across the fabric',
    withOne(plan, 1, (one) => turnedAbout(one, [34, 6], Math.PI / 2)),
    /grain is off by 1 rad/,
  ],
  [
    'a nap against another',
    withOne(plan, 1, (one) => turnedAbout(one, [34, 6], Math.PI)),
    /nap runs against front/,
    {nap: 'one-way'},
  ],
  [
    'a nap against that of the garment',
    withOne(plan, 1, (one) => turnedAbout(one, [34, 6], Math.PI)),
    /nap runs against front/,
    {nap: 'garment'},
  ],
  ['cloth too narrow', {...plan, widthCm: 39}, /back.* over the right selvedge/],
  ['a wide selvedge', {...plan, selvedgeCm: 5}, /front.* over the left selvedge/],
  ['a piece before the cut', moved(plan, [0, -0.01]), /over the start/],
  ['a piece beyond the end', moved(plan, [0, 0.01]), /over the end/],
  [
    'a piece on a flaw',
    plan,
    /back of 0.0 lies on flaw 0/,
    {
      flaws: [
        [
          [40, 5],
          [41, 5],
          [41, 6],
        ],
      ],
    },
  ],
  [
    'pieces too near',
    {...plan, gapCm: 6.5},
    /back of 0.0 and front of 0.0 are .* cm apart, not 6.5/,
  ],
  [
    'pieces on each other',
    withOne(plan, 1, (one) => shifted(one, [-8, 0])),
    /and front of 0.0 overlap by /,
  ],
  ['another length', {...plan, lengthCm: plan.lengthCm + 1}, /the pieces take 14.*, not 15/],
  ['another use', {...plan, useShare: 0.5}, /of the fabric is used, not 0.5/],
  ['a bound above the length', {...plan, boundCm: plan.lengthCm + 0.01}, /above the length/],
  ['a proof that is none', {...plan, boundCm: plan.lengthCm - 1}, /said to be proven/],
  ['a print that saves fabric', {...plan, freeLengthCm: plan.lengthCm + 1}, /to be longer/],
  ['another phase', {...plan, phases: [{phaseCm: 1, lengthCm: plan.lengthCm}]}, /no phase/],
  [
    'a better phase that is not shown',
    {...plan, phases: [...plan.phases, {phaseCm: 1, lengthCm: 12}]},
    /1 cm takes 12 cm, less/,
  ],
];

describe('damage to it', () => {
  it.each(damaged.map(([name, broken, sentence, more = {}]) => ({name, broken, sentence, more})))(
    'is found: $name',
    ({broken, sentence, more}) => {
      expect(planComplaints(broken, results, {...rules, ...more}).join('\n')).toMatch(sentence);
    },
  );

  it('is a shift of the print of one of two that a seam joins', () => {
    const side = (piece: number) => ({piece, vertices: [1, 2]});
    const seam = {weight: 1, matched: true, lengthRatio: 1, kind: 'continuous', mismatch: [0]};
    const sewn = [
      resultOf(print, [front, back], {
        seams: [{a: side(0), b: side(1), ...seam, kind: 'continuous'}],
      }),
    ];
    const placements = [0, 1].map((piece) =>
      placementOf(sewn, origin, {
        ...{piece, repeats: [3 * piece, 0], shift: [4 * piece, 0]},
        turn: piece === 0 ? Math.PI : 0,
      }),
    );
    const lain = lowered(planOf(sewn, placements, {printOrigin: origin}));
    const free = {...rules, shift: 'component'} as const;
    expect(planComplaints(lain, results, free)).toEqual([]);
    expect(planComplaints(lain, sewn, free).join()).toMatch(/moved 4 cm against front/);
    const third = placementOf(sewn, origin, {piece: 1, repeats: [3, 0], shift: [1, 0]});
    const odd = lowered(planOf(sewn, [at(placements, 0), third], {printOrigin: origin}));
    expect(planComplaints(odd, results, free).join()).toMatch(/moved to other symmetries by 2 cm/);
  });

  it('is a length from the first piece on where the cut is fixed', () => {
    const later = moved({...plan, lengthCm: plan.lengthCm + 3}, [0, 3]);
    expect(planComplaints(later, results, rules).join()).toMatch(/the pieces take/);
    expect(planComplaints(later, results, {...rules, isStartFixed: true}).join()).not.toMatch(
      /the pieces take/,
    );
  });
});

describe('the table of turns', () => {
  it.each(groupNames)('agrees with the symmetries of %s that do not mirror', (group) => {
    const [w1, w2] = latticeVectors(group, {width: 7, height: 9, angleDeg: 80});
    const proper = printElements({group, w1, w2}).filter((one) => determinant(one) > 0);
    expect(proper).toHaveLength(turnsOf[group]);
    expect(greatest(proper.map(({shift}) => Math.hypot(...shift)))).toBe(0);
    const angles = proper.map(({xx, yx}) => Math.atan2(yx, xx) / ((2 * Math.PI) / turnsOf[group]));
    expect(greatest(angles.map((angle) => Math.abs(angle - Math.round(angle))))).toBeLessThan(1e-9);
  });

  it('has the shifts after which a print is as symmetric as before', () => {
    const third: Point = [5, 5 / Math.sqrt(3)];
    const [w1, w2] = latticeVectors('p3', {width: 10, height: 10, angleDeg: 60});
    expect(offNormaliser({group: 'p3', w1, w2}, third)).toBeLessThan(1e-9);
    expect(offNormaliser({group: 'p6', w1, w2}, third)).toBeGreaterThan(1);
    const stripe = {group: 'pm', w1: [6, 0], w2: [0, 8]} as const;
    expect(offNormaliser(stripe, [1.3, 4])).toBeLessThan(1e-9);
    expect(offNormaliser(stripe, [1.3, 3])).toBeGreaterThan(1);
  });

  it('has the repeat along the cloth', () => {
    expect(warpPeriod(print)).toBe(8);
    expect(warpPeriod({w1: [6, -5], w2: [6, 5]})).toBe(10);
    expect(warpPeriod({w1: [10, 0], w2: [5, 4]})).toBe(8);
    expect(warpPeriod({w1: [10, 1], w2: [-Math.SQRT2, 10]})).toBeUndefined();
  });
});

describe('distances and shared areas', () => {
  const square: readonly Point[] = [
    [0, 0],
    [4, 0],
    [4, 4],
    [0, 4],
  ];
  const at34 = square.map((p) => plus(p, [7, 8]));
  const small = square.map(([x, y]): Point => [1 + x / 4, 1 + y / 4]);

  it('are those of a square and others', () => {
    const [a, b, c] = [square, at34, small].map(outlineOf);
    if (!a || !b || !c) throw new Error();
    expect(ringDistance(a, b)).toBe(5);
    expect(ringDistance(a, b, [-7, 0])).toBe(4);
    expect(ringDistance(a, c)).toBe(0);
    expect(ringDistance(c, a)).toBe(0);
    expect(ringDistance(a, a, [2, 2])).toBe(0);
    expect(sharedArea(square, small)).toBeCloseTo(1, 9);
    expect(sharedArea(square, at34)).toBe(0);
  });
});

describe('the complete search', () => {
  it('finds that pieces lie side by side where the print lets them', () => {
    const {pieces, board} = boardOf(plan, results, rules);
    expect(shortestLength(pieces, board, 60)).toBeCloseTo(plan.lengthCm, 9);
    // none is shorter, and on narrow fabric one is above the other
    expect(shortestLength(pieces, board, plan.lengthCm - 0.01)).toBeUndefined();
    expect(shortestLength(pieces, {...board, widthCm: 30}, 60)).toBeCloseTo(26, 9);
    expect(shortestLength(pieces, {...board, widthCm: 20}, 60)).toBeUndefined();
  });

  it('knows by the print where pieces lie: 6 cm high, a repeat of 8, one above the other', () => {
    const low = [0, 1, 2].map((k) => rectangle(`piece ${k}`, 20, 4));
    const board = {print, widthCm: 30, selvedgeCm: 1, gapCm: 0.2, phaseCm: 0};
    const pieces = low.map(({shape, alignment}) => ({
      ring: shape.map(([x, y]): Point => [x + (x > 0 ? 1 : -1), y + (y > 0 ? 1 : -1)]),
      ...{alignment, turns: 'half' as const},
    }));
    // turned ones have their edges at -5 and 1 modulo 8, others at -1 and 5: 16 + 6, or less by
    // turns
    expect(shortestLength(pieces, board, 60)).toBeCloseTo(22, 9);
    expect(shortestLength(pieces, {...board, print: {...print, group: 'p1'}}, 60)).toBeCloseTo(
      22,
      9,
    );
    expect(shortestLength(pieces, {...board, print: {...print, w2: [0, 6.2]}}, 60)).toBeCloseTo(
      18.4,
      9,
    );
    expect(
      shortestLength(pieces, {...board, widthCm: 47, print: {...print, w1: [1, 0]}}, 60),
    ).toBeCloseTo(14, 9);
  });
});
