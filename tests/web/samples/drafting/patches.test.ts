/** Garments of many pieces, or of pairs only. */
import {describe, expect, it} from 'vitest';

import {draftPatchworkJacket} from '@samples/drafting/patchwork-jacket.js';
import {draftRaglan} from '@samples/drafting/raglan.js';
import {medium} from '../../../support/garments/drafts.js';
import {closedPoints} from '../../../support/garments/sewn-corners.js';

describe('the patchwork jacket', () => {
  const jacket = draftPatchworkJacket(medium);

  it('has forty patches: four in the middle of the back, and eighteen pairs', () => {
    expect(jacket.panels).toHaveLength(40);
    expect(jacket.symmetries.filter((names) => names.length === 1)).toHaveLength(4);
    expect(jacket.symmetries.filter((names) => names.length === 2)).toHaveLength(18);
  });

  it('sews every edge but those of hem, wrists, neckline and front', () => {
    const sewn = new Set(jacket.seams.flatMap(({a, b}) => [a.join(), b.join()]));
    const open = jacket.panels.flatMap(({name, edges}) =>
      edges.filter((one) => !sewn.has(`${name},${one.name}`)).map((one) => one.name),
    );
    const counts = Object.fromEntries(
      [...new Set(open)].map((name) => [name, open.filter((one) => one === name).length]),
    );
    // 7 patches along the hem and 4 at the wrists end in their lower edges
    expect(counts).toEqual({lower: 11, 'front edge': 8, neckline: 3});
  });

  it('meets in fours: rows and columns run on across each other', () => {
    const inFours = closedPoints(jacket).filter((corners) => corners.length === 4);
    expect(inFours.length).toBeGreaterThan(20);
  });
});

it('cuts every piece of the raglan shirt in a mirrored pair', () => {
  const raglan = draftRaglan(medium);
  expect(raglan.symmetries.flat().toSorted()).toEqual(
    raglan.panels.map(({name}) => name).toSorted(),
  );
  expect(raglan.symmetries.every((names) => names.length === 2)).toBe(true);
});
