/**
 * Draws a cell of areas and lines in levels. All cells of a window draw one level before the next,
 * so an area that crosses the border of cells is covered by nothing but what lies on it. Each cell
 * extends slightly beyond its borders, so that no hairline is visible between two. Lengths in cm.
 */
import type {PathStep} from '../files/svg/paths.js';
import {filledWith, nums, strokedWith} from '../files/pdf/content.js';
import type {Box} from '../model/geometry/polyline.js';
import {distance, type Point} from '../model/geometry/vectors.js';
import {boxAt, grown, overlap, shared} from './boxes.js';
import type {Leaf} from './vector-tile.js';

export type Size = readonly [width: number, height: number];

/** Extension beyond the borders, more than a pixel at close view. */
const usualReach = 0.02;
/** Greatest extension in a small cell, as a share of its shorter side. */
const mostShare = 0.25;
/** Lines this close to a border are on it, as a share of the side. */
const onBorder = 1e-4;
/** Further levels are drawn together, which bounds the size of files. */
const mostLevels = 64;

/** Length of a cell whose picture is the same all along it. */
const stripeLength = 40;

/**
 * The size of a cell and its leaves. Stripes, which run from border to border, become longer: many
 * short cells would show their overlaps.
 */
export function lengthened(
  groups: readonly (readonly Leaf[])[],
  size: Size,
): {readonly size: Size; readonly groups: readonly (readonly Leaf[])[]} {
  const ends = groups.flat().flatMap(({path}) => path.flatMap(({points}) => points));
  const axis = ([0, 1] as const).find((one) =>
    ends.every((p) => [false, true].some((isFar) => isOn(p, {axis: one, isFar}, size))),
  );
  if (axis === undefined || groups.flat().some(({stroke}) => stroke)) return {size, groups};
  const factor = Math.max(1, Math.round(stripeLength / size[axis]));
  const longer = ([x, y]: Point): Point => (axis === 0 ? [factor * x, y] : [x, factor * y]);
  return {
    size: longer(size),
    groups: groups.map((leaves) =>
      leaves.map(({path, box, ...leaf}) => ({
        ...leaf,
        path: path.map(({kind, points}) => ({kind, points: points.map(longer)})),
        box: {low: longer(box.low), high: longer(box.high)},
      })),
    ),
  };
}

/** An area or a line of one colour. */
interface Part {
  readonly leaf: Leaf;
  /** Parts of the same paint may be drawn in any order. */
  readonly paint: string;
}

/** Separates areas from their outlines. */
const partsOf = (leaves: readonly Leaf[]): readonly Part[] =>
  leaves.flatMap(({fill, stroke, ...leaf}) => [
    ...(fill ? [{leaf: {...leaf, fill}, paint: `f${String(fill)}`}] : []),
    ...(stroke ? [{leaf: {...leaf, stroke}, paint: `s${String(stroke.colour)}`}] : []),
  ]);

const movedBox = ({low, high}: Box, [dx, dy]: Point): Box => ({
  low: [low[0] + dx, low[1] + dy],
  high: [high[0] + dx, high[1] + dy],
});

/** The cell itself and the eight around it. */
const around: readonly Point[] = [-1, 0, 1].flatMap((i) => [-1, 0, 1].map((j): Point => [i, j]));

/** For each part, the number of levels below it, in its own cell or the one beside it. */
function levelsOf(parts: readonly Part[], size: Size, reach: number): readonly number[] {
  const cell = boxAt([0, 0], ...size);
  const seen = parts.map(({leaf}) => shared(grown(leaf.box, reach), grown(cell, 2 * reach)));
  const inner = grown(cell, -2 * reach);
  const isAtBorder = seen.map(
    ({low, high}) =>
      low[0] < inner.low[0] ||
      low[1] < inner.low[1] ||
      high[0] > inner.high[0] ||
      high[1] > inner.high[1],
  );
  const meets = (k: number, n: number): boolean => {
    const [one, other] = [seen[k] ?? cell, seen[n] ?? cell];
    if (overlap(one, other)) return true;
    return (
      isAtBorder[k] === true &&
      isAtBorder[n] === true &&
      around.some(([i, j]) => overlap(movedBox(one, [i * size[0], j * size[1]]), other))
    );
  };
  const levels: number[] = [];
  parts.forEach(({paint}, k) => {
    let level = 0;
    levels.forEach((below, n) => {
      const least = parts[n]?.paint === paint ? below : below + 1;
      if (least > level && meets(k, n)) level = least;
    });
    levels.push(Math.min(level, mostLevels - 1));
  });
  return levels;
}

/** A border of the cell: left or lower, or right or upper if `isFar`. */
interface Border {
  readonly axis: 0 | 1;
  readonly isFar: boolean;
}

const borders: readonly Border[] = ([0, 1] as const).flatMap((axis) =>
  [false, true].map((isFar) => ({axis, isFar})),
);

const isOn = (p: Point, {axis, isFar}: Border, size: Size): boolean =>
  Math.abs(p[axis] - (isFar ? size[axis] : 0)) < onBorder * size[axis];

/** The point, moved out of the cell or, by a negative distance, into the one beside it. */
function beyond(p: Point, {axis, isFar}: Border, by: number): Point {
  const moved: [number, number] = [...p];
  moved[axis] += isFar ? by : -by;
  return moved;
}

/**
 * Returns whether the colour of an area continues beyond a border: whether the topmost part there,
 * among those that the area covers, has its paint.
 */
function continues(
  k: number,
  ends: readonly [Point, Point],
  border: Border,
  {
    parts,
    size,
    reach,
  }: {readonly parts: readonly Part[]; readonly size: Size; readonly reach: number},
): boolean {
  const [from, to] = ends.map((p) => beyond(p, border, -size[border.axis])) as [Point, Point];
  const inside = beyond(to, border, reach);
  const strip = {
    low: [Math.min(from[0], to[0], inside[0]), Math.min(from[1], to[1], inside[1])] as const,
    high: [Math.max(from[0], to[0], inside[0]), Math.max(from[1], to[1], inside[1])] as const,
  };
  const last = parts.findLastIndex(({leaf}, n) => n <= k && overlap(leaf.box, strip));
  const found = last < 0 ? parts.find(({leaf}) => overlap(leaf.box, strip)) : parts[last];
  return found?.paint === parts[k]?.paint;
}

/** Extends an area beyond the borders along which it ends, where its colour continues. */
function extended(
  {leaf}: Part,
  size: Size,
  reach: number,
  isOpen: (ends: readonly [Point, Point], border: Border) => boolean,
): readonly PathStep[] {
  let start: Point = [0, 0];
  let at: Point = [0, 0];
  return leaf.path.flatMap((step) => {
    const [from, to] = [at, step.kind === 'h' ? start : (step.points.at(-1) ?? at)];
    at = to;
    if (step.kind === 'm') {
      start = to;
      return [step];
    }
    const border = borders.find((one) =>
      [from, to, ...step.points].every((p) => isOn(p, one, size)),
    );
    const isShort = distance(from, to) < onBorder * Math.min(...size);
    if (!border || isShort || !isOpen([from, to], border)) return [step];
    const out = [beyond(from, border, reach), beyond(to, border, reach), to];
    const added = out.map((p): PathStep => ({kind: 'l', points: [p]}));
    return step.kind === 'h' ? [...added, step] : added;
  });
}

function drawnLeaf({path, fill, stroke, isEvenOdd}: Leaf): string {
  return [
    ...(fill ? [filledWith(fill)] : []),
    ...(stroke
      ? [
          strokedWith(stroke.colour),
          `${nums(stroke.width)} w ${stroke.cap} J ${stroke.join} j [${nums(...stroke.dash)}] 0 d`,
        ]
      : []),
    ...path.map(({kind, points}) => [...points.map(([x, y]) => nums(x, y)), kind].join(' ')),
    stroke ? 'S' : `f${isEvenOdd ? '*' : ''}`,
  ].join('\n');
}

/** The contents of a cell by level, from the lowest, and their extension beyond its borders. */
export function drawnLevels(
  leaves: readonly Leaf[],
  size: Size,
): {readonly levels: readonly string[]; readonly reach: number} {
  const reach = Math.min(usualReach, mostShare * Math.min(...size));
  const parts = partsOf(leaves);
  const contents: string[][] = [];
  const cell = grown(boxAt([0, 0], ...size), reach);
  const levels = levelsOf(parts, size, reach);
  parts.forEach((part, k) => {
    const {leaf} = part;
    if (!overlap(leaf.box, cell)) return;
    const path = leaf.fill
      ? extended(part, size, reach, (ends, border) =>
          continues(k, ends, border, {parts, size, reach}),
        )
      : leaf.path;
    (contents[levels[k] ?? 0] ??= []).push(drawnLeaf({...leaf, path}));
  });
  return {levels: Object.values(contents).map((drawn) => drawn.join('\n')), reach};
}
