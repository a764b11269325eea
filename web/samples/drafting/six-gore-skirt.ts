/**
 * A six-gore skirt on a straight waistband: centre front, two side fronts, two side backs, centre
 * back. It is fitted to the hip and flares from there. The two edges of a seam have one shape.
 * Origin of a gore: the middle of its waist.
 */
import {radians} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {length, mirrored, moved, reversed, trueTo, type Curve} from './curves.js';
import {
  edge,
  onBothSides,
  pairOf,
  sew,
  symmetricPanel,
  type Garment,
  type Panel,
  type Placement,
} from './panel.js';
import {aroundHip, bandPanel, hipSeam, squareAbove, squareBelow} from './skirt-lines.js';

const waistEase = 2;
/** Ease for straight waists; the actual curved ones reduce it by up to half a centimetre. */
const hipEase = 6;
const bandHeight = 3.5;
const seamDrop = 60;
const flare = radians(8);
/**
 * Share of each of the seams' twelve edges in the hip's excess over the waist, relative to the
 * mean.
 */
const shaping = {front: 0.8, side: 1.25, back: 0.95};
/** The centre gore's share of half the waist. */
const centreShare = {front: 0.37, back: 0.35};
/** Excess of the front's width over the back's, at each side seam. */
const forward = 0.75;

type Half = 'front' | 'back';

/** Waist lengths of the gores and the band of a half. [cm] */
function waistParts(body: Body, half: Half): {readonly centre: number; readonly side: number} {
  const whole = (body.waist + waistEase) / 2 + (half === 'front' ? forward : -forward);
  const centre = centreShare[half] * whole;
  return {centre, side: (whole - centre) / 2};
}

function seamOf(body: Body, which: keyof typeof shaping): Curve {
  const wider = (body.hip + hipEase - body.waist - waistEase) / 12;
  return hipSeam({
    atHip: shaping[which] * wider,
    hipDepth: body.hipDepth,
    flare,
    drop: seamDrop,
  });
}

/**
 * The seams of a gore, the one at -x first, both upwards, with the distance that gives its waist
 * this length.
 */
function goreSeams(what: string, inner: Curve, outer: Curve, waist: number): [Curve, Curve] {
  const apart = (width: number): [Curve, Curve] => [
    moved(mirrored(inner), [-width / 2, 0]),
    moved(outer, [width / 2, 0]),
  ];
  const waistOf = ([from, to]: [Curve, Curve]): number => length(squareAbove(to, from));
  return apart(trueTo(what, waist, (width) => waistOf(apart(width)), waist / 2, waist));
}

const around = (body: Body, angle: number): Placement =>
  aroundHip(body, angle, {away: 12, height: body.waistHeight});

function centreGore(body: Body, half: Half): Panel {
  const seam = seamOf(body, half);
  const [inner, outer] = goreSeams(
    `the centre ${half} waist`,
    seam,
    seam,
    waistParts(body, half).centre,
  );
  return symmetricPanel(
    `centre_${half}`,
    {
      bottom: edge('hem', squareBelow(inner, outer)),
      half: [edge('panel seam', outer)],
      top: edge('waist', squareAbove(outer, inner)),
      side: half === 'front' ? 'left' : 'right',
    },
    around(body, half === 'front' ? 0 : 180),
  );
}

function sideGores(body: Body, half: Half): readonly [Panel, Panel] {
  const [inner, outer] = goreSeams(
    `the side ${half} waist`,
    seamOf(body, half),
    seamOf(body, 'side'),
    waistParts(body, half).side,
  );
  return pairOf(
    `side_${half}`,
    half === 'front' ? 'left' : 'right',
    [
      edge('hem', squareBelow(inner, outer)),
      edge('side', outer),
      edge('waist', squareAbove(outer, inner)),
      edge('panel seam', reversed(inner)),
    ],
    around(body, half === 'front' ? 60 : -120),
  );
}

function waistband(body: Body, half: Half): Panel {
  const {centre, side} = waistParts(body, half);
  const away = (half === 'front' ? 1 : -1) * (radiusOf(body.waist) + 8);
  return bandPanel(
    `waistband_${half}`,
    half === 'front' ? 'left' : 'right',
    ['lower centre', centre],
    [['lower', side]],
    bandHeight,
    {
      translation: [0, body.waistHeight + 1, away],
      rotation: [0, half === 'front' ? 0 : 180, 0],
    },
  );
}

export function draftSixGoreSkirt(body: Body): Garment {
  const hipNotch = 1 - body.hipDepth / seamDrop;
  return {
    name: 'six-gore-skirt',
    title: 'Six-gore skirt',
    panels: [
      centreGore(body, 'front'),
      ...sideGores(body, 'front'),
      ...sideGores(body, 'back'),
      centreGore(body, 'back'),
      waistband(body, 'front'),
      waistband(body, 'back'),
    ],
    seams: [
      ...onBothSides(
        'panel',
        'Front panel seam',
        ['centre_front', 'panel seam *'],
        ['side_front_*', 'panel seam'],
        {notches: [hipNotch]},
      ),
      ...onBothSides('side', 'Side seam', ['side_front_*', 'side'], ['side_back_*', 'side'], {
        notches: [hipNotch],
      }),
      ...onBothSides(
        'panel',
        'Back panel seam',
        ['centre_back', 'panel seam *'],
        ['side_back_*', 'panel seam'],
        {notches: [hipNotch - 0.01, hipNotch + 0.01]},
      ),
      ...(['front', 'back'] as const).flatMap((half) => [
        sew(
          'waist',
          `Waist, centre ${half}`,
          [`waistband_${half}`, 'lower centre'],
          [`centre_${half}`, 'waist'],
          {notches: [0.5]},
        ),
        ...onBothSides(
          'waist',
          `Waist, side ${half}`,
          [`waistband_${half}`, 'lower *'],
          [`side_${half}_*`, 'waist'],
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
      ['centre_front'],
      ['side_front_left', 'side_front_right'],
      ['side_back_left', 'side_back_right'],
      ['centre_back'],
      ['waistband_front'],
      ['waistband_back'],
    ],
  };
}
