/**
 * One leg of the straight trousers, front or back. Origin: the height of the waist, on the crease;
 * its centre seam is at -x.
 */
import {leftOf, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import type {Body} from './body.js';
import {withDart, type DartedEdge} from './darts.js';
import {curve, leaning, length, line, reversed, trueTo, type Curve} from './curves.js';
import {edge, type Edge} from './panel.js';
import {squareAbove} from './skirt-lines.js';

const waistEase = 2;
const hipEase = 5;
const riseEase = 1;
const kneeEase = 11.5;
const hemAboveFloor = 3;
/** Height of the waist's side over the measured waist. */
const sideRise = 0.8;
/** Share of each of the outseam's four edges in the hip's excess over the waist. */
const sideShare = 0.08;

export type Half = 'front' | 'back';

/** Differences of front and back. [cm, radians, parts of the hip] */
const shapes = {
  front: {
    /** Extra width of a quarter of the hip, of the waist, and of half the leg. */
    hip: -1,
    waist: 0.25,
    leg: -1,
    /**
     * Extent of the crotch beyond the centre line, and its excess distance from the crease over the
     * side's.
     */
    crotch: 0.058,
    inward: 0,
    /** The lean of the centre line, and the height of the waist on it. */
    centreLean: radians(2.5),
    centreRise: -0.8,
    /** The lean of the inseam at the crotch; the crotch curve is square to it. */
    inseamLean: radians(12),
    /**
     * Start of the crotch curve above the crotch, as a part of its reach, and its handles, as parts
     * of height and reach.
     */
    curveStart: 1.25,
    handles: [0.6, 0.56],
    /** Position of the dart from the side, and its depth. */
    dartAt: 0.55,
    dartDepth: 9.5,
  },
  back: {
    hip: 1,
    waist: -0.25,
    leg: 1,
    crotch: 0.105,
    inward: 1.6,
    centreLean: radians(7),
    centreRise: 2.2,
    inseamLean: radians(16),
    curveStart: 0.95,
    handles: [0.6, 0.68],
    dartAt: 0.52,
    dartDepth: 12,
  },
} as const;

/** The three edges of the outseam and the two of the inseam, from the hem up. */
interface LegSeams {
  readonly outLower: Curve;
  readonly outThigh: Curve;
  readonly outHip: Curve;
  readonly inLower: Curve;
  readonly inThigh: Curve;
}

/**
 * Widths of a leg: x of the crotch, of the centre line at the crotch curve, of the side, and half
 * the leg.
 */
export function frameOf(
  body: Body,
  half: Half,
): {crotchX: number; centreX: number; sideX: number; legHalf: number} {
  const shape = shapes[half];
  const hipWidth = (body.hip + hipEase) / 4 + shape.hip;
  const reach = shape.crotch * body.hip;
  const crotchX = -(hipWidth + reach + shape.inward) / 2;
  return {
    crotchX,
    centreX: crotchX + reach,
    sideX: crotchX + reach + hipWidth,
    legHalf: ((body.knee + kneeEase) / 2 + shape.leg) / 2,
  };
}

const riseOf = (body: Body): number => body.bodyRise + riseEase;

/**
 * Seams with hip and crotch at the given heights below the waist: upright from hem to knee and at
 * the hip.
 */
function seamsAt(body: Body, half: Half, hip: number, rise: number): LegSeams {
  const {crotchX, sideX, legHalf} = frameOf(body, half);
  const upright: Point = [0, 1];
  const hem = hemAboveFloor - body.waistHeight;
  const taken = sideShare * (body.hip + hipEase - body.waist - waistEase);
  const tall = body.hipDepth + sideRise;
  const sideLean = 2 * Math.atan(taken / tall);
  const atHip: Point = [sideX, -hip];
  return {
    outLower: line([legHalf, hem], [legHalf, -body.kneeDepth]),
    outThigh: curve([legHalf, -body.kneeDepth], upright, atHip, upright, 13, 11),
    outHip: curve(atHip, upright, plus(atHip, [-taken, tall]), leaning(-sideLean)),
    inLower: line([-legHalf, hem], [-legHalf, -body.kneeDepth]),
    inThigh: curve(
      [-legHalf, -body.kneeDepth],
      upright,
      [crotchX, -rise],
      leaning(-shapes[half].inseamLean),
    ),
  };
}

/**
 * Seams of a half. The back's hip and crotch are lowered until its seams are as long as the
 * front's.
 */
function legSeams(body: Body, half: Half): LegSeams {
  const front = seamsAt(body, 'front', body.hipDepth, riseOf(body));
  if (half === 'front') return front;
  const trued = (part: 'outThigh' | 'inThigh', at: number): number =>
    trueTo(
      `the back ${part === 'outThigh' ? 'outseam' : 'inseam'}`,
      length(front[part]),
      (lower) => length(seamsAt(body, 'back', at + lower, at + lower)[part]),
      -3,
      6,
    );
  return seamsAt(
    body,
    'back',
    body.hipDepth + trued('outThigh', body.hipDepth),
    riseOf(body) + trued('inThigh', riseOf(body)),
  );
}

/**
 * The centre seam from the waist down to the crotch: the straight part of fly or seat, and the
 * curve.
 */
function centreSeam(body: Body, half: Half, crotch: Point): {straight: Curve; curved: Curve} {
  const shape = shapes[half];
  const {centreX, crotchX} = frameOf(body, half);
  const reach = centreX - crotchX;
  const tall = shape.curveStart * reach;
  const start: Point = [centreX, tall - riseOf(body)];
  const down = plus([0, 0], leaning(shape.centreLean), -1);
  const rise = (shape.centreRise - start[1]) / Math.cos(shape.centreLean);
  return {
    straight: line(plus(start, down, -rise), start),
    curved: curve(
      start,
      down,
      crotch,
      leftOf(leaning(-shape.inseamLean)),
      shape.handles[0] * tall,
      shape.handles[1] * reach,
    ),
  };
}

/**
 * The waist from the side to the centre; the dart takes the hip's excess width that centre and side
 * do not.
 */
function waistOf(body: Body, half: Half, side: Curve, centre: Curve): DartedEdge {
  const {waist, dartAt, dartDepth} = shapes[half];
  const whole = squareAbove(side, reversed(centre));
  const withIntake = (intake: number): DartedEdge => withDart(whole, dartAt, intake, dartDepth);
  const sewn = ({before, after}: DartedEdge): number => length(before) + length(after);
  const target = (body.waist + waistEase) / 4 + waist;
  return withIntake(
    trueTo(`the ${half} waist`, target, (intake) => sewn(withIntake(intake)), 0.2, 7),
  );
}

/**
 * The outline of the leg of a half, from the hem up its outseam, and its waist as sewn to the band.
 */
export function legOf(
  body: Body,
  half: Half,
): {readonly edges: readonly Edge[]; readonly waist: DartedEdge} {
  const {outLower, outThigh, outHip, inLower, inThigh} = legSeams(body, half);
  const {straight, curved} = centreSeam(body, half, inThigh.to);
  const waist = waistOf(body, half, outHip, straight);
  const edges = [
    edge('hem', line(inLower.from, outLower.from)),
    edge('outseam lower leg', outLower),
    edge('outseam thigh', outThigh),
    edge('outseam hip', outHip),
    edge('waist side', waist.before),
    edge('dart side', waist.legs[0]),
    edge('dart centre', waist.legs[1]),
    edge('waist centre', waist.after),
    edge('centre', straight),
    edge('crotch', curved),
    edge('inseam thigh', reversed(inThigh)),
    edge('inseam lower leg', reversed(inLower)),
  ];
  return {edges, waist};
}
