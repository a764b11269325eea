import {expect, it} from 'vitest';

import {draftGatheredSkirt, waistGathers} from '@samples/drafting/gathered-skirt.js';
import {length} from '@samples/drafting/curves.js';
import {findEdge} from '@samples/drafting/panel.js';
import {medium} from '../../../support/garments/drafts.js';

it('gathers 1.6 cm of skirt into every centimetre of waistband', () => {
  const skirt = draftGatheredSkirt(medium);
  const waist = length(findEdge(skirt, ['front', 'waist']).curve);
  const band = length(findEdge(skirt, ['waistband_front', 'lower']).curve);
  expect(waistGathers).toBe(1.6);
  expect(waist / band).toBeCloseTo(1.6, 9);
});
