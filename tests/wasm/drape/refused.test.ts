/**
 * Results that cannot be draped: an error, or a drape with a note about its fault; the next drape
 * works.
 */
import {
  drape,
  solve,
  type SolverError,
  type DrapeSettings,
  type ResultPiece,
  type SolveResult,
} from 'seamwise/node';
import {beforeAll, describe, expect, it} from 'vitest';

import {isThorough, sampleOf} from '../../support/level.js';
import {at} from '../../support/plane.js';
import {checks, sample, shortSkirt} from '../../support/garments/samples.js';

let tee: SolveResult;
/** The garment of tests that need no sleeves; in a commit the one that is draped soonest. */
let usual: SolveResult;

beforeAll(async () => {
  tee = await solve({garment: sample('tee'), print: checks});
  usual = isThorough ? tee : await solve({garment: shortSkirt(), print: checks});
});

type Change = (result: SolveResult) => SolveResult;

const eachPiece =
  (change: (piece: ResultPiece, number: number) => object): Change =>
  (result) => ({
    ...result,
    pieces: result.pieces.map((piece, k) => ({...piece, ...change(piece, k)})),
  });

const larger = (factor: number): Change =>
  eachPiece(({rest, shape}) => ({
    rest: rest.map(([x, y]) => [factor * x, factor * y]),
    shape: shape.map(([x, y]) => [factor * x, factor * y]),
  }));

const movedBy = (y: number): Change =>
  eachPiece(({placement}) => {
    const [ahead = 0, up = 0, side = 0] = placement?.translation ?? [];
    return {placement: {...placement, translation: [ahead, up + y, side]}};
  });

const times =
  (count: number): Change =>
  (result) => {
    const {pieces, seams} = result;
    const copies = Array.from({length: count}, (_, k) => k);
    const shifted = (side: SolveResult['seams'][number]['a'], copy: number) => ({
      ...side,
      piece: side.piece + copy * pieces.length,
    });
    return {
      ...result,
      pieces: copies.flatMap((k) =>
        pieces.map((piece) => ({...piece, name: `${piece.name} ${k}`})),
      ),
      seams: copies.flatMap((k) =>
        seams.map((seam) => ({...seam, a: shifted(seam.a, k), b: shifted(seam.b, k)})),
      ),
      symmetries: [],
    };
  };

const nowhere = {translation: [0, 0, 0], rotation: [0, 0, 0]};

const refused: readonly [string, Change, string, reason?: string][] = [
  [
    'made before garments were worn',
    eachPiece(() => ({placement: undefined})),
    'align the garment again',
  ],
  [
    'of panels that are all at 0 and not sewn',
    (result) => ({...eachPiece(() => ({placement: nowhere}))(result), seams: []}),
    "No seam joins piece 'back' to the others",
    'drapeUnsewn',
  ],
  ['without a number', movedBy(NaN), 'write a number'],
  ['1e6 cm up', movedBy(1e6), 'is beyond 10000'],
  ['10 m up', movedBy(1000), 'is placed far from any body', 'drapeFar'],
  ['of pieces of 1e6 cm', larger(1e4), 'is beyond 10000 cm'],
  [
    'in the wrong unit',
    larger(10),
    'm2 of fabric, more than the 20 m2 that can be draped',
    'drapeTooLarge',
  ],
  [
    'of 200 pieces',
    times(50),
    'm2 of fabric, more than the 20 m2 that can be draped',
    'drapeTooLarge',
  ],
  ['cut to nothing', eachPiece(({shape}) => ({shape: shape.map(() => [0, 0])})), 'no area as cut'],
];

describe('refuses in one sentence a result', () => {
  it.each(refused)('%s', async (_, change, sentence, reason) => {
    const failure = await drape(JSON.stringify(change(tee))).then(
      () => undefined,
      (error: unknown) => error as SolverError,
    );
    expect(failure?.message).toContain(sentence);
    expect(failure?.reason).toBe(reason);
    expect(failure?.message).toMatch(/^[^`\n]*\.$/);
    expect(failure?.message.match(/\. /g)).toBeNull();
  });
});

const sleeve = 2;
/** Reverses the sleeve's side of each seam. */
const insideOut: Change = (result) => ({
  ...result,
  seams: result.seams.map((seam) => {
    const turned = (side: typeof seam.a) =>
      side.piece === sleeve ? {...side, vertices: side.vertices.toReversed()} : side;
    return {...seam, a: turned(seam.a), b: turned(seam.b)};
  }),
});

const torn: readonly [string, Change, DrapeSettings, string][] = [
  ['that is far too large', larger(2.5), {}, 'slides off the form'],
  ['that is too small for the form', (result) => result, {size: 'XL'}, 'cm at the hip (it fits'],
  // takes as long as all others
  ['with a sleeve sewn inside out', insideOut, {}, 'look at how its pieces are sewn'],
];

describe('shows no garment', () => {
  it.each(sampleOf(2, torn))('%s', async (_, change, settings, sentence) => {
    const failure = await drape(change(usual), settings).then(
      () => undefined,
      (error: unknown) => error as SolverError,
    );
    expect(failure?.message).toContain(sentence);
    const {lengthCm, measure, fits} = failure ?? {};
    expect(failure?.message.includes(' cm at the ')).toBe(lengthCm !== undefined);
    if (lengthCm === undefined) return;
    const girth = `${lengthCm.toFixed(1)} cm at the ${measure ?? ''}`;
    expect(failure?.message).toContain(`${girth} (it fits size ${fits ?? ''})`);
  });
});

it('says that pieces that are not sewn are still moving', async () => {
  const {notes, stages, positions} = await drape({...usual, seams: []});
  expect(notes.join(' ')).toContain('still moving');
  expect(positions.every(Number.isFinite)).toBe(true);
  // the last step may exceed the budget
  expect(stages.reduce((sum, {work}) => sum + work, 0)).toBeLessThan(180);
});

it(
  'does not take the band of gathers for a garment that is too small',
  {tags: ['thorough']},
  async () => {
    const skirt = await solve({garment: sample('gathered-skirt'), print: checks});
    const {check} = await drape(skirt, {fabric: 'denim'});
    expect(check.tension.p99).toBeGreaterThan(0.08); // beyond the limit for other fabric
    expect(check.fromRest).toBeLessThan(3);
    expect(check.atRest).toBe((check.fromRest ?? 1) <= 0.5);
  },
);

it('drapes the next one', async () => {
  const {check, notes} = await drape(usual);
  expect(notes).toEqual([]);
  expect(check.crossings).toBe(0);
  expect(at(tee.pieces, sleeve).name).toContain('sleeve');
});
