/**
 * Places on printed fabric where a piece shows the same print as in its alignment. Fabric
 * coordinates: x across from the left edge, y along the warp from the cut; p_fabric = R(angle) p +
 * translation. Lengths in cm, angles in radians.
 */
import {determinant} from '../model/geometry/plane-map.js';
import {
  combined,
  coordinates,
  minus,
  plus,
  rotated,
  wrapped,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import type {MarkerPiece, MarkerProblem} from '../model/result/marker-search.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import {printElements, reducedBasis, type CellOf} from '../model/print/wallpaper.js';
import {areApart, ringOf, type Ring} from './apart.js';

/** Angles that differ by less are equal. [rad] */
const sameAngle = 1e-6;
/** Overlaps smaller than this are ignored. [cm] */
const slack = 1e-4;

/** The parts of a problem's piece that determine its places. */
export type LayablePiece = Pick<MarkerPiece, 'outline' | 'alignment' | 'turns' | 'up' | 'shifts'>;

/** The fabric, and the distances that pieces keep on it. */
export interface Bolt {
  readonly repeat: CellOf;
  /** Position of an origin of the print. */
  readonly origin: Point;
  readonly widthCm: number;
  readonly selvedgeCm: number;
  readonly gapCm: number;
  /** All pieces point the same way up. */
  readonly isOneWay: boolean;
  /** Polygons where no piece may lie. */
  readonly flaws: readonly (readonly Point[])[];
}

/** A rotation of a piece on the fabric. */
interface Turn {
  readonly angle: number;
  /** Possible translations, up to whole repeats. */
  readonly bases: readonly Point[];
}

const stepOf: Readonly<Record<LayablePiece['turns'], number>> = {
  half: Math.PI,
  quarter: Math.PI / 2,
  any: 0,
};

const isMultiple = (angle: number, step: number): boolean =>
  step === 0 || Math.abs(wrapped(angle - step * Math.round(angle / step))) < sameAngle;

/**
 * All rotations in which a piece matches its print, face up. The first is the one of its alignment,
 * if allowed.
 */
export function turnsOf(piece: LayablePiece, {repeat, origin, isOneWay}: Bolt): readonly Turn[] {
  const {angle: aligned, translation} = piece.alignment;
  const turns = printElements(repeat)
    .filter((element) => determinant(element) > 0)
    .map(({xx, yx, shift}) => ({turn: Math.atan2(yx, xx), shift}))
    .filter(({turn}) => isMultiple(turn, stepOf[piece.turns]))
    .map(({turn, shift}): Turn => {
      const angle = wrapped(turn - aligned);
      const under = plus(rotated(minus([0, 0], translation), angle), plus(shift, origin));
      const shifts = [[0, 0] as const, ...piece.shifts];
      return {angle, bases: shifts.map((by) => plus(under, rotated(by, turn)))};
    });
  if (!isOneWay) return turns;
  const upright = turns.filter(({angle}) => rotated(piece.up, angle)[1] > 0.1);
  return upright.length > 0 ? upright.slice(0, 1) : turns.slice(0, 1);
}

/** All points in a box of the lattice through `base`. */
function latticeIn(basis: readonly [Point, Point], base: Point, {low, high}: Box): Point[] {
  const corners = [low, high, [low[0], high[1]], [high[0], low[1]]] as const;
  const seen = boxOf(corners.map((corner) => coordinates(basis, minus(corner, base))));
  const found: Point[] = [];
  for (let i = Math.ceil(seen.low[0] - slack); i <= seen.high[0] + slack; i++) {
    for (let j = Math.ceil(seen.low[1] - slack); j <= seen.high[1] + slack; j++) {
      const at = plus(base, combined(basis, i, j));
      const isWithin = ([0, 1] as const).every(
        (axis) => at[axis] > low[axis] - slack && at[axis] < high[axis] + slack,
      );
      if (isWithin) found.push(at);
    }
  }
  return found;
}

const rings = new WeakMap<readonly Point[], Map<number, Ring>>();

/** A rotated cut line, cached. */
export function turnedRing(cut: readonly Point[], angle: number): Ring {
  const known = rings.get(cut) ?? new Map<number, Ring>();
  rings.set(cut, known);
  const key = Math.round(angle / sameAngle);
  const ring = known.get(key) ?? ringOf(cut.map((p) => rotated(p, angle)));
  known.set(key, ring);
  return ring;
}

/** A piece and its place. */
export interface LaidPiece {
  readonly piece: LayablePiece;
  readonly place: Alignment;
}

/** Obstacles of a piece: indices of other pieces and of flaws, or an edge of the fabric. */
export interface Obstacles {
  readonly pieces: readonly number[];
  readonly flaws: readonly number[];
  readonly isOutside: boolean;
}

export const isFree = ({pieces, flaws, isOutside}: Obstacles): boolean =>
  pieces.length === 0 && flaws.length === 0 && !isOutside;

/** The bounding box of a placed piece. */
export function boxAt({piece, place}: LaidPiece): Box {
  const {low, high} = turnedRing(piece.outline, place.angle);
  return {low: plus(low, place.translation), high: plus(high, place.translation)};
}

/** The used length of the fabric. */
export const usedLength = (laid: readonly LaidPiece[]): number =>
  Math.max(0, ...laid.map((one) => boxAt(one).high[1]));

/** The obstacles to piece `k` at a place. */
export function obstaclesTo(
  laid: readonly LaidPiece[],
  k: number,
  place: Alignment,
  {widthCm, selvedgeCm, gapCm, flaws}: Bolt,
): Obstacles {
  const own = laid[k];
  if (!own) return {pieces: [], flaws: [], isOutside: true};
  const ring = turnedRing(own.piece.outline, place.angle);
  const {low, high} = boxAt({...own, place});
  const meets = (other: Ring, at: Point, gap: number): boolean =>
    !areApart(ring, other, minus(at, place.translation), gap);
  return {
    pieces: laid.flatMap(({piece, place: {angle, translation}}, n) =>
      n !== k && meets(turnedRing(piece.outline, angle), translation, gapCm) ? [n] : [],
    ),
    flaws: flaws.flatMap((flaw, n) => (meets(turnedRing(flaw, 0), [0, 0], 0) ? [n] : [])),
    isOutside:
      low[0] < selvedgeCm - slack || high[0] > widthCm - selvedgeCm + slack || low[1] < -slack,
  };
}

/**
 * Places of one piece among the others, for one of its rotations. Each place is tested only when
 * needed.
 */
export class Places {
  readonly angle: number;
  /**
   * All translations within the edges of the fabric, up to one height of the piece beyond the used
   * length.
   */
  readonly all: readonly Point[];
  readonly #known: (boolean | undefined)[];
  readonly #tell: (at: Point) => boolean;

  constructor(laid: readonly LaidPiece[], k: number, turn: Turn, bolt: Bolt) {
    const own = laid[k];
    this.angle = turn.angle;
    this.#known = [];
    this.#tell = (translation) =>
      isFree(obstaclesTo(laid, k, {angle: turn.angle, translation}, bolt));
    if (!own) {
      this.all = [];
      return;
    }
    const {low, high} = turnedRing(own.piece.outline, turn.angle);
    const {widthCm, selvedgeCm, repeat} = bolt;
    const beyond = usedLength(laid.filter((_, n) => n !== k)) + 2 * (high[1] - low[1]);
    const room: Box = {
      low: [selvedgeCm - low[0], -low[1]],
      high: [widthCm - selvedgeCm - high[0], Math.max(beyond, boxAt(own).high[1]) - high[1]],
    };
    const basis = reducedBasis(repeat.w1, repeat.w2);
    const isRoom = room.low[0] <= room.high[0] + slack;
    this.all = isRoom ? turn.bases.flatMap((base) => latticeIn(basis, base, room)) : [];
  }

  /**
   * Returns whether a place is free.
   * @param n an index of `all`
   */
  isFree(n: number): boolean {
    const at = this.all[n];
    return (this.#known[n] ??= at !== undefined && this.#tell(at));
  }

  /** The result of a test; undefined if the place was not tested yet. */
  known(n: number): boolean | undefined {
    return this.#known[n];
  }

  /** The free place of least cost; places of infinite cost are excluded. */
  least(cost: (at: Point) => number): Point | undefined {
    const costs = this.all.map(cost);
    for (;;) {
      const best = leastOf(costs, (n) => this.#known[n] !== false);
      if (best === undefined) return undefined;
      if (this.isFree(best)) return this.all[best];
    }
  }

  /** The place of least cost, free or not. */
  leastOfAll(cost: (at: Point) => number): Point | undefined {
    const best = leastOf(this.all.map(cost), () => true);
    return best === undefined ? undefined : this.all[best];
  }
}

function leastOf(costs: readonly number[], counts: (n: number) => boolean): number | undefined {
  let [best, least]: [number | undefined, number] = [undefined, Infinity];
  for (let n = 0; n < costs.length; n++) {
    const cost = costs[n] ?? Infinity;
    if (cost < least && counts(n)) [best, least] = [n, cost];
  }
  return best;
}

/** Squared distance of a place from another. */
export const apartFrom =
  (wanted: Point) =>
  (at: Point): number =>
    (at[0] - wanted[0]) ** 2 + (at[1] - wanted[1]) ** 2;

/** Cost of a place in a unit direction from another; infinite if it is farther aside than ahead. */
export const onFrom =
  (from: Point, [wayX, wayY]: Point) =>
  (at: Point): number => {
    const [x, y] = minus(at, from);
    const on = x * wayX + y * wayY;
    const beside = Math.abs(x * wayY - y * wayX);
    return on > slack && beside <= on ? on + 3 * beside : Infinity;
  };

/** The next rotation after the current one. */
export function turnAfter(turns: readonly Turn[], angle: number): Turn | undefined {
  const ways = turns.map((turn) => {
    const way = wrapped(turn.angle - angle);
    return way > sameAngle ? way : way + 2 * Math.PI;
  });
  const least = Math.min(...ways);
  return turns[ways.indexOf(least)];
}

/** The current rotation of a piece, or the first if it has none of these. */
export const turnAt = (turns: readonly Turn[], angle: number): Turn | undefined =>
  turns.find((turn) => Math.abs(wrapped(turn.angle - angle)) < 1e3 * sameAngle) ?? turns[0];

/** The translation that keeps the middle of a piece's bounding box when the piece is rotated. */
export function turnedInPlace({piece, place}: LaidPiece, angle: number): Point {
  const [before, after] = [place.angle, angle].map((one) => turnedRing(piece.outline, one));
  if (!before || !after) return place.translation;
  const middleOf = ({low, high}: Box): Point => [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  return plus(place.translation, minus(middleOf(before), middleOf(after)));
}

// The least space of a piece over all of its rotations. Lengths in cm.

/**
 * The least extent across the fabric and along it, each for the rotation with the smallest value.
 */
export function leastExtents(
  piece: LayablePiece,
  {print, widthCm, selvedgeCm, nap}: MarkerProblem,
): readonly [across: number, along: number] {
  const bolt = {repeat: print, origin: [0, 0], widthCm, selvedgeCm, gapCm: 0, flaws: []} as const;
  const turns = turnsOf(piece, {...bolt, isOneWay: nap === 'one-way'});
  const extents = turns.map(({angle}) => {
    const {low, high} = turnedRing(piece.outline, angle);
    return [high[0] - low[0], high[1] - low[1]] as const;
  });
  return [Math.min(...extents.map(([x]) => x)), Math.min(...extents.map(([, y]) => y))];
}
