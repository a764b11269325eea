import {
  layPlanText,
  marker,
  solve,
  type LayPlan,
  type MarkerSettings,
  type Point,
  type MarkerGarment,
  type Print,
  type SolveResult,
} from 'seamwise/node';
import {beforeAll, describe, expect, it} from 'vitest';

import {plus, rotated} from '@/model/geometry/vectors.js';
import {planComplaints} from '../../support/marker/check-plan.js';
import {rectangle, resultOf} from '../../support/marker/laid-rectangles.js';
import {isThorough, sampleOf} from '../../support/level.js';
import type {PlanRules} from '../../support/marker/plan-rules.js';
import {extentOf} from '../../support/marker/rings.js';
import {sample} from '../../support/garments/samples.js';

/** The layouts below are measured on results with even weights. */
const even = {visibility: 'even'} as const;

const print: Print = {group: 'p4m', w1: [11, 0], w2: [0, 11]};
const rules: PlanRules = {turns: () => 'half'};
const usual: MarkerSettings = {
  widthCm: 140,
  allowanceCm: 1,
  effort: 0.05,
  phaseCm: 3,
  widthsCm: [],
};

let tee: SolveResult;
/** Most tests lay out a skirt of two pieces, which takes a seventh of the tee's time. */
let usualGarment: SolveResult;
beforeAll(async () => {
  tee = await solve({garment: sample('tee'), print, options: even});
  usualGarment = isThorough
    ? tee
    : await solve({garment: sample('gathered-skirt'), print, options: even});
});

/** Three pieces that no seam joins, solved on a print with or without half turns. */
const loose = (group: Print['group'], more: Partial<SolveResult> = {}): SolveResult =>
  resultOf(
    {...print, group},
    [
      rectangle('front', 30, 41, {angle: 0, translation: [2, 3]}),
      rectangle('back', 33, 38, {angle: 0, translation: [-4, 7]}),
      rectangle('pocket', 14, 12, {angle: 0, translation: [1, -5]}),
      rectangle('facing', 27, 6, {angle: 0, translation: [6, 2]}),
    ],
    more,
  );

/** Creates a layout, and runs all checks on it. */
async function laid(
  results: readonly (SolveResult | MarkerGarment)[],
  settings: Partial<MarkerSettings> = {},
  more: Partial<PlanRules> = {},
): Promise<LayPlan> {
  const plan = await marker(results, {...usual, ...settings});
  const solved = results.map((one) => ('result' in one ? one.result : one));
  const {copies, nap, shift, flaws} = settings;
  const told = {
    ...(copies !== undefined && {copies}),
    ...(nap && {nap}),
    ...(shift && {shift}),
    ...(flaws && {flaws}),
  };
  expect(planComplaints(plan, solved, {...rules, ...told, ...more})).toEqual([]);
  expect(plan.unplaced).toEqual([]);
  return plan;
}

let plain: Promise<LayPlan> | undefined;
/** The layout of that garment with the usual settings, computed once. */
const plainPlan = (): Promise<LayPlan> => (plain ??= laid([usualGarment]));

describe('a garment on its print', () => {
  it('is laid where the fabric shows what the result asks for, the same bytes each time', async () => {
    const plan = await plainPlan();
    expect(plan.placements).toHaveLength(usualGarment.pieces.length);
    expect(plan.printOrigin?.[0]).toBe(3);
    expect(plan.freeLengthCm).toBeLessThanOrEqual(plan.lengthCm);
    const again = await marker([usualGarment], usual);
    expect(layPlanText(again)).toBe(layPlanText(plan));
  });

  it('says what would take less fabric, and that is true', async () => {
    const {phaseCm: given, ...anywhere} = usual;
    expect(given).toBeDefined();
    const best = await marker([usualGarment], {...anywhere, widthCm: 120});
    const lengths = best.phases.map(({lengthCm}) => lengthCm ?? 0);
    const {phaseCm = 0} = best.phases[lengths.indexOf(Math.max(...lengths))] ?? {};
    const worst = await laid([usualGarment], {widthCm: 120, phaseCm});
    for (const {lengthCm} of worst.cheaper) expect(lengthCm).toBeLessThan(worst.lengthCm - 1);
    const offer = worst.cheaper.find(({kind}) => kind === 'phase');
    expect(offer !== undefined).toBe(best.lengthCm < worst.lengthCm - 1);
    const moved = await laid([usualGarment], {widthCm: 120, phaseCm: offer?.phaseCm ?? phaseCm});
    expect(moved.lengthCm).toBeLessThan((offer ?? worst).lengthCm + 0.5);
  });

  it('takes the least fabric of several phases, and tells of all', async () => {
    const {phaseCm, ...anywhere} = usual;
    expect(phaseCm).toBeDefined();
    const plan = await marker([usualGarment], anywhere);
    expect(planComplaints(plan, [usualGarment], rules)).toEqual([]);
    expect(plan.phases).toHaveLength(8);
    const lengths = plan.phases.map(({lengthCm}) => lengthCm ?? Infinity);
    expect(Math.min(...lengths)).toBeCloseTo(plan.lengthCm, 6);
    expect(plan.notes.join()).toMatch(
      /\d+ to \d+ cm, depending on where the print starts at the selvedge/,
    );
  });

  it('is laid in copies, with others, and with naps', async () => {
    const one = await plainPlan();
    const two = await laid([usualGarment], {copies: 2});
    const ofCopy = (copy: number) => usualGarment.pieces.map(() => copy);
    expect(two.placements.map(({copy}) => copy)).toEqual([...ofCopy(0), ...ofCopy(1)]);
    expect(two.lengthCm).toBeLessThan(2 * one.lengthCm + 11.01);
    const mixed = await laid([usualGarment, {result: loose('p4m'), name: 'bag'}], {nap: 'garment'});
    expect(new Set(mixed.placements.map(({result}) => result))).toEqual(new Set([0, 1]));
    await laid([usualGarment], {nap: 'one-way'});
  });

  it('is laid on whole repeats, off flaws, and from a start', async () => {
    const plan = await laid([usualGarment], {plies: 4}, {wholeRepeats: true});
    expect(plan.lengthCm / 11).toBeCloseTo(Math.round(plan.lengthCm / 11), 9);
    const flaws: Point[][] = [
      [
        [30, 20],
        [50, 20],
        [50, 45],
        [30, 45],
      ],
    ];
    const flawed = await laid([usualGarment], {flaws});
    expect(flawed.printOrigin).toEqual([3, 0]);
    const started = await laid([usualGarment], {startCm: 4}, {isStartFixed: true});
    expect(((started.printOrigin?.[1] ?? 0) - 4) / 11).toBeCloseTo(0, 9);
  });

  it('costs less without the print', async () => {
    const free = await laid([usualGarment], {ignoresPrint: true});
    expect(free.printOrigin).toBeNull();
    const {lengthCm} = await plainPlan();
    expect(free.lengthCm).toBeLessThanOrEqual(lengthCm);
  });
});

describe('folded fabric', () => {
  it('is cut through both plies: each piece with its mirror image in the fold', async () => {
    const onGrain = {grain: {default: 'on'}} as const;
    const result = await solve({garment: sample('tee'), print, options: onGrain});
    const {phaseCm, ...anywhere} = usual;
    expect(phaseCm).toBeDefined();
    const wheres = [{phaseCm: 4, widthCm: 190}, {ignoresPrint: true}, {}];
    for (const where of sampleOf(2, wheres)) {
      const settings = {...anywhere, widthCm: 180, copies: 2, fold: true, ...where};
      const plan = await marker([result], settings);
      expect(planComplaints(plan, [result], {...rules, copies: 2})).toEqual([]);
      expect(plan.placements).toHaveLength(8);
      const {foldCm = NaN} = plan;
      expect(Math.abs(foldCm - settings.widthCm / 2)).toBeLessThanOrEqual(11 / 4 + 1e-9);
      const images = plan.placements.map(({cut}) => extentOf(cut));
      for (const [left, lower, right, upper] of images) {
        const image = [2 * foldCm - right, lower, 2 * foldCm - left, upper];
        const off = images.map((other) =>
          Math.max(...other.map((side, k) => Math.abs(side - (image[k] ?? NaN)))),
        );
        expect(Math.min(...off)).toBeLessThan(0.02);
        expect(left > foldCm || right < foldCm).toBe(true);
      }
    }
  });

  it('is for prints that mirror along it, and for pieces with mirror images', async () => {
    const refusal = (result: SolveResult, copies: number) =>
      marker([result], {...usual, widthCm: 180, copies, fold: true}).then(
        () => '',
        (error: unknown) => String(error),
      );
    expect(await refusal(loose('p4m'), 2)).toContain("Piece 'front' has no mirror image");
    expect(await refusal(loose('p4'), 2)).toContain('Along this fabric p4 has no mirror line');
    const map = {angle: 0, translation: [30, 0]} as const;
    const front = rectangle('front', 30, 41, {angle: 0, translation: [4, 3]});
    const symmetries = [{kind: 'piece', piece: 0, map, pairs: []}] as const;
    const single = resultOf(print, [front], {symmetries});
    expect(await refusal(single, 1)).toContain("Piece 'front' is its own mirror image");
    const off = resultOf(print, [{...front, alignment: {angle: 0, translation: [5, 3]}}], {
      symmetries,
    });
    expect(await refusal(off, 2)).toContain("'front' do not show each other's mirror image");
    expect(await refusal(single, 2)).toBe('');
    const wide = {...usual, widthCm: 50, copies: 2, fold: true};
    await expect(marker([single], wide)).rejects.toThrow(
      /^front is 32.0 cm wide, .* between selvedge and fold; folded fabric has to be at least 66.2 cm wide/,
    );
  });

  it('names the piece and the reason of an impossible layout', async () => {
    const narrow = {...usual, widthCm: 30};
    const wide = rectangle('front', 30, 40);
    const fault = {code: 'options', piece: 0, reason: 'layTooWide'};
    const failure = marker([resultOf(print, [wide])], narrow);
    const lengthCm = expect.closeTo(34, 1) as number; // with two selvedges of 1 cm
    await expect(failure).rejects.toMatchObject({...fault, lengthCm});
  });
});

describe('no layout is longer for', () => {
  const within = 1.005;

  it('more room, less between pieces, or more freedom', async () => {
    const narrow = await laid([usualGarment], {widthCm: 120});
    const wide = await laid([usualGarment], {widthCm: 150});
    expect(wide.lengthCm).toBeLessThanOrEqual(within * narrow.lengthCm);
    const tight = await laid([usualGarment], {widthCm: 120, gapCm: 0});
    expect(tight.lengthCm).toBeLessThanOrEqual(within * narrow.lengthCm);
    for (const group of ['pm', 'p4m'] as const) {
      const kept = await laid([loose(group)], {widthCm: 90});
      const moved = await laid([loose(group)], {widthCm: 90, shift: 'component'});
      expect(moved.lengthCm).toBeLessThanOrEqual(within * kept.lengthCm);
    }
  });

  it('other names, or alignments that are whole repeats away', async () => {
    const {lengthCm} = await plainPlan();
    const renamed = usualGarment.pieces.map((piece, k) => ({
      ...piece,
      name: `${9 - k} ${piece.name}`,
    }));
    expect((await laid([{...usualGarment, pieces: renamed}])).lengthCm).toBeCloseTo(lengthCm, 6);
    const moved = usualGarment.pieces.map((piece, k) => {
      const {angle, translation} = piece.alignment;
      const by = rotated([11 * (k - 1), 22 * k], angle);
      return {...piece, alignment: {angle, translation: plus(translation, by)}};
    });
    expect((await laid([{...usualGarment, pieces: moved}])).lengthCm).toBeCloseTo(lengthCm, 6);
  });
});

describe('a search', () => {
  it('tells of plans that get shorter, and how far it is', async () => {
    const plans: LayPlan[] = [];
    const stages = new Set<string>();
    const plan = await marker([usualGarment], usual, {
      onLayout: (better) => plans.push(better),
      onProgress: ({stage, fraction}) => {
        stages.add(stage);
        expect(fraction).toBeGreaterThanOrEqual(0);
        expect(fraction).toBeLessThanOrEqual(1);
      },
    });
    const lengths = plans.map(({lengthCm}) => lengthCm);
    expect(lengths.length).toBeGreaterThan(0);
    expect(lengths.at(-1)).toBeCloseTo(plan.lengthCm, 9);
    expect([...lengths].sort((a, b) => b - a)).toEqual(lengths);
    expect(stages).toContain('done');
    expect(
      planComplaints({...plans[0], phases: plan.phases} as LayPlan, [usualGarment], rules).filter(
        (complaint) => !/phase|takes/.test(complaint),
      ),
    ).toEqual([]);
  });

  it('ends when nobody wants it any more', async () => {
    const controller = new AbortController();
    const laying = marker(
      [usualGarment],
      {...usual, effort: 50},
      {
        signal: controller.signal,
        onLayout: () => {
          controller.abort(new Error('enough'));
        },
      },
    );
    await expect(laying).rejects.toThrow('enough');
    await expect(marker([usualGarment], usual, {signal: controller.signal})).rejects.toThrow(
      'enough',
    );
  });
});

describe('says in one sentence', () => {
  const refused = (result: SolveResult, settings: Partial<MarkerSettings>) =>
    marker([result], {...usual, ...settings}).then(
      () => '',
      (error: unknown) => String(error),
    );

  it('which piece is wider than the fabric, and what it needs', async () => {
    const sentence = await refused(tee, {widthCm: 60});
    expect(sentence).toMatch(/front|back/);
    expect(sentence).toMatch(/at least \d+(\.\d)? cm/);
  });

  it('which piece fits nowhere', async () => {
    const wide = resultOf({...print, w1: [50, 0], w2: [0, 50]}, [rectangle('front', 60, 20)]);
    expect(await refused(wide, {widthCm: 70, phaseCm: 30})).toContain('front');
  });
});
