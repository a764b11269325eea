import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import type {Pattern, ResultPiece} from '@/model/result/result.js';
import {ontoSheet} from '@/model/geometry/sheet-place.js';
import {layOut, layOutNamed, type Layout} from '@/layout/layout.js';
import type {Placement} from '@/model/garment/garment-document.js';
import type {Placements} from '@/layout/on-body.js';
import {plainPrint as print, squarePiece} from '../../support/garments/two-squares.js';

/** A rectangle with its middle at `at`. */
function block(name: string, width: number, height: number, at: Point = [0, 0]): ResultPiece {
  const [x, y] = [width / 2, height / 2];
  const rest: Point[] = [
    [at[0] - x, at[1] - y],
    [at[0] + x, at[1] - y],
    [at[0] + x, at[1] + y],
    [at[0] - x, at[1] + y],
  ];
  return squarePiece(name, {rest, shape: rest});
}

const patternOf = (pieces: readonly ResultPiece[]): Pattern => ({
  ...{print, pieces, seams: [], symmetries: []},
});
const bare = {gap: 2, below: () => 1, least: () => 0};

/** Middles of the pieces on the sheet, by name. */
const middles = ({pieces}: Pattern, {places}: Layout): Readonly<Record<string, Point>> =>
  Object.fromEntries(
    pieces.map(({name, rest}, k) => {
      const [[x0, y0] = [NaN, NaN], , [x1, y1] = [NaN, NaN]] = rest;
      const [dx, dy] = places[k]?.offset ?? [NaN, NaN];
      return [name, [(x0 + x1) / 2 + dx, (y0 + y1) / 2 + dy]];
    }),
  );

const shirt = patternOf([
  block('cuff_left', 20, 6),
  block('back_left', 25, 60, [-12, 0]),
  block('sleeve_left', 30, 40),
  block('front', 50, 60),
  block('cuff_right', 20, 6),
  block('yoke', 40, 12, [0, 40]),
  block('sleeve_right', 30, 40),
  block('back_right', 25, 60, [12, 0]),
]);
const onBody: Placements = new Map([
  ['front', {translation: [0, 110, 20], rotation: [0, 0, 0]}],
  ['back_left', {translation: [2, 110, -20], rotation: [0, 180, 0]}],
  ['back_right', {translation: [-2, 110, -20], rotation: [0, 180, 0]}],
  ['yoke', {translation: [0, 110, -20], rotation: [0, 180, 0]}],
  ['sleeve_left', {translation: [40, 130, 0], rotation: [0, 90, 45]}],
  ['sleeve_right', {translation: [-40, 130, 0], rotation: [0, -90, -45]}],
  ['cuff_left', {translation: [70, 100, 0], rotation: [0, 90, 45]}],
  ['cuff_right', {translation: [-70, 100, 0], rotation: [0, -90, -45]}],
]);

describe('pieces that a garment places on the body', () => {
  const at = middles(shirt, layOut(shirt, 1, bare, onBody));
  const x = (name: string): number => at[name]?.[0] ?? NaN;
  const y = (name: string): number => at[name]?.[1] ?? NaN;

  it('lie with the front between the sleeves, the left one on the right', () => {
    expect(x('sleeve_right')).toBeLessThan(x('front'));
    expect(x('front')).toBeLessThan(x('sleeve_left'));
    expect(Math.abs(y('sleeve_left') - y('front'))).toBeLessThan(30);
  });

  it('lie with the back below the front, as it is seen from behind', () => {
    expect(y('back_left')).toBeLessThan(y('front') - 60);
    expect(x('back_left')).toBeLessThan(x('back_right'));
    expect(y('yoke')).toBeGreaterThan(y('back_left') + 30);
  });

  it('lie with the small parts at the foot, the left one on the right', () => {
    expect(y('cuff_left')).toBeLessThan(y('back_left') - 30);
    expect(y('cuff_left')).toBe(y('cuff_right'));
    expect(x('cuff_right')).toBeLessThan(x('cuff_left'));
  });

  it('lie in one row on a wide sheet, and one below the other on a narrow one', () => {
    const wide = middles(shirt, layOut(shirt, 3, bare, onBody));
    expect(wide.back_left?.[0]).toBeGreaterThan(wide.sleeve_left?.[0] ?? NaN);
    const narrow = middles(shirt, layOut(shirt, 0.4, bare, onBody));
    expect(narrow.sleeve_left?.[1]).toBeLessThan(narrow.back_left?.[1] ?? NaN);
  });

  it('lie in a grid when they are pieced', () => {
    const names = ['a', 'b', 'c', 'd'];
    const pieces = names.map((name, k) =>
      block(name, 10, 10, [10 * (k % 2), 10 * Math.floor(k / 2)]),
    );
    const pieced = patternOf([...pieces, block('back', 20, 20)]);
    const placements: Placements = new Map([
      ...names.map((name): [string, Placement] => [name, {translation: [0, 100, 10]}]),
      ['back', {translation: [0, 100, -10], rotation: [0, 180, 0]}],
    ]);
    const {a, b, c, d} = middles(pieced, layOut(pieced, 1, bare, placements));
    expect([a?.[0], a?.[1]]).toEqual([c?.[0], b?.[1]]);
    expect((b?.[0] ?? NaN) - (a?.[0] ?? NaN)).toBe(12);
    expect((d?.[1] ?? NaN) - (b?.[1] ?? NaN)).toBe(11);
  });

  it('lie upright, halves that were drawn upside down as mirror images of the others', () => {
    const leaning: Point[] = [
      [0, 0],
      [10, 0],
      [4, 20],
    ];
    const left = squarePiece('hood_left', {rest: leaning, outline: [0, 1, 2]});
    const over = leaning.map(([px, py]): Point => [px, -py]).reverse(); // mirrored vertically
    const right = squarePiece('hood_right', {rest: over, outline: [0, 1, 2]});
    const hood = patternOf([left, right]);
    const placements: Placements = new Map([
      ['hood_left', {translation: [8, 150, 0], rotation: [0, 90, 0]}],
      ['hood_right', {translation: [-8, 150, 0], rotation: [0, 90, 180]}],
    ]);
    const {places, width} = layOut(hood, 2, bare, placements);
    expect(places.map(({isTurned}) => isTurned ?? false)).toEqual([false, true]);
    const [onLeft, onRight] = hood.pieces.map(({rest}, k) =>
      rest.map((point) => ontoSheet(places[k] ?? {offset: [NaN, NaN]}, point)),
    );
    expect(onRight?.toReversed()).toEqual(onLeft?.map(([px, py]) => [width - px, py]));
  });

  it('do not move when symmetries are imposed or the pattern is deformed', () => {
    const worked: Pattern = {
      ...shirt,
      pieces: shirt.pieces.map((piece) => ({
        ...piece,
        shape: piece.rest.map(([px, py]): Point => [1.02 * px, py]),
        alignment: {angle: 1, translation: [3, 4]},
      })),
      symmetries: [{kind: 'pair', pieces: [2, 6], map: {angle: 0, translation: [0, 0]}, pairs: []}],
    };
    expect(layOut(worked, 1.2, bare, onBody)).toEqual(layOut(shirt, 1.2, bare, onBody));
    expect(layOut(worked, 1.2, bare)).toEqual(layOut(shirt, 1.2, bare));
  });
});

describe('pieces that no placement tells apart', () => {
  const flat: Placements = new Map(
    shirt.pieces.map(({name}) => [name, {translation: [0, 0, 0]}] as const),
  );

  it('lie as on the body where names tell: sleeves beside the front', () => {
    const layout = layOut(shirt, 2, bare, flat);
    expect(layout).toEqual(layOut(shirt, 2, bare));
    const at = middles(shirt, layout);
    const [left = NaN, right = NaN, middle = NaN] = [at.sleeve_left, at.sleeve_right, at.front].map(
      (point) => point?.[0] ?? NaN,
    );
    expect(left).toBeGreaterThan(middle);
    expect(right).toBeLessThan(middle);
  });

  it('stand on shelves otherwise, pairs by name side by side with the right one first', () => {
    const names = ['one', 'two', 'three', 'four', 'five'];
    const nameless = {
      ...shirt,
      pieces: shirt.pieces.map((piece, k) =>
        piece.name.startsWith('sleeve_') ? piece : {...piece, name: names[k] ?? `${k}`},
      ),
    };
    const at = middles(nameless, layOut(nameless, 2, bare, flat));
    expect(at.sleeve_left?.[1]).toBe(at.sleeve_right?.[1]);
    expect((at.sleeve_left?.[0] ?? NaN) - (at.sleeve_right?.[0] ?? NaN)).toBe(32);
  });

  it('are kept apart by the gap asked for', () => {
    const pair = patternOf([squarePiece('one'), squarePiece('two')]);
    const {places, width} = layOut(pair, 3, bare);
    expect(Math.abs((places[0]?.offset[0] ?? NaN) - (places[1]?.offset[0] ?? NaN))).toBe(6);
    expect(width).toBe(10);
  });

  it('are given room for their names', () => {
    const pair = patternOf([squarePiece('one'), squarePiece('two')]);
    expect(layOut(pair, 3, {...bare, least: () => 9}).width).toBe(20);
  });
});

describe('a page with names', () => {
  const page = {width: 400, height: 300, greatestScale: 50, gap: 10, nameWidth: () => 90};

  it('is filled at the scale at which every name has its room', () => {
    const pair = patternOf([squarePiece('one'), squarePiece('two')]);
    const {layout, scale} = layOutNamed(pair, {...page, nameHeight: () => 20});
    expect(scale).toBeCloseTo((400 - 10) / 8, 1); // two squares of 4 cm and a gap
    expect(layout.height * scale).toBeCloseTo(4 * scale + 20, 0);
  });

  it('makes pieces smaller rather than names', () => {
    const crowd = patternOf(Array.from({length: 16}, (_, k) => squarePiece(`piece ${k}`)));
    const {layout, scale} = layOutNamed(crowd, {...page, nameHeight: () => 40});
    expect(layout.width * scale).toBeLessThanOrEqual(400 + 1e-6);
    expect(layout.height * scale).toBeLessThanOrEqual(300 + 1e-6);
    const rows = new Set(layout.places.map(({offset: [, y]}) => y.toFixed(6))).size;
    expect(layout.height * scale).toBeGreaterThanOrEqual(rows * (4 * scale + 40) - 1e-6);
  });
});

it('leaves twins where they are that have been meshed anew', () => {
  const placesOf = (first: number, second: number): readonly (readonly number[])[] => {
    const pattern = patternOf([
      block('front', 50, 60),
      block('sleeve', 30, first),
      block('sleeve 2', 30, second),
    ]);
    const at = Object.values(middles(pattern, layOut(pattern, 1.6, bare)));
    return at.map((middle) => middle.map(Math.round));
  };
  expect(placesOf(40.1, 40.09)).toEqual(placesOf(40.1, 40.1));
  expect(placesOf(40.09, 40.1)).toEqual(placesOf(40.1, 40.1));
});
