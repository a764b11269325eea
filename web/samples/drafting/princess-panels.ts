/**
 * The panels of the princess dress, each drafted for the +x side of the view onto its face; the
 * height of the waist is y = 0 throughout.
 */
import {leftOf, minus, plus, rotated, type Point} from '../../src/model/geometry/vectors.js';
import {halfNeckline, hung, roundNeckline} from './bodice.js';
import {radiusOf, type Body} from './body.js';
import {bustDart} from './darts.js';
import {bodiceSeam} from './fitted-seams.js';
import {curve, leaning, line, mapped, mirrored, moved, reversed, type Curve} from './curves.js';
import {edge, pairOf, symmetricPanel, type Edge, type Panel, type Placement} from './panel.js';
import {
  centreBackSkirt,
  centreLine,
  centreTaken,
  shoulderSlope,
  sideLine,
  sidePanelWaist,
  sideSeam,
  sideSlope,
  type Half,
} from './princess-seams.js';
import {heading, squareBelow} from './skirt-lines.js';

const neckDepth = {front: 12.5, back: 3};
/** Excess length of the front over the back above the bust, as a part of the bust. */
const frontLonger = 0.018;
/**
 * The part of the shoulder seam on the centre panel, and the distance from the end of the whole to
 * the shoulder point.
 */
const innerLength = 3.8;
const inFromShoulder = 3.9;
/** Handle of the armhole at the underarm; a front armhole curves in further. */
const scoop = {front: 6.4, back: 4.6};
/**
 * Intake of the bust dart, as a part of the bust; the princess seam takes the rest of the shaping.
 */
const dartIntake = 0.027;

const neckPoint = (body: Body, half: Half): Point => [
  body.neck / 5 + 2.2,
  body.backLength + 1.6 + (half === 'front' ? frontLonger * body.bust : 0),
];

/** A point down a shoulder seam that slopes away to +x. */
const downShoulder = (from: Point, slope: number, distance: number): Point =>
  plus(from, [Math.cos(slope), -Math.sin(slope)], distance);

/** The end of a half's princess seam at the shoulder, on the centre panel. */
const innerShoulder = (body: Body, half: Half): Curve => {
  const neck = neckPoint(body, half);
  return line(downShoulder(neck, shoulderSlope, innerLength), neck);
};

export function centreFront(body: Body): Panel {
  const shoulderSeam = innerShoulder(body, 'front');
  const {skirt, waist, top} = centreLine(body, 'front', shoulderSeam.from);
  const neckline = roundNeckline(shoulderSeam.to, neckDepth.front, shoulderSlope);
  return symmetricPanel(
    'centre_front',
    {
      bottom: edge('hem', squareBelow(mirrored(skirt), skirt)),
      half: [
        edge('princess skirt', skirt),
        edge('princess waist', waist),
        edge('princess top', top),
        edge('shoulder', shoulderSeam),
      ],
      top: edge('neckline', reversed(neckline)),
      side: 'left',
    },
    hung(body, 'front', 10),
  );
}

export function centreBacks(body: Body): readonly [Panel, Panel] {
  const shoulderSeam = innerShoulder(body, 'back');
  const {skirt, waist, top} = centreLine(body, 'back', shoulderSeam.from);
  const neckline = halfNeckline(shoulderSeam.to, neckDepth.back, shoulderSlope);
  const centreSkirt = centreBackSkirt(body);
  return pairOf(
    'centre_back',
    'right',
    [
      edge('hem', squareBelow(centreSkirt, skirt)),
      edge('princess skirt', skirt),
      edge('princess waist', waist),
      edge('princess top', top),
      edge('shoulder', shoulderSeam),
      edge('neckline', neckline),
      edge('centre top', reversed(bodiceSeam([centreTaken, 0], neckline.to))),
      edge('centre skirt', reversed(centreSkirt)),
    ],
    hung(body, 'back', 10, -1.5),
  );
}

/** The part of the shoulder seam on the side panel. */
const outerLength = (body: Body): number =>
  (body.shoulderWidth / 2 - inFromShoulder - neckPoint(body, 'back')[0]) / Math.cos(shoulderSlope) -
  innerLength;

/** Placement of the side panels: rotated by 40 degrees out of the plane of the centre panel. */
function beside(body: Body, half: Half): Placement {
  const [x, z] = [0.8 * radiusOf(body.bust), radiusOf(body.bust) + 4];
  return half === 'front'
    ? {translation: [x, body.waistHeight, z], rotation: [0, 40, 0]}
    : {translation: [-x, body.waistHeight, -z], rotation: [0, -140, 0]};
}

/** The bust dart of a side front, and the side seam above it. `upper` starts at the dart. */
function darted(
  body: Body,
  bust: Point,
  upper: Curve,
): {readonly dart: readonly Edge[]; readonly upper: Curve} {
  const {legs, opening} = bustDart(upper.from, bust, dartIntake * body.bust);
  const [lowerLeg, upperLeg] = legs;
  return {
    dart: [edge('dart lower', lowerLeg), edge('dart upper', upperLeg)],
    upper: mapped(upper, (p) => plus(upperLeg.to, rotated(minus(p, upper.from), opening))),
  };
}

/**
 * The side panels. Origin: the waist at the princess seam. The armhole is square to the side seam
 * and to the shoulder.
 */
export function sidePanels(body: Body, half: Half): readonly [Panel, Panel] {
  const seam = sideLine(body, half, centreLine(body, half, innerShoulder(body, half).from));
  const side = sideSeam(body);
  const out: Point = [sidePanelWaist(body, half), 0];
  const sideSkirt = moved(side.skirt, out);
  const straight = {dart: [], upper: moved(side.upper, out)};
  const {dart, upper} = half === 'front' ? darted(body, seam.waist.to, straight.upper) : straight;
  const slope = sideSlope(body, half);
  const underarm = upper.to;
  const tip = downShoulder(seam.top.to, slope, outerLength(body));
  const armhole = curve(
    underarm,
    leftOf(heading(upper, 1)),
    tip,
    leaning(slope),
    scoop[half],
    0.5 * (tip[1] - underarm[1]),
  );
  return pairOf(
    `side_${half}`,
    half === 'front' ? 'left' : 'right',
    [
      edge('hem', squareBelow(seam.skirt, sideSkirt)),
      edge('side skirt', sideSkirt),
      edge('side lower', moved(side.lower, out)),
      ...dart,
      edge('side upper', upper),
      edge('armhole', armhole),
      edge('shoulder', line(tip, seam.top.to)),
      edge('princess top', reversed(seam.top)),
      edge('princess waist', reversed(seam.waist)),
      edge('princess skirt', reversed(seam.skirt)),
    ],
    beside(body, half),
  );
}
