/** Folds on the cutting sheet. */
import {expect, it} from 'vitest';

import {cutFold} from '@/cutting/fold-marks.js';
import {foldsAmong} from '@/files/base/fold-lines.js';
import {foldArrows} from '@/model/garment/fold-arrows.js';
import {foldKinds, type DraftedFold} from '@/model/garment/garment-document.js';

const fold = (changes: Partial<DraftedFold> = {}): DraftedFold => ({
  kind: 'knife',
  line: [
    [4, 10],
    [4, 0],
  ],
  to: [
    [8, 10],
    [8, 0],
  ],
  ...changes,
});
const drawn = (changes: Partial<DraftedFold> = {}, locale = 'en') =>
  cutFold(fold(changes), (p) => p, {units: 'cm', locale});

it('names the kind and the fabric between the lines', () => {
  expect(drawn().name).toBe('Knife pleat, 4 cm');
  expect(drawn({kind: 'press'}).name).toBe('Press line');
});

it.each(['en', 'de', 'fr', 'es', 'it'])('names kinds in %s as the reader knows them', (locale) => {
  const read = foldKinds.map((kind) => {
    const {line, to = line, name} = drawn({kind}, locale);
    return foldsAmong([line, to], [{at: line[0], text: name}], 1).folds[0]?.kind;
  });
  expect(read).toEqual(foldKinds);
});

it('lays a knife pleat from one line onto the other', () => {
  const [shaft, head] = foldArrows(drawn());
  expect(shaft).toEqual([
    [4, 5],
    [8, 5],
  ]);
  expect(head?.[1]).toEqual([8, 5]);
});

it('lets the lines of an inverted pleat meet in the middle', () => {
  const tips = foldArrows(drawn({kind: 'inverted'}))
    .filter((line) => line.length === 2)
    .map((line) => line[1]);
  expect(tips).toEqual([
    [6, 5],
    [6, 5],
  ]);
});

it('draws no arrow at a crease', () => {
  expect(foldArrows(drawn({kind: 'roll'}))).toEqual([]);
});
