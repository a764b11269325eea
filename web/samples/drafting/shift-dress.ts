/**
 * A shift dress with short sleeves: a front with side bust darts, a back in two halves with a
 * centre back seam.
 */
import {leftOf, plus, radians, rotated, type Point} from '../../src/model/geometry/vectors.js';
import {halfNeckline, hung, roundNeckline, type Half} from './bodice.js';
import type {Body} from './body.js';
import {bustDart} from './darts.js';
import {curve, leaning, length, line, mirrored, reversed, type Curve} from './curves.js';
import {edge, onBothSides, pairOf, sew, symmetricPanel, type Garment, type Panel} from './panel.js';
import {squareBelow} from './skirt-lines.js';
import {setInOutline, setInSeams} from './set-in-sleeve.js';
import {hungSleeve, sleeveCap, sleeveTube} from './sleeve.js';

const bustEase = 10;
const hipEase = 8;
const skirtLength = 56;
const flare = radians(2);
const sideLean = radians(6);
const neckOut = 2.2;
const neckDepth = {front: 9, back: 2.6};
/**
 * Intake of the bust dart, as a part of the bust, and its share by which the front is longer above
 * the bust.
 */
const dartIntake = 0.031;
const frontLonger = 0.6;
/** Intake of the centre back seam from the waist down. */
const centreTaken = 1.2;
const capEase = {front: 1.1, back: 1.4};
const sleeve = {ease: 8, length: 22, taper: radians(6)};
const away = 8;

/**
 * Differences of front and back. Handles of the armhole at the underarm and at the shoulder. [cm,
 * radians]
 */
const shapes = {
  front: {wider: 0.5, slope: radians(22), scoop: [7.6, 9]},
  back: {wider: -0.5, slope: radians(17), scoop: [5.4, 10.5]},
} as const;

/**
 * The side seam up to the height of the dart, curved in at the waist, and its remaining length to
 * the underarm.
 */
function sideOf(body: Body, half: Half): {readonly lower: Curve; readonly upper: number} {
  const {wider} = shapes[half];
  const dartHeight = 0.27 * body.backLength;
  const underarm: Point = [
    (body.bust + bustEase) / 4 + wider,
    body.backLength - (body.bust / 10 + 12.5),
  ];
  const upper = (underarm[1] - dartHeight) / Math.cos(sideLean);
  const dart = plus(underarm, leaning(sideLean), -upper);
  const swing = (skirtLength - body.hipDepth) * Math.tan(flare);
  const hem: Point = [(body.hip + hipEase) / 4 + wider + swing, -skirtLength];
  return {lower: curve(hem, leaning(-flare), dart, leaning(sideLean), 34, 17), upper};
}

/** Armhole and shoulder above the underarm, where the side seam arrives along `lean`. */
interface Top {
  readonly armhole: Curve;
  readonly shoulder: Curve;
}

/** @param raised  height of the shoulder over the back's */
function topOf(body: Body, half: Half, underarm: Point, lean: Point, raised = 0): Top {
  const {slope, scoop} = shapes[half];
  const neck: Point = [body.neck / 5 + neckOut, body.backLength + 1.8 + raised];
  const shoulderLength = (body.shoulderWidth / 2 + 0.2 - neck[0]) / Math.cos(shapes.back.slope);
  const tip = plus(neck, [Math.cos(slope), -Math.sin(slope)], shoulderLength);
  return {
    armhole: curve(underarm, leftOf(lean), tip, leaning(slope), ...scoop),
    shoulder: line(tip, neck),
  };
}

function front(body: Body): {readonly panel: Panel; readonly armhole: Curve} {
  const {lower, upper} = sideOf(body, 'front');
  const intake = dartIntake * body.bust;
  const bust: Point = [body.bustSpan / 2 + 0.5, 0.4 * body.backLength];
  const {legs, opening} = bustDart(lower.to, bust, intake);
  const along = rotated(leaning(sideLean), opening);
  const sideUpper = line(legs[1].to, plus(legs[1].to, along, upper));
  const {armhole, shoulder} = topOf(body, 'front', sideUpper.to, along, frontLonger * intake);
  const neckline = roundNeckline(shoulder.to, neckDepth.front, shapes.front.slope);
  const panel = symmetricPanel(
    'front',
    {
      bottom: edge('hem', squareBelow(mirrored(lower), lower)),
      half: [
        edge('side lower', lower),
        edge('dart lower', legs[0]),
        edge('dart upper', legs[1]),
        edge('side upper', sideUpper),
        edge('armhole', armhole),
        edge('shoulder', shoulder),
      ],
      top: edge('neckline', reversed(neckline)),
      side: 'left',
    },
    hung(body, 'front', away),
  );
  return {panel, armhole};
}

function backs(body: Body): {readonly panels: readonly [Panel, Panel]; readonly armhole: Curve} {
  const {lower, upper} = sideOf(body, 'back');
  const lean = leaning(sideLean);
  const sideUpper = line(lower.to, plus(lower.to, lean, upper));
  const {armhole, shoulder} = topOf(body, 'back', sideUpper.to, lean);
  const neckline = halfNeckline(shoulder.to, neckDepth.back, shapes.back.slope);
  const down: Point = [0, -1];
  const centre = curve(neckline.to, down, [centreTaken, -skirtLength], down, 30, 55);
  const panels = pairOf(
    'back',
    'right',
    [
      edge('hem', squareBelow(reversed(centre), lower)),
      edge('side lower', lower),
      edge('side upper', sideUpper),
      edge('armhole', armhole),
      edge('shoulder', shoulder),
      edge('neckline', neckline),
      edge('centre back', centre),
    ],
    hung(body, 'back', away, -1.5),
  );
  return {panels, armhole};
}

function sleeves(body: Body, armholes: Readonly<Record<Half, Curve>>): readonly [Panel, Panel] {
  const cap = sleeveCap(
    {front: length(armholes.front), back: length(armholes.back)},
    {width: body.upperArm + sleeve.ease, ease: capEase, taper: sleeve.taper},
  );
  const tube = sleeveTube(cap, sleeve.taper, sleeve.length - cap.height);
  return pairOf(
    'sleeve',
    'left',
    setInOutline(cap, tube),
    hungSleeve(body, armholes.back.to, cap.height),
  );
}

export function draftShiftDress(body: Body): Garment {
  const {panel, armhole: frontArmhole} = front(body);
  const {panels, armhole: backArmhole} = backs(body);
  return {
    name: 'shift-dress',
    title: 'Shift dress',
    panels: [panel, ...panels, ...sleeves(body, {front: frontArmhole, back: backArmhole})],
    seams: [
      sew('centre', 'Centre back', ['back_left', 'centre back'], ['back_right', 'centre back'], {
        notches: [0.3, 0.6],
      }),
      ...onBothSides('shoulder', 'Shoulder', ['front', 'shoulder *'], ['back_*', 'shoulder']),
      ...onBothSides('dart', 'Bust dart', ['front', 'dart lower *'], ['front', 'dart upper *']),
      ...onBothSides(
        'side',
        'Side seam above the dart',
        ['front', 'side upper *'],
        ['back_*', 'side upper'],
      ),
      ...onBothSides(
        'side',
        'Side seam below the dart',
        ['front', 'side lower *'],
        ['back_*', 'side lower'],
        {notches: [0.4, 0.8]},
      ),
      ...setInSeams(capEase, {front: ['front', 'armhole *'], back: ['back_*', 'armhole']}),
    ],
    symmetries: [['front'], ['back_left', 'back_right'], ['sleeve_left', 'sleeve_right']],
  };
}
