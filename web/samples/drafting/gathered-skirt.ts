/**
 * An A-line skirt gathered into a waistband. Origin of each skirt panel: the height of its side
 * waist, in the middle.
 */
import {leftOf, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {across, leaning, length, line, reversed, trueTo, type Curve} from './curves.js';
import {edge, onBothSides, sew, symmetricPanel, type Garment, type Panel} from './panel.js';
import {bandPanel} from './skirt-lines.js';

export const waistGathers = 1.6;
const gathered = {gathers: waistGathers, notches: [0.25, 0.5, 0.75]};
const waistEase = 2;
const bandHeight = 4;
const sideLength = 58;
const flare = radians(9);
/** Excess of the front's width over the back's, at each side seam. */
const forward = 0.75;

type Half = 'front' | 'back';
const bandLength = (body: Body, half: Half): number =>
  (body.waist + waistEase) / 2 + (half === 'front' ? forward : -forward);

/** Curves that meet both side seams at right angles. */
const waistline = (halfWidth: number): Curve =>
  across([halfWidth, 0], leaning(Math.PI / 2 - flare));

function skirtPanel(body: Body, half: Half): Panel {
  const around = waistGathers * bandLength(body, half);
  const waist: Point = [
    trueTo(`the ${half} waist`, around, (w) => length(waistline(w)), around / 4, around / 2),
    0,
  ];
  const hem = plus(waist, leaning(-flare), -sideLength);
  const away = radiusOf(body.hip) + 10;
  return symmetricPanel(
    half,
    {
      bottom: edge('hem', across(hem, plus([0, 0], leftOf(leaning(-flare)), -1))),
      half: [edge('side', line(hem, waist))],
      top: edge('waist', reversed(waistline(waist[0]))),
      side: half === 'front' ? 'left' : 'right',
    },
    half === 'front'
      ? {translation: [0, body.waistHeight - bandHeight, away], rotation: [0, 0, 0]}
      : {translation: [0, body.waistHeight - bandHeight, -away], rotation: [0, 180, 0]},
  );
}

function waistband(body: Body, half: Half): Panel {
  const away = radiusOf(body.waist) + 8;
  return bandPanel(
    `waistband_${half}`,
    half === 'front' ? 'left' : 'right',
    ['lower', bandLength(body, half)],
    [],
    bandHeight,
    half === 'front'
      ? {translation: [0, body.waistHeight, away], rotation: [0, 0, 0]}
      : {translation: [0, body.waistHeight, -away], rotation: [0, 180, 0]},
  );
}

export function draftGatheredSkirt(body: Body): Garment {
  return {
    name: 'gathered-skirt',
    title: 'Gathered skirt',
    panels: [
      skirtPanel(body, 'front'),
      skirtPanel(body, 'back'),
      waistband(body, 'front'),
      waistband(body, 'back'),
    ],
    seams: [
      ...onBothSides('side', 'Side seam', ['front', 'side *'], ['back', 'side *'], {
        notches: [0.5],
      }),
      ...onBothSides(
        'side',
        'Waistband end',
        ['waistband_front', 'end *'],
        ['waistband_back', 'end *'],
      ),
      sew('gathered', 'Front waist', ['front', 'waist'], ['waistband_front', 'lower'], gathered),
      sew('gathered', 'Back waist', ['back', 'waist'], ['waistband_back', 'lower'], gathered),
    ],
    symmetries: [['front'], ['back'], ['waistband_front'], ['waistband_back']],
  };
}
