/**
 * A short-sleeved raglan shirt cut in pairs throughout, with seams at the centre front and the
 * centre back, and sleeves divided along the top of the arm. Each half of a sleeve is drawn onto
 * the body that it is cut from, then rotated so that the arm hangs down.
 */
import {
  distance,
  leftOf,
  minus,
  plus,
  radians,
  rotated,
  unit,
  type Point,
} from '../../src/model/geometry/vectors.js';
import {bodiceHalf, halfNeckline, hung, type BodiceStyle, type Half} from './bodice.js';
import type {Body} from './body.js';
import {
  curve,
  leaning,
  length,
  line,
  mapped,
  reversed,
  splitAtLengths,
  trueTo,
  type Curve,
} from './curves.js';
import {edge, onBothSides, pairOf, sew, type Garment, type Panel, type Side} from './panel.js';
import {hungSleeve} from './sleeve.js';

const style: BodiceStyle = {
  bustEase: 14,
  hipEase: 8,
  armholeDepth: 13.5,
  shoulderOut: 0.4,
  shoulderSlope: radians(19),
  neckOut: 1.6,
  neckDepth: {front: 9, back: 2.4},
  frontLower: 0,
  hemBelowWaist: 19,
  sideLean: radians(3.5),
  forward: 0.5,
  scoop: {front: 1.2, back: 0.6}, // the raglan line replaces the armhole
};
/** Distance of the raglan seam's end from the shoulder, along the neckline. [cm] */
const onNeckline: Readonly<Record<Half, number>> = {front: 3.6, back: 2.4};
/** Angle of the raglan seam towards the neck, at the neckline. */
const raglanLean: Readonly<Record<Half, number>> = {front: radians(30), back: radians(24)};
const sleeve = {ease: 9, length: 24, taper: radians(6)};
/** Angle of the arm below level: the smaller, the more room to move. */
const armSlope = radians(42);
const along: Point = [Math.cos(armSlope), -Math.sin(armSlope)];
/** Direction from the top of the arm to the underarm. */
const down = plus([0, 0], leftOf(along), -1);

interface HalfDraft {
  readonly side: Curve;
  readonly tip: Point;
  readonly raglan: Curve;
  /** Parts of the neckline from the shoulder to the raglan seam, and on to the centre. */
  readonly neckline: {readonly sleeve: Curve; readonly body: Curve};
}

function halfOf(body: Body, half: Half): HalfDraft {
  const {side, shoulder} = bodiceHalf(body, half, style);
  const whole = halfNeckline(shoulder.to, style.neckDepth[half], style.shoulderSlope);
  const [onSleeve, onBody] = splitAtLengths('the raglan seam', whole, [onNeckline[half]]);
  if (!onSleeve || !onBody) throw new Error('a neckline that the raglan seam parts');
  const chord = distance(onBody.from, side.to);
  const raglan = curve(
    side.to,
    leftOf(leaning(style.sideLean)),
    onBody.from,
    leaning(-raglanLean[half]),
    0.3 * chord,
    0.3 * chord,
  );
  return {side, tip: shoulder.from, raglan, neckline: {sleeve: onSleeve, body: onBody}};
}

/**
 * The sleeve's edge of the raglan seam; it leaves the underarm seam at a right angle, as the body's
 * leaves the side.
 */
function sleeveRaglan(half: Half, neck: Point, underarm: Point): Curve {
  const chord = distance(neck, underarm);
  return curve(
    underarm,
    rotated(plus([0, 0], down, -1), sleeve.taper),
    neck,
    leaning(-raglanLean[half]),
    0.24 * chord,
    0.34 * chord,
  );
}

/**
 * The underarm point of half a sleeve, by its width there and its distance from the hem along the
 * arm.
 */
function underarmPoint({tip}: HalfDraft, width: number, fromHem: number): Point {
  return plus(plus(tip, along, sleeve.length - fromHem), down, width);
}

const raglanLength = (half: Half, draft: HalfDraft, width: number, fromHem: number): number =>
  length(sleeveRaglan(half, draft.raglan.to, underarmPoint(draft, width, fromHem)));

/** Limits of a half sleeve's width. [cm] */
const widths = {least: 10, most: 40};

function widthAt(half: Half, draft: HalfDraft, fromHem: number): number {
  return trueTo(
    `the ${half} raglan seam`,
    length(draft.raglan),
    (width) => raglanLength(half, draft, width, fromHem),
    widths.least,
    widths.most,
  );
}

/** Least distance of the underarm from the hem; the raglan seam would be too long below it. [cm] */
function leastFromHem(half: Half, draft: HalfDraft): number {
  return trueTo(
    `the ${half} raglan seam`,
    length(draft.raglan),
    (fromHem) => raglanLength(half, draft, widths.least, fromHem),
    0,
    sleeve.length,
  );
}

function bodyPanels(body: Body, half: Half, draft: HalfDraft): readonly [Panel, Panel] {
  const {side, raglan, neckline} = draft;
  const top = neckline.body.to;
  // the centre back slants in towards the hem, square to it and to the neckline
  const foot: Point = [half === 'front' ? 0 : 1, side.from[1]];
  const centre = half === 'front' ? line(top, foot) : curve(top, [0, -1], foot, [0, -1], 18, 24);
  return pairOf(
    half,
    half === 'front' ? 'left' : 'right',
    [
      edge('hem', line(foot, side.from)),
      edge('side', side),
      edge('raglan', raglan),
      edge('neckline', neckline.body),
      edge('centre', centre),
    ],
    hung(body, half, 8, half === 'front' ? 2 : -2),
  );
}

function sleevePanels(
  body: Body,
  half: Half,
  draft: HalfDraft,
  fromHem: number,
): readonly [Panel, Panel] {
  const {tip, neckline} = draft;
  const width = widthAt(half, draft, fromHem);
  const underarm = underarmPoint(draft, width, fromHem);
  const top = plus(tip, along, sleeve.length);
  const low = plus(top, down, width - fromHem * Math.tan(sleeve.taper));
  const upwards = unit(minus(underarm, low));
  const neck = neckline.sleeve.from;
  // over the shoulder and down the arm in one line
  const overarm = curve(
    top,
    plus([0, 0], along, -1),
    neck,
    [-Math.cos(style.shoulderSlope), Math.sin(style.shoulderSlope)],
    0.45 * distance(top, neck),
    0.3 * distance(top, neck),
  );
  const edges: readonly (readonly [string, Curve])[] = [
    ['hem', curve(low, plus([0, 0], leftOf(upwards), -1), top, plus([0, 0], down, -1))],
    ['overarm', overarm],
    ['neckline', neckline.sleeve],
    ['raglan', reversed(sleeveRaglan(half, draft.raglan.to, underarm))],
    ['underarm', line(underarm, low)],
  ];
  const hanging = (p: Point): Point => rotated(minus(p, tip), armSlope - Math.PI / 2);
  const side: Side = half === 'front' ? 'left' : 'right';
  const {translation, rotation} = hungSleeve(body, tip, 0);
  const [x, y] = translation;
  return pairOf(
    `sleeve_${half}`,
    side,
    edges.map(([name, drawn]) => edge(name, mapped(drawn, hanging))),
    // rotated slightly from straight ahead, or from straight back on the other side
    half === 'front'
      ? {translation: [x, y, 9], rotation: [0, 20, rotation[2]]}
      : {translation: [-x, y, -9], rotation: [0, -160, -rotation[2]]},
  );
}

export function draftRaglan(body: Body): Garment {
  const front = halfOf(body, 'front');
  const back = halfOf(body, 'back');
  const fromHem = trueTo(
    'the sleeve width',
    body.upperArm + sleeve.ease,
    (l) => widthAt('front', front, l) + widthAt('back', back, l),
    Math.max(leastFromHem('front', front), leastFromHem('back', back)) + 1e-6,
    sleeve.length - 4,
  );
  return {
    name: 'raglan',
    title: 'Raglan shirt',
    panels: [
      ...bodyPanels(body, 'front', front),
      ...bodyPanels(body, 'back', back),
      ...sleevePanels(body, 'front', front, fromHem),
      ...sleevePanels(body, 'back', back, fromHem),
    ],
    seams: [
      sew('centre', 'Centre front', ['front_left', 'centre'], ['front_right', 'centre'], {
        notches: [0.5],
      }),
      sew('centre', 'Centre back', ['back_left', 'centre'], ['back_right', 'centre'], {
        notches: [0.5],
      }),
      ...onBothSides('side', 'Side seam', ['front_*', 'side'], ['back_*', 'side'], {
        notches: [0.5],
      }),
      ...onBothSides(
        'armhole',
        'Front raglan seam',
        ['sleeve_front_*', 'raglan'],
        ['front_*', 'raglan'],
        {notches: [0.55]},
      ),
      ...onBothSides(
        'armhole',
        'Back raglan seam',
        ['sleeve_back_*', 'raglan'],
        ['back_*', 'raglan'],
        {notches: [0.53, 0.57]},
      ),
      ...onBothSides(
        'shoulder',
        'Overarm',
        ['sleeve_front_*', 'overarm'],
        ['sleeve_back_*', 'overarm'],
        {notches: [0.5]},
      ),
      ...onBothSides(
        'underarm',
        'Underarm',
        ['sleeve_front_*', 'underarm'],
        ['sleeve_back_*', 'underarm'],
      ),
    ],
    symmetries: [
      ['front_left', 'front_right'],
      ['back_left', 'back_right'],
      ['sleeve_front_left', 'sleeve_front_right'],
      ['sleeve_back_left', 'sleeve_back_right'],
    ],
  };
}
