/** DXF without blocks: every closed line is a piece, and what lies in it belongs to it. */
import {distance, type Point} from '../../model/geometry.js';
import {boxOf, isInside, type Box} from '../../model/polyline.js';
import {nearestOn} from '../base/nearest.js';
import type {Drawn} from './blocks.js';
import {checkCount} from './count.js';
import * as layers from './layers.js';
import {areaOf, isAllowance, loopsOf, type Loop} from './loops.js';
import {linesOn, pieceOf, type DxfPiece} from './pieces.js';
import {sizeOf} from './units.js';

/** What goes round less is a mark. [cm2] */
const smallest = 25;

/** How far apart ends of lines may be that follow each other, as a share of the size of the whole. */
const reach = 2e-5;

/** How far outside of its piece a mark may lie. [cm] */
const markReach = 1;

interface FlatPiece {
  readonly loop: Loop;
  readonly box: Box;
  readonly sewn?: Loop;
  readonly marks: Drawn[];
}

/**
 * @param file its name, for messages
 * @param scaleOf the length of a unit, by that of the largest piece [cm]
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
  // in the order of the file
  const order = new Map(closed.map((loop, k) => [loop, k]));
  return pieces
    .sort((a, b) => (order.get(a.loop) ?? 0) - (order.get(b.loop) ?? 0))
    .map((one, k) => pieceOf(asBlock(one, `piece ${String(k + 1)}`)));
}

/** Whether the largest is a sheet of paper around all others. The largest come first. */
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

/** Of two lines that run around in each other no allowance apart, the inner one is sewn. The largest come first. */
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

/** The smallest piece that a mark lies in, else the nearest that is near. */
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

/** As a file with blocks would have it. */
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
