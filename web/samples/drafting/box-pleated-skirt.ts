/**
 * A straight skirt with an inverted box pleat in the middle of each of its four panels: front, back
 * and sides. The pleats open from the waistband down. Origin of each panel: the middle of its
 * waist. Its edges end at the lines of the pleat, whose fabric is sewn to nothing.
 */
import {plus, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {line} from './curves.js';
import {edge, onBothSides, pleatBetween, type Garment, type Panel, type Side} from './panel.js';
import {aroundHip, strip} from './skirt-lines.js';

const waistEase = 2;
const bandHeight = 4;
const drop = 56;
/** Fabric in a pleat: two repeats of most prints, within the solver's greatest change. */
const uptake = 20;

/** Length of half a panel's waist with its pleat closed. */
const halfWaist = (body: Body): number => (body.waist + waistEase) / 8;

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
  const parts = (edgeName: string): readonly (readonly [string, number])[] => [
    [`${edgeName} ${low}`, half],
    [`${edgeName} pleat`, uptake],
    [`${edgeName} ${high}`, half],
  ];
  const waist = strip([-far, 0], parts('waist')).map((part) => ({
    ...part,
    curve: line(part.curve.to, part.curve.from),
  }));
  return {
    name,
    edges: [
      ...strip([-far, -drop], parts('hem')),
      edge(`side ${high}`, line([far, -drop], [far, 0])),
      ...waist.reverse(),
      edge(`side ${low}`, line([-far, 0], [-far, -drop])),
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
