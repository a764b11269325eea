import {expect, it} from 'vitest';

import {distance} from '@/model/geometry/vectors.js';
import {length} from '@samples/drafting/curves.js';
import {findEdge} from '@samples/drafting/panel.js';
import {draftShiftDress} from '@samples/drafting/shift-dress.js';
import {medium} from '../../../support/garments/drafts.js';

it('has bust darts that are a notch with legs of one length', () => {
  const dress = draftShiftDress(medium);
  const lower = findEdge(dress, ['front', 'dart lower left']);
  const upper = findEdge(dress, ['front', 'dart upper left']);
  expect(lower.curve.to).toEqual(upper.curve.from);
  expect(length(lower.curve)).toBeCloseTo(length(upper.curve), 9);
  expect(distance(lower.curve.from, upper.curve.to)).toBeCloseTo(0.031 * medium.bust, 6);
});
