/** Set-in sleeves, whatever they are set into: edges of a cap are named so. */
import {expect, it} from 'vitest';

import {
  minus,
  norm,
  reversed,
  velocity,
  type Curve,
  type Point,
} from '../../web/drafting/geometry.js';
import {wardrobe} from '../../web/drafting/wardrobe.js';
import {forEveryGarment, medium} from '../support/drafts.js';

const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];

/** Curvature where a cubic starts, positive to the left. [1/cm] */
function startCurvature({from, controls}: Curve): number {
  if (!controls) return 0;
  const [first, second] = [minus(controls[0], from), minus(controls[1], from)];
  return ((2 / 3) * cross(first, second)) / norm(first) ** 3;
}

it('draws caps without a point: direction and curvature run on from the back to the front', () => {
  forEveryGarment(({name, panels}) => {
    for (const {name: panel, edges} of panels) {
      edges.forEach((edge, k) => {
        const next = edges[(k + 1) % edges.length];
        if (!edge.name.startsWith('cap') || !next?.name.startsWith('cap')) return;
        const what = `${name}: ${panel}, ${edge.name} to ${next.name}`;
        const [into, out] = [velocity(edge.curve, 1), velocity(next.curve, 0)];
        expect(cross(into, out) / norm(into) / norm(out), what).toBeCloseTo(0, 9);
        const [before, after] = [-startCurvature(reversed(edge.curve)), startCurvature(next.curve)];
        expect(after, what).toBeCloseTo(before, 6);
        // round enough for an arm, flat enough for a dropped shoulder: a radius of 5 to 40 cm
        if (edge.name.includes('back') && next.name.includes('front')) {
          expect(1 / after, what).toBeGreaterThan(5);
          expect(1 / after, what).toBeLessThan(40);
        }
      });
    }
  });
});

it('finds caps to look at', () => {
  const capped = wardrobe
    .map((draft) => draft(medium))
    .filter(({panels}) =>
      panels.some(({edges}) => edges.some(({name}) => name.startsWith('cap back'))),
    );
  expect(capped.length).toBeGreaterThan(0);
});
