/**
 * Finds the outlines of nets of lines: outline and construction lines that meet in ends and T
 * junctions. The outline is the outer face of each part of the planar graph that one cut at a point
 * cannot divide.
 */
import {angleOf, distance, minus, type Point} from '../../model/geometry/vectors.js';
import {startOf, tipOf, turnedStretch, pointsOfChain, type Chain, type Stretch} from './chain.js';
import {gridOfPoints, PointGrid, pointsOnLine} from './point-grid.js';

interface NetEdge {
  readonly from: number;
  readonly to: number;
  readonly stretches: readonly Stretch[];
}

interface NetParts {
  readonly outlines: readonly Chain[];
  /** Lines inside outlines, and lines that lead nowhere. */
  readonly others: readonly Chain[];
  /** True if more than two lines meet anywhere. */
  readonly isNet: boolean;
}

/** Greatest number of lines of a net; larger ones are drawings of something else. */
const mostLines = 2000;

/** Greatest number of parts into which those lines divide each other. */
const mostParts = 4000;

/**
 * Divides open chains into outlines and other lines.
 * @param reach greatest gap between ends that meet
 */
export function outlinesOfNet(chains: readonly Chain[], reach: number): NetParts {
  const none: NetParts = {outlines: [], others: chains, isNet: false};
  if (chains.length > mostLines) return none;
  const nodes = new Nodes(reach);
  const ends = chains.flatMap((chain) => [{at: startOf(chain)}, {at: tipOf(chain)}]);
  const grid = gridOfPoints(ends, reach);
  const split: Chain[] = [];
  for (const chain of chains) {
    for (const part of splitAtEnds(chain, grid, reach)) split.push(part);
    if (split.length > mostParts) return none;
  }
  const edges = split.map((chain): NetEdge => ({
    from: nodes.at(startOf(chain)),
    to: nodes.at(tipOf(chain)),
    stretches: chain.stretches,
  }));
  const degrees = edges
    .flatMap(({from, to}) => [from, to])
    .reduce(
      (counts, node) => counts.set(node, (counts.get(node) ?? 0) + 1),
      new Map<number, number>(),
    );
  const isNet = [...degrees.values()].some((degree) => degree > 2);
  if (!isNet) return none;
  const used = new Set<NetEdge>();
  const outlines = blocksOf(edges).flatMap((block): Chain[] => {
    const outer = outerFace(block);
    for (const edge of outer.keys()) used.add(edge);
    const stretches = [...outer].flatMap(([edge, isTurned]) =>
      isTurned ? edge.stretches.map(turnedStretch).reverse() : edge.stretches,
    );
    return stretches.length > 0
      ? [{stretches, isClosed: true, gap: {width: 0, at: stretches[0]?.points[0] ?? [0, 0]}}]
      : [];
  });
  const others = split.filter((_, k) => {
    const edge = edges[k];
    return !edge || !used.has(edge);
  });
  return {outlines, others, isNet};
}

/** Assigns one number to all ends at one place. */
class Nodes {
  readonly #reach: number;
  readonly #grid: PointGrid<{readonly at: Point; readonly node: number}>;
  #count = 0;

  constructor(reach: number) {
    this.#reach = reach;
    this.#grid = new PointGrid(reach);
  }

  at(point: Point): number {
    for (const cell of this.#grid.around(point)) {
      const found = cell.find(({at}) => distance(at, point) <= this.#reach);
      if (found) return found.node;
    }
    const node = this.#count++;
    this.#grid.add(point, {at: point, node});
    return node;
  }
}

/** The parts of a chain between the places where ends of others meet it. */
function splitAtEnds(chain: Chain, ends: PointGrid<{readonly at: Point}>, reach: number): Chain[] {
  const line = pointsOfChain(chain);
  const isInner = (p: Point): boolean =>
    distance(p, startOf(chain)) > reach && distance(p, tipOf(chain)) > reach;
  const cuts = [...pointsOnLine(line, false, ends, reach)]
    .filter(([end]) => isInner(end.at))
    .map(([, {at, step}]) => ({at, step, along: distance(line[step] ?? at, at)}))
    .sort((a, b) => a.step - b.step || a.along - b.along);
  if (cuts.length === 0) return [chain];
  const id = chain.stretches[0]?.id ?? 0;
  const stops = [...cuts, {at: tipOf(chain), step: line.length - 2}];
  let [from, next] = [startOf(chain), 1];
  return stops.flatMap(({at, step}): Chain[] => {
    const points = [from, ...line.slice(next, step + 1), at].filter(
      (p, k, all) => k === 0 || distance(p, all[k - 1] ?? p) > 0,
    );
    [from, next] = [at, step + 1];
    return points.length > 1
      ? [{stretches: [{id, points}], isClosed: false, gap: {width: 0, at: from}}]
      : [];
  });
}

/** The edges of each part that stays whole when any point is cut out; excludes single lines. */
function blocksOf(edges: readonly NetEdge[]): NetEdge[][] {
  const around = new Map<number, {readonly edge: number; readonly to: number}[]>();
  edges.forEach(({from, to}, edge) => {
    if (from === to) return;
    around.set(from, [...(around.get(from) ?? []), {edge, to}]);
    around.set(to, [...(around.get(to) ?? []), {edge, to: from}]);
  });
  const depth = new Map<number, number>();
  const low = new Map<number, number>();
  const blocks: NetEdge[][] = edges.flatMap((edge) => (edge.from === edge.to ? [[edge]] : []));
  const pending: number[] = [];
  for (const root of around.keys()) {
    if (depth.has(root)) continue;
    depth.set(root, 0);
    low.set(root, 0);
    const path = [{node: root, through: -1, next: 0}];
    for (let top = path.at(-1); top; top = path.at(-1)) {
      const step = around.get(top.node)?.[top.next++];
      if (!step) {
        path.pop();
        const above = path.at(-1);
        if (!above) continue;
        low.set(above.node, Math.min(low.get(above.node) ?? 0, low.get(top.node) ?? 0));
        if ((low.get(top.node) ?? 0) < (depth.get(above.node) ?? 0)) continue;
        const block = pending.splice(pending.lastIndexOf(top.through));
        if (block.length > 1) blocks.push(block.flatMap((k) => edges[k] ?? []));
        continue;
      }
      if (step.edge === top.through) continue;
      const known = depth.get(step.to);
      if (known === undefined) {
        depth.set(step.to, path.length);
        low.set(step.to, path.length);
        pending.push(step.edge);
        path.push({node: step.to, through: step.edge, next: 0});
      } else if (known < (depth.get(top.node) ?? 0)) {
        pending.push(step.edge);
        low.set(top.node, Math.min(low.get(top.node) ?? 0, known));
      }
    }
  }
  return blocks;
}

const pointsOfEdge = ({stretches}: NetEdge): readonly Point[] =>
  pointsOfChain({stretches, isClosed: false, gap: {width: 0, at: [0, 0]}});

/** The edges around a block in order, and whether each is turned. */
function outerFace(block: readonly NetEdge[]): Map<NetEdge, boolean> {
  const lines = new Map(block.map((edge) => [edge, pointsOfEdge(edge)]));
  const heading = (edge: NetEdge, isTurned: boolean): number => {
    const line = lines.get(edge) ?? [];
    const points = isTurned ? [...line].reverse() : line;
    const start = points[0] ?? [0, 0];
    return angleOf(minus(points.find((p) => distance(p, start) > 0) ?? start, start));
  };
  const [first] = [...lines]
    .flatMap(([edge, line]) => line.map((at, k) => ({edge, at, k, line})))
    .sort((a, b) => a.at[1] - b.at[1] || b.at[0] - a.at[0]);
  const face = new Map<NetEdge, boolean>();
  if (!first) return face;
  const begin = firstStep(first, block, heading);
  const startNode = begin.isTurned ? begin.edge.to : begin.edge.from;
  // where edges leave a node in one direction, the way may circle beside its start
  let {edge, isTurned} = begin;
  for (let step = 0; step < 2 * block.length; step++) {
    face.set(edge, isTurned);
    const node = isTurned ? edge.from : edge.to;
    if (node === startNode) return face;
    const back = heading(edge, !isTurned);
    const next = leavingAt(node, block)
      .filter((one) => one.edge !== edge)
      .map((one) => ({...one, turn: turnFrom(back, heading(one.edge, one.isTurned))}))
      .sort((a, b) => a.turn - b.turn)[0];
    if (!next) return face;
    ({edge, isTurned} = next);
  }
  return face;
}

interface Step {
  readonly edge: NetEdge;
  readonly isTurned: boolean;
}

const leavingAt = (node: number, block: readonly NetEdge[]): Step[] =>
  block.flatMap((edge) => [
    ...(edge.from === node ? [{edge, isTurned: false}] : []),
    ...(edge.to === node ? [{edge, isTurned: true}] : []),
  ]);

/** The counter-clockwise angle from one direction to another, positive. [rad] */
const turnFrom = (from: number, to: number): number => {
  const turn = (to - from) % (2 * Math.PI);
  return turn > 0 ? turn : turn + 2 * Math.PI;
};

/** The edge and direction in which the lowest point is passed with the block on the left. */
function firstStep(
  {edge, at, k, line}: {edge: NetEdge; at: Point; k: number; line: readonly Point[]},
  block: readonly NetEdge[],
  heading: (edge: NetEdge, isTurned: boolean) => number,
): Step {
  const down = -Math.PI / 2;
  const [before, after] = [line[k - 1], line[k + 1]];
  if (before && after) {
    const [ahead, back] = [after, before].map((to) => turnFrom(down, angleOf(minus(to, at))));
    return {edge, isTurned: (back ?? 0) < (ahead ?? 0)};
  }
  const node = k === 0 ? edge.from : edge.to;
  const [step] = leavingAt(node, block)
    .map((one) => ({...one, turn: turnFrom(down, heading(one.edge, one.isTurned))}))
    .sort((a, b) => a.turn - b.turn);
  return step ?? {edge, isTurned: false};
}
