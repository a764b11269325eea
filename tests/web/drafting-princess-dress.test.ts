import {expect, it} from 'vitest';

import {length, minus, norm} from '../../web/drafting/geometry.js';
import {findEdge} from '../../web/drafting/panel.js';
import {draftPrincessDress} from '../../web/drafting/princess-dress.js';
import {medium} from '../support/drafts.js';

it('has darts that are a notch with legs of one length, sewn to each other', () => {
  const dress = draftPrincessDress(medium);
  const lower = findEdge(dress, ['side_front_left', 'dart lower']);
  const upper = findEdge(dress, ['side_front_left', 'dart upper']);
  expect(lower.curve.to).toEqual(upper.curve.from);
  expect(length(lower.curve)).toBeCloseTo(length(upper.curve), 9);
  expect(norm(minus(lower.curve.from, upper.curve.to))).toBeCloseTo(0.032 * medium.bust, 6);
});
