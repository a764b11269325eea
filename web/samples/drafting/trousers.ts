/**
 * Straight trousers: two fronts and two backs with a waist dart each, and a straight waistband,
 * open at the centre front.
 */
import {plus, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import type {DartedEdge} from './darts.js';
import {length, line, moved} from './curves.js';
import {
  edge,
  onBothSides,
  pairOf,
  sew,
  type Edge,
  type Garment,
  type Panel,
  type Placement,
} from './panel.js';
import {strip} from './skirt-lines.js';
import {frameOf, legOf, type Half} from './trouser-leg.js';

const bandHeight = 4;

/** Both legs of a half, side by side. */
function legs(body: Body, half: Half, edges: readonly Edge[]): readonly [Panel, Panel] {
  const clear = 1 - frameOf(body, half).crotchX;
  const away = radiusOf(body.hip) + 9;
  const placement: Placement =
    half === 'front'
      ? {translation: [clear, body.waistHeight, away], rotation: [0, 0, 0]}
      : {translation: [-clear, body.waistHeight, -away], rotation: [0, 180, 0]};
  return pairOf(half, half === 'front' ? 'left' : 'right', edges, placement);
}

/** Half the waistband, from the centre front to the centre back. Origin: its lower front corner. */
function waistbands(body: Body, front: DartedEdge, back: DartedEdge): readonly [Panel, Panel] {
  const lower = strip(
    [0, 0],
    [
      ['front centre', length(front.after)],
      ['front side', length(front.before)],
      ['back side', length(back.before)],
      ['back centre', length(back.after)],
    ],
  );
  const end = lower.at(-1)?.curve.to ?? [0, 0];
  const up: Point = [0, bandHeight];
  return pairOf(
    'waistband',
    'left',
    [
      ...lower,
      edge('centre back', line(end, plus(end, up))),
      edge('upper', moved(line(end, [0, 0]), up)),
      edge('centre front', line(up, [0, 0])),
    ],
    {
      translation: [radiusOf(body.waist) + 8, body.waistHeight + 2, end[0] / 2],
      rotation: [0, 90, 0],
    },
  );
}

export function draftTrousers(body: Body): Garment {
  const front = legOf(body, 'front');
  const back = legOf(body, 'back');
  const halves = ['front', 'back'] as const;
  return {
    name: 'trousers',
    title: 'Straight trousers',
    panels: [
      ...legs(body, 'front', front.edges),
      ...legs(body, 'back', back.edges),
      ...waistbands(body, front.waist, back.waist),
    ],
    seams: [
      // the lower leg ends at the knee, which is marked
      ...['lower leg', 'thigh', 'hip'].flatMap((part) =>
        onBothSides(
          'side',
          `Outseam, ${part}`,
          ['front_*', `outseam ${part}`],
          ['back_*', `outseam ${part}`],
          part === 'lower leg' ? {notches: [1]} : {},
        ),
      ),
      ...['lower leg', 'thigh'].flatMap((part) =>
        onBothSides(
          'inseam',
          `Inseam, ${part}`,
          ['front_*', `inseam ${part}`],
          ['back_*', `inseam ${part}`],
          part === 'lower leg' ? {notches: [0]} : {},
        ),
      ),
      sew('front', 'Fly', ['front_left', 'centre'], ['front_right', 'centre']),
      sew('centre', 'Seat seam', ['back_left', 'centre'], ['back_right', 'centre']),
      ...halves.map((half) =>
        sew(
          'inseam',
          `${half === 'front' ? 'Front' : 'Back'} crotch`,
          [`${half}_left`, 'crotch'],
          [`${half}_right`, 'crotch'],
          {notches: half === 'front' ? [0.5] : [0.48, 0.52]},
        ),
      ),
      ...halves.flatMap((half) => [
        ...onBothSides(
          'dart',
          `Waist dart, ${half}`,
          [`${half}_*`, 'dart side'],
          [`${half}_*`, 'dart centre'],
        ),
        ...['centre', 'side'].flatMap((part) =>
          onBothSides(
            'waist',
            `Waist, ${half} ${part}`,
            ['waistband_*', `${half} ${part}`],
            [`${half}_*`, `waist ${part}`],
          ),
        ),
      ]),
      sew(
        'front',
        'Waistband, centre front',
        ['waistband_left', 'centre front'],
        ['waistband_right', 'centre front'],
      ),
      sew(
        'centre',
        'Waistband, centre back',
        ['waistband_left', 'centre back'],
        ['waistband_right', 'centre back'],
      ),
    ],
    symmetries: [
      ['front_left', 'front_right'],
      ['back_left', 'back_right'],
      ['waistband_left', 'waistband_right'],
    ],
  };
}
