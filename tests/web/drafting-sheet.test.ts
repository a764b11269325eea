import {expect, it} from 'vitest';

import {titled} from '../../web/drafting/garment-file.js';
import {garmentSheet} from '../../web/drafting/sheet.js';
import {wardrobe} from '../../web/drafting/wardrobe.js';
import {medium} from '../support/drafts.js';

const garments = wardrobe.map((draft) => draft(medium));
const sheet = garmentSheet(garments, 'Title', 'Note');

it('names every piece and numbers both edges of every seam', () => {
  for (const {panels} of garments) {
    for (const {name} of panels) expect(sheet).toContain(`>${titled(name)}</text>`);
  }
  const numbers = [...sheet.matchAll(/<text x="[-\d.]+" y="[-\d.]+">\d+<\/text>/g)];
  expect(numbers).toHaveLength(2 * garments.flatMap(({seams}) => seams).length);
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
