/**
 * Probable grain lines of pieces whose file gives none, from their placement and their symmetry.
 */
import type {Placement} from '../../model/garment/garment-document.js';
import type {PanelMarks} from '../../model/garment/panel-marks.js';
import {degrees, middle, radians, towards, type Point} from '../../model/geometry/vectors.js';
import {boxOf} from '../../model/geometry/polyline.js';
import type {ResultPiece} from '../../model/result/result.js';
import {turned} from '../../layout/on-body.js';
import type {Mirror} from '../mirrors.js';

type Drafted = Pick<ResultPiece, 'name' | 'rest' | 'outline'>;

/**
 * Direction of the grain as drawn. [degrees, counter-clockwise from the x axis of the face-up
 * piece]
 */
export const upwards = 90;

/** Names of pieces along an arm, where the grain runs to the shoulder in any pose of the arm. */
const onArm = /sleeve|cuff|(^|[_ -])(arm|sl)([_ -]|$)/i;
/** Assumed slope of an arm up to the shoulder. [degrees] */
const armSlope = 30;
/** A direction within this of an axis means the axis. [degrees] */
const nearAxis = 45;

/** The same angle from 0 to 360. [degrees] */
const whole = (angleDeg: number): number => ((angleDeg % 360) + 360) % 360;
const apart = (one: number, other: number): number => {
  const difference = whole(one - other);
  return Math.min(difference, 360 - difference);
};

/** Direction of the fabric's length on the body. */
function upOf(name: string, middle: Point, {translation, rotation = [0, 0, 0]}: Placement): Point {
  const [dx] = turned([...middle, 0], rotation);
  const x = translation[0] + dx;
  if (!onArm.test(name) || Math.abs(x) < 1) return [0, 1];
  const [out, up] = towards(radians(armSlope));
  return [-Math.sign(x) * out, up];
}

/** The drawing direction that points up most on the body; undefined without evidence. */
function placedUp(piece: Drafted, placement: Placement | undefined): number | undefined {
  const {rotation} = placement ?? {};
  if (!placement || !rotation) return undefined;
  const {low, high} = boxOf(piece.rest);
  const [ux, uy] = upOf(piece.name, middle(low, high), placement);
  const rise = (x: number, y: number): number => {
    const [dx, dy] = turned([x, y, 0], rotation);
    return dx * ux + dy * uy;
  };
  const [across, along] = [rise(1, 0), rise(0, 1)];
  if (Math.max(Math.abs(across), Math.abs(along)) < 0.3) return undefined;
  // drawn upright, unless the piece is clearly on its side
  if (Math.abs(across) > Math.abs(along) + 0.05) return across > 0 ? 0 : 180;
  return along > 0 ? upwards : 270;
}

/** The direction along or across the piece's own axis that points up. */
function alongAxis(up: number, axis: number): number {
  const ways = [axis, axis + 90, axis + 180, axis + 270].map(whole);
  return ways.find((way) => apart(way, up) < nearAxis) ?? up;
}

/** Grain line of a piece, and of its mirror image if it has one, by name. [degrees] */
export function withImage(
  piece: string,
  angleDeg: number,
  mirrors: readonly Mirror[],
): Readonly<Record<string, number>> {
  const lines: Record<string, number> = {[piece]: whole(angleDeg)};
  for (const one of mirrors) {
    if (one.kind !== 'pair' || !one.pieces.includes(piece)) continue;
    const isFirst = one.pieces[0] === piece;
    // F turns the direction d into 180 - d; the inverse map turns by the same angle
    lines[one.pieces[isFirst ? 1 : 0]] = whole(180 - angleDeg + degrees(one.map.angle));
  }
  return lines;
}

/** Grain lines by name, for the pieces whose file gives none. [degrees] */
export function grainProposals(
  pieces: readonly Drafted[],
  marks: ReadonlyMap<string, PanelMarks>,
  mirrors: readonly Mirror[],
): ReadonlyMap<string, number> {
  const proposals = new Map<string, number>();
  for (const piece of pieces) {
    const {grain, placement} = marks.get(piece.name) ?? {};
    if (grain) continue;
    const up = placedUp(piece, placement) ?? upwards;
    const own = mirrors.find((one) => one.kind === 'piece' && one.piece === piece.name);
    // R F mirrors in a line at half the angle from the y axis
    const axis = own && upwards + degrees(own.map.angle) / 2;
    proposals.set(piece.name, axis === undefined ? up : alongAxis(up, axis));
  }
  for (const one of mirrors) {
    if (one.kind !== 'pair') continue;
    const [first, second] = one.pieces;
    const lead = proposals.get(first);
    const image = lead === undefined ? undefined : withImage(first, lead, [one])[second];
    if (image !== undefined && proposals.has(second)) proposals.set(second, image);
  }
  return proposals;
}

/** Choices of a grain line for a file without one. */
export const grainWays = ['up', 'across', 'bias'] as const;
type GrainWay = (typeof grainWays)[number];

export const angleOfWay: Readonly<Record<GrainWay, number>> = {up: upwards, across: 0, bias: 45};

/** The choice with an angle; undefined for any other angle. */
export const wayOf = (angleDeg: number): GrainWay | undefined =>
  grainWays.find((way) => apart(angleOfWay[way], angleDeg) < 0.05);
