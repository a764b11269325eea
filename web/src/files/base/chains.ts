/**
 * Joins lines by their ends: to closed lines, to open chains, and to the outlines of nets, in which
 * more than two lines meet at a point.
 */
import {distance, type Point} from '../../model/geometry/vectors.js';
import {lengthOf} from '../../model/geometry/polyline.js';
import {
  pointsOfChain,
  sortedByFirst,
  startOf,
  tipOf,
  turnedStretch,
  type Chain,
  type OpenLine,
  type Stretch,
} from './chain.js';
import {Ends} from './ends.js';
import {outlinesOfNet} from './nets.js';

/** Share of the greatest gap up to which ends coincide. */
const exact = 1 / 30;

/**
 * Joins lines.
 * @param reach greatest gap between ends that meet
 */
export function chainsOf(lines: readonly OpenLine[], reach: number): Chain[] {
  const single = lines.map(({points, run}, id): Chain => ({
    stretches: [{id, points, ...(run && {run})}],
    isClosed: false,
    gap: {width: 0, at: points[0] ?? [0, 0]},
  }));
  const joined = withoutCopies(passed(single, reach * exact, true), reach);
  const closed = joined.filter(({isClosed}) => isClosed);
  const open = joined.filter(({isClosed}) => !isClosed);
  const greedy = passed(open, reach, false);
  const rest = greedy.filter(({isClosed}) => !isClosed);
  if (rest.length === 0) return inOrder([...closed, ...greedy]);
  const {outlines, others, isNet} = outlinesOfNet(open, reach);
  if (!isNet) return inOrder([...closed, ...greedy]);
  return inOrder([...closed, ...outlines, ...passed(others, reach, false)]);
}

const inOrder = (chains: readonly Chain[]): Chain[] =>
  sortedByFirst(chains, ({stretches}) => stretches.map(({id}) => id));

const turned = (chain: Chain): Chain => ({
  ...chain,
  stretches: chain.stretches.map(turnedStretch).reverse(),
});

/**
 * Joins chains in their order, each with the nearest.
 * @param isClear true if only ends without a third end at the same place are joined
 */
function passed(chains: readonly Chain[], reach: number, isClear: boolean): Chain[] {
  const ends = new Ends(
    chains.map((chain) => (chain.isClosed ? [] : [startOf(chain), tipOf(chain)])),
    reach,
  );
  return chains.flatMap((first, k) => {
    if (!ends.take(k)) return [];
    if (first.isClosed) return [first];
    const chain = new GrowingChain(first, reach);
    for (let turn = 0; turn < 2 && chain.isOpen(); turn++) {
      while (!(isClear && ends.countAt(chain.tip, 3) !== 2) && !chain.close()) {
        const next = ends.next(chain.tip);
        const other = next && chains[next.line];
        if (!other) break;
        chain.add(next.isTurned ? turned(other) : other);
      }
      if (chain.isOpen()) chain.turn();
    }
    return [chain.result()];
  });
}

/** A stretch of a growing chain. */
interface Part {
  readonly stretch: Stretch;
  readonly isTurned: boolean;
}

const unturned = (stretch: Stretch): Part => ({stretch, isTurned: false});

/** A chain while lines are added at its tip. */
class GrowingChain {
  readonly #reach: number;
  #isClosed = false;
  /** Stretches in order, which are turned only once the chain is whole. */
  #parts: Part[];
  #gap: Chain['gap'];
  #length: number;

  constructor({stretches, gap}: Chain, reach: number) {
    this.#reach = reach;
    this.#parts = stretches.map(unturned);
    this.#gap = gap;
    this.#length = wayOf(stretches);
  }

  get tip(): Point {
    const last = this.#parts.at(-1);
    return last?.stretch.points.at(last.isTurned ? 0 : -1) ?? [0, 0];
  }

  get #start(): Point {
    const [first] = this.#parts;
    return first?.stretch.points.at(first.isTurned ? -1 : 0) ?? [0, 0];
  }

  add({stretches, gap}: Chain): void {
    const [first] = stretches;
    this.#widen({width: distance(this.tip, first?.points[0] ?? this.tip), at: this.tip});
    this.#widen(gap);
    for (const one of stretches) this.#parts.push(unturned(one));
    this.#length += wayOf(stretches);
  }

  /** Closes the chain if its ends meet and it is longer than the gap between them. */
  close(): boolean {
    const width = distance(this.#start, this.tip);
    const [only] = this.#parts;
    const isLine = this.#parts.length === 1 && (only?.stretch.points.length ?? 0) < 4;
    if (width > this.#reach || this.#length <= 4 * this.#reach || isLine) return false;
    this.#widen({width, at: this.tip});
    this.#isClosed = true;
    return true;
  }

  isOpen(): boolean {
    return !this.#isClosed;
  }

  turn(): void {
    this.#parts.reverse();
    this.#parts = this.#parts.map(({stretch, isTurned}) => ({stretch, isTurned: !isTurned}));
  }

  result(): Chain {
    const stretches = this.#parts.map(({stretch, isTurned}) =>
      isTurned ? turnedStretch(stretch) : stretch,
    );
    return {stretches, isClosed: this.#isClosed, gap: this.#gap};
  }

  #widen(gap: Chain['gap']): void {
    if (gap.width > this.#gap.width) this.#gap = gap;
  }
}

const wayOf = (stretches: readonly Stretch[]): number =>
  stretches.reduce((sum, {points}) => sum + lengthOf(points), 0);

/** Removes lines that repeat others from end to end. */
function withoutCopies(chains: readonly Chain[], reach: number): Chain[] {
  const seen = new Set<string>();
  return chains.filter((chain) => {
    if (chain.isClosed) return true;
    const points = pointsOfChain(chain);
    const [from, to, half] = [
      startOf(chain),
      tipOf(chain),
      points[points.length >> 1] ?? startOf(chain),
    ];
    const place = ([x, y]: Point): string => `${Math.round(x / reach)} ${Math.round(y / reach)}`;
    const length = Math.round(lengthOf(points) / (10 * reach));
    const key = [[place(from), place(to)].sort().join(' '), place(half), length].join(' ');
    if (seen.has(key)) return false;
    seen.add(key);
    return true;
  });
}
