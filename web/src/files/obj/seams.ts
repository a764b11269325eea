/** Divides panel boundaries into edges where their seam partner changes. */
import {minus, radians, turnBetween, type Point} from '../../model/geometry/vectors.js';

/** Least turn of a free boundary between two edges; mesh segments along a curve turn less. [rad] */
const corner = radians(35);

/** A closed boundary. */
export interface Rim {
  /** Panel index. */
  readonly panel: number;
  readonly sides: readonly number[];
  /** Start of each side, in true size. */
  readonly points: readonly Point[];
}

/** A part of a boundary. */
interface RimRun {
  readonly rim: number;
  /** Index of the first side in the boundary, and number of sides. */
  readonly from: number;
  readonly count: number;
}

interface RimSeam {
  /** Indices of runs. */
  readonly a: number;
  readonly b: number;
  readonly sameDirection: boolean;
}

/** The position of a side. */
interface Place {
  readonly rim: number;
  readonly at: number;
}

export interface RimRuns {
  readonly runs: readonly RimRun[];
  readonly seams: readonly RimSeam[];
}

/**
 * Divides boundaries.
 * @param sewnTo for each side, the side it is sewn to, or -1
 * @param begins for each side, its start vertex
 */
export function runsOfRims(rims: readonly Rim[], sewnTo: Int32Array, begins: Int32Array): RimRuns {
  const places = new Map<number, Place>();
  rims.forEach(({sides}, rim) => {
    sides.forEach((side, at) => places.set(side, {rim, at}));
  });
  const joins = new Joins(rims, sewnTo, begins, places);
  const runs = rims.flatMap((rim, number) =>
    runsBetween(number, joins.cutsOf(rim), rim.sides.length),
  );
  return {runs, seams: seamsOf(runs, rims, joins)};
}

const turning = (k: number, count: number): number => ((k % count) + count) % count;

class Joins {
  readonly #rims: readonly Rim[];
  readonly #sewnTo: Int32Array;
  readonly #begins: Int32Array;
  readonly #places: ReadonlyMap<number, Place>;
  /** Sides at which an edge begins. */
  readonly #cuts = new Set<number>();

  constructor(
    rims: readonly Rim[],
    sewnTo: Int32Array,
    begins: Int32Array,
    places: ReadonlyMap<number, Place>,
  ) {
    this.#rims = rims;
    this.#sewnTo = sewnTo;
    this.#begins = begins;
    this.#places = places;
    const own = rims.flatMap((rim) => rim.sides.filter((_, at) => this.#isCut(rim, at)));
    for (const side of own) this.#cuts.add(side);
    // a division of one side of a seam also divides the other
    for (const side of own) this.#cutAcross(side);
  }

  /** The side that a side is sewn to, with its position. */
  across(side: number | undefined): (Place & {readonly side: number}) | undefined {
    const other = side === undefined ? -1 : (this.#sewnTo[side] ?? -1);
    const place = this.#places.get(other);
    return place && {...place, side: other};
  }

  cutsOf({sides}: Rim): number[] {
    return sides.flatMap((side, at) => (this.#cuts.has(side) ? [at] : []));
  }

  /** Returns whether two sides begin at the same vertex. */
  beginTogether(a: number, b: number): boolean {
    return this.#begins[a] === this.#begins[b];
  }

  #isCut({sides, points}: Rim, at: number): boolean {
    const count = sides.length;
    const [before, after] = [sides[turning(at - 1, count)], sides[at]];
    const [a, b] = [this.across(before), this.across(after)];
    if (Boolean(a) !== Boolean(b)) return true;
    if (a && b && (a.rim !== b.rim || !this.#goesOn(a, b) || a.side === after)) return true;
    const [p, q, r] = [-1, 0, 1].map((k) => points[turning(at + k, count)]);
    return p !== undefined && q !== undefined && r !== undefined
      ? Math.abs(turnBetween(minus(q, p), minus(r, q))) > corner
      : false;
  }

  #goesOn(a: Place, b: Place): boolean {
    const count = this.#rims[a.rim]?.sides.length ?? 1;
    return turning(a.at - 1, count) === b.at || turning(a.at + 1, count) === b.at;
  }

  /** Divides the other side of one or two seams at the start vertex of a side. */
  #cutAcross(side: number): void {
    const place = this.#places.get(side);
    const sides = place && this.#rims[place.rim]?.sides;
    if (!sides) return;
    for (const own of [side, sides[turning(place.at - 1, sides.length)]]) {
      const twin = this.across(own);
      const others = twin && this.#rims[twin.rim]?.sides;
      if (!others) continue;
      const next = others[turning(twin.at + 1, others.length)];
      if (this.beginTogether(twin.side, side)) this.#cuts.add(twin.side);
      else if (next !== undefined) this.#cuts.add(next);
    }
  }
}

/**
 * Runs from cut to cut. A boundary with fewer than two cuts is also cut in the middle, since an
 * edge has two ends.
 */
function runsBetween(rim: number, cuts: readonly number[], count: number): RimRun[] {
  const [first = 0, second] = cuts;
  const all = second === undefined ? [first, first + Math.floor(count / 2)] : cuts;
  return all.map((from, k) => ({
    ...{rim, from: from % count},
    count: (all[k + 1] ?? (all[0] ?? 0) + count) - from,
  }));
}

function seamsOf(runs: readonly RimRun[], rims: readonly Rim[], joins: Joins): RimSeam[] {
  const starts = new Map<number, number>();
  runs.forEach(({rim, from, count}, number) => {
    const sides = rims[rim]?.sides ?? [];
    for (let k = 0; k < count; k++) {
      const side = sides[(from + k) % sides.length];
      if (side !== undefined) starts.set(side, number);
    }
  });
  return runs.flatMap(({rim, from, count}, a) => {
    const sides = rims[rim]?.sides ?? [];
    const start = sides[from];
    const first = joins.across(start);
    const b = first && starts.get(first.side);
    if (start === undefined || !first || b === undefined) return [];
    if (b < a || runs[b]?.count !== count) return [];
    return [{a, b, sameDirection: joins.beginTogether(first.side, start)}];
  });
}
