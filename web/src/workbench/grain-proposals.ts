/** Where the grain of pieces probably runs, when their file does not say it: from how they hang, and from their symmetry. */
import type {Placement} from '../model/garment-document.js';
import type {PanelMarks} from '../model/garment-marks.js';
import {degrees, middle, radians, towards, type Point} from '../model/geometry.js';
import {boxOf} from '../model/polyline.js';
import type {ResultPiece} from '../model/result.js';
import type {Registration, Symmetry} from '../model/symmetries.js';
import {turned} from '../layout/on-body.js';
import type {Workbench} from './workbench.js';

type Drafted = Pick<ResultPiece, 'name' | 'rest' | 'outline'>;

/** As drawn. [degrees, counter-clockwise from the x axis of the face-up piece] */
export const upwards = 90;

/** What hangs along an arm: there the grain runs to the shoulder, however the arm is held. */
const onArm = /sleeve|cuff|(^|[_ -])(arm|sl)([_ -]|$)/i;
/** How steeply an arm is thought to lead up to the shoulder. [degrees] */
const armSlope = 30;
/** Within this of an axis, the axis is meant. [degrees] */
const nearAxis = 45;

/** From 0 to 360. */
const whole = (angleDeg: number): number => ((angleDeg % 360) + 360) % 360;
const apart = (one: number, other: number): number => {
  const difference = whole(one - other);
  return Math.min(difference, 360 - difference);
};

/** Which way the cloth's length points on the body. */
function upOf(name: string, middle: Point, {translation, rotation = [0, 0, 0]}: Placement): Point {
  const [dx] = turned([...middle, 0], rotation);
  const x = translation[0] + dx;
  if (!onArm.test(name) || Math.abs(x) < 1) return [0, 1];
  const [out, up] = towards(radians(armSlope));
  return [-Math.sign(x) * out, up];
}

/** Of the ways in which a piece is drawn the one that leads up most on the body; undefined where nothing tells. */
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
  // as drawn, unless it clearly lies on its side
  if (Math.abs(across) > Math.abs(along) + 0.05) return across > 0 ? 0 : 180;
  return along > 0 ? upwards : 270;
}

/** Along the piece's own axis, or across it, whichever leads up. */
function alongAxis(up: number, axis: number): number {
  const ways = [axis, axis + 90, axis + 180, axis + 270].map(whole);
  return ways.find((way) => apart(way, up) < nearAxis) ?? up;
}

/** What mirrors what, by name, and how: p' = R F p + t of the pieces face up. */
export type Mirror = Symmetry & Pick<Registration, 'map'>;

/** The symmetries that the answer keeps, and those that were found beside them. */
export function mirrorsOf({
  pattern,
  found,
}: Pick<Workbench, 'pattern' | 'found'>): readonly Mirror[] {
  const nameOf = (piece: number): string => pattern?.pieces[piece]?.name ?? '';
  const kept = (pattern?.symmetries ?? []).map((one): Mirror =>
    one.kind === 'piece'
      ? {kind: 'piece', piece: nameOf(one.piece), map: one.map}
      : {kind: 'pair', pieces: [nameOf(one.pieces[0]), nameOf(one.pieces[1])], map: one.map},
  );
  return [...kept, ...found];
}

/** The grain line of a piece, and that of its mirror image if it has one, by name. [degrees] */
export function withImage(
  piece: string,
  angleDeg: number,
  mirrors: readonly Mirror[],
): Readonly<Record<string, number>> {
  const lines: Record<string, number> = {[piece]: whole(angleDeg)};
  for (const one of mirrors) {
    if (one.kind !== 'pair' || !one.pieces.includes(piece)) continue;
    const isFirst = one.pieces[0] === piece;
    // F turns the direction d into 180 - d; back the other way, the map turns as far
    lines[one.pieces[isFirst ? 1 : 0]] = whole(180 - angleDeg + degrees(one.map.angle));
  }
  return lines;
}

/** By name, for the pieces whose file says nothing. */
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

/** How a grain line of a file without one is chosen. */
export const grainWays = ['up', 'across', 'bias'] as const;
type GrainWay = (typeof grainWays)[number];

export const angleOfWay: Readonly<Record<GrainWay, number>> = {up: upwards, across: 0, bias: 45};

/** Undefined for a line that is none of these. */
export const wayOf = (angleDeg: number): GrainWay | undefined =>
  grainWays.find((way) => apart(angleOfWay[way], angleDeg) < 0.05);
