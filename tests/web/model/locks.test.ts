/** Locked pieces and edges, with their mirror images. */
import {describe, expect, it} from 'vitest';

import {decisions} from '@/model/design/read-design.js';
import {isKept, keptParts, toggledLock, type LockablePattern} from '@/model/design/locks.js';
import {squarePiece} from '../../support/garments/two-squares.js';

/**
 * Squares of four edges each, counter-clockwise from the lower one, two of which are a pair that
 * mirrors left and right.
 */
const square = (name: string): LockablePattern['pieces'][number] => ({
  ...squarePiece(name),
  edges: [0, 1, 2, 3],
});
const pairs = [
  [0, 1],
  [1, 0],
  [2, 3],
  [3, 2],
] as const;
const map = {angle: 0, translation: [4, 0]} as const;
const pattern: LockablePattern = {
  pieces: [square('left'), square('right'), square('front'), square('collar')],
  symmetries: [
    {kind: 'pair', pieces: [0, 1], map, pairs},
    {kind: 'piece', piece: 2, map, pairs},
  ],
};

describe('what is kept', () => {
  it('is nothing without a lock', () => {
    for (const {whole, edges} of keptParts(pattern, undefined)) {
      expect([whole, edges.size]).toEqual([false, 0]);
    }
  });

  it('has its mirror image kept as well, on the twin or on the same piece', () => {
    const parts = keptParts(pattern, {left: [1], front: [0, 3], collar: [2]});
    expect(parts.map(({edges}) => [...edges].sort())).toEqual([[1], [3], [0, 1, 3], [2]]);
    expect(keptParts(pattern, {right: [3]})[0]?.edges).toEqual(new Set([1]));
  });

  it('is all of a piece and all of its twin', () => {
    const parts = keptParts(pattern, {right: true});
    expect(parts.map(({whole}) => whole)).toEqual([true, true, false, false]);
    expect(isKept(parts, {piece: 0, edge: 2})).toBe(true);
  });
});

describe('a click', () => {
  it('keeps an edge, and the next one lets it go', () => {
    const once = toggledLock({maxChangeCm: 1}, pattern, {piece: 3, edge: 2});
    expect(once).toEqual({maxChangeCm: 1, locked: {collar: [2]}});
    expect(toggledLock(once, pattern, {piece: 3, edge: 2})).toEqual({maxChangeCm: 1});
  });

  it('lets go what is kept as the mirror image of another', () => {
    const options = {locked: {left: [1, 0]}};
    expect(toggledLock(options, pattern, {piece: 1, edge: 3})).toEqual({locked: {left: [0]}});
    expect(toggledLock({locked: {left: true}}, pattern, {piece: 1})).toEqual({});
  });

  it('lets a single edge of a whole piece go, with its image', () => {
    const options = {locked: {front: true}} as const;
    expect(toggledLock(options, pattern, {piece: 2, edge: 1})).toEqual({locked: {front: [0, 2]}});
    expect(toggledLock(options, pattern, {piece: 2, edge: 0})).toEqual({
      locked: {front: [1, 2, 3]},
    });
  });

  it('keeps all of a piece of which some edges were kept', () => {
    const options = {locked: {collar: [2]}};
    expect(toggledLock(options, pattern, {piece: 3})).toEqual({locked: {collar: true}});
  });
});

describe('locks of a file', () => {
  const read = (options: object): unknown =>
    decisions({symmetries: [], method: 'best', options}, '').options;

  it('are read as they were written', () => {
    const options = {locked: {front: true, back: [0, 3]}, openEdges: 'free'};
    expect(read(options)).toEqual(options);
  });

  it.each([
    [{locked: {front: false}}, 'options.locked.front'],
    [{locked: {front: [-1]}}, 'options.locked.front[0]'],
    [{locked: ['front']}, 'options.locked'],
    [{openEdges: 'open'}, 'options.openEdges'],
  ])('are refused with their name when they are none: %j', (options, name) => {
    expect(() => read(options)).toThrow(name);
  });
});
