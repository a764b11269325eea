/** Every shipped garment, read by the built package: its contents, and its solve. */
import {readFileSync} from 'node:fs';

import {solve, symmetries, type GarmentCodeSpecification, type Print} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {bodyOf, sizeNames} from '@samples/drafting/body.js';
import {wardrobe} from '@samples/drafting/wardrobe.js';
import {strays} from '../../support/results/check-garment.js';
import {violations} from '../../support/results/check-result.js';
import {isThorough} from '../../support/level.js';
import {at} from '../../support/plane.js';

const file = (path: string): string =>
  readFileSync(new URL(`../../../public/${path}`, import.meta.url), 'utf8');
const printNamed = (group: string): Print => JSON.parse(file(`prints/${group}.json`)) as Print;
/** Names in a canonical order for comparison. */
const sorted = (names: readonly (readonly string[])[]): string[] =>
  names.map((one) => one.toSorted().join(' and ')).toSorted();

/** Sizes and print groups of the solves. */
const solves = [
  ...['pmm', 'p4m', 'pgg'].map((group) => ['m', group] as const),
  ...sizeNames.filter((size) => size !== 'm').map((size) => [size, 'pmm'] as const),
];

const garments = wardrobe.map((draft, k) => {
  // a commit solves every garment once, and every case with some garment
  const solved = isThorough ? solves : [at(solves, k % solves.length)];
  return {...draft(bodyOf('m')), solved};
});

describe.each(garments)('the $name', ({name, solved, ...drafted}) => {
  it.each(sizeNames)(
    'shows exactly the symmetries it is drafted with, in size %s',
    async (size) => {
      const found = await symmetries(file(`garments/${name}-${size}.json`));
      const names = found.symmetries.map((one) =>
        one.kind === 'piece' ? [one.piece] : one.pieces,
      );
      expect(sorted(names)).toEqual(sorted(drafted.symmetries));
    },
  );

  it.each(solved)('is solved soundly in size %s on %s', async (size, group) => {
    const garment = JSON.parse(file(`garments/${name}-${size}.json`)) as GarmentCodeSpecification;
    const options = {maxChangeCm: 1};
    const result = await solve({garment, print: printNamed(group), options});
    expect(violations(result, options)).toEqual([]);
    expect(strays(result, garment)).toEqual([]);
    expect(result.metrics.fit).toBeLessThan(result.metrics.fitRandom);
  });
});

it('meets at the waistband of the apron with every piece on grain, and nothing bent', async () => {
  const garment = file('garments/apron-m.json');
  const options = {grain: {default: 'on'}} as const;
  const {metrics} = await solve({garment, print: printNamed('pmm'), options});
  expect(metrics.fit).toBeLessThan(1e-6);
  expect(metrics.maxMovedCm).toBeLessThan(1e-3);
});
