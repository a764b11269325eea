/**
 * Draws a cell of areas and lines so that no hairline is visible between cells. Viewers draw pixels
 * at the edge of an area half transparent, and stacked areas each let the one below show through.
 * Cells are drawn from left to right and from the bottom up, and each covers the edges of previous
 * cells. Areas on top of others therefore extend beyond the cell, the further the more areas are
 * below. Lengths in cm.
 */
import {boxOf, type Box} from '../model/geometry/polyline.js';
import type {Point} from '../model/geometry/vectors.js';
import {boxAt, grown, overlap, shared} from './boxes.js';
import {box, filledWith, nums, scoped, strokedWith} from '../files/pdf/content.js';
import type {Leaf} from './vector-tile.js';

export type Size = readonly [width: number, height: number];

/** Extension of an area on top of another, more than a pixel at close view. */
const leastReach = 0.02;
/** Additional extension per further level. */
const reachStep = 0.01;
/** Greatest extension in a small cell, as a share of its shorter side. */
const mostShare = 0.25;
/** Lines this close to an edge of the image are on it, as a share of the side. */
const onEdge = 1e-4;

/** For each leaf, the number of leaves stacked below it. */
function levelsOf(leaves: readonly Leaf[]): readonly number[] {
  const levels: number[] = [];
  leaves.forEach((leaf, k) => {
    const near = grown(leaf.box, leastReach);
    const below = levels.map((level, n) =>
      leaves[n] && overlap(leaves[n].box, near) ? level + 1 : 0,
    );
    levels[k] = below.reduce((most, level) => Math.max(most, level), 0);
  });
  return levels;
}

/** An edge of the image: left or lower, or right or upper if `isFar`. */
interface Side {
  readonly axis: 0 | 1;
  readonly isFar: boolean;
}

const sides: readonly Side[] = ([0, 1] as const).flatMap((axis) =>
  [false, true].map((isFar) => ({axis, isFar})),
);

const isNear = (p: Point, {axis, isFar}: Side, size: Size): boolean =>
  Math.abs(p[axis] - (isFar ? size[axis] : 0)) < onEdge * size[axis];

/** Returns whether a leaf ends along an edge rather than at a single point of it. */
const touches = ({path}: Leaf, side: Side, size: Size): boolean =>
  path.flatMap(({points}) => points).filter((p) => isNear(p, side, size)).length > 1;

const hasColour = (one: Leaf, other: Leaf): boolean => String(one.fill) === String(other.fill);

/**
 * Extends a leaf beyond the edges where its colour continues, by the greatest extension of cells.
 */
function runningOn(leaf: Leaf, leaves: readonly Leaf[], size: Size, by: number): Leaf {
  const open = sides.filter(
    (side) =>
      touches(leaf, side, size) &&
      (side.isFar ||
        leaves.some(
          (other) => hasColour(leaf, other) && touches(other, {...side, isFar: true}, size),
        )),
  );
  if (open.length === 0) return leaf;
  const moved = (p: Point): Point => {
    const next: [number, number] = [...p];
    for (const side of open) {
      if (isNear(p, side, size)) next[side.axis] += side.isFar ? by : -by;
    }
    return next;
  };
  const path = leaf.path.map((step) => ({...step, points: step.points.map(moved)}));
  return {...leaf, path, box: boxOf(path.flatMap(({points}) => points))};
}

function drawnLeaf({path, fill, stroke, isEvenOdd}: Leaf, [dx, dy]: Point): string {
  const rule = isEvenOdd ? '*' : '';
  return [
    ...(fill ? [filledWith(fill)] : []),
    ...(stroke
      ? [
          strokedWith(stroke.colour),
          `${nums(stroke.width)} w ${stroke.cap} J ${stroke.join} j [${nums(...stroke.dash)}] 0 d`,
        ]
      : []),
    ...path.map(({kind, points}) =>
      [...points.map(([x, y]) => nums(x + dx, y + dy)), kind].join(' '),
    ),
    stroke ? (fill ? `B${rule}` : 'S') : `f${rule}`,
  ].join('\n');
}

const movedBox = ({low, high}: Box, [dx, dy]: Point): Box => ({
  low: [low[0] + dx, low[1] + dy],
  high: [high[0] + dx, high[1] + dy],
});

const holds = (outer: Box, inner: Box): boolean =>
  ([0, 1] as const).every((k) => outer.low[k] <= inner.low[k] && inner.high[k] <= outer.high[k]);

/** Draws a leaf clipped to a box. */
function within(seen: Box, leaf: Leaf, shift: Point): string {
  const drawn = drawnLeaf(leaf, shift);
  if (holds(seen, movedBox(leaf.box, shift))) return drawn;
  const [width, height] = [seen.high[0] - seen.low[0], seen.high[1] - seen.low[1]];
  return scoped(box(seen.low, width, height), 'W n', drawn);
}

/** Offsets of the previous cells whose edges this cell covers. */
const before: readonly Point[] = [
  [-1, 0],
  [0, -1],
  [-1, -1],
];

/** The content of a cell, and its greatest extension. */
export function drawnGroup(
  leaves: readonly Leaf[],
  size: Size,
): {readonly content: string; readonly reach: number} {
  const levels = levelsOf(leaves);
  const highest = levels.reduce((most, level) => Math.max(most, level), 0);
  const scale = Math.min(
    1,
    (mostShare * Math.min(...size)) / (leastReach + reachStep * (highest + 1)),
  );
  const reachOf = (level: number): number =>
    level === 0 ? 0 : scale * (leastReach + reachStep * (level - 1));
  const far = scale * (leastReach + reachStep * highest);
  const drawn = leaves.map((leaf) => runningOn(leaf, leaves, size, far));
  const seenOf = (level: number): Box => {
    const reach = reachOf(level);
    return {low: [-reach, -reach], high: [size[0] + far, size[1] + far]};
  };
  /** Returns whether a lower leaf covers the edge of a previous cell at this place. */
  const isCovered = (place: Box, level: number): boolean =>
    drawn.some((other, k) => {
      const below = levels[k] ?? 0;
      return below > 0 && below < level && overlap(shared(other.box, seenOf(below)), place);
    });
  const parts = drawn.flatMap((leaf, k) => {
    const level = levels[k] ?? 0;
    const seen = seenOf(level);
    const original = leaves[k] ?? leaf;
    const again = before.flatMap(([i, j]) => {
      const shift: Point = [i * size[0], j * size[1]];
      const place = shared(shared(seen, boxAt(shift, ...size)), movedBox(original.box, shift));
      const isSeen = place.low[0] < place.high[0] && place.low[1] < place.high[1];
      // a leaf that continues on the opposite side is already there
      const runsThrough = sides.some(
        ({axis}) =>
          (axis === 0 ? i : j) !== 0 &&
          [false, true].every((isFar) => touches(original, {axis, isFar}, size)),
      );
      return isSeen && !runsThrough && isCovered(place, level)
        ? [within(shared(seen, boxAt(shift, ...size)), original, shift)]
        : [];
    });
    return [...again, ...(overlap(leaf.box, seen) ? [within(seen, leaf, [0, 0])] : [])];
  });
  return {content: parts.join('\n'), reach: far};
}
