/** Permitted places of pieces on printed fabric, and their obstacles. */
import {apply, determinant} from '@/model/geometry/plane-map.js';
import fc from 'fast-check';
import {describe, expect, it} from 'vitest';

import {areApart, ringOf} from '@/marker/apart.js';
import {countedRepeats} from '@/marker/counted-repeats.js';
import {
  apartFrom,
  isFree,
  obstaclesTo,
  onFrom,
  Places,
  turnAfter,
  turnsOf,
  turnedInPlace,
  usedLength,
  type Bolt,
  type LaidPiece,
  type LayablePiece,
} from '@/marker/places.js';
import {
  distance,
  minus,
  onPiece,
  onPrint,
  plus,
  rotated,
  type Point,
} from '@/model/geometry/vectors.js';
import {boxOf, distanceTo, isInside} from '@/model/geometry/polyline.js';
import {groupNames} from '@/model/base/core-tables.js';
import {latticeVectors} from '@/model/print/repeat.js';
import {latticeType, printElements, reduced} from '@/model/print/wallpaper.js';

/** An outline like that of a sleeve: wavy, nowhere straight. */
const wavy = (radius: number, count = 200): readonly Point[] =>
  Array.from({length: count}, (_, k) => {
    const angle = (2 * Math.PI * k) / count;
    return rotated([radius * (1 + 0.2 * Math.cos(3 * angle)), 0], angle);
  });

const piece = (more: Partial<LayablePiece> = {}): LayablePiece => ({
  outline: [
    [0, 0],
    [18, 0],
    [18, 28],
    [4, 28],
  ],
  alignment: {angle: 0, translation: [0, 0]},
  turns: 'half',
  up: [0, 1],
  shifts: [],
  ...more,
});

const bolt = (more: Partial<Bolt> = {}): Bolt => ({
  repeat: {group: 'p2', w1: [10, 0], w2: [0, 10]},
  origin: [3, 2],
  widthCm: 110,
  selvedgeCm: 1,
  gapCm: 0.2,
  isOneWay: false,
  flaws: [],
  ...more,
});

describe('the places of a piece on printed fabric', () => {
  it.each(groupNames)(
    'show it the same print, by one symmetry that mirrors nothing: %s',
    (group) => {
      const sides = {oblique: [9, 11, 80], rectangular: [9, 14, 90], square: [9, 9, 90]} as const;
      const type = latticeType(group);
      const [width, height, angleDeg] =
        type === 'oblique' || type === 'rectangular' ? sides[type] : sides.square;
      const [w1, w2] = latticeVectors(group, {width, height, angleDeg}, 20, 'primitive');
      const repeat = {group, w1, w2};
      const laid: LaidPiece = {
        piece: piece({turns: 'any', alignment: {angle: 0.4, translation: [5, -3]}}),
        place: {angle: 0, translation: [40, 0]},
      };
      const fabric = bolt({repeat});
      const turns = turnsOf(laid.piece, fabric);
      const proper = printElements(repeat).filter((element) => determinant(element) > 0);
      expect(turns).toHaveLength(proper.length);
      for (const turn of turns) {
        const {all} = new Places([laid], 0, turn, fabric);
        expect(all.length).toBeGreaterThan(10);
        for (const translation of all.slice(0, 20)) {
          const seen = laid.piece.outline.map((p) =>
            minus(onPiece({angle: turn.angle, translation}, p), fabric.origin),
          );
          const meant = laid.piece.outline.map((p) => onPrint(laid.piece.alignment, p));
          const missed = proper.map((element) =>
            Math.max(
              ...meant.map((w, k) =>
                Math.hypot(...reduced(repeat, minus(seen[k] ?? [0, 0], apply(element, w)))),
              ),
            ),
          );
          expect(Math.min(...missed)).toBeLessThan(1e-6);
        }
      }
    },
  );

  it('are those on the fabric, between its selvedges', () => {
    const fabric = bolt();
    const laid: LaidPiece = {piece: piece(), place: {angle: 0, translation: [3, 2]}};
    const [turn] = turnsOf(laid.piece, fabric);
    if (!turn) throw new Error('It has no turn.');
    const places = new Places([laid], 0, turn, fabric);
    const columns = new Set(places.all.map(([x]) => Math.round(x)));
    expect([...columns].sort((a, b) => a - b)).toEqual([3, 13, 23, 33, 43, 53, 63, 73, 83]);
    expect(Math.min(...places.all.map(([, y]) => y))).toBeCloseTo(2);
  });

  it('are as many turns as grain and direction allow', () => {
    const angles = (more: Partial<LayablePiece>, fabric: Partial<Bolt>): number[] =>
      turnsOf(piece(more), bolt(fabric)).map(({angle}) => Math.round((angle * 180) / Math.PI));
    const square = {group: 'p4', w1: [10, 0], w2: [0, 10]} as const;
    expect(angles({}, {repeat: square})).toEqual([0, 180]);
    expect(angles({turns: 'quarter'}, {repeat: square}).sort((a, b) => a - b)).toEqual([
      -90, 0, 90, 180,
    ]);
    expect(angles({}, {isOneWay: true})).toEqual([0]);
    expect(angles({up: [0, -1]}, {isOneWay: true})).toEqual([180]);
    expect(angles({}, {repeat: {...square, group: 'p1'}})).toEqual([0]);
  });

  it('take in shifts of the print that fit as well', () => {
    const fabric = bolt({repeat: {group: 'p1', w1: [10, 0], w2: [0, 10]}});
    const [turn] = turnsOf(piece({shifts: [[0, 5]]}), fabric);
    expect(turn?.bases).toEqual([
      [3, 2],
      [3, 7],
    ]);
  });
});

describe('what is in the way', () => {
  const fabric = bolt();
  const at = (x: number, y: number): LaidPiece => ({
    piece: piece(),
    place: {angle: 0, translation: [x, y]},
  });

  it('is another piece nearer than the gap, a flaw, an edge', () => {
    const laid = [at(3, 2), at(23, 2)];
    const to = (x: number, y: number, more: Partial<Bolt> = {}) =>
      obstaclesTo(laid, 0, {angle: 0, translation: [x, y]}, {...fabric, ...more});
    expect(isFree(to(3, 2))).toBe(true);
    expect(to(13, 2).pieces).toEqual([1]);
    expect(to(4.9, 2).pieces).toEqual([1]); // 0.1 cm apart
    expect(isFree(to(4.9, 2, {gapCm: 0}))).toBe(true);
    expect(to(0.5, 2).isOutside).toBe(true);
    expect(to(3, -1).isOutside).toBe(true);
    const hole = [
      [6, 5],
      [8, 5],
      [8, 7],
      [6, 7],
    ] as const;
    expect(to(3, 2, {flaws: [hole]}).flaws).toEqual([0]);
    expect(to(43, 2, {flaws: [hole]}).flaws).toEqual([]);
  });

  it('is a piece that lies within another, or right on it', () => {
    const small = piece({
      outline: [
        [0, 0],
        [2, 0],
        [2, 2],
        [0, 2],
      ],
    });
    const laid = [{piece: small, place: {angle: 0, translation: [15, 10] as const}}, at(3, 2)];
    const to = (k: number) =>
      obstaclesTo(laid, k, laid[k]?.place ?? {angle: 0, translation: [0, 0]}, {
        ...fabric,
        gapCm: 0,
      });
    expect(to(0).pieces).toEqual([1]);
    expect(to(1).pieces).toEqual([0]);
    const twins = [at(3, 2), at(3, 2)];
    expect(obstaclesTo(twins, 0, at(3, 2).place, {...fabric, gapCm: 0}).pieces).toEqual([1]);
  });

  it('is told as sampling the outlines finely tells it', () => {
    const one = wavy(10, 60);
    const other = wavy(7, 50);
    const [a, b] = [ringOf(one), ringOf(other)];
    const finely = (loop: readonly Point[]): readonly Point[] =>
      loop.flatMap((p, k) => {
        const q = loop[(k + 1) % loop.length] ?? p;
        return Array.from({length: 12}, (_, n) => plus(p, minus(q, p), n / 12));
      });
    const samples = finely(other);
    fc.assert(
      fc.property(
        fc.double({min: 0, max: 7, noNaN: true}),
        fc.double({min: 0, max: 26, noNaN: true}),
        fc.constantFrom(0.2, 1),
        (angle, far, gap) => {
          const shift = rotated([far, 0], angle);
          const moved = samples.map((p) => plus(p, shift));
          const inside =
            moved.some((p) => isInside(one, p)) ||
            one.some((p) => isInside(other, minus(p, shift)));
          const least = inside ? 0 : Math.min(...moved.map((p) => distanceTo(one, p)));
          if (Math.abs(least - gap) < 0.05) return; // within the sampling error
          expect(areApart(a, b, shift, gap)).toBe(least > gap);
          expect(areApart(b, a, minus([0, 0], shift), gap)).toBe(least > gap);
        },
      ),
      {numRuns: 300},
    );
  });
});

describe('a piece that is moved', () => {
  const fabric = bolt();
  const laid: readonly LaidPiece[] = [
    {piece: piece(), place: {angle: 0, translation: [3, 2]}},
    {piece: piece(), place: {angle: 0, translation: [23, 2]}},
  ];
  const places = (k: number): Places => {
    const [turn] = turnsOf(piece(), fabric);
    if (!turn) throw new Error('It has no turn.');
    return new Places(laid, k, turn, fabric);
  };

  it('goes to the nearest free place, or to the nearest', () => {
    expect(places(0).least(apartFrom([24, 3]))).toEqual([43, 2]);
    expect(places(0).leastOfAll(apartFrom([24, 3]))).toEqual([23, 2]);
    expect(places(0).least(apartFrom([5, 31]))).toEqual([3, 32]);
  });

  it('goes on in a direction, past what is in the way', () => {
    expect(places(0).least(onFrom([3, 2], [1, 0]))).toEqual([43, 2]);
    expect(places(1).least(onFrom([23, 2], [1, 0]))).toEqual([33, 2]);
    expect(places(0).least(onFrom([3, 2], [0, 1]))).toEqual([3, 12]);
    expect(places(0).least(onFrom([3, 2], [-1, 0]))).toBeUndefined();
    expect(places(0).least(onFrom([3, 2], [0, -1]))).toBeUndefined();
  });

  it('turns in place, one turn after the other', () => {
    const turns = turnsOf(
      piece({turns: 'any'}),
      bolt({repeat: {group: 'p4', w1: [10, 0], w2: [0, 10]}}),
    );
    let angle = 0;
    const seen = turns.map(() => {
      angle = turnAfter(turns, angle)?.angle ?? 0;
      return Math.round((angle * 180) / Math.PI);
    });
    expect(seen).toEqual([90, 180, -90, 0]);
    const [first] = laid;
    if (!first) throw new Error('Nothing is laid.');
    const turned = turnedInPlace(first, Math.PI);
    const middle = (angle: number, at: Point): Point => {
      const {low, high} = boxOf(first.piece.outline.map((p) => plus(rotated(p, angle), at)));
      return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
    };
    expect(distance(middle(Math.PI, turned), middle(0, first.place.translation))).toBeLessThan(
      1e-9,
    );
  });

  it('uses as much fabric as it reaches', () => {
    expect(usedLength(laid)).toBeCloseTo(30);
    expect(usedLength([])).toBe(0);
  });
});

describe('how a place is said', () => {
  it('counts repeats from the left selvedge and from the start', () => {
    expect(countedRepeats([3, 2], bolt())).toEqual({across: 2, along: 2});
    expect(countedRepeats([1, 0], bolt())).toEqual({across: 1, along: 1});
    expect(countedRepeats([23.5, 12.5], bolt())).toEqual({across: 4, along: 3});
    const centred = bolt({repeat: {group: 'cm', w1: [5, -5], w2: [5, 5], cell: 'rectangular'}});
    expect(countedRepeats([13, 2], centred)).toEqual({across: 3, along: 2});
  });

  it('has nothing to count where the print lies aslant, or repeats too often', () => {
    expect(countedRepeats([3, 2], bolt({repeat: {group: 'pmm', w1: [10, 0], w2: [0, 0.5]}}))).toBe(
      undefined,
    );
    expect(countedRepeats([3, 2], bolt({repeat: {group: 'p2', w1: [9, 1], w2: [-1, 9]}}))).toBe(
      undefined,
    );
  });
});
