/** Panels and seams of a drafted garment. */
import {plus, type Point} from '../../src/model/geometry/vectors.js';
import {length, mirror, mirrored, reversed, type Curve} from './curves.js';
import type {SeamKind} from './seam-kinds.js';

/** The wearer's sides. */
export type Side = 'left' | 'right';
const other = (side: Side): Side => (side === 'left' ? 'right' : 'left');

/**
 * Placement of a panel before sewing: rotated about the fixed axes x, y, z in this order (degrees),
 * then moved (cm).
 */
export interface Placement {
  readonly translation: readonly [number, number, number];
  readonly rotation: readonly [number, number, number];
}

/** One edge of an outline. Its name is unique in its panel and describes its seam. */
export interface Edge {
  readonly name: string;
  readonly curve: Curve;
}

/**
 * A cut piece, face side up, in its own coordinates: a counter-clockwise outline that starts with
 * its lowest edge.
 */
export interface Panel {
  readonly name: string;
  readonly edges: readonly Edge[];
  readonly placement: Placement;
  /**
   * The direction of the grain in the panel; +y by default, as on a band, whose print so continues
   * that of the piece it is sewn to.
   */
  readonly grain?: Point;
  readonly folds?: readonly Fold[];
}

/** A pleat or tuck that is closed by laying `line` on `to`. */
interface Fold {
  readonly line: readonly [Point, Point];
  readonly to: readonly [Point, Point];
  readonly kind: 'knife' | 'box' | 'inverted' | 'tuck';
}

/** A pleat whose lines run down by `drop` from two points at one height. */
export const pleatBetween = (kind: Fold['kind'], from: Point, to: Point, drop: number): Fold => ({
  line: [from, plus(from, [0, -drop])],
  to: [to, plus(to, [0, -drop])],
  kind,
});

export type EdgeName = readonly [panel: string, edge: string];

/** Two edges sewn to each other: the start of one meets the end of the other. */
export interface Seam extends SeamManner {
  /** A sewist's name of it, unique in the garment. */
  readonly name: string;
  readonly kind: SeamKind;
  readonly a: EdgeName;
  readonly b: EdgeName;
}

/** Sewing details of two edges. */
interface SeamManner {
  /**
   * Excess of `a` over `b` as drafted, as a factor (gathers), or in cm (ease). Neither: equal
   * lengths.
   */
  readonly gathers?: number;
  readonly ease?: number;
  /** Marks on both sides, as fractions of the length from the start of `a`. */
  readonly notches?: readonly number[];
  /** Marks on `a` only, measured in the same way: they meet the end of another seam. */
  readonly ownNotches?: readonly number[];
}

/** Two marked lines that coincide without being sewn, in panel coordinates, start on start. */
export interface Match {
  readonly name: string;
  readonly a: {readonly panel: string; readonly line: readonly Point[]};
  readonly b: {readonly panel: string; readonly line: readonly Point[]};
}

/** The corner of a panel where two of its edges meet, in either order. */
export type CornerName = readonly [panel: string, edge: string, edge: string];

/**
 * A seam's end where the line beyond the seam turns on purpose, so that it does not continue
 * straight across.
 */
interface Turn {
  /** One of the corners that meet there. */
  readonly corner: CornerName;
  /** A sewist's name of it: the point of a V neck, a slit, the crotch. */
  readonly reason: string;
}

export interface Garment {
  readonly name: string;
  /** Its name in lists. */
  readonly title: string;
  readonly panels: readonly Panel[];
  readonly seams: readonly Seam[];
  readonly matches?: readonly Match[];
  /** Everywhere else lines continue across the seams: hems, necklines, waistlines, armholes. */
  readonly turns?: readonly Turn[];
  /**
   * The mirror symmetries of the draft: of one panel, or of two. The file does not contain them;
   * they are detected or clicked.
   */
  readonly symmetries: readonly (readonly [string] | readonly [string, string])[];
}

export const edge = (name: string, curve: Curve): Edge => ({name, curve});

/**
 * A panel that is its own mirror image. `half` runs up its +x side, from the end of `bottom` to the
 * start of `top`, or to the middle when there is no edge across the top.
 */
export function symmetricPanel(
  name: string,
  parts: {
    readonly bottom: Edge;
    readonly half: readonly Edge[];
    readonly top?: Edge;
    readonly side: Side;
  },
  placement: Placement,
): Panel {
  const near = parts.half.map(({name: part, curve}) => edge(`${part} ${parts.side}`, curve));
  const far = parts.half.map(({name: part, curve}) =>
    edge(`${part} ${other(parts.side)}`, reversed(mirrored(curve))),
  );
  const top = parts.top ? [parts.top] : [];
  return {name, edges: [parts.bottom, ...near, ...top, ...far.reverse()], placement};
}

/**
 * The panel drafted on one side of the body, and its mirror image for the other. Edge names stay.
 */
export function pairOf(
  name: string,
  side: Side,
  edges: readonly Edge[],
  placement: Placement,
  grain?: Point,
): readonly [Panel, Panel] {
  const [bottom, ...rest] = edges.map(({name: part, curve}) =>
    edge(part, reversed(mirrored(curve))),
  );
  const [x, y, z] = placement.translation;
  const [rx, ry, rz] = placement.rotation;
  const twin: Placement = {translation: [-x, y, z], rotation: [rx, -ry, -rz]};
  return [
    {name: `${name}_${side}`, edges, placement, ...(grain && {grain})},
    {
      name: `${name}_${other(side)}`,
      edges: bottom ? [bottom, ...rest.reverse()] : [],
      placement: twin,
      ...(grain && {grain: mirror(grain)}),
    },
  ];
}

export const sew = (
  kind: SeamKind,
  name: string,
  a: EdgeName,
  b: EdgeName,
  how: SeamManner = {},
): Seam => ({kind, name, a, b, ...how});

/**
 * The same seam on both sides of the body. `*` in a panel or edge name represents the side. All
 * outlines run counter-clockwise, so an edge and its mirror image start at opposite ends; notches
 * are measured on the left.
 */
export function onBothSides(
  kind: SeamKind,
  name: string,
  a: EdgeName,
  b: EdgeName,
  how: SeamManner = {},
): Seam[] {
  const at = (names: EdgeName, side: Side): EdgeName => [
    names[0].replace('*', side),
    names[1].replace('*', side),
  ];
  const counted = (marks?: readonly number[]): readonly number[] | undefined =>
    marks?.map((share) => 1 - share);
  const [notches, ownNotches] = [counted(how.notches), counted(how.ownNotches)];
  const mirroredHow = {...how, ...(notches && {notches}), ...(ownNotches && {ownNotches})};
  return (['left', 'right'] as const).map((side) =>
    sew(kind, `${name}, ${side}`, at(a, side), at(b, side), side === 'left' ? how : mirroredHow),
  );
}

/** The same turn on both sides of the body. */
export function turnsOnBothSides([panel, before, after]: CornerName, reason: string): Turn[] {
  return (['left', 'right'] as const).map((side) => ({
    corner: [
      panel.replace('*', side),
      before.replace('*', side),
      after.replace('*', side),
    ] as const,
    reason,
  }));
}

/** @throws {Error} for a name that the garment does not have. */
export function findEdge(
  garment: Garment,
  [panelName, edgeName]: EdgeName,
): {readonly index: number; readonly curve: Curve} {
  const edges = garment.panels.find((panel) => panel.name === panelName)?.edges ?? [];
  const index = edges.findIndex(({name}) => name === edgeName);
  const found = edges[index];
  if (!found)
    throw new Error(`no edge '${edgeName}' on panel '${panelName}' of the ${garment.name}`);
  return {index, curve: found.curve};
}

/** Length difference of the two sides of a seam in excess of the stated one. [cm] */
export function untrue(garment: Garment, {a, b, gathers = 1, ease = 0}: Seam): number {
  const [lengthA, lengthB] = [a, b].map((names) => length(findEdge(garment, names).curve));
  return Math.abs((lengthA ?? NaN) - (lengthB ?? NaN) * gathers - ease);
}
