import {describe, expect, it} from 'vitest';

import {collection} from '@samples/prints/collection.js';
import {elementsWithin} from '@samples/prints/elements.js';
import type {Cell} from '@samples/prints/tile.js';
import type {Point} from '@/model/geometry/vectors.js';
import {printDistance} from '@/model/print/wallpaper.js';

const cornersOf = ({w1, w2}: Cell): Point[] => [[0, 0], w1, [w1[0] + w2[0], w1[1] + w2[1]], w2];
const somewhere: Point = [0.317, 1.236];

describe.each(collection.map(({id, cell}) => [id, cell] as const))(
  'the symmetry elements drawn for %s',
  (_, cell) => {
    const {centres, axes} = elementsWithin(cell, cornersOf(cell));
    const distance = printDistance(cell);

    it('have centres about which the print may be turned by what their sign says, and by no less', () => {
      const turned = ([x, y]: Point, angle: number): Point => {
        const [dx, dy] = [somewhere[0] - x, somewhere[1] - y];
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        return [x + c * dx - s * dy, y + s * dx + c * dy];
      };
      for (const {at, order} of centres) {
        expect(distance(somewhere, turned(at, (2 * Math.PI) / order))).toBeCloseTo(0, 9);
        expect(distance(somewhere, turned(at, Math.PI / order))).toBeGreaterThan(0.01);
      }
    });

    it('have solid lines where the print is mirrored, and dashed ones where it is not', () => {
      for (const {from, to, glide} of axes) {
        const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        const aside =
          (dx * (somewhere[1] - from[1]) - dy * (somewhere[0] - from[0])) / (dx * dx + dy * dy);
        const image: Point = [somewhere[0] + 2 * dy * aside, somewhere[1] - 2 * dx * aside];
        if (glide) expect(distance(somewhere, image)).toBeGreaterThan(0.01);
        else expect(distance(somewhere, image)).toBeCloseTo(0, 9);
      }
    });
  },
);

// numbers in a closed cell, including corners and sides
it.each([
  ['p2', 9, 0, 0],
  ['pg', 0, 0, 3],
  ['p4m', 9, 8, 4],
  ['p4g', 9, 4, 6],
  ['p3', 6, 0, 0],
  ['p6m', 11, 10, 12],
] as const)(
  '%s has %i centres, %i mirrors and %i glides in its cell',
  (name, turns, solid, dashed) => {
    const cell = collection.find(({id}) => id === name)?.cell;
    if (!cell) throw new Error(`there is no ${name}`);
    const {centres, axes} = elementsWithin(cell, cornersOf(cell));
    const glides = axes.filter(({glide}) => glide).length;
    expect([centres.length, axes.length - glides, glides]).toEqual([turns, solid, dashed]);
  },
);
