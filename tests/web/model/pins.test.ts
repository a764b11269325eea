/** Pins of pieces that share symmetries. */
import {describe, expect, it} from 'vitest';

import type {Alignment} from '@/model/geometry/vectors.js';
import {
  contradictions,
  keptPins,
  mirroringsOf,
  nearestPlace,
  pinnedPlace,
  withPin,
  type Mirroring,
} from '@/model/design/pins.js';
import {mirrors} from '@/model/print/mirror-images.js';
import {squarePair} from '../../support/garments/two-squares.js';

const repeat = {group: 'pmm', w1: [10, 0], w2: [0, 8]} as const;
/** x -> 4 - x: the axis of the front is x = 2, in which the sleeves mirror, too. */
const map: Alignment = {angle: 0, translation: [4, 0]};
const front: Mirroring = {pieces: ['front', 'front'], map};
const sleeves: Mirroring = {pieces: ['left', 'right'], map};
const all = [front, sleeves];
const at = (x: number, y: number): Alignment => ({angle: 0, translation: [x, y]});
const facts = {middle: [2, 5]} as const;

it('names the pieces of a pattern’s symmetries', () => {
  const pattern = squarePair({
    symmetries: [
      {kind: 'pair', pieces: [0, 1], map, pairs: []},
      {kind: 'piece', piece: 1, map, pairs: []},
    ],
  });
  expect(mirroringsOf(pattern)).toEqual([
    {pieces: ['left_half', 'right_half'], map},
    {pieces: ['right_half', 'right_half'], map},
  ]);
});

describe('a piece that somebody drags', () => {
  it('goes along its axis as far as it is dragged, and across to the nearest mirror line', () => {
    const {translation} = nearestPlace(repeat, all, 'front', at(3, 1.7), facts);
    expect(translation[0]).toBeCloseTo(2, 9);
    expect(translation[1]).toBeCloseTo(1.7, 9);
    const over = nearestPlace(repeat, all, 'front', at(4.8, 1.7), facts);
    expect(over.translation[0]).toBeCloseTo(7, 9);
  });

  it('goes anywhere when it is one of a pair, and its twin’s pin gives way', () => {
    expect(nearestPlace(repeat, all, 'left', at(3.3, 1), facts)).toEqual(at(3.3, 1));
    const pins = {right: at(0, 0), front: at(2, 0)};
    expect(withPin(pins, all, 'left', at(3.3, 1))).toEqual({front: at(2, 0), left: at(3.3, 1)});
  });
});

it('shows the twin of a pinned piece as its mirror image', () => {
  const pins = {left: at(3.3, 1)};
  const image = pinnedPlace(repeat, all, pins, 'right', at(0, 0));
  expect(image && mirrors(repeat, map, pins.left, image)).toBe(true);
  const back = pinnedPlace(repeat, all, {right: at(3.3, 1)}, 'left', at(0, 0));
  expect(back && mirrors(repeat, map, back, at(3.3, 1))).toBe(true);
  expect(pinnedPlace(repeat, all, pins, 'front', at(0, 0))).toBeUndefined();
  expect(pinnedPlace(repeat, all, undefined, 'left', at(0, 0))).toBeUndefined();
});

it('moves only those pins that a symmetry is against', () => {
  const sound = {front: at(7, 3), left: at(1.234, 0)};
  expect(keptPins(repeat, all, sound, () => facts)).toBe(sound);
  const kept = keptPins(repeat, all, {...sound, front: at(6.4, 3)}, () => facts);
  expect(kept.front?.translation[0]).toBeCloseTo(7, 9);
  expect(kept.front?.translation[1]).toBeCloseTo(3, 9);
  expect(kept.left).toEqual(at(1.234, 0));
});

it('leaves a pin alone on a print that has no mirrors', () => {
  const pins = {front: at(6.4, 3)};
  expect(keptPins({...repeat, group: 'p2'}, all, pins, () => facts)).toBe(pins);
});

it('finds pairs whose pins contradict each other', () => {
  const image = pinnedPlace(repeat, all, {left: at(3.3, 1)}, 'right', at(0, 0)) ?? at(0, 0);
  expect(contradictions(repeat, all, {left: at(3.3, 1), right: image})).toEqual([]);
  expect(contradictions(repeat, all, {left: at(3.3, 1), right: at(0.1, 0)})).toEqual([sleeves]);
  expect(contradictions(repeat, all, {left: at(3.3, 1)})).toEqual([]);
});
