/** Points of a print that are easy to find on fabric, such as the middle of a flower. [cm] */
import type {Leaf} from './vector-tile.js';
import {
  combined,
  coordinates,
  distance,
  dot,
  middle,
  minus,
  norm,
  onPiece,
  onPrint,
  plus,
  rotated,
  unit,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';
import {imageCell} from '../model/print/wallpaper.js';
import {shared} from './boxes.js';

/** A motif of the print, and its copies at all points of a lattice. */
interface Motif {
  /** The middle on the print. */
  readonly at: Point;
  readonly radius: number;
}

export interface Motifs {
  readonly motifs: readonly Motif[];
  readonly lattice: readonly [Point, Point];
}

/** Limits of a motif's width and height. */
const leastSize = 0.4;
const mostSize = 7;
/** Motifs are as wide as they are high, within this factor. */
const mostAspect = 1.7;
/** Shapes whose middles are this close, as a share of the larger one's size, are concentric. */
const concentric = 0.12;
/** Motifs that are nearly as distinct as the best one are used, too. */
const nearlyBest = 0.5;
const mostMotifs = 6;

/** Greatest distance of a mirrored point from one of the shape, as a share of its size. */
const likeness = 0.05;
/** Weights of a motif's properties. */
const weights = {concentric: 0.8, symmetric: 1.2, repeated: 0.4};
/** More concentric shapes do not make a motif more distinct. */
const mostConcentric = 3;
/** Larger motifs are not more distinct. */
const easySize = 4;

interface Shape {
  readonly middle: Point;
  readonly size: number;
  readonly isSymmetric: boolean;
  readonly kind: string;
  readonly isMotif: boolean;
}

/** Returns whether points are symmetric about their middle, as a flower or a leaf seen straight. */
function isSymmetric(points: readonly Point[], [x, y]: Point, size: number): boolean {
  const maps: readonly ((p: Point) => Point)[] = [
    (p) => [2 * x - p[0], p[1]],
    (p) => [p[0], 2 * y - p[1]],
    (p) => [2 * x - p[0], 2 * y - p[1]],
  ];
  return maps.some((map) =>
    points.every((p) => points.some((q) => distance(map(p), q) < likeness * size)),
  );
}

/** Overlap of boxes above which areas of one colour belong together. [share of the smaller] */
const joined = 0.1;
/** Images with more areas have no flat motifs, but shades. */
const mostAreas = 3000;

interface Area {
  readonly fill: string;
  readonly points: readonly Point[];
  readonly box: Box;
  readonly size: number;
}

const extent = ({low, high}: Box): readonly [number, number] => [
  Math.max(0, high[0] - low[0]),
  Math.max(0, high[1] - low[1]),
];

function areaOf(fill: string, points: readonly Point[]): Area {
  const box = boxOf(points);
  return {fill, points, box, size: Math.max(...extent(box))};
}

const product = ([w, h]: readonly [number, number]): number => w * h;

/** The areas of leaves, those of one colour that overlap as one, such as the petals of a flower. */
function areasOf(leaves: readonly Leaf[]): readonly Area[] {
  const all = leaves.flatMap(({path, fill}) =>
    fill
      ? [
          areaOf(
            String(fill),
            path.flatMap((step) => step.points),
          ),
        ]
      : [],
  );
  if (all.length > mostAreas) return [];
  const found: Area[] = [];
  for (const area of all.filter(({size}) => size <= mostSize)) {
    const near = found.findIndex(
      ({fill, box}) =>
        fill === area.fill &&
        product(extent(shared(box, area.box))) >
          joined * Math.min(product(extent(box)), product(extent(area.box))),
    );
    const other = found[near];
    const whole = other && areaOf(area.fill, [...other.points, ...area.points]);
    if (whole && whole.size <= mostSize) found[near] = whole;
    else found.push(area);
  }
  return found;
}

function shapeOf({fill, points, box, size}: Area): Shape {
  const [w, h] = extent(box);
  const shorter = Math.min(w, h);
  const centre = middle(box.low, box.high);
  return {
    ...{middle: centre, size},
    isSymmetric: isSymmetric(points, centre, size),
    kind: `${fill} ${size.toFixed(1)}`,
    isMotif: shorter >= leastSize && size < mostAspect * shorter,
  };
}

/**
 * Motifs of a cell: compact shapes. They are the more distinct, the larger and the more symmetric
 * they are, the more shapes are concentric with them, and the fewer there are of their kind.
 */
function motifsAmong(leaves: readonly Leaf[], [w, h]: Point): readonly (Motif & {score: number})[] {
  const shapes = areasOf(leaves).map(shapeOf);
  const isInCell = ({middle: [x, y]}: Shape): boolean => x >= 0 && x < w && y >= 0 && y < h;
  const counts = new Map<string, number>();
  for (const one of shapes) {
    if (isInCell(one)) counts.set(one.kind, (counts.get(one.kind) ?? 0) + 1);
  }
  return shapes
    .filter((one) => one.isMotif && isInCell(one))
    .map(({middle: at, size, kind, isSymmetric: isEven}) => {
      const inner = shapes.filter(
        (other) => distance(other.middle, at) < concentric * size && other.size <= size,
      ).length;
      const score =
        Math.log2(Math.min(size, easySize) / leastSize) +
        weights.concentric * Math.min(inner, mostConcentric) +
        (isEven ? weights.symmetric : 0) -
        weights.repeated * Math.log2(counts.get(kind) ?? 1);
      return {at, radius: size / 2, score};
    })
    .sort((a, b) => b.score - a.score);
}

/**
 * The motifs of a print.
 * @param leaves the shapes of its cell; without shapes, or motifs among them, the group's origin
 *   counts, which is the middle of a motif
 */
export function motifsOf(print: Print, leaves: readonly Leaf[] = []): Motifs {
  const lattice = imageCell(print);
  const [a, b] = lattice;
  const found = motifsAmong(leaves, [norm(a), norm(b)]);
  const best = found[0]?.score ?? 0;
  const motifs = found
    .filter(({score}) => score > best - nearlyBest)
    .slice(0, mostMotifs)
    .map(({at, radius}) => ({at: combined([unit(a), unit(b)], ...at), radius}));
  if (motifs.length > 0) return {motifs, lattice};
  const {w1, w2} = print;
  const radius = Math.min(1, 0.25 * Math.min(norm(w1), norm(w2)));
  return {motifs: [{at: [0, 0], radius}], lattice: [w1, w2]};
}

/** Repeats shorter than this are stripes: only the distance across them counts. */
const stripe = 1;

/** The motif nearest to a point of the sheet, with its middle on the sheet. */
export function nearestMotif(
  {motifs, lattice}: Motifs,
  lying: Alignment,
  from: Point,
  cost: (at: Point) => number = (at) => distance(at, from),
): Motif {
  const steps = [-1, 0, 1, 2];
  let best: Motif = {at: from, radius: 0};
  let least = Infinity;
  for (const {at: motif, radius} of motifs) {
    const [s, t] = coordinates(lattice, minus(onPrint(lying, from), motif)).map(Math.floor);
    for (const i of steps) {
      for (const j of steps) {
        const on = plus(motif, combined(lattice, (s ?? 0) + i - 1, (t ?? 0) + j - 1));
        const at = acrossStripes(lattice, lying, from, onPiece(lying, on));
        if (cost(at) >= least) continue;
        least = cost(at);
        best = {at, radius};
      }
    }
  }
  return best;
}

/** The point at the level of another one, for stripes along which all points are alike. */
function acrossStripes(
  lattice: readonly [Point, Point],
  lying: Alignment,
  from: Point,
  at: Point,
): Point {
  const short = lattice.find((side) => norm(side) < stripe);
  if (!short) return at;
  const along = rotated(unit(short), lying.angle);
  return plus(at, along, -dot(minus(at, from), along));
}
