import {describe, expect, it} from 'vitest';

import {minus} from '@/model/geometry/vectors.js';
import {length, pointAt} from '@samples/drafting/curves.js';
import {findEdge} from '@samples/drafting/panel.js';
import {draftTee} from '@samples/drafting/tee.js';
import {medium} from '../../../support/garments/drafts.js';

describe('the tee', () => {
  const tee = draftTee(medium);
  const lengthOf = (...names: [string, string]): number => length(findEdge(tee, names).curve);

  it('has 2 to 3 cm of ease in each sleeve cap', () => {
    const cap = lengthOf('sleeve_left', 'cap front') + lengthOf('sleeve_left', 'cap back');
    const armhole = lengthOf('front', 'armhole left') + lengthOf('back', 'armhole left');
    expect(cap - armhole).toBeGreaterThanOrEqual(2);
    expect(cap - armhole).toBeLessThanOrEqual(3);
  });

  it('has sleeves whose front is scooped out further than their back', () => {
    const front = findEdge(tee, ['sleeve_left', 'cap front']).curve;
    const back = findEdge(tee, ['sleeve_left', 'cap back']).curve;
    // inwards, a quarter of the way up from the underarm
    const [frontIn] = minus(pointAt(front, 0.75), front.to);
    const [backIn] = minus(pointAt(back, 0.25), back.from);
    expect(frontIn).toBeGreaterThan(-backIn + 0.5);
  });

  it('says which measurements it cannot be drafted from', () => {
    expect(() => draftTee({...medium, upperArm: 90})).toThrow('sleeve cap cannot be made');
  });
});
