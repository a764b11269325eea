/** A skirt's box pleats, as seen from the front. */
import {drape, solve, type Drape, type Point} from 'seamwise/node';
import {expect, it} from 'vitest';

import {checks, sample} from '../../support/garments/samples.js';

/** Repeat of the print across the pleats. [cm] */
const repeat = 4;

const nth = (list: ArrayLike<number>, index: number): number => list[index] ?? NaN;

interface Seen {
  readonly piece: string;
  /** The point on the drafted piece. [cm] */
  readonly rest: Point;
}

/** Returns the visible point at (x, y) from the front. */
function seenAt({mesh, positions}: Drape, x: number, y: number): Seen {
  let nearest = -Infinity;
  let seen: Seen = {piece: '', rest: [NaN, NaN]};
  for (const {name, rest, sewn, triangles} of mesh.pieces)
    for (let k = 0; k < triangles.length; k += 3) {
      const corners = [0, 1, 2].map((i) => nth(triangles, k + i));
      const [p, q, r] = corners.map((v) => {
        const place = 3 * nth(sewn, v);
        return [0, 1, 2].map((c) => nth(positions, place + c)) as [number, number, number];
      }) as [[number, number, number], [number, number, number], [number, number, number]];
      const area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
      const b = ((x - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (y - p[1])) / area;
      const c = ((q[0] - p[0]) * (y - p[1]) - (x - p[0]) * (q[1] - p[1])) / area;
      const weights = [1 - b - c, b, c];
      const z = nth(weights, 0) * p[2] + b * q[2] + c * r[2];
      if (weights.some((weight) => !(weight >= 0)) || z <= nearest) continue;
      nearest = z;
      const mean = (axis: number) =>
        corners.reduce((sum, v, i) => sum + nth(weights, i) * nth(rest, 2 * v + axis), 0);
      seen = {piece: name, rest: [mean(0), mean(1)]};
    }
  return seen;
}

it('hang folded, and the print runs on across them', async () => {
  const skirt = await solve({garment: sample('box-pleated-skirt'), print: checks});
  expect(skirt.pieces[0]?.folds).toMatchObject([{kind: 'inverted'}]);
  const draped = await drape(skirt);
  expect(draped.check.crossings).toBe(0);
  const waistband = draped.mesh.pieces.find(({name}) => name === 'waistband_front');
  const heights = Array.from(waistband?.sewn ?? [], (v) => nth(draped.positions, 3 * v + 1));
  const below = Math.min(...heights) - 1;
  const across = [-4, -3, -2, -1, 1, 2, 3, 4].map((x) => ({x, ...seenAt(draped, x, below)}));
  // the hidden fabric is between 10 cm to the right and to the left
  for (const {piece, rest} of across) {
    expect(piece).toBe('front');
    expect(Math.abs(rest[0])).toBeGreaterThan(9.5);
  }
  const shifts = across.map(({x, rest}) => rest[0] - x);
  const first = nth(shifts, 0);
  for (const shift of shifts) {
    const off = (shift - first) / repeat;
    expect(repeat * Math.abs(off - Math.round(off))).toBeLessThan(0.8);
  }
});
