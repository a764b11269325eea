/** Reads DXF without blocks: every closed line is a piece and owns everything inside. */
import {distance, type Point} from '../../model/geometry/vectors.js';
import {boxOf, isInside, type Box} from '../../model/geometry/polyline.js';
import {nearestOn} from '../base/nearest.js';
import type {Drawn} from './blocks.js';
import {checkCount} from './count.js';
import * as layers from './layers.js';
import {areaOf, isAllowance, loopsOf, type Loop} from './loops.js';
import {linesOn, pieceOf, type DxfPiece} from './pieces.js';
import {sizeOf} from './units.js';

/** Smallest area of a piece; smaller closed lines are marks. [cm2] */
const smallest = 25;

/** Greatest gap between the ends of consecutive lines, as a share of the drawing's size. */
const reach = 2e-5;

/** Greatest distance of a mark outside its piece. [cm] */
const markReach = 1;

interface FlatPiece {
  readonly loop: Loop;
  readonly box: Box;
  readonly sewn?: Loop;
  readonly marks: Drawn[];
}

/**
 * Pieces of a flat drawing.
 * @param file file name for messages
 * @param scaleOf returns the length of a unit in cm, given the largest piece's size in units
 * @throws {FileError} for more pieces than a garment has
 */
export function flatPieces(
  entities: readonly Drawn[],
  file: string,
  scaleOf: (largest: number) => number,
): DxfPiece[] {
  const onLayer = loopsOf(linesOn(entities, layers.boundary), reach * sizeOf(linesIn(entities)));
  const isLayered = onLayer.closed.length > 0;
  const {closed, open} = isLayered
    ? onLayer
    : loopsOf(linesIn(entities), reach * sizeOf(linesIn(entities)));
  if (closed.length === 0) return [];
  const scale = scaleOf(Math.max(...closed.map((loop) => sizeOf([loop]))));
  const isLarge = (loop: Loop): boolean => areaOf(loop) * scale * scale >= smallest;
  const sorted = closed.filter(isLarge).sort((a, b) => areaOf(b) - areaOf(a));
  const large = isFrame(sorted) ? sorted.slice(1) : sorted;
  checkCount(large.length, file);
  const pieces = isLayered ? large.map(piece) : withAllowances(large, scale);
  const marks: readonly Drawn[] = isLayered
    ? entities.filter((one) => !(one.kind === 'line' && one.layer === layers.boundary))
    : [
        ...entities.filter((one) => one.kind !== 'line'),
        ...closed.filter((loop) => !isLarge(loop)).map(({points}) => inner(points, true)),
        ...open.map((points) => inner(points, false)),
      ];
  for (const mark of marks) ownerOf(pieces, mark, markReach / scale)?.marks.push(mark);
  // in file order
  const order = new Map(closed.map((loop, k) => [loop, k]));
  return pieces
    .sort((a, b) => (order.get(a.loop) ?? 0) - (order.get(b.loop) ?? 0))
    .map((one, k) => pieceOf(asBlock(one, `piece ${String(k + 1)}`)));
}

/**
 * Returns whether the largest line is a page frame around all others.
 * @param loops the largest first
 */
function isFrame([largest, ...others]: readonly Loop[]): boolean {
  return (
    largest?.points.length === 4 &&
    others.length > 1 &&
    others.every(({points}) => points.every((point) => isInside(largest.points, point)))
  );
}

const linesIn = (entities: readonly Drawn[]) => entities.filter((one) => one.kind === 'line');

const inner = (points: readonly Point[], isClosed: boolean): Drawn => ({
  ...{kind: 'line', layer: layers.internalLine},
  ...{points, isClosed},
});

const piece = (loop: Loop): FlatPiece => ({loop, box: boxOf(loop.points), marks: []});

/**
 * Pairs outlines with sewn lines: of two nested lines an allowance apart, the inner one is sewn.
 * @param loops the largest first
 */
function withAllowances(loops: readonly Loop[], scale: number): FlatPiece[] {
  const sewn = new Set<Loop>();
  return loops.flatMap((outer, k) => {
    if (sewn.has(outer)) return [];
    const own = loops
      .slice(k + 1)
      .find((loop) => !sewn.has(loop) && isAllowance(loop, outer, scale));
    if (own) sewn.add(own);
    return [{...piece(outer), ...(own && {sewn: own})}];
  });
}

/** The smallest piece that contains a mark, otherwise a nearby piece. */
function ownerOf(
  pieces: readonly FlatPiece[],
  mark: Drawn,
  reachable: number,
): FlatPiece | undefined {
  const at = mark.kind === 'line' ? mark.points[Math.floor(mark.points.length / 2)] : mark.at;
  if (!at) return undefined;
  const near = pieces.filter(({box: {low, high}}) =>
    [0, 1].every((axis) => {
      const x = at[axis] ?? 0;
      return x >= (low[axis] ?? 0) - reachable && x <= (high[axis] ?? 0) + reachable;
    }),
  );
  const around = near.findLast(({loop}) => isInside(loop.points, at));
  if (around) return around;
  return near.find(({loop}) => distance(nearestOn(loop.points, at, true).at, at) <= reachable);
}

/** Converts a piece to the structure of a file with blocks. */
function asBlock({loop, sewn, marks}: FlatPiece, name: string): Parameters<typeof pieceOf>[0] {
  const line = ({points, joints}: Loop, layer: string): Drawn[] =>
    joints.length < 2
      ? [{kind: 'line', layer, points, isClosed: true}]
      : joints.map((from, k): Drawn => {
          const next = joints[k + 1];
          const stretch =
            next === undefined
              ? [...points.slice(from), ...points.slice(0, (joints[0] ?? 0) + 1)]
              : points.slice(from, next + 1);
          return {kind: 'line', layer, points: stretch, isClosed: false};
        });
  const named = marks.find((mark) => mark.kind === 'text' && mark.text !== '');
  return {
    name: named?.kind === 'text' ? named.text : name,
    entities: [
      ...line(loop, layers.boundary),
      ...(sewn ? line(sewn, layers.sewLine) : []),
      ...marks,
    ],
    inserted: {asDrawn: 1, mirrored: 0},
  };
}
