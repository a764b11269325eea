import {describe, expect, it} from 'vitest';

import {draftHoodie} from '@samples/drafting/hoodie.js';
import {length} from '@samples/drafting/curves.js';
import {findEdge} from '@samples/drafting/panel.js';
import {medium} from '../../../support/garments/drafts.js';

describe('the hoodie', () => {
  const hoodie = draftHoodie(medium);
  const lengthOf = (panel: string, edge: string): number =>
    length(findEdge(hoodie, [panel, edge]).curve);

  it('has a hood that the head goes through, and that is sewn to the whole neckline', () => {
    const opening = 2 * lengthOf('hood_left', 'face') + lengthOf('hood_centre', 'face');
    expect(opening).toBeGreaterThan(medium.head + 10);
    const hood = 2 * (lengthOf('hood_left', 'neck front') + lengthOf('hood_left', 'neck back'));
    const neckline =
      2 * (lengthOf('front', 'neckline left') + lengthOf('back', 'neckline left')) +
      lengthOf('back', 'nape');
    expect(hood + lengthOf('hood_centre', 'neck')).toBeCloseTo(neckline, 6);
  });

  it('lays the pocket on the front, unsewn: its top and both sides are matched there', () => {
    expect(hoodie.seams.some(({a, b}) => [a[0], b[0]].includes('pocket'))).toBe(false);
    const onPocket = (hoodie.matches ?? []).filter(
      ({a, b}) => a.panel === 'pocket' && b.panel === 'front',
    );
    expect(onPocket).toHaveLength(3);
    const hem = findEdge(hoodie, ['front', 'hem']).curve.to;
    const foot = findEdge(hoodie, ['pocket', 'foot']).curve.to;
    expect(foot[1]).toBe(hem[1]);
    expect(foot[0]).toBeLessThan(hem[0] - 5);
  });

  it('holds hem and wrists in with ribs', () => {
    const ratio = (panel: string, edge: string, rib: string): number =>
      lengthOf(panel, edge) / lengthOf(rib, 'upper');
    expect(ratio('sleeve_left', 'wrist', 'cuff_left')).toBeCloseTo(1.3, 6);
    expect(ratio('front', 'hem', 'band_front')).toBeCloseTo(1.15, 6);
    expect(lengthOf('cuff_left', 'upper')).toBeGreaterThan(medium.wrist);
  });
});
