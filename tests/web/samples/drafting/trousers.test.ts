import {describe, expect, it} from 'vitest';

import {bodyOf, sizeNames} from '@samples/drafting/body.js';
import {notchesOf} from '@samples/drafting/garment-file.js';
import {length, pointAt, velocity, type Curve} from '@samples/drafting/curves.js';
import {findEdge} from '@samples/drafting/panel.js';
import {draftTrousers} from '@samples/drafting/trousers.js';

describe.each(sizeNames)('the trousers in size %s', (size) => {
  const body = bodyOf(size);
  const trousers = draftTrousers(body);
  const curveOf = (panel: string, edge: string): Curve => findEdge(trousers, [panel, edge]).curve;

  it('have a waistband 2 cm longer than the waist', () => {
    expect(2 * length(curveOf('waistband_left', 'upper'))).toBeCloseTo(body.waist + 2, 6);
  });

  it('are marked at the knee, on both seams of every leg', () => {
    for (const panel of trousers.panels.filter(({name}) => !name.startsWith('waistband'))) {
      const marks = notchesOf(panel, trousers).flatMap(({edge, at}) => {
        const {name, curve} = panel.edges[edge] ?? {name: '', curve: undefined};
        return curve && name.endsWith('lower leg') ? [pointAt(curve, at)[1]] : [];
      });
      expect(marks).toEqual([-body.kneeDepth, -body.kneeDepth]);
    }
  });

  it('are 5 cm wider than the hip, from the centre lines to the outseams', () => {
    const [front = NaN, back = NaN] = ['front_left', 'back_right'].map(
      (leg) => curveOf(leg, 'outseam hip').from[0] - curveOf(leg, 'centre').to[0],
    );
    expect(2 * (front + back)).toBeCloseTo(body.hip + 5, 6);
  });

  it('have a longer seat than front, and a back crotch that lies lower', () => {
    const around = (leg: string): number =>
      length(curveOf(leg, 'centre')) + length(curveOf(leg, 'crotch'));
    expect(around('back_right') - around('front_left')).toBeGreaterThan(5);
    const drop = curveOf('front_left', 'crotch').to[1] - curveOf('back_right', 'crotch').to[1];
    expect(drop).toBeGreaterThan(0.3);
    expect(drop).toBeLessThan(3);
  });

  it('have a crotch curve that runs on smoothly from fly and seat', () => {
    for (const leg of ['front_left', 'back_right']) {
      const [ax, ay] = velocity(curveOf(leg, 'centre'), 1);
      const [bx, by] = velocity(curveOf(leg, 'crotch'), 0);
      expect(Math.atan2(ax * by - ay * bx, ax * bx + ay * by)).toBeCloseTo(0, 9);
    }
  });
});
