/**
 * Features of a pair of edges that depend on the beliefs about all others: the seams beside it, its
 * joints and its mirror image.
 */
import {near, type Surroundings} from './features.js';
import type {Table} from './matching.js';

/** Beliefs about a garment's seams: a sewn edge has 1 for its seam and 0 for all other pairs. */
export interface Beliefs {
  readonly likelihoods: Table;
  /** For each edge, the likelihood that it stays open. */
  readonly open: Float64Array;
  /** For each edge, its probable partners, the likeliest first. */
  readonly likely: readonly Int32Array[];
  /** For each two pieces, row by row, the expected number of seams between them. */
  readonly shared: Table;
  /** Share of the edges with a confirmed seam. */
  readonly confirmed: number;
}

/** Likelihood below which a partner is ignored. */
const least = 0.02;

export function beliefsOf(
  {garment: {edges, pieces}}: Surroundings,
  likelihoods: Table,
  confirmed: number,
): Beliefs {
  const {size, values} = likelihoods;
  const shared: Table = {size: pieces.length, values: new Float64Array(pieces.length ** 2)};
  const open = new Float64Array(size);
  const likely = edges.map(({at}, i) => {
    const row = values.subarray(i * size, (i + 1) * size);
    let sum = 0;
    const found: number[] = [];
    for (const [j, p] of row.entries()) {
      if (p === 0) continue;
      sum += p;
      const place = at.piece * pieces.length + (edges[j]?.at.piece ?? 0);
      shared.values[place] = (shared.values[place] ?? 0) + p;
      if (p > least) found.push(j);
    }
    open[i] = Math.max(0, 1 - sum);
    found.sort((a, b) => (row[b] ?? 0) - (row[a] ?? 0));
    return Int32Array.from(found);
  });
  return {likelihoods, open, likely, shared, confirmed};
}

/**
 * Weight of a joint: 1 if its angles add up to `whole`, falling off within about 20 degrees. [rad]
 */
const closes = (angle: number, whole: number): number => near(angle - whole, 0.3);

/** One end of a seam: the edges beside it, and the angles of both pieces there. */
interface SeamEnd {
  /** Edges beside the seam's first and second edge. */
  readonly a: number;
  readonly b: number;
  readonly angles: readonly [number, number];
  /** `a` begins at this end, so its partner ends here. */
  readonly begins: boolean;
}

/** Scores one end of a seam for each kind of joint that may close there. */
function closings({garment: {edges}}: Surroundings, beliefs: Beliefs, end: SeamEnd): number[] {
  const {open, likely, likelihoods} = beliefs;
  const {a, b, angles, begins} = end;
  const angle = angles[0] + angles[1];
  const p = (i: number, j: number): number => likelihoods.values[i * likelihoods.size + j] ?? 0;
  /**
   * Next edge of a third piece at this joint, seen from a partner of `a`; `back` does the same for
   * `b`.
   */
  const onwards = (k: number): number => (begins ? edges[k]?.next : edges[k]?.previous) ?? k;
  const back = (l: number): number => (begins ? edges[l]?.previous : edges[l]?.next) ?? l;
  const angleAt = (k: number): number => edges[begins ? onwards(k) : k]?.angle ?? 0;
  const angleBack = (l: number): number => edges[begins ? l : back(l)]?.angle ?? 0;
  const openA = open[a] ?? 0;
  const openB = open[b] ?? 0;
  let [three, threeWhole, four, fourWhole, border] = [0, 0, 0, 0, 0];
  for (const k of likely[a] ?? []) {
    const sewn = p(a, k);
    const l = onwards(k);
    const sum = angle + angleAt(k);
    const other = p(b, l);
    const closed = other > least ? sewn * other : 0;
    three += closed;
    threeWhole += closed * closes(sum, 2 * Math.PI);
    border += sewn * openB * (open[l] ?? 0) * closes(sum, Math.PI);
    for (const m of likely[b] ?? []) {
      const all = sewn * p(b, m) * p(l, back(m));
      if (l === m || all === 0) continue;
      four += all;
      fourWhole += all * closes(sum + angleBack(m), 2 * Math.PI);
    }
  }
  for (const m of likely[b] ?? []) {
    border += p(b, m) * openA * (open[back(m)] ?? 0) * closes(angle + angleBack(m), Math.PI);
  }
  const free = openA * openB;
  const straight = closes(angles[0], Math.PI) * closes(angles[1], Math.PI);
  return [
    p(a, b),
    p(a, b) * straight,
    free * straight,
    three,
    threeWhole,
    Math.min(1, four),
    Math.min(1, fourWhole),
    border,
    free,
    free * closes(angle, Math.PI),
    (1 - openA) * (1 - openB),
    Math.abs(openA - openB),
  ];
}

/** Number of scores in `closings`. */
const ways = 12;
const none: readonly number[] = Array.from({length: ways}, () => 0);

const logit = (p: number): number =>
  Math.max(-8, Math.min(8, Math.log((p + 1e-9) / (1 - p + 1e-9))));

/** Returns the belief-dependent features of edges `i` and `j`; symmetric in `i` and `j`. */
export function jointFeatures(
  surroundings: Surroundings,
  beliefs: Beliefs,
  i: number,
  j: number,
): number[] {
  const {garment, images} = surroundings;
  const {edges, pieces} = garment;
  const {open, likelihoods, shared} = beliefs;
  const {size, values} = likelihoods;
  const p = (k: number, l: number): number => values[k * size + l] ?? 0;
  const [a, b] = [edges[i], edges[j]];
  if (!a || !b) return [];
  const own = p(i, j);
  const best = (k: number, not: number): number => {
    const [first = not, second = not] = beliefs.likely[k] ?? [];
    return first === not ? (second === not ? 0 : p(k, second)) : p(k, first);
  };
  const [rivalA, rivalB] = [best(i, j), best(j, i)];
  const [openA, openB] = [open[i] ?? 0, open[j] ?? 0];
  const [ia, ib] = [images[i] ?? -1, images[j] ?? -1];
  const hasImage = ia >= 0 && ib >= 0;
  const isOwnImage = hasImage && ((ia === i && ib === j) || (ia === j && ib === i));
  const image = hasImage && !isOwnImage ? p(ia, ib) : 0;
  const isApex = [a.next === j, a.previous === j];
  const afterA = edges[a.next]?.angle ?? 0;
  const afterB = edges[b.next]?.angle ?? 0;
  const first = isApex[0]
    ? none
    : closings(surroundings, beliefs, {
        a: a.next,
        b: b.previous,
        angles: [afterA, b.angle],
        begins: true,
      });
  const last = isApex[1]
    ? none
    : closings(surroundings, beliefs, {
        a: a.previous,
        b: b.next,
        angles: [a.angle, afterB],
        begins: false,
      });
  const together =
    (shared.values[a.at.piece * pieces.length + b.at.piece] ?? 0) /
    (a.at.piece === b.at.piece ? 2 : 1);
  return [
    logit(own),
    Math.min(rivalA, rivalB),
    Math.max(rivalA, rivalB),
    Math.min(openA, openB),
    Math.max(openA, openB),
    image,
    Number(hasImage && !isOwnImage),
    Number(isOwnImage),
    Math.min(3, Math.max(0, together - own)),
    Number(a.next === b.previous) + Number(a.previous === b.next),
    beliefs.confirmed,
    ...first.map((one, k) => one + (last[k] ?? 0)),
    ...first.map((one, k) => Math.max(one, last[k] ?? 0)),
  ];
}
