/** The workbench's handling of pins, locks and options that a garment cannot have. */
import {describe, expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {MeshedPattern} from '@/model/result/result.js';
import {cleanedOptions} from '@/workbench/cleaned-options.js';
import {askedOf, keptLines, withKeptPins} from '@/workbench/kept-pins.js';
import {bareFabric, newDesign} from '@/workbench/samples.js';
import {squarePair} from '../../support/garments/two-squares.js';

const plain = squarePair();
const pattern: MeshedPattern = {
  ...plain,
  pieces: plain.pieces.map((piece) => ({...piece, edges: [0, 1, 2, 3]})),
  fitRandom: 1,
  notes: [],
};

describe('options of another garment', () => {
  it('lose pieces, seams and edges that this one has not', () => {
    const pin = {angle: 0, translation: [0, 0]} as const;
    expect(
      cleanedOptions(
        {
          maxChangeCm: 1,
          pins: {left_half: pin, hood: pin},
          plain: ['hood'],
          locked: {hood: true, left_half: [1, 9], right_half: [9]},
          weights: {0: 2, 5: 3},
          unmatched: [0, 7],
          grain: {default: 'on', pieces: {hood: 'free', right_half: 'bias'}},
        },
        pattern,
      ),
    ).toEqual({
      maxChangeCm: 1,
      pins: {left_half: pin},
      plain: [],
      locked: {left_half: [1]},
      weights: {0: 2},
      unmatched: [0],
      grain: {default: 'on', pieces: {right_half: 'bias'}},
    });
  });

  it('stay the very same where there is nothing to lose', () => {
    const options = {plain: ['left_half'], locked: {right_half: true}} as const;
    expect(cleanedOptions(options, pattern)).toBe(options);
  });
});

describe('lines of what is kept', () => {
  it('run along neighbouring edges, sewn ones apart from open ones', () => {
    expect(keptLines(pattern, {left_half: [0, 1], right_half: [1]})).toEqual([
      {piece: 0, vertices: [0, 1], isSewn: false},
      {piece: 0, vertices: [1, 2], isSewn: true},
      {piece: 1, vertices: [1, 2], isSewn: false},
    ]);
  });

  it('run across the place where the outline is numbered from', () => {
    expect(keptLines(pattern, {right_half: [0, 1, 2]})).toEqual([
      {piece: 1, vertices: [0, 1, 2, 3], isSewn: false},
    ]);
    expect(keptLines(pattern, {left_half: [3, 0]})).toEqual([
      {piece: 0, vertices: [3, 0, 1], isSewn: false},
    ]);
  });

  it('are none without a lock', () => {
    expect(keptLines(pattern, undefined)).toBeUndefined();
    expect(keptLines(pattern, {})).toBeUndefined();
  });
});

describe('a design with pins', () => {
  /** x -> 4 - x on a print of 10 x 10 cm with mirrors along its sides. */
  const own = {pieces: ['left_half', 'left_half'], map: {angle: 0, translation: [4, 0]}} as const;
  const pinned = (x: number): Design => {
    const design = newDesign({name: 'squares.json', text: '{}'}, {...bareFabric, group: 'pmm'});
    const pins = {left_half: {angle: 0, translation: [x, 3]}} as const;
    return {...design, options: {...design.options, pins}};
  };

  it('has the pin of a symmetric piece moved onto a mirror line', () => {
    const {options} = withKeptPins(pinned(2.4), pattern, [own]);
    expect(options.pins?.left_half?.translation[0]).toBeCloseTo(2, 9);
    expect(options.pins?.left_half?.translation[1]).toBeCloseTo(3, 9);
    expect(options.maxChangeCm).toBe(1);
  });

  it('stays the very same when all pins are good, or no symmetry concerns them', () => {
    const good = pinned(2);
    expect(withKeptPins(good, pattern, [own])).toBe(good);
    const free = pinned(2.4);
    expect(withKeptPins(free, pattern, askedOf(free, [own]))).toBe(free);
  });
});
