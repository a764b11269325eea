/** Keyboard moves of a piece in the layout: its new place, the distance, and scrolling. */
import {describe, expect, it} from 'vitest';

import {canTurn, placeOn, placeTurned, reachOfPinned} from '@/workbench/marker/marker-moves.js';
import {missed} from '@/editor/marker/marker-pane.js';
import {isFree, obstaclesTo, type Bolt} from '@/marker/places.js';
import type {Alignment, Point} from '@/model/geometry/vectors.js';
import type {PieceOnFabric} from '@/workbench/marker/marker-work.js';
import {at} from '../../../support/plane.js';

/** Fabric for squares of 8 cm, with places every 4 cm: neighbours need every second one. */
const bolt: Bolt = {
  ...{repeat: {group: 'p2', w1: [4, 0], w2: [0, 4]}, origin: [0, 0], flaws: []},
  ...{widthCm: 60, selvedgeCm: 0, gapCm: 0, isOneWay: false},
};

const square = (number: number, translation: Point, width = 8): PieceOnFabric => ({
  ...{number, garment: 0, name: `square ${number}`},
  place: {angle: 0, translation},
  piece: {
    outline: [
      [0, 0],
      [width, 0],
      [width, 8],
      [0, 8],
    ],
    ...{alignment: {angle: 0, translation: [0, 0]}, turns: 'half', up: [0, 1], shifts: []},
  },
});

const onWay = (pieces: readonly PieceOnFabric[], way: Point, takes = false) =>
  placeOn(pieces, at(pieces, 0), bolt, way, takes);

const wasAt = ({place}: {readonly place: Alignment}) => place.translation;

describe('an arrow', () => {
  it('moves a piece to the place next to it, of which nothing is to be told', () => {
    expect(onWay([square(0, [0, 0])], [1, 0])).toEqual({
      ...{place: {angle: 0, translation: [4, 0]}, fartherCm: undefined},
    });
  });

  it('moves it beyond what is in its way, and tells how far', () => {
    const pieces = [square(0, [0, 0]), square(1, [8, 0])];
    const moved = onWay(pieces, [1, 0]);
    expect(moved && wasAt(moved)).toEqual([16, 0]);
    expect(moved?.fartherCm).toBeCloseTo(16);
    const onto = onWay(pieces, [1, 0], true);
    expect(onto && wasAt(onto)).toEqual([4, 0]);
    expect(onto?.fartherCm).toBeUndefined();
  });
});

describe('a turn', () => {
  const first = square(0, [3, 3]);
  /** A turn moves it two centimetres from its old place, in either direction. */
  const own = {
    ...first,
    piece: {...first.piece, alignment: {angle: 0, translation: [1, 1]}},
  } as const;
  const turned = (others: readonly PieceOnFabric[], reach: number) =>
    placeTurned([own, ...others], own, bolt, {takes: false, reach});

  it('goes to the nearest free place', () => {
    const move = turned([], reachOfPinned(bolt));
    expect(move?.place.angle).toBeCloseTo(Math.PI);
    expect(move?.fartherCm).toBeUndefined();
    // its old place was from 3 to 11
    for (const x of move?.place.translation ?? []) expect([9, 13]).toContain(Math.round(x));
    const beside = turned([square(1, [11, 3])], reachOfPinned(bolt));
    expect(beside?.place.translation[0]).toBeCloseTo(9);
  });

  it('goes no further than a pinned piece may, where all is taken there', () => {
    const others = [
      ...[square(1, [11, 3], 20), square(2, [0, 3], 3)],
      ...[11, 19, 27].map((y, k) => square(3 + k, [0, y], 60)),
    ];
    expect(turned(others, reachOfPinned(bolt))).toBeUndefined();
    const far = turned(others, Infinity);
    if (!far) throw new Error('It has gone nowhere.');
    expect(far.fartherCm).toBeGreaterThan(25);
    expect(isFree(obstaclesTo([own, ...others], 0, far.place, bolt))).toBe(true);
  });

  it('reaches over one repeat, or a hand', () => {
    expect(reachOfPinned(bolt)).toBe(10);
    const wide: Bolt = {...bolt, repeat: {group: 'p2', w1: [32, 0], w2: [0, 20]}};
    expect(reachOfPinned(wide)).toBe(32);
  });

  it('is none where the print lies one way only', () => {
    expect(canTurn(square(0, [0, 0]), bolt)).toBe(true);
    const oneWay: Bolt = {...bolt, repeat: {...bolt.repeat, group: 'p1'}};
    expect(canTurn(square(0, [0, 0]), oneWay)).toBe(false);
  });
});

it('scrolls by as little as brings a stretch into sight', () => {
  expect(missed(10, 20, 0, 100)).toBe(0);
  expect(missed(-30, 20, 0, 100)).toBe(-30);
  expect(missed(90, 130, 0, 100)).toBe(30);
  expect(missed(-10, 130, 0, 100)).toBe(0); // it fills the view
  expect(missed(90, 300, 0, 100)).toBe(90);
});
