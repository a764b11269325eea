import {readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import {collection} from '@samples/prints/collection.js';
import {repeatName} from '@samples/prints/repeat.js';

const cellOf = (id: string) => {
  const cell = collection.find((design) => design.id === id)?.cell;
  if (!cell) throw new Error(`there is no ${id}`);
  return cell;
};

describe('the name of a repeat', () => {
  it.each([
    ['p1', '10 × 12 cm', 'width by height'],
    ['pg', '7 × 11 cm', 'upright, also when w1 runs along the warp'],
    ['cm', '9 × 12 cm half-drop', 'the rectangle of a rhomb'],
    ['p3', '9 × 15.59 cm half-drop', 'the rectangle of a hexagonal lattice'],
    ['p31m', '19.05 × 11 cm half-drop', 'the same lattice turned'],
    ['p2', '8 × 9.5 cm, 2.6 cm aside', 'how far a slanted cell leans'],
    ['regatta', '7.75 cm', 'the width of a stripe alone'],
  ])('of %s is %s: %s', (id, name) => {
    expect(repeatName(cellOf(id))).toBe(name);
  });
});

describe('the contact sheet', () => {
  const sheet = readFileSync('docs/prints.svg', 'utf8');

  it('names every print with its file and its repeat, in 700 kB', () => {
    for (const {title, id, cell} of collection) {
      const name = sheet.indexOf(`>${title}</tspan>`);
      const next = sheet.indexOf('</g>', name);
      expect(name, title).toBeGreaterThan(0);
      expect(sheet.slice(name, next)).toContain(`>${id}</tspan>`);
      expect(sheet.slice(name, next)).toContain(`>${repeatName(cell)}</text>`);
    }
    expect(sheet.length).toBeLessThan(700e3);
  });

  it('shows every colourway', () => {
    expect(sheet.match(/<image /g)).toHaveLength(3 * collection.length);
  });
});
