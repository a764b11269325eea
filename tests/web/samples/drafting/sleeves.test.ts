/** Set-in sleeves of all garments; the name of a cap's edges contains `cap`. */
import {expect, it} from 'vitest';

import {cross, minus, norm} from '@/model/geometry/vectors.js';
import {notchesOf} from '@samples/drafting/garment-file.js';
import {length, reversed, velocity, type Curve} from '@samples/drafting/curves.js';
import {findEdge, type Garment} from '@samples/drafting/panel.js';
import {wardrobe} from '@samples/drafting/wardrobe.js';
import {forEveryGarment, medium} from '../../../support/garments/drafts.js';

/** Curvature at the start of a cubic, positive to the left. [1/cm] */
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

/** Length of one side of an armhole, all edges sewn to a cap; 0 without a set-in sleeve. [cm] */
const armhole = (garment: Garment, half: 'Front' | 'Back'): number =>
  garment.seams
    .filter(({name}) => name.startsWith(`${half} armhole`) && name.endsWith('left'))
    .reduce((sum, {b}) => sum + length(findEdge(garment, b).curve), 0);

it('cuts the back armhole at least as long as the front one: arms are moved forward', () => {
  forEveryGarment((garment) => {
    const [front, back] = [armhole(garment, 'Front'), armhole(garment, 'Back')];
    expect(back, garment.name).toBeGreaterThanOrEqual(front);
    expect(back, garment.name).toBeLessThanOrEqual(1.06 * front);
  });
});

it('marks the crown of every cap in one piece, where its back and front meet', () => {
  forEveryGarment((garment) => {
    for (const panel of garment.panels) {
      panel.edges.forEach((edge, k) => {
        const next = (k + 1) % panel.edges.length;
        const halves = `${edge.name} ${panel.edges[next]?.name ?? ''}`;
        if (!/cap back.*cap front|cap front.*cap back/.test(halves)) return;
        const crown = notchesOf(panel, garment).filter(
          (notch) =>
            (notch.edge === k && notch.at === 1) || (notch.edge === next && notch.at === 0),
        );
        expect(crown, `${garment.name}: ${panel.name}`).toHaveLength(1);
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
