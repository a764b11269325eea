/** Pleated samples: the print runs on across the closed pleats, and the shapes are sound. */
import {readFileSync} from 'node:fs';

import {solve, type GarmentCodeSpecification, type Print, type SolveResult} from 'seamwise/node';
import {expect, it} from 'vitest';

import {between, minus, rotated, type Point} from '@/model/geometry/vectors.js';
import {carried} from '@/model/geometry/triangles.js';
import {strays} from '../../support/results/check-garment.js';
import {violations} from '../../support/results/check-result.js';

interface Fold {
  readonly line: readonly [Point, Point];
  readonly to: readonly [Point, Point];
}
interface Pleated {
  readonly pattern: {readonly panels: Readonly<Record<string, {readonly folds?: readonly Fold[]}>>};
}

const json = (path: string): unknown => JSON.parse(readFileSync(`public/${path}.json`, 'utf8'));

/** Length of a print vector modulo the print's translations, of a lattice with upright sides. */
function offRepeat([x, y]: Point, {w1, w2}: {readonly w1: Point; readonly w2: Point}): number {
  const det = w1[0] * w2[1] - w1[1] * w2[0];
  const [u, v] = [(x * w2[1] - y * w2[0]) / det, (w1[0] * y - w1[1] * x) / det];
  const [a, b] = [u - Math.round(u), v - Math.round(v)];
  return Math.hypot(a * w1[0] + b * w2[0], a * w1[1] + b * w2[1]);
}

/** Greatest mismatch across the closed pleats of a garment, between points all along them. [cm] */
function acrossPleats({pattern: {panels}}: Pleated, {pieces, print}: SolveResult): number {
  const found = pieces.flatMap(({name, triangles, rest, shape, alignment}) =>
    (panels[name]?.folds ?? []).flatMap(({line, to}) =>
      Array.from({length: 21}, (_, k) => {
        const [a, b] = [line, to].map((ends) =>
          carried(triangles, rest, shape, between(...ends, k / 20)),
        ) as [Point, Point];
        return offRepeat(rotated(minus(b, a), -alignment.angle), print);
      }),
    ),
  );
  expect(found.length).toBeGreaterThan(0);
  return Math.max(...found);
}

it.each([
  ['box-pleated-skirt-m', 'pmm'],
  ['box-pleated-skirt-m', 'p31m'],
  ['box-pleated-skirt-xl', 'ditsy'],
  ['tucked-blouse-m', 'p3'],
  ['tucked-blouse-s', 'p2'],
] as const)('the print of the %s in %s runs on across its pleats', async (name, printName) => {
  const garment = json(`garments/${name}`);
  const print = json(`prints/${printName}`) as Print;
  const options = {maxChangeCm: 1, grain: {default: 'on'}} as const;
  const result = await solve({garment: garment as GarmentCodeSpecification, print, options});
  expect(violations(result, options)).toEqual([]);
  expect(strays(result, garment as GarmentCodeSpecification)).toEqual([]);
  expect(acrossPleats(garment as Pleated, result)).toBeLessThan(0.02);
  expect(result.noteDetails?.map(({code}) => code)).not.toContain('pleatsOff');
});

it('says which pleats cannot take up a whole repeat', async () => {
  const garment = json('garments/tucked-blouse-m') as GarmentCodeSpecification;
  const {notes} = await solve({garment, print: json('prints/tartan') as Print});
  expect(notes.join('\n')).toContain(
    "The print does not run on across the pleats of 'front': they take up 9 cm, and a whole " +
      'repeat is 13.75 cm',
  );
});
