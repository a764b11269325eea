/** Every garment of the wardrobe, drafted for the size table and for bodies in between. */
import fc from 'fast-check';

import {bodyOf, sizeNames, type Body} from '@samples/drafting/body.js';
import type {Garment} from '@samples/drafting/panel.js';
import {wardrobe} from '@samples/drafting/wardrobe.js';

const sizes = sizeNames.map(bodyOf);
export const medium = bodyOf('m');

/** The smallest and the largest value of each measurement in the size table. */
const ranges = (Object.keys(medium) as (keyof Body)[]).map((name) => {
  const values = sizes.map((body) => body[name]);
  return [name, Math.min(...values), Math.max(...values)] as const;
});

/** A body within the size table: between two of its sizes, each measurement off by up to 3 %. */
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

let drafted: readonly Garment[] | undefined;

/** Checks a property on every garment, drafted for every size and for many other bodies. */
export function forEveryGarment(check: (garment: Garment) => void): void {
  drafted ??= [...sizes, ...fc.sample(bodies, {seed: 5, numRuns: 20})].flatMap((body) =>
    wardrobe.map((draft) => draft(body)),
  );
  for (const garment of drafted) check(garment);
}
