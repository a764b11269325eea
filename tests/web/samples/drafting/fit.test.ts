/** Widths of fitted garments around the body; their panels are drafted with the waist at y = 0. */
import {describe, expect, it} from 'vitest';

import {distance, minus, type Point} from '@/model/geometry/vectors.js';
import {draftAsymmetricDress} from '@samples/drafting/asymmetric-dress.js';
import {bodyOf, sizeNames} from '@samples/drafting/body.js';
import {length, pointAt} from '@samples/drafting/curves.js';
import {findEdge, type Panel} from '@samples/drafting/panel.js';
import {draftPrincessDress} from '@samples/drafting/princess-dress.js';
import {medium} from '../../../support/garments/drafts.js';

/** Width of a panel at a height: between every two crossings of its outline. [cm] */
function widthAt({edges}: Panel, height: number): number {
  const steps = 200;
  const points = edges.flatMap(({curve}) =>
    Array.from({length: steps}, (_, k) => pointAt(curve, k / steps)),
  );
  const passes = points
    .flatMap((a, k) => {
      const b = points[(k + 1) % points.length] ?? a;
      const share = (height - a[1]) / (b[1] - a[1]);
      return a[1] < height === b[1] < height ? [] : [a[0] + share * (b[0] - a[0])];
    })
    .sort((p, q) => p - q);
  return passes.reduce((sum, x, k) => sum + (k % 2 === 0 ? -x : x), 0);
}

const girthAt = (panels: readonly Panel[], height: number): number =>
  panels.reduce((sum, panel) => sum + widthAt(panel, height), 0);

describe.each(sizeNames)('in size %s', (size) => {
  const body = bodyOf(size);

  it.each([
    [draftPrincessDress(body), 5],
    [draftAsymmetricDress(body), 6],
  ] as const)('the dress %# is as wide as the hip and its ease', ({panels}, ease) => {
    expect(girthAt(panels, -body.hipDepth)).toBeCloseTo(body.hip + ease, 1);
  });

  it.each([
    [draftPrincessDress(body), 4],
    [draftAsymmetricDress(body), 6],
  ] as const)('the dress %# is as wide as the waist and its ease', ({panels}, ease) => {
    expect(girthAt(panels, 1e-3)).toBeCloseTo(body.waist + ease, 1);
  });
});

it('marks every panel seam of the asymmetric dress so that it fits one way round only', () => {
  const dress = draftAsymmetricDress(medium);
  const inside = dress.seams.filter(({kind}) => kind === 'panel' || kind === 'front');
  expect(inside.length).toBe(17);
  for (const {name, notches = []} of inside) {
    const turned = notches.map((share) => 1 - share);
    expect(notches.length, name).toBeGreaterThan(0);
    const apart = notches.map((at) => Math.min(...turned.map((other) => Math.abs(at - other))));
    expect(Math.max(...apart), name).toBeGreaterThan(0.05);
  }
});

it('shapes the bust of the princess dress in a side dart and in the seam above the bust', () => {
  const dress = draftPrincessDress(medium);
  const lean = (from: Point, to: Point): number => {
    const [x, y] = minus(to, from);
    return (Math.atan2(x, y) * 180) / Math.PI;
  };
  const centre = findEdge(dress, ['centre_front', 'princess top left']).curve;
  const side = findEdge(dress, ['side_front_left', 'princess top']).curve;
  expect(lean(side.to, side.from) - lean(centre.from, centre.to)).toBeCloseTo(7, 6);
  const lower = findEdge(dress, ['side_front_left', 'dart lower']).curve;
  const upper = findEdge(dress, ['side_front_left', 'dart upper']).curve;
  expect(lower.to).toEqual(upper.from);
  expect(length(lower)).toBeCloseTo(length(upper), 9);
  expect(distance(lower.from, upper.to)).toBeCloseTo(0.027 * medium.bust, 6);
  // its tip ends before the bust
  expect(distance(lower.to, side.to)).toBeGreaterThan(3);
});

it('goes on above the bust dart of the princess dress as its side back does', () => {
  const dress = draftPrincessDress(medium);
  const chord = (panel: string): number => {
    const {from, to} = findEdge(dress, [panel, 'side upper']).curve;
    return distance(to, from);
  };
  expect(chord('side_front_left')).toBeCloseTo(chord('side_back_left'), 9);
});
