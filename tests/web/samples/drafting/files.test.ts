/** The files of drafted garments. */
import {readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import {minus, norm, type Point} from '@/model/geometry/vectors.js';
import {draftApron} from '@samples/drafting/apron.js';
import {bodyOf, sizeNames} from '@samples/drafting/body.js';
import {garmentFile, grainLine} from '@samples/drafting/garment-file.js';
import {length} from '@samples/drafting/curves.js';
import {sampleList} from '@samples/drafting/sample-list.js';
import {wardrobe} from '@samples/drafting/wardrobe.js';
import {medium} from '../../../support/garments/drafts.js';

describe.each(sizeNames)('size %s', (size) => {
  it.each(wardrobe.map((draft) => draft(bodyOf(size))))(
    'ships the $name as it is drafted now',
    (garment) => {
      const path = `public/garments/${garment.name}-${size}.json`;
      expect(readFileSync(path, 'utf8')).toBe(garmentFile(garment, size));
    },
  );
});

it('ships a list of all garments and prints', () => {
  expect(readFileSync('public/samples.json', 'utf8')).toBe(sampleList());
});

it('lays the grain across every band, so that its print runs on from what it is sewn to', () => {
  for (const garment of wardrobe.map((draft) => draft(medium))) {
    for (const panel of garment.panels) {
      if (!/waistband|stand|collar|yoke|cuff|band_/.test(panel.name)) continue;
      const [low, high] = grainLine(panel);
      expect(minus(high, low)[0] + 0, panel.name).toBeCloseTo(0, 9);
    }
  }
});

it('lays the grain along the strap, which goes on up from the bib of the apron', () => {
  const strap = draftApron(medium).panels.find(({name}) => name === 'neck_strap');
  const [low, high] = strap ? grainLine(strap) : [];
  expect(low?.[1]).toBe(high?.[1]);
});

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

it.each(wardrobe.map((draft) => draft(medium)))(
  'writes the $name so that its stitches name edges of one length',
  (garment) => {
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
