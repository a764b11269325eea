/**
 * A straight skirt with an inverted box pleat in the middle of each of its four panels: front, back
 * and sides. The side seams are shaped over the hip, so that the pleats hang closed. Origin of each
 * panel: the middle of its waist. Its edges end at the lines of the pleat, whose fabric is sewn to
 * nothing.
 */
import {plus, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {line, mirrored, moved, reversed, type Curve} from './curves.js';
import {edge, onBothSides, pleatBetween, type Garment, type Panel, type Side} from './panel.js';
import {aroundHip, hipSeam, strip} from './skirt-lines.js';

/** More than without pleats, whose three layers are inside the band. */
const waistEase = 3;
const hipEase = 4;
const bandHeight = 4;
const drop = 56;
/** Fabric in a pleat: two repeats of most prints, within the solver's greatest change. */
const uptake = 20;

/** Length of half a panel's waist with its pleat closed. */
const halfWaist = (body: Body): number => (body.waist + waistEase) / 8;

/** An edge of a side seam, upwards to the waist at the origin, for the fabric at its -x side. */
const sideSeam = (body: Body): Curve =>
  hipSeam({
    atHip: (body.hip + hipEase - body.waist - waistEase) / 8,
    hipDepth: body.hipDepth - bandHeight,
    flare: 0,
    drop,
  });

/** @param ends names of the halves at -x and at +x */
function skirtPanel(
  body: Body,
  name: string,
  ends: readonly [string, string],
  angle: number,
): Panel {
  const [low, high] = ends;
  const half = halfWaist(body);
  const far = uptake / 2 + half;
  const parts = (edgeName: string, side: number): readonly (readonly [string, number])[] => [
    [`${edgeName} ${low}`, side],
    [`${edgeName} pleat`, uptake],
    [`${edgeName} ${high}`, side],
  ];
  const waist = strip([-far, 0], parts('waist', half)).map((part) => ({
    ...part,
    curve: line(part.curve.to, part.curve.from),
  }));
  const seam = moved(sideSeam(body), [far, 0]);
  const hem = seam.from[0];
  return {
    name,
    edges: [
      ...strip([-hem, -drop], parts('hem', hem - uptake / 2)),
      edge(`side ${high}`, seam),
      ...waist.reverse(),
      edge(`side ${low}`, reversed(mirrored(seam))),
    ],
    placement: aroundHip(body, angle, {away: 14, height: body.waistHeight - bandHeight}),
    folds: [pleatBetween('inverted', [-uptake / 2, 0], [uptake / 2, 0], drop)],
  };
}

/** A half of the waistband, over a whole panel and half of each side panel. */
function waistband(body: Body, half: 'front' | 'back'): Panel {
  const [low, high]: readonly [Side, Side] =
    half === 'front' ? ['right', 'left'] : ['left', 'right'];
  const part = halfWaist(body);
  const from: Point = [-2 * part, 0];
  const to = plus(from, [4 * part, 0]);
  const up: Point = [0, bandHeight];
  const away = (half === 'front' ? 1 : -1) * (radiusOf(body.waist) + 8);
  return {
    name: `waistband_${half}`,
    edges: [
      ...strip(from, [
        [`lower side ${low}`, part],
        [`lower middle ${low}`, part],
        [`lower middle ${high}`, part],
        [`lower side ${high}`, part],
      ]),
      edge(`end ${high}`, line(to, plus(to, up))),
      edge('upper', line(plus(to, up), plus(from, up))),
      edge(`end ${low}`, line(plus(from, up), from)),
    ],
    placement: {
      translation: [0, body.waistHeight, away],
      rotation: [0, half === 'front' ? 0 : 180, 0],
    },
  };
}

export function draftBoxPleatedSkirt(body: Body): Garment {
  const halves = ['front', 'back'] as const;
  return {
    name: 'box-pleated-skirt',
    title: 'Box-pleated skirt',
    panels: [
      skirtPanel(body, 'front', ['right', 'left'], 0),
      skirtPanel(body, 'side_left', ['front', 'back'], 90),
      skirtPanel(body, 'side_right', ['back', 'front'], -90),
      skirtPanel(body, 'back', ['left', 'right'], 180),
      waistband(body, 'front'),
      waistband(body, 'back'),
    ],
    seams: [
      ...halves.flatMap((half) =>
        onBothSides(
          'side',
          half === 'front' ? 'Front side seam' : 'Back side seam',
          [half, 'side *'],
          ['side_*', `side ${half}`],
          {notches: half === 'front' ? [0.5] : [0.49, 0.51]},
        ),
      ),
      ...halves.flatMap((half) => [
        ...onBothSides(
          'waist',
          `Waist, ${half}`,
          [`waistband_${half}`, 'lower middle *'],
          [half, 'waist *'],
        ),
        ...onBothSides(
          'waist',
          `Waist, ${half} of the side`,
          [`waistband_${half}`, 'lower side *'],
          ['side_*', `waist ${half}`],
        ),
      ]),
      ...onBothSides(
        'side',
        'Waistband end',
        ['waistband_front', 'end *'],
        ['waistband_back', 'end *'],
      ),
    ],
    symmetries: [
      ['front'],
      ['side_left', 'side_right'],
      ['back'],
      ['waistband_front'],
      ['waistband_back'],
    ],
  };
}
