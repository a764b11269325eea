/**
 * The panel seams of the asymmetric dress, from the hem up into the armholes. The height of the
 * waist is y = 0.
 */
import {leftOf, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import type {Half} from './bodice.js';
import type {Body} from './body.js';
import {bodiceSeam, skirtSeam, upright} from './fitted-seams.js';
import {curve, leaning, length, mirrored, moved, trueTo, type Curve} from './curves.js';
import {heading} from './skirt-lines.js';

const ease = {bust: 5, waist: 6, hip: 6};
const seamLength = 54;
/** Outward angle of each panel seam at the hem. */
const flare = radians(5);
export const shoulderSlope = radians(19);
/** Distance from the end of the shoulder seam to the shoulder point. */
const inFromShoulder = 3.4;
/** Distance from the nape down to the underarm, in excess of a tenth of the bust. */
const armholeDepth = 11.5;

/** Shape of the panel seam of a half, and its end at the armhole. [cm, radians] */
export const shapes = {
  front: {
    /**
     * x of the seam, as a part of the waist; its share of the extra width at the bust; the height
     * of the bust.
     */
    waist: 0.115,
    out: 0.24,
    bust: 0.41,
    /**
     * End at the armhole: in from the shoulder point and up from the underarm; inward angle of the
     * armhole there.
     */
    inward: 3,
    up: 6.5,
    lean: radians(13),
    /**
     * The side panel's edge: its share of the extra width at the bust, and its return up to the
     * armhole.
     */
    sideOut: 0.28,
    sideBack: 6.5,
  },
  back: {
    waist: 0.11,
    out: 0.23,
    bust: 0.45,
    inward: 2.4,
    up: 7.5,
    lean: radians(9),
    sideOut: 0.25,
    sideBack: 5.5,
  },
} as const;

/**
 * The edges of a panel seam from the hem up: hem to waist, waist to the height of the bust, on to
 * the armhole.
 */
export interface PanelSeam {
  readonly skirt: Curve;
  readonly bodice: Curve;
  readonly top: Curve;
}

export const underarmHeight = (body: Body): number =>
  body.backLength - (body.bust / 10 + armholeDepth);
export const neckPoint = (body: Body): Point => [body.neck / 5 + 2.2, body.backLength + 1.8];
export function shoulderTip(body: Body): Point {
  const neck = neckPoint(body);
  const x = body.shoulderWidth / 2 - inFromShoulder;
  return [x, neck[1] - (x - neck[0]) * Math.tan(shoulderSlope)];
}

/** Excess of half the bust over half the waist, shared by the four edges of that half. */
const bustWider = (body: Body): number => (body.bust + ease.bust - body.waist - ease.waist) / 2;

/** A panel seam below a waist at the origin; all eight edges together make the hip. */
function skirtOf(body: Body): Curve {
  const wider = body.hip + ease.hip - body.waist - ease.waist;
  const {hipDepth} = body;
  return skirtSeam('the skirt', {atHip: wider / 8, hipDepth, flare, seamLength});
}

/** The seam on the centre panel, at its +x side; it meets the armhole square. */
export function centreSeam(body: Body, half: Half): PanelSeam {
  const shape = shapes[half];
  const waist: Point = [shape.waist * body.waist, 0];
  const bust: Point = [waist[0] + shape.out * bustWider(body), shape.bust * body.backLength];
  const armhole: Point = [shoulderTip(body)[0] - shape.inward, underarmHeight(body) + shape.up];
  return {
    skirt: moved(skirtOf(body), waist),
    bodice: bodiceSeam(waist, bust),
    top: curve(bust, upright, armhole, plus([0, 0], leftOf(leaning(-shape.lean)), -1)),
  };
}

/**
 * The side panel's edge of that seam, for a waist at the origin and fabric at +x: every part is
 * trued to the other side.
 */
export function sideEdge(body: Body, half: Half): PanelSeam {
  const shape = shapes[half];
  const centre = centreSeam(body, half);
  const bodiceAt = (height: number): Curve =>
    bodiceSeam([0, 0], [-shape.sideOut * bustWider(body), height]);
  const bodice = bodiceAt(
    trueTo(
      'the panel seam below the bust',
      length(centre.bodice),
      (y) => length(bodiceAt(y)),
      5,
      40,
    ),
  );
  const topAt = (rise: number): Curve =>
    curve(bodice.to, upright, plus(bodice.to, [shape.sideBack, rise]), heading(centre.top, 1));
  return {
    skirt: mirrored(skirtOf(body)),
    bodice,
    top: topAt(
      trueTo('the panel seam above the bust', length(centre.top), (y) => length(topAt(y)), 1, 40),
    ),
  };
}

/** The waist of a side panel: half the waist less the centre panels. */
export const sidePanelWaist = (body: Body): number =>
  (body.waist + ease.waist) / 2 - (shapes.front.waist + shapes.back.waist) * body.waist;
