/** Checks a result by its geometry alone: properties that hold for every problem and method. */
import {determinant} from '@/model/geometry/plane-map.js';
import type {Point, ResultPiece, ResultSeam, SolveOptions, SolveResult} from 'seamwise/node';

import {distanceModulo, fitsOf, randomFit} from './fits.js';
import {checkMesh} from './check-mesh.js';
import {
  cross,
  distance,
  dot,
  minus,
  onPrint,
  plus,
  rotated,
  turnBetween,
} from '@/model/geometry/vectors.js';
import {alongLine, aroundLoop, at, greatest, mirrored, scale, sum} from '../plane.js';
import {printElements} from '@/model/print/wallpaper.js';

const degree = Math.PI / 180;

/**
 * Limits for a result; `paper` and `ws19` keep lengths and symmetries only by penalties, so softly.
 */
interface Limits {
  /** Least area of a triangle as a share of its rest area. */
  readonly area: number;
  /** Greatest distance between mirror images. [cm] */
  readonly symmetry: number;
  /** True if the method keeps lengths and lines of the garment. */
  readonly keepsGarment: boolean;
}

const strict: Limits = {area: 0.3, symmetry: 1e-6, keepsGarment: true};
const soft: Limits = {area: 0, symmetry: 1e-3, keepsGarment: false};

/** Violations of a result, a message each; empty if it is valid. */
export function violations(result: SolveResult, options: SolveOptions = {}): string[] {
  const broken: string[] = [];
  const must = (holds: boolean, sentence: string) => {
    if (!holds) broken.push(sentence);
  };
  if (!allFinite(result)) return ['a coordinate or figure is not finite'];
  const limits = result.metrics.method === 'best' ? strict : soft;
  for (const piece of result.pieces) {
    broken.push(...checkMesh(piece, limits.area));
    if (limits.keepsGarment) broken.push(...checkOutline(piece));
  }
  broken.push(...checkSeams(result, limits));
  broken.push(...checkSymmetries(result, limits.symmetry));
  const moved = greatest(result.pieces.map(movement));
  const allowed = (options.maxChangeCm ?? 1) + 1e-6;
  must(moved <= allowed, `an outline vertex moved ${moved} cm (limit ${allowed})`);
  broken.push(...checkMetrics(result, moved));
  broken.push(...checkOptions(result, options));
  return broken;
}

function allFinite(value: unknown): boolean {
  if (typeof value === 'number') return Number.isFinite(value);
  if (typeof value !== 'object' || value === null) return true;
  return Object.values(value).every(allFinite);
}

const loopsOf = ({outline, holes}: ResultPiece) => [outline, ...holes];

/**
 * Checks that no outline edge stretches by more than 15 %, and no smooth one bends by more than 15
 * degrees.
 */
function checkOutline(piece: ResultPiece): string[] {
  let [change, kink] = [0, 0];
  for (const loop of loopsOf(piece)) {
    loop.forEach((v, k) => {
      const [u, w] = [at(loop, k - 1), at(loop, (k + 1) % loop.length)];
      const lengthIn = (points: readonly Point[]) => distance(at(points, v), at(points, w));
      const turnIn = (points: readonly Point[]) =>
        turnBetween(minus(at(points, v), at(points, u)), minus(at(points, w), at(points, v)));
      change = Math.max(change, Math.abs(lengthIn(piece.shape) / lengthIn(piece.rest) - 1));
      const rest = turnIn(piece.rest);
      if (Math.abs(rest) < 30 * degree) {
        kink = Math.max(kink, Math.abs(turnIn(piece.shape) - rest));
      }
    });
  }
  const broken: string[] = [];
  if (change > 0.15) broken.push(`${piece.name}: an edge changed its length by ${change}`);
  if (kink > 15 * degree) broken.push(`${piece.name}: bends by ${kink / degree} degrees`);
  return broken;
}

/**
 * Checks that both sides keep the ratio of their rest lengths, edge by edge, and run along
 * outlines, none sewn twice.
 */
function checkSeams(result: SolveResult, limits: Limits): string[] {
  const broken: string[] = [];
  const must = (holds: boolean, sentence: string) => {
    if (!holds) broken.push(sentence);
  };
  const averaged = restLengths(result);
  const sewn = new Set<string>();
  result.seams.forEach((seam, number) => {
    const sides = [seam.a, seam.b].map(({piece, vertices}) => {
      const {name, rest, shape, ...loops} = at(result.pieces, piece);
      const edges = alongLine(vertices);
      const rim = new Set(
        [loops.outline, ...loops.holes].flatMap(aroundLoop).map(([u, v]) => `${u},${v}`),
      );
      const isOutline =
        edges.every(([u, v]) => rim.has(`${u},${v}`)) ||
        edges.every(([u, v]) => rim.has(`${v},${u}`));
      must(isOutline, `seam ${number} leaves the outline of ${name}`);
      for (const [u, v] of edges) {
        const key = `${piece}:${Math.min(u, v)},${Math.max(u, v)}`;
        must(!sewn.has(key), `seam ${number} sews an edge of ${name} again`);
        sewn.add(key);
      }
      const longest = greatest(edges.map(([u, v]) => distance(at(rest, u), at(rest, v))));
      must(longest <= 1.05 + 1e-9, `seam ${number} has an edge of ${longest} cm`);
      const now = edges.map(([u, v]) => distance(at(shape, u), at(shape, v)));
      const before = sum(edges.map(([u, v]) => averaged(piece, u, v)));
      const change = Math.abs(sum(now) - before);
      if (limits.keepsGarment) {
        const allowed = Math.max(0.02 * before, 0.2) + 1e-9;
        must(change <= allowed, `seam ${number} changed its length by ${change} of ${before} cm`);
      }
      return {now, before};
    });
    const [a, b] = [at(sides, 0), at(sides, 1)];
    must(a.now.length === b.now.length && a.now.length > 0, `seam ${number} has unequal sides`);
    const ratio = a.before / b.before;
    must(
      Math.abs(ratio / seam.lengthRatio - 1) < 2e-3,
      `seam ${number} has the length ratio ${ratio}, not ${seam.lengthRatio}`,
    );
    const apart = greatest(a.now.map((length, k) => Math.abs(length - ratio * (b.now[k] ?? 0))));
    must(apart <= 0.01, `seam ${number} has edges ${apart} cm off their ratio`);
    const whole = Math.abs(sum(a.now) - ratio * sum(b.now));
    must(whole <= 0.01, `seam ${number} has sides ${whole} cm off their ratio`);
  });
  return broken;
}

/** The rest length of an edge; under a symmetry, the mean with that of its mirror image. */
function restLengths(result: SolveResult): (piece: number, u: number, v: number) => number {
  const images = result.pieces.map(() => new Map<number, readonly [number, number]>());
  for (const symmetry of result.symmetries) {
    const [p, q] = symmetry.kind === 'piece' ? [symmetry.piece, symmetry.piece] : symmetry.pieces;
    for (const [i, j] of symmetry.pairs) {
      images[p]?.set(i, [q, j]);
      images[q]?.set(j, [p, i]);
    }
  }
  const length = (piece: number, u: number, v: number) => {
    const {rest} = at(result.pieces, piece);
    return distance(at(rest, u), at(rest, v));
  };
  return (piece, u, v) => {
    const own = length(piece, u, v);
    const [i, j] = [images[piece]?.get(u), images[piece]?.get(v)];
    return i && j ? (own + length(i[0], i[1], j[1])) / 2 : own;
  };
}

/** Checks that print and shape obey every symmetry of the result. */
function checkSymmetries(result: SolveResult, shapeTolerance: number): string[] {
  const broken: string[] = [];
  const elements = printElements(result.print).filter((element) => determinant(element) < 0);
  const apart = distanceModulo(result.print);
  result.symmetries.forEach((symmetry, number) => {
    const [i, j] = symmetry.kind === 'piece' ? [symmetry.piece, symmetry.piece] : symmetry.pieces;
    const [from, to] = [at(result.pieces, i), at(result.pieces, j)];
    const map = (p: Point) => mirrored(symmetry.map, p);
    if (i === j && distance(map(map([1, 2])), [1, 2]) > 1e-9) {
      broken.push(`symmetry ${number} of one piece is a glide`);
    }
    const shape = symmetry.pairs.map(([u, v]) => distance(at(to.shape, v), map(at(from.shape, u))));
    if (greatest(shape) > shapeTolerance) {
      broken.push(`symmetry ${number}: the shape is off by ${greatest(shape)} cm`);
    }
    const covered = new Set(symmetry.pairs.flatMap(([u, v]) => [`${i}:${u}`, `${j}:${v}`]));
    const all = [from.outline.map((v) => `${i}:${v}`), to.outline.map((v) => `${j}:${v}`)].flat();
    if (!all.every((v) => covered.has(v))) {
      broken.push(`symmetry ${number} does not pair every outline vertex`);
    }
    const print = from.shape.map((p) =>
      apart(onPrint(to.alignment, map(p)), onPrint(from.alignment, p), elements),
    );
    if (greatest(print) > 1e-6) {
      broken.push(`symmetry ${number}: the print is off by ${greatest(print)} cm`);
    }
  });
  return broken;
}

/**
 * Greatest movement of a piece's outline, directly or after its best rigid motion, whichever is
 * less. [cm]
 */
function movement(piece: ResultPiece): number {
  const rim = loopsOf(piece).flat();
  const of = (points: readonly Point[]) => rim.map((v) => at(points, v));
  const centred = (points: readonly Point[]) => {
    const centre = scale(
      points.reduce((sum, p) => plus(sum, p), [0, 0]),
      1 / points.length,
    );
    return points.map((p) => minus(p, centre));
  };
  const [rest, shape] = [of(piece.rest), of(piece.shape)];
  const [a, b] = [centred(rest), centred(shape)];
  const angle = Math.atan2(
    sum(a.map((p, k) => cross(p, at(b, k)))),
    sum(a.map((p, k) => dot(p, at(b, k)))),
  );
  return Math.min(
    greatest(rest.map((p, k) => distance(p, at(shape, k)))),
    greatest(a.map((p, k) => distance(rotated(p, angle), at(b, k)))),
  );
}

/** Checks the figures of a result against its geometry. */
function checkMetrics(result: SolveResult, maxMovedCm: number): string[] {
  const {metrics} = result;
  const final = fitsOf(
    result,
    'shape',
    result.pieces.map(({alignment}) => alignment),
  );
  const found = {
    fit: final.any,
    fitStrict: final.strict,
    fitSeam: final.seam,
    fitAligned: fitsOf(
      result,
      'rest',
      result.pieces.map(({alignment}) => alignment),
    ).any,
    fitSearch: fitsOf(result, 'rest', result.search).any,
    maxMovedCm,
  };
  const broken = Object.entries(found).flatMap(([name, value]) => {
    const claimed = metrics[name as keyof typeof found];
    return Math.abs(claimed - value) <= 1e-3 * (value + 1)
      ? []
      : [`${name} is ${value}, not ${claimed}`];
  });
  const {mean, error} = randomFit(result);
  if (Math.abs(metrics.fitRandom - mean) > 6 * error + 0.1 * mean + 1e-6) {
    broken.push(`fitRandom is about ${mean}, not ${metrics.fitRandom}`);
  }
  return broken;
}

/**
 * Checks the user's options beyond the geometry: ignored seams, and permitted alignments of pieces.
 */
function checkOptions(result: SolveResult, options: SolveOptions): string[] {
  const broken: string[] = [];
  const plain = new Set(options.plain ?? []);
  const isPlain = ({piece}: ResultSeam['a']) => plain.has(at(result.pieces, piece).name);
  result.seams.forEach((seam, number) => {
    const off = (options.unmatched ?? []).includes(number) || isPlain(seam.a) || isPlain(seam.b);
    if (seam.matched === off) broken.push(`seam ${number} is switched ${off ? 'on' : 'off'}`);
    if (options.continuousOnly && seam.matched && seam.kind !== 'continuous') {
      broken.push(`seam ${number} is mirrored`);
    }
  });
  const symmetric = new Set(
    result.symmetries.flatMap((one) => (one.kind === 'piece' ? [one.piece] : one.pieces)),
  );
  result.pieces.forEach(({name, alignment}, piece) => {
    const pin = options.pins?.[name];
    const rule = options.grain?.pieces?.[name] ?? options.grain?.default ?? 'free';
    const lock = typeof rule === 'string' ? rule : rule.lock;
    if (!pin || lock !== 'free' || symmetric.has(piece)) return; // others go to a permitted place
    const turnedBy = Math.abs(Math.sin((alignment.angle - pin.angle) / 2));
    if (turnedBy > 1e-9 || distance(alignment.translation, pin.translation) > 1e-9) {
      broken.push(`${name} does not lie where it is pinned`);
    }
  });
  return broken;
}
