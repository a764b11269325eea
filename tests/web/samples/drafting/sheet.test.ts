import {expect, it} from 'vitest';

import {titled} from '@samples/drafting/garment-file.js';
import {garmentSheet} from '@samples/drafting/sheet.js';
import {wardrobe} from '@samples/drafting/wardrobe.js';
import {medium} from '../../../support/garments/drafts.js';

const garments = wardrobe.map((draft) => draft(medium));
const sheet = garmentSheet(garments, 'Title', 'Note');

it('names every piece, numbers both edges of every seam and each dart once, and gives their stitches', () => {
  for (const {panels} of garments) {
    for (const {name} of panels)
      expect(sheet).toMatch(new RegExp(`>${titled(name)}, (pair|cut 1)</text>`));
  }
  const numbers = [...sheet.matchAll(/<text x="[-\d.]+" y="[-\d.]+">\d+<\/text>/g)];
  const seams = garments.flatMap((garment) => garment.seams);
  const darts = seams.filter(({kind}) => kind === 'dart');
  expect(numbers).toHaveLength(2 * seams.length - darts.length);
  expect(sheet).toContain('1  Side seam (stitches 0, 1)');
});

it('keeps every outline on the page', () => {
  const [, width = '0', height = '0'] = /viewBox="0 0 (\d+) (\d+)"/.exec(sheet) ?? [];
  const outlines = [...sheet.matchAll(/<path d="(M[^"]*Z)"\/>/g)].map(([, path = '']) => path);
  expect(outlines).toHaveLength(garments.flatMap(({panels}) => panels).length);
  for (const path of outlines) {
    const numbers = path.match(/-?[\d.]+/g)?.map(Number) ?? [];
    const [xs, ys] = [numbers.filter((_, k) => k % 2 === 0), numbers.filter((_, k) => k % 2 === 1)];
    expect(Math.min(...xs)).toBeGreaterThan(0);
    expect(Math.max(...xs)).toBeLessThan(Number(width));
    expect(Math.min(...ys)).toBeGreaterThan(0);
    expect(Math.max(...ys)).toBeLessThan(Number(height));
  }
});
