/**
 * The fabric along both sides of a seam, straightened to coordinates along the seam and inwards
 * from it. Lengths in cm.
 */
import {BufferAttribute, BufferGeometry, Mesh} from 'three';

import {between, distance, minus, plus, unit, type Point} from '../model/geometry/vectors.js';
import type {SeamSide} from '../model/result/result.js';
import {pick} from '../scene/marks.js';
import type {OnPiece} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import {apply} from '../model/geometry/plane-map.js';
import {imageCoordinates} from '../model/print/image-coordinates.js';
import type {PrintMaterial} from './print-layer.js';

/** Depth of a ribbon in a piece. */
export const ribbonDepth = 6;
/** Distance between columns. */
const step = 0.2;
/**
 * Distance along the seam below which a line is too straight to locate the intersection of its
 * normals.
 */
const straight = 1.5;

/** A line across a piece from a point of its seam line. */
interface Column {
  /** Point in the coordinates of the piece. */
  readonly at: Point;
  /** Unit vector into the piece. */
  readonly normal: Point;
  /**
   * Distance to the end of the piece, or to the point that is as near to another place of the seam.
   */
  readonly depth: number;
}

interface Ribbon {
  readonly piece: number;
  /** Columns at equal steps along the seam in sewing order, the same number for both sides. */
  readonly columns: readonly Column[];
}

export interface StraightSeam {
  /** Mean of both sides. */
  readonly length: number;
  readonly a: Ribbon;
  readonly b: Ribbon;
  /** True if the seam has to run from right to left for side a to be above it. */
  readonly runsLeft: boolean;
}

/** A place near a seam: share of its length in sewing order, from 0 to 1, and distance inwards. */
export interface NearSeam {
  readonly side: 'a' | 'b';
  readonly share: number;
  readonly offset: number;
}

/** Straightens a seam; undefined for a seam without length. */
export function straightSeam(scene: PatternScene, number: number): StraightSeam | undefined {
  const seam = scene.seams[number];
  if (!seam) return undefined;
  const lines = [seam.a, seam.b].map(({piece, vertices}) =>
    pick(scene.pieces[piece]?.points ?? [], vertices),
  ) as [Point[], Point[]];
  const ends = [0];
  for (let k = 1; k < Math.min(lines[0].length, lines[1].length); k++) {
    const long = lines.map((line) => distance(line[k - 1] ?? [0, 0], line[k] ?? [0, 0]));
    ends.push((ends[k - 1] ?? 0) + ((long[0] ?? 0) + (long[1] ?? 0)) / 2);
  }
  const length = ends.at(-1) ?? 0;
  if (length === 0) return undefined;
  const ribbon = (side: SeamSide, line: readonly Point[]): Ribbon => ({
    piece: side.piece,
    columns: columnsOf(scene, side, line, ends),
  });
  return {
    length,
    a: ribbon(seam.a, lines[0]),
    b: ribbon(seam.b, lines[1]),
    runsLeft: !isOnLeft(scene, seam.a),
  };
}

/** Returns whether the piece is to the left of its seam in sewing order. */
function isOnLeft({pieces}: PatternScene, {piece, vertices: [first, second]}: SeamSide): boolean {
  const {outline = [], holes = []} = pieces[piece] ?? {};
  return [outline, ...holes].some((loop) =>
    loop.some((v, k) => v === first && loop[(k + 1) % loop.length] === second),
  );
}

function columnsOf(
  scene: PatternScene,
  side: SeamSide,
  line: readonly Point[],
  ends: readonly number[],
): readonly Column[] {
  const sign = isOnLeft(scene, side) ? 1 : -1;
  const along = line.slice(1).map((to, k) => unit(minus(to, line[k] ?? to)));
  const normals = line.map((_, k): Point => {
    const [x0, y0] = along[k - 1] ?? along[k] ?? [1, 0];
    const [x1, y1] = along[k] ?? [x0, y0];
    return unit([-sign * (y0 + y1), sign * (x0 + x1)]);
  });
  const length = ends.at(-1) ?? 0;
  const count = Math.max(1, Math.ceil(length / step));
  let edge = 0;
  const feet = Array.from({length: count + 1}, (_, k) => {
    const way = (length * k) / count;
    while (edge < ends.length - 2 && way > (ends[edge + 1] ?? Infinity)) edge++;
    const [from, to] = [ends[edge] ?? 0, ends[edge + 1] ?? 0];
    const t = to > from ? (way - from) / (to - from) : 0;
    const here = (values: readonly Point[]): Point => {
      const start = values[edge] ?? [0, 0];
      return between(start, values[edge + 1] ?? start, t);
    };
    return {at: here(line), normal: unit(here(normals))};
  });
  const edges = edgesOf(scene, side.piece);
  const apart = Math.ceil(straight / (length / count));
  return feet.map(({at, normal}, k) => {
    // at a corner the normal would run along the next edge, or past it
    const inside = between(at, feet[k === 0 ? 1 : k === count ? count - 1 : k]?.at ?? at, 1 / 4);
    let depth = Math.min(ribbonDepth, untilOut(inside, normal, edges));
    feet.forEach((other, n) => {
      if (Math.abs(n - k) >= apart) depth = Math.min(depth, untilNearer(at, normal, other.at));
    });
    return {at, normal, depth};
  });
}

/** Returns the ends of all edges of a piece, four numbers each. */
function edgesOf({pieces}: PatternScene, piece: number): Float64Array {
  const {points = [], outline = [], holes = []} = pieces[piece] ?? {};
  return Float64Array.from(
    [outline, ...holes].flatMap((loop) => {
      const line = pick(points, loop);
      return line.flatMap((from, k) => [...from, ...(line[(k + 1) % line.length] ?? from)]);
    }),
  );
}

/**
 * Returns the distance from a point of the outline, along a direction, to where it leaves the
 * piece.
 */
function untilOut([x, y]: Point, [nx, ny]: Point, edges: Float64Array): number {
  let least = Infinity;
  for (let k = 0; k < edges.length; k += 4) {
    const ax = (edges[k] ?? 0) - x;
    const ay = (edges[k + 1] ?? 0) - y;
    const ex = (edges[k + 2] ?? 0) - x - ax;
    const ey = (edges[k + 3] ?? 0) - y - ay;
    const across = nx * ey - ny * ex;
    if (Math.abs(across) < 1e-12) continue;
    const way = (ax * ey - ay * ex) / across;
    const share = (ax * ny - ay * nx) / across;
    // the edge at the start does not count
    if (way > 0.02 && way < least && share >= 0 && share <= 1) least = way;
  }
  return least;
}

/**
 * Returns the distance along the normal at which `other` becomes nearer than `at`: |n d - v| = d
 * for v = other - at.
 */
function untilNearer(at: Point, [nx, ny]: Point, other: Point): number {
  const vx = other[0] - at[0];
  const vy = other[1] - at[1];
  const ahead = nx * vx + ny * vy;
  return ahead > 1e-9 ? (vx * vx + vy * vy) / (2 * ahead) : Infinity;
}

/** Converts a place near the seam to its piece. */
export function onPieceAt(seam: StraightSeam, {side, share, offset}: NearSeam): OnPiece {
  const {piece, columns} = seam[side];
  const place = Math.min(1, Math.max(0, share)) * (columns.length - 1);
  const k = Math.min(Math.floor(place), columns.length - 2);
  const [from, to] = [columns[k], columns[k + 1]];
  if (!from || !to) return {piece, point: [0, 0]};
  const t = place - k;
  const at = (column: Column): Point => plus(column.at, column.normal, offset);
  return {piece, point: between(at(from), at(to), t)};
}

// Mesh of the print on both sides of a straightened seam, side a above the line and side b below.

/** Distance between rows. [cm] */
const rowStep = 0.3;
const rows = Math.ceil(ribbonDepth / rowStep);

export class StripMesh {
  readonly object: Mesh<BufferGeometry, PrintMaterial>;
  readonly #seam: StraightSeam;
  readonly #coordinates: BufferAttribute;

  constructor(seam: StraightSeam, material: PrintMaterial) {
    this.#seam = seam;
    const columns = seam.a.columns.length;
    const positions: number[] = [];
    const indices: number[] = [];
    for (const [ribbon, up] of [
      [seam.a, 1],
      [seam.b, -1],
    ] as const) {
      const first = positions.length / 3;
      ribbon.columns.forEach(({depth}, k) => {
        const way = (seam.length * k) / (columns - 1);
        const x = seam.runsLeft ? seam.length - way : way;
        for (const d of depths(depth)) positions.push(x, up * d, 0);
      });
      for (let k = 0; k + 1 < columns; k++) {
        for (let row = 0; row < rows; row++) {
          const corner = first + k * (rows + 1) + row;
          const next = corner + rows + 1;
          // the winding depends on side and direction
          const [one, other] = up > 0 !== seam.runsLeft ? [corner, next] : [next, corner];
          indices.push(one, other, other + 1, one, other + 1, one + 1);
        }
      }
    }
    this.#coordinates = new BufferAttribute(new Float32Array((positions.length / 3) * 2), 2);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    geometry.setAttribute('uv', this.#coordinates);
    geometry.setAttribute('printed', new BufferAttribute(new Uint8Array(positions.length / 3), 1));
    geometry.setIndex(indices);
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  /** Aligns the strip with the print as the pieces of the scene. */
  align(scene: PatternScene): void {
    const printed = this.object.geometry.getAttribute('printed');
    let vertex = 0;
    const lay = ({piece, columns}: Ribbon): void => {
      const {alignment, plain} = scene.pieces[piece] ?? {plain: true};
      if (!alignment) return;
      const map = imageCoordinates(scene.print, alignment, columns[0]?.at ?? [0, 0]);
      for (const {at, normal, depth} of columns) {
        for (const d of depths(depth)) {
          const [u, v] = apply(map, plus(at, normal, d));
          printed.setX(vertex, plain ? 0 : 1);
          this.#coordinates.setXY(vertex++, u, v);
        }
      }
    };
    lay(this.#seam.a);
    lay(this.#seam.b);
    this.#coordinates.needsUpdate = true;
    printed.needsUpdate = true;
  }

  dispose(): void {
    this.object.geometry.dispose();
  }
}

/** Returns the rows of a column, from the seam inwards; rows beyond its depth coincide. */
const depths = (depth: number): readonly number[] =>
  Array.from({length: rows + 1}, (_, row) => Math.min(row * rowStep, depth));
