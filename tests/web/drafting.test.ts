import {readFileSync} from 'node:fs';

import fc from 'fast-check';
import {describe, expect, it} from 'vitest';

import {bodyOf, sizeNames, type Body} from '../../web/drafting/body.js';
import {garmentFile} from '../../web/drafting/garment-file.js';
import {draftGatheredSkirt, waistGathers} from '../../web/drafting/gathered-skirt.js';
import {draftPrincessDress} from '../../web/drafting/princess-dress.js';
import {wardrobe} from '../../web/drafting/wardrobe.js';
import {length, minus, norm, pointAt, velocity, type Point} from '../../web/drafting/geometry.js';
import {
  findEdge,
  untrue,
  type EdgeName,
  type Garment,
  type Panel,
} from '../../web/drafting/panel.js';
import {draftTee} from '../../web/drafting/tee.js';

const sizes = sizeNames.map(bodyOf);
const medium = bodyOf('m');

/** The smallest and the largest of each measurement in the size table. */
const ranges = (Object.keys(medium) as (keyof Body)[]).map((name) => {
  const values = sizes.map((body) => body[name]);
  return [name, Math.min(...values), Math.max(...values)] as const;
});

/** A body within the size table: between two of its sizes, each measurement off by up to 3 % of its own. */
const bodies = fc
  .tuple(
    fc.double({min: 0, max: 1, noNaN: true}),
    fc.array(fc.double({min: -0.03, max: 0.03, noNaN: true}), {
      minLength: ranges.length,
      maxLength: ranges.length,
    }),
  )
  .map(
    ([share, own]) =>
      Object.fromEntries(
        ranges.map(([name, low, high], k) => {
          const measured = (low + share * (high - low)) * (1 + (own[k] ?? 0));
          return [name, Math.min(high, Math.max(low, measured))];
        }),
      ) as unknown as Body,
  );

const shipped = wardrobe.flatMap((draft) => sizes.map((body) => draft(body)));
const redrafted = fc
  .sample(bodies, {seed: 5, numRuns: 20})
  .flatMap((body) => wardrobe.map((draft) => draft(body)));

/** Checks a property on every garment, drafted for the sample body and for many others. */
function forEveryGarment(check: (garment: Garment) => void): void {
  for (const garment of [...shipped, ...redrafted]) check(garment);
}

function flattened({edges}: Panel, perEdge = 24): Point[] {
  return edges.flatMap(({curve}) =>
    Array.from({length: curve.controls ? perEdge : 1}, (_, k) =>
      pointAt(curve, curve.controls ? k / perEdge : 0),
    ),
  );
}

const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];

function area(points: readonly Point[]): number {
  return points.reduce((sum, a, k) => sum + cross(a, points[(k + 1) % points.length] ?? a) / 2, 0);
}

function crossings(points: readonly Point[]): number {
  const side = (a: Point, b: Point, c: Point): number => cross(minus(b, a), minus(c, a));
  const at = (k: number): Point => points[k % points.length] ?? [0, 0];
  let count = 0;
  for (let i = 0; i < points.length; i++) {
    for (let j = i + 2; j < points.length - (i === 0 ? 1 : 0); j++) {
      const [a, b, c, d] = [at(i), at(i + 1), at(j), at(j + 1)];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) count++;
    }
  }
  return count;
}

/** The angle inside the panel where edge `index` starts. [degrees] */
function cornerAngle({edges}: Panel, index: number): number {
  const next = edges[index]?.curve;
  const last = edges.at(index - 1)?.curve;
  if (!next || !last) throw new Error('no such corner');
  const out = velocity(next, 0);
  const back = velocity(last, 1);
  const turn = Math.atan2(cross(back, out), back[0] * out[0] + back[1] * out[1]);
  return 180 - (turn * 180) / Math.PI;
}

/** Corners that are sewn together, as the sum of their angles, and whether cloth lies all round them. */
function sewnPoints(garment: Garment): {angle: number; corners: string[]; inside: boolean}[] {
  const corners = garment.panels.flatMap((panel) =>
    panel.edges.map((_, k) => ({panel, k, key: `${panel.name}:${k}`})),
  );
  const owner = new Map(corners.map(({key}) => [key, key]));
  const find = (key: string): string => {
    const up = owner.get(key) ?? key;
    return up === key ? key : find(up);
  };
  const ends = (names: EdgeName): [string, string] => {
    const {index} = findEdge(garment, names);
    const count = garment.panels.find(({name}) => name === names[0])?.edges.length ?? 1;
    return [`${names[0]}:${index}`, `${names[0]}:${(index + 1) % count}`];
  };
  const sewn = new Set<string>();
  for (const {a, b} of garment.seams) {
    const [a0, a1] = ends(a);
    const [b0, b1] = ends(b);
    owner.set(find(a0), find(b1));
    owner.set(find(a1), find(b0));
    sewn.add(a.join(':')).add(b.join(':'));
  }
  const groups = new Map<string, typeof corners>();
  for (const corner of corners) {
    const at = find(corner.key);
    groups.set(at, [...(groups.get(at) ?? []), corner]);
  }
  return [...groups.values()].map((group) => ({
    angle: group.reduce((sum, {panel, k}) => sum + cornerAngle(panel, k), 0),
    corners: group.map(({key}) => key),
    inside: group.every(({panel, k}) =>
      [panel.edges[k], panel.edges.at(k - 1)].every((e) => sewn.has(`${panel.name}:${e?.name}`)),
    ),
  }));
}

describe('every garment, for any body', () => {
  it('has seams whose sides are as long as each other, but for the ease and gathers it states', () => {
    forEveryGarment((garment) => {
      for (const seam of garment.seams) expect(untrue(garment, seam)).toBeLessThan(0.01);
    });
  });

  it('sews no edge twice', () => {
    forEveryGarment((garment) => {
      const edges = garment.seams.flatMap(({a, b}) => [a.join(), b.join()]);
      expect(new Set(edges).size).toBe(edges.length);
    });
  });

  it('has simple counter-clockwise outlines that start low', () => {
    forEveryGarment((garment) => {
      for (const panel of garment.panels) {
        const points = flattened(panel);
        expect(area(points)).toBeGreaterThan(0);
        expect(crossings(points)).toBe(0);
        const ends = panel.edges.map(({curve}) => (curve.from[1] + curve.to[1]) / 2);
        expect(ends.indexOf(Math.min(...ends))).toBe(0);
      }
    });
  });

  it('lies flat around every sewn point: hems, necklines and armholes run on across the seams', () => {
    forEveryGarment((garment) => {
      for (const {angle, corners, inside} of sewnPoints(garment)) {
        const dartTip = corners.length === 1 && inside;
        if (corners.length === 1 && !dartTip) continue;
        if (dartTip) expect(angle).toBeLessThan(355);
        else expect(angle, corners.join(' ')).toBeCloseTo(inside ? 360 : 180, 4);
      }
    });
  });

  it('is its own mirror image', () => {
    forEveryGarment((garment) => {
      for (const panel of garment.panels) {
        const swap = (name: string): string =>
          name.replace(/left|right/, (side) => (side === 'left' ? 'right' : 'left'));
        const twin = garment.panels.find(({name}) => name === swap(panel.name));
        expect(twin).toBeDefined();
        const images = twin ? flattened(twin, 6) : [];
        for (const [x, y] of flattened(panel, 6)) {
          const apart = Math.min(...images.map((q) => norm(minus(q, [-x, y]))));
          expect(apart).toBeLessThan(1e-9);
        }
        const [x, y, z] = panel.placement.translation;
        expect(twin?.placement.translation).toEqual([0 - x, y, z]);
      }
    });
  });
});

describe('the tee', () => {
  const tee = draftTee(medium);
  const lengthOf = (...names: [string, string]): number => length(findEdge(tee, names).curve);

  it('has 2 to 3 cm of ease in each sleeve cap', () => {
    const cap = lengthOf('sleeve_left', 'cap front') + lengthOf('sleeve_left', 'cap back');
    const armhole = lengthOf('front', 'armhole left') + lengthOf('back', 'armhole left');
    expect(cap - armhole).toBeGreaterThanOrEqual(2);
    expect(cap - armhole).toBeLessThanOrEqual(3);
  });

  it('has sleeves whose front is scooped out further than their back', () => {
    const front = findEdge(tee, ['sleeve_left', 'cap front']).curve;
    const back = findEdge(tee, ['sleeve_left', 'cap back']).curve;
    // a quarter of the way up from the underarm, in from it
    const [frontIn] = minus(pointAt(front, 0.75), front.to);
    const [backIn] = minus(pointAt(back, 0.25), back.from);
    expect(frontIn).toBeGreaterThan(-backIn + 0.5);
  });
});

describe('the skirt', () => {
  it('gathers 1.6 cm of skirt into every centimetre of waistband', () => {
    const skirt = draftGatheredSkirt(medium);
    const waist = length(findEdge(skirt, ['front', 'waist']).curve);
    const band = length(findEdge(skirt, ['waistband_front', 'lower']).curve);
    expect(waistGathers).toBe(1.6);
    expect(waist / band).toBeCloseTo(1.6, 9);
  });
});

describe('the dress', () => {
  it('has darts that are a notch with legs of one length, sewn to each other', () => {
    const dress = draftPrincessDress(medium);
    const lower = findEdge(dress, ['side_front_left', 'dart lower']);
    const upper = findEdge(dress, ['side_front_left', 'dart upper']);
    expect(lower.curve.to).toEqual(upper.curve.from);
    expect(length(lower.curve)).toBeCloseTo(length(upper.curve), 9);
    expect(norm(minus(lower.curve.from, upper.curve.to))).toBeCloseTo(0.032 * medium.bust, 6);
  });
});

it('says which measurements it cannot draft from', () => {
  expect(() => draftTee({...medium, upperArm: 90})).toThrow('the sleeve width cannot be made');
});

describe.each(sizeNames)('size %s', (size) => {
  it.each(wardrobe.map((draft) => draft(bodyOf(size))))(
    'ships the $name as it is drafted now',
    (garment) => {
      const path = `public/garments/${garment.name}-${size}.json`;
      expect(readFileSync(path, 'utf8')).toBe(garmentFile(garment, size));
    },
  );
});

it.each(wardrobe.map((draft) => draft(medium)))(
  'writes the $name so that its stitches name edges of one length',
  (garment) => {
    interface File {
      pattern: {
        panels: Record<
          string,
          {
            vertices: Point[];
            edges: {endpoints: [number, number]; curvature?: {params: [Point, Point]}}[];
          }
        >;
        stitches: {panel: string; edge: number}[][];
      };
    }
    const {pattern} = JSON.parse(garmentFile(garment, 'm')) as File;
    const lengthOf = ({panel, edge}: {panel: string; edge: number}): number => {
      const {vertices = [], edges = []} = pattern.panels[panel] ?? {};
      const {endpoints, curvature} = edges[edge] ?? {endpoints: [0, 0]};
      const [from, to] = endpoints.map((v) => vertices[v] ?? [NaN, NaN]) as [Point, Point];
      const [ex, ey] = minus(to, from);
      const absolute = ([u, v]: Point): Point => [
        from[0] + u * ex - v * ey,
        from[1] + u * ey + v * ex,
      ];
      if (!curvature) return norm([ex, ey]);
      return length({
        from,
        to,
        controls: [absolute(curvature.params[0]), absolute(curvature.params[1])],
      });
    };
    pattern.stitches.forEach(([a, b], k) => {
      const seam = garment.seams[k];
      if (!a || !b || !seam) throw new Error('a stitch without a seam');
      expect(
        Math.abs(lengthOf(a) - lengthOf(b) * (seam.gathers ?? 1) - (seam.ease ?? 0)),
      ).toBeLessThan(0.001);
    });
  },
);
