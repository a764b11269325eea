/**
 * The mismatches of a result, from its geometry, and distances modulo the symmetries of its print.
 */
import {apply, type PlaneMap} from '@/model/geometry/plane-map.js';
import type {Alignment, Point, ResultSeam, SolveResult} from 'seamwise/node';

import {printElements, reducedBasis, type Repeat} from '@/model/print/wallpaper.js';
import {
  cross,
  distance,
  middle,
  minus,
  onPrint,
  plus,
  turnBetween,
} from '@/model/geometry/vectors.js';
import {alongLine, at, scale, sum} from '../plane.js';

interface Fits {
  /** Any symmetry of the print, edge by edge. */
  readonly any: number;
  /** Only the symmetries that align the directions of the two edges, within 0.1 rad of the best. */
  readonly strict: number;
  /** One symmetry for the whole seam. */
  readonly seam: number;
}

type Lattice = Pick<Repeat, 'w1' | 'w2'>;

/** A vector less the nearest lattice vector. */
function modulo(lattice: Lattice): (v: Point) => Point {
  const [a, b] = reducedBasis(lattice.w1, lattice.w2);
  const cell = cross(a, b);
  return (v) => {
    const i = Math.round(cross(v, b) / cell);
    const j = Math.round(cross(a, v) / cell);
    let least: Point = v;
    let square = Infinity;
    for (const [s, t] of nearby) {
      const x = v[0] - (i + s) * a[0] - (j + t) * b[0];
      const y = v[1] - (i + s) * a[1] - (j + t) * b[1];
      if (x * x + y * y >= square) continue;
      square = x * x + y * y;
      least = [x, y];
    }
    return least;
  };
}

const nearby: readonly Point[] = [-1, 0, 1].flatMap((s) => [-1, 0, 1].map((t): Point => [s, t]));

/**
 * The distance of two points of the print modulo some of its symmetries and all its translations.
 * [cm]
 */
export function distanceModulo(
  lattice: Lattice,
): (x: Point, y: Point, elements: readonly PlaneMap[]) => number {
  const reduce = modulo(lattice);
  return (x, y, elements) =>
    Math.min(...elements.map((element) => Math.hypot(...reduce(minus(x, apply(element, y))))));
}

/** An edge of a seam on the print: its length, and its middle and direction on either side. */
interface PrintEdge {
  readonly length: number;
  readonly x: Point;
  readonly y: Point;
  readonly along: readonly [Point, Point];
}

type Outline = 'rest' | 'shape';

function edgesOf(
  {pieces}: SolveResult,
  {a, b}: ResultSeam,
  outline: Outline,
  alignments: readonly Alignment[],
): PrintEdge[] {
  const side = ({piece, vertices}: ResultSeam['a']) => {
    const points = at(pieces, piece)[outline];
    return alongLine(vertices.map((v) => onPrint(at(alignments, piece), at(points, v))));
  };
  const second = side(b);
  return side(a).map(([from, to], k) => {
    const [from2, to2] = at(second, k);
    return {
      length: (distance(from, to) + distance(from2, to2)) / 2,
      x: middle(from, to),
      y: middle(from2, to2),
      along: [minus(to, from), minus(to2, from2)],
    };
  });
}

/** Matched seams, except those that join a piece to its own mirror twin. */
function countedSeams({seams, symmetries}: SolveResult): ResultSeam[] {
  const images = new Map<string, string>();
  for (const symmetry of symmetries) {
    const [i, j] = symmetry.kind === 'piece' ? [symmetry.piece, symmetry.piece] : symmetry.pieces;
    for (const [u, v] of symmetry.pairs) {
      images.set(`${i}:${u}`, `${j}:${v}`).set(`${j}:${v}`, `${i}:${u}`);
    }
  }
  const isTwin = ({a, b}: ResultSeam) =>
    a.vertices.every((v, k) => images.get(`${a.piece}:${v}`) === `${b.piece}:${at(b.vertices, k)}`);
  return seams.filter((seam) => seam.matched && !isTwin(seam));
}

/** The mismatches of `rest` or `shape` under the given alignments. [cm2] */
export function fitsOf(
  result: SolveResult,
  outline: Outline,
  alignments: readonly Alignment[],
): Fits {
  const elements = printElements(result.print);
  const apart = distanceModulo(result.print);
  const seams = countedSeams(result).map((seam) => edgesOf(result, seam, outline, alignments));
  const edges = seams.flat();
  const total = (some: (edge: PrintEdge) => readonly PlaneMap[]) =>
    sum(edges.map((edge) => edge.length * apart(edge.x, edge.y, some(edge))));
  return {
    any: total(() => elements),
    strict: total((edge) => parallel(edge, elements)),
    seam: sum(
      seams.map((seam) =>
        Math.min(...elements.map((element) => cheapest(seam, element, result.print))),
      ),
    ),
  };
}

function parallel({along: [a, b]}: PrintEdge, elements: readonly PlaneMap[]): PlaneMap[] {
  const turns = elements.map((element) =>
    Math.abs(turnBetween(a, apply({...element, shift: [0, 0]}, b))),
  );
  const least = Math.min(...turns);
  return elements.filter((_, k) => at(turns, k) <= least + 0.1);
}

/** The cost of a seam whose side b is moved by `element` and one lattice vector near the mean. */
function cheapest(seam: readonly PrintEdge[], element: PlaneMap, lattice: Lattice): number {
  const reduce = modulo(lattice);
  const [u1, u2] = reducedBasis(lattice.w1, lattice.w2);
  const apart = seam.map(({x, y}) => minus(x, apply(element, y)));
  const length = sum(seam.map((edge) => edge.length));
  const mean = apart
    .map((v, k) => scale(v, at(seam, k).length / length))
    .reduce((sum, v) => plus(sum, v), [0, 0]);
  const near = minus(mean, reduce(mean));
  const costs = nearby.map(([s, t]) => {
    const shift = plus(near, plus(scale(u1, s), scale(u2, t)));
    return sum(apart.map((v, k) => at(seam, k).length * distance(v, shift)));
  });
  return Math.min(...costs);
}

/**
 * The mean mismatch of `rest` over random alignments, and the standard error of that mean. [cm2]
 */
export function randomFit(result: SolveResult): {mean: number; error: number} {
  let state = 2463534242;
  const random = () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
  const {w1, w2} = result.print;
  const elements = printElements(result.print);
  const apart = distanceModulo(result.print);
  const seams = countedSeams(result);
  const fits = Array.from({length: 20}, () => {
    const anywhere = result.pieces.map(() => ({
      angle: random() * 2 * Math.PI,
      translation: plus(scale(w1, random()), scale(w2, random())),
    }));
    const edges = seams.flatMap((seam) => edgesOf(result, seam, 'rest', anywhere));
    return sum(edges.map(({length, x, y}) => length * apart(x, y, elements)));
  });
  const mean = sum(fits) / fits.length;
  const variance = sum(fits.map((fit) => (fit - mean) ** 2)) / fits.length;
  return {mean, error: Math.sqrt(variance / fits.length)};
}
