/**
 * Properties of every shipped garment, for any body. Properties of a single garment have separate
 * test files.
 */
import {describe, expect, it} from 'vitest';

import {distance, type Point} from '@/model/geometry/vectors.js';
import {isInside, lengthOf, signedArea} from '@/model/geometry/polyline.js';
import {notchesOf, type Notch} from '@samples/drafting/garment-file.js';
import {parameterAt, pointAt} from '@samples/drafting/curves.js';
import {untrue, type Panel} from '@samples/drafting/panel.js';
import {wardrobe} from '@samples/drafting/wardrobe.js';
import {forEveryGarment, medium} from '../../../support/garments/drafts.js';
import {aroundLoop, crossesItself, toLine} from '../../../support/plane.js';
import {
  anglesAt,
  called,
  closedPoints,
  cornerAngle,
  crossedEnds,
  isCorner,
} from '../../../support/garments/sewn-corners.js';

function flattened({edges}: Panel, perEdge = 24): Point[] {
  return edges.flatMap(({curve}) =>
    Array.from({length: curve.controls ? perEdge : 1}, (_, k) =>
      pointAt(curve, curve.controls ? k / perEdge : 0),
    ),
  );
}

/** Returns whether a point is inside an outline, or on it to 1 mm. */
const covers = (outline: readonly Point[], p: Point): boolean =>
  isInside(outline, p) || aroundLoop(outline).some((edge) => toLine(p, edge) < 0.1);

function notchPoint({edges}: Panel, {edge, at}: Notch): Point {
  const curve = edges[edge]?.curve;
  if (!curve) throw new Error('a notch without an edge');
  return pointAt(curve, parameterAt(curve, at));
}

/**
 * Largest deviation from straight for a line across a seam; no corner is visible below it.
 * [degrees]
 */
const nearlyStraight = 5;

describe('every garment, for any body', () => {
  it('has seams whose sides are as long as each other, but for the ease and gathers it states', () => {
    forEveryGarment((garment) => {
      for (const seam of garment.seams) {
        expect(untrue(garment, seam), `${garment.name}: ${seam.name}`).toBeLessThan(0.01);
      }
    });
  });

  it('sews no edge twice, and names every seam and every edge of a panel once', () => {
    forEveryGarment(({seams, panels}) => {
      const lists = [
        seams.flatMap(({a, b}) => [a.join(), b.join()]),
        seams.map(({name}) => name),
        panels.map(({name}) => name),
        ...panels.map(({edges}) => edges.map(({name}) => name)),
      ];
      for (const list of lists) expect(new Set(list).size, list.join('; ')).toBe(list.length);
    });
  });

  it('has simple counter-clockwise outlines that start low', () => {
    forEveryGarment((garment) => {
      for (const panel of garment.panels) {
        const what = `${garment.name}: ${panel.name}`;
        const points = flattened(panel);
        expect(signedArea(points), what).toBeGreaterThan(0);
        expect(crossesItself(aroundLoop(points)), what).toBe(false);
        const ends = panel.edges.map(({curve}) => (curve.from[1] + curve.to[1]) / 2);
        expect(ends.indexOf(Math.min(...ends)), what).toBe(0);
      }
    });
  });

  it('runs on across its seams: hems, necklines and armholes turn only where it says so', () => {
    forEveryGarment((garment) => {
      for (const end of crossedEnds(garment)) {
        const {seam, corners} = end;
        const isTurn = (garment.turns ?? []).some((turn) =>
          corners.some((corner) => isCorner(corner, turn.corner)),
        );
        if (isTurn) continue;
        const what = `${garment.name}: ${seam}, ${corners.map(called).join(' and ')}`;
        expect(Math.abs(anglesAt(end) - 180), what).toBeLessThan(nearlyStraight);
      }
    });
  });

  it('turns where it says so', () => {
    for (const garment of wardrobe.map((draft) => draft(medium))) {
      for (const {corner: name} of garment.turns ?? []) {
        const ends = crossedEnds(garment).filter(({corners}) =>
          corners.some((corner) => isCorner(corner, name)),
        );
        const turning = ends.map((end) => Math.abs(anglesAt(end) - 180));
        const what = `${garment.name}: ${name.join(', ')}`;
        expect(Math.max(...turning), what).toBeGreaterThan(nearlyStraight);
      }
    }
  });

  it('has cloth all round a sewn point without excess: a body is not flat, but it has neither spikes nor frills', () => {
    forEveryGarment((garment) => {
      for (const corners of closedPoints(garment)) {
        const angle = corners.reduce((sum, corner) => sum + cornerAngle(corner), 0);
        const what = `${garment.name}: ${corners.map(called).join(' and ')}`;
        const isDartTip = corners.length === 1;
        expect(angle, what).toBeGreaterThan(isDartTip ? 270 : 250);
        expect(angle, what).toBeLessThan(isDartTip ? 355 : 400);
      }
    });
  });

  it('has the mirror symmetries it names: exact, hung to mirror each other, and none named twice', () => {
    forEveryGarment(({panels, symmetries}) => {
      const named = symmetries.flat();
      expect(new Set(named).size).toBe(named.length);
      const find = (name: string): Panel => {
        const found = panels.find((panel) => panel.name === name);
        if (!found) throw new Error(`no panel '${name}'`);
        return found;
      };
      for (const [one, other = one] of symmetries) {
        const images = flattened(find(other), 6);
        for (const [x, y] of flattened(find(one), 6)) {
          const apart = Math.min(...images.map((q) => distance(q, [-x, y])));
          expect(apart, one).toBeLessThan(1e-9);
        }
        const [x, y, z] = find(one).placement.translation;
        expect(find(other).placement.translation, one).toEqual([0 - x, y, z]);
      }
    });
  });

  it('has notches that mirror each other where the pieces do', () => {
    forEveryGarment((garment) => {
      const marks = (name: string): Point[] => {
        const panel = garment.panels.find((one) => one.name === name);
        return panel ? notchesOf(panel, garment).map((notch) => notchPoint(panel, notch)) : [];
      };
      for (const [one, other = one] of garment.symmetries) {
        const images = marks(other);
        for (const [x, y] of marks(one)) {
          const apart = Math.min(...images.map((q) => distance(q, [-x, y])));
          expect(apart, `${garment.name}: ${one}`).toBeLessThan(0.001);
        }
      }
    });
  });

  it('marks the lines that lie on each other on both pieces, and as long on one as on the other', () => {
    forEveryGarment(({name, panels, matches = []}) => {
      for (const match of matches) {
        const [a, b] = [match.a, match.b].map(({panel: on, line}) => {
          const panel = panels.find((one) => one.name === on);
          const outline = panel ? flattened(panel) : [];
          for (const p of line) expect(covers(outline, p), `${name}: ${match.name}`).toBe(true);
          return lengthOf(line);
        });
        expect(a, `${name}: ${match.name}`).toBeGreaterThan(1);
        expect(a, `${name}: ${match.name}`).toBeCloseTo(b ?? 0, 9);
      }
    });
  });
});
