/** Rims of panels as edges, parted where what they are sewn to changes. */
import {minus, radians, turnBetween, type Point} from '../../model/geometry.js';

/** A turn of a free rim that parts two edges; steps of meshes around a curve turn by less. [rad] */
const corner = radians(35);

/** A closed rim. */
export interface Rim {
  /** The panel that it bounds, by number. */
  readonly panel: number;
  readonly sides: readonly number[];
  /** Where each side begins, in true size. */
  readonly points: readonly Point[];
}

/** Part of a rim. */
interface RimRun {
  readonly rim: number;
  /** The place of its first side in the rim, and how many it has. */
  readonly from: number;
  readonly count: number;
}

interface RimSeam {
  /** Numbers of runs. */
  readonly a: number;
  readonly b: number;
  readonly sameDirection: boolean;
}

/** Where a side lies. */
interface Place {
  readonly rim: number;
  readonly at: number;
}

export interface RimRuns {
  readonly runs: readonly RimRun[];
  readonly seams: readonly RimSeam[];
}

/** @param sewnTo of every side, the one that it is sewn to, or -1 @param begins of every side the vertex at which it begins */
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
  /** Sides that begin an edge. */
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
    // what parts one side of a seam parts the other
    for (const side of own) this.#cutAcross(side);
  }

  /** The side that one is sewn to, and where that lies. */
  across(side: number | undefined): (Place & {readonly side: number}) | undefined {
    const other = side === undefined ? -1 : (this.#sewnTo[side] ?? -1);
    const place = this.#places.get(other);
    return place && {...place, side: other};
  }

  cutsOf({sides}: Rim): number[] {
    return sides.flatMap((side, at) => (this.#cuts.has(side) ? [at] : []));
  }

  /** Whether two sides begin at one vertex. */
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

  /** Parts the other side of a seam, or of two, at the vertex at which a side begins. */
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

/** From cut to cut; a rim without two of them is parted in the middle, since an edge has two ends. */
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
