/**
 * The upper body without darts, from which tops are cut. Origin of front and back: the middle of
 * the waist line.
 */
import {leftOf, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {across, curve, leaning, line, type Curve} from './curves.js';
import type {Placement} from './panel.js';

export type Half = 'front' | 'back';

/** Style of a top relative to the body. Lengths in cm, angles in radians. */
export interface BodiceStyle {
  readonly bustEase: number;
  readonly hipEase: number;
  /** Distance from the nape down to the underarm, in excess of a tenth of the bust. */
  readonly armholeDepth: number;
  /** Extension of the shoulder seam beyond the shoulder point. */
  readonly shoulderOut: number;
  readonly shoulderSlope: number;
  /** Excess of each half of the neckline over a fifth of the neck. */
  readonly neckOut: number;
  /** Depth below the end of the shoulder seam. */
  readonly neckDepth: Readonly<Record<Half, number>>;
  /**
   * Height of the back's shoulder over the front's: the seam is in front of the top of the
   * shoulder.
   */
  readonly frontLower: number;
  readonly hemBelowWaist: number;
  /** Outward angle of the side seam at the underarm. */
  readonly sideLean: number;
  /** Excess of the front's width over the back's, at each side seam. */
  readonly forward: number;
  /**
   * Distance of the armhole's middle inwards from the end of the shoulder: greater in front than
   * behind.
   */
  readonly scoop: Readonly<Record<Half, number>>;
}

/** The edges of the +x side, from the hem up to the neck. */
export interface BodiceHalf {
  readonly side: Curve;
  readonly armhole: Curve;
  readonly shoulder: Curve;
}

/** The armhole's handle at the shoulder, as a part of its height. */
const armholeHandle: Readonly<Record<Half, number>> = {front: 0.52, back: 0.46};

export function bodiceHalf(body: Body, half: Half, style: BodiceStyle): BodiceHalf {
  const {shoulderSlope, sideLean, hemBelowWaist} = style;
  const wider = half === 'front' ? style.forward : -style.forward;
  const underarm: Point = [
    (body.bust + style.bustEase) / 4 + wider,
    body.backLength - (body.bust / 10 + style.armholeDepth),
  ];
  const hem: Point = [(body.hip + style.hipEase) / 4 + wider, -hemBelowWaist];
  const lower = half === 'front' ? style.frontLower : 0;
  const neck: Point = [
    body.neck / 5 + style.neckOut,
    body.backLength + style.neckDepth.back - lower,
  ];
  const tipX = body.shoulderWidth / 2 + style.shoulderOut;
  const tip: Point = [tipX, neck[1] - (tipX - neck[0]) * Math.tan(shoulderSlope)];

  // up the side, curved in at the waist and square to a level hem
  const up = underarm[1] - hem[1];
  const side = curve(hem, [0, 1], underarm, leaning(sideLean), 0.46 * up, 0.35 * up);
  // The armhole is square to the side seam and to the shoulder, so that it continues smoothly from
  // front to back. The middle of a cubic follows from its ends and handles.
  const atShoulder = armholeHandle[half] * (tip[1] - underarm[1]);
  const atUnderarm =
    (8 / 3) * ((underarm[0] - tip[0]) / 2 + style.scoop[half]) -
    atShoulder * Math.sin(shoulderSlope);
  const armhole = curve(
    underarm,
    leftOf(leaning(sideLean)),
    tip,
    leaning(shoulderSlope),
    atUnderarm,
    atShoulder,
  );
  return {side, armhole, shoulder: line(tip, neck)};
}

/**
 * The whole neckline from -x to +x, square to the shoulders; a cubic sinks to 3/4 of its handles.
 */
export function roundNeckline(neck: Point, depth: number, shoulderSlope: number): Curve {
  return across(neck, leaning(shoulderSlope), depth / 0.75 / Math.cos(shoulderSlope));
}

/** One side of a neckline, from the shoulder to the middle, which it reaches square. */
export function halfNeckline(neck: Point, depth: number, shoulderSlope: number): Curve {
  return curve(
    neck,
    leaning(Math.PI + shoulderSlope),
    [0, neck[1] - depth],
    [-1, 0],
    0.6 * depth,
    0.5 * neck[0],
  );
}

/** Placement of front and back: `away` cm off the body, the waist at its height. */
export function hung(body: Body, half: Half, away: number, x = 0): Placement {
  const z = radiusOf(body.bust) + away;
  return half === 'front'
    ? {translation: [x, body.waistHeight, z], rotation: [0, 0, 0]}
    : {translation: [x, body.waistHeight, -z], rotation: [0, 180, 0]};
}
