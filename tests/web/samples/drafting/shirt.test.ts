import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {length} from '@samples/drafting/curves.js';
import {findEdge} from '@samples/drafting/panel.js';
import {draftShirt} from '@samples/drafting/shirt.js';
import {buttonStand, cuffPleats} from '@samples/drafting/shirt-pieces.js';
import {medium} from '../../../support/garments/drafts.js';

describe('the shirt', () => {
  const shirt = draftShirt(medium);
  const curveOf = (panel: string, edge: string) => findEdge(shirt, [panel, edge]).curve;
  const lengthOf = (panel: string, edge: string): number => length(curveOf(panel, edge));

  it('pleats 1.25 cm of sleeve into every centimetre of cuff', () => {
    const wrist = lengthOf('sleeve_left', 'wrist front') + lengthOf('sleeve_left', 'wrist back');
    const cuff = lengthOf('cuff_left', 'upper front') + lengthOf('cuff_left', 'upper back');
    expect(cuffPleats).toBe(1.25);
    expect(wrist / cuff).toBeCloseTo(1.25, 6);
    expect(cuff).toBeGreaterThan(medium.wrist + 4);
  });

  it('has 2 to 3 cm of ease in each sleeve cap, front and back, body and yoke together', () => {
    const eases = shirt.seams.flatMap(({name, ease}) =>
      name.includes('armhole') && name.endsWith('left') && ease ? [ease] : [],
    );
    expect(eases).toHaveLength(4);
    const all = eases.reduce((sum, ease) => sum + ease, 0);
    expect(all).toBeGreaterThanOrEqual(2);
    expect(all).toBeLessThanOrEqual(3);
  });

  it('laps its fronts: both go on beyond the centre front, where they are matched', () => {
    const [front] = shirt.matches ?? [];
    expect([front?.a.panel, front?.b.panel]).toEqual(['front_left', 'front_right']);
    const [low, high] = front?.a.line ?? [];
    expect([low?.[0], high?.[0]]).toEqual([0, 0]);
    expect(high).toEqual(curveOf('front_left', 'neckline').to);
    const edges: readonly Point[] = ['front_left', 'front_right'].map(
      (panel) => curveOf(panel, 'front edge').from,
    );
    expect(edges.map(([x]) => x)).toEqual([-buttonStand, buttonStand]);
  });

  it('sets the collar on the stand from centre front to centre front', () => {
    const {from, to} = curveOf('stand', 'collar');
    const neckline =
      lengthOf('stand', 'back') +
      2 * (lengthOf('stand', 'yoke left') + lengthOf('stand', 'front left'));
    expect(from[0]).toBe(-to[0]);
    expect(lengthOf('collar', 'stand')).toBeCloseTo(lengthOf('stand', 'collar'), 6);
    // it is closer to the neck than the neckline
    expect(lengthOf('stand', 'collar')).toBeLessThan(neckline);
    expect(lengthOf('stand', 'collar')).toBeGreaterThan(medium.neck);
  });
});
