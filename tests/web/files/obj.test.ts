import {describe, expect, it} from 'vitest';

import {tracedLoop} from '@/files/base/bezier.js';
import {readObj} from '@/files/obj/read-obj.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import type {Drawing} from '@/model/garment/imported-drawing.js';
import {boxOf, signedArea} from '@/model/geometry/polyline.js';

import {tunic, type MeshHabits} from '../../support/files/drawn-mesh.js';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const read = (text: string): Drawing => readObj(bytesOf(text), 'garment.obj');

const areas = (drawing: Drawing): number[] =>
  drawing.pieces.map(({sewn}) => Math.abs(signedArea(tracedLoop(sewn, 1e-4))));

/** Area of 50 x 60 cm less half a round neck of 10 cm, as twelve chords. [m2] */
const area = 0.3 - 0.5 * 12 * 0.01 * Math.sin(Math.PI / 12);

describe('the pieces of an OBJ file', () => {
  it('are what hangs together in the texture, in true size', () => {
    const drawing = read(tunic());
    expect(drawing).toMatchObject({kind: 'obj', unit: {unit: 'm', because: 'size'}});
    expect(areas(drawing)).toHaveLength(2);
    // the curve of the neck is drawn through its points, and bulges beyond the chords
    for (const one of areas(drawing)) expect(Math.abs(one - area)).toBeLessThan(4e-4);
    const [{sewn} = {sewn: []}] = drawing.pieces;
    const {low, high} = boxOf(tracedLoop(sewn, 1e-4));
    expect([high[0] - low[0], high[1] - low[1]]).toEqual([
      expect.closeTo(0.5, 5),
      expect.closeTo(0.6, 5),
    ]);
  });

  it('are sewn where the mesh is, from corner to corner', () => {
    const drawing = read(tunic());
    expect(drawing.pieces.map(({sewn}) => sewn.length)).toEqual([6, 6]);
    expect(drawing.seams).toHaveLength(4);
    for (const {a, b, sameDirection} of drawing.seams) {
      expect([a.piece, b.piece].sort()).toEqual([0, 1]);
      expect(sameDirection).toBe(false);
    }
    const {seams, pieces} = garmentOf(drawing, defaultChoices(drawing));
    const lengths = seams.map(({a, b}) =>
      [a, b].map(({piece, edge}) => {
        const {low, high} = boxOf(pieces[piece]?.outline[edge]?.points ?? []);
        return Math.hypot(high[0] - low[0], high[1] - low[1]);
      }),
    );
    expect(lengths.map(([a]) => Math.round(a ?? 0)).sort((a, b) => a - b)).toEqual([
      15, 15, 60, 60,
    ]);
    for (const [a = 0, b = 0] of lengths) expect(a).toBeCloseTo(b, 3);
  });

  it.each<readonly [string, MeshHabits]>([
    ['a texture coordinate for every corner', {unwelded: true}],
    ['indices that count back', {relative: true}],
    ['faces of many corners', {polygons: true}],
  ])('are the same with %s', (_, habits) => {
    const drawing = read(tunic(habits));
    const plain = read(tunic());
    expect(drawing.seams).toHaveLength(plain.seams.length);
    areas(plain).forEach((one, k) => {
      expect(areas(drawing)[k]).toBeCloseTo(one, 6);
    });
  });

  it('keep their size where the texture is in another unit, or was squeezed into a square', () => {
    for (const flatScale of [
      [100, 100],
      [0.4, 0.9],
    ] as const) {
      const all = areas(read(tunic({flatScale})));
      for (const one of all) expect(Math.abs(one / area - 1)).toBeLessThan(0.05);
    }
  });

  it('are called as their groups are, where each has its own', () => {
    expect(read(tunic({grouped: true})).pieces.map(({name}) => name)).toEqual(['front', 'back']);
    expect(read(tunic()).pieces.map(({name}) => name)).toEqual(['piece 1', 'piece 2']);
  });

  it('lie face up, whichever way the texture has them', () => {
    const drawing = read(tunic({mirrored: [1]}));
    expect(drawing.notes.join(' ')).toMatch(/turned over/);
    const plain = read(tunic());
    const sides = (one: Drawing): boolean[] =>
      one.pieces.map(({sewn}) => signedArea(tracedLoop(sewn, 1e-4)) > 0);
    expect(sides(drawing)).toEqual(sides(plain));
    expect(drawing.seams).toEqual(plain.seams);
  });
});
