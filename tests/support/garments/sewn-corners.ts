/**
 * Corners that meet at the ends of a garment's seams, and the lines that continue across the seams.
 */
import {velocity} from '@samples/drafting/curves.js';
import {
  findEdge,
  type CornerName,
  type EdgeName,
  type Garment,
  type Panel,
} from '@samples/drafting/panel.js';

/** A corner of a panel, by the number of the edge that starts there. */
interface Corner {
  readonly panel: Panel;
  readonly at: number;
}

const keyOf = ({panel, at}: Corner): string => `${panel.name}:${at}`;
const edgeAfter = ({panel, at}: Corner) => panel.edges[at];
const edgeBefore = ({panel, at}: Corner) => panel.edges.at(at - 1);

/** 'front: shoulder left / neckline', for messages. */
export const called = (corner: Corner): string =>
  `${corner.panel.name}: ${edgeBefore(corner)?.name ?? ''} / ${edgeAfter(corner)?.name ?? ''}`;

export function isCorner(corner: Corner, [panel, one, other]: CornerName): boolean {
  const edges = [edgeBefore(corner)?.name, edgeAfter(corner)?.name];
  return (
    corner.panel.name === panel && one !== other && edges.includes(one) && edges.includes(other)
  );
}

/** The angle inside the panel. [degrees] */
export function cornerAngle(corner: Corner): number {
  const before = edgeBefore(corner);
  const after = edgeAfter(corner);
  if (!before || !after) throw new Error('no such corner');
  const [bx, by] = velocity(before.curve, 1);
  const [ax, ay] = velocity(after.curve, 0);
  return 180 - (Math.atan2(bx * ay - by * ax, bx * ax + by * ay) * 180) / Math.PI;
}

/** The corners where an edge starts and ends. */
function endsOf(garment: Garment, edge: EdgeName): readonly [Corner, Corner] {
  const {index} = findEdge(garment, edge);
  const panel = garment.panels.find(({name}) => name === edge[0]);
  if (!panel) throw new Error(`no panel '${edge[0]}'`);
  return [
    {panel, at: index},
    {panel, at: (index + 1) % panel.edges.length},
  ];
}

/** An edge's name in maps. */
const joined = (panel: string, edge = ''): string => `${panel}:${edge}`;

/** Maps each sewn edge, as panel and edge, to its partner. */
function partners({seams}: Garment): ReadonlyMap<string, EdgeName> {
  return new Map(
    seams.flatMap(({a, b}) => [[joined(...a), b] as const, [joined(...b), a] as const]),
  );
}

/**
 * One end of a seam: the two corners that meet there, and the panels' next edges beyond the seam.
 */
interface SeamEnd {
  readonly seam: string;
  readonly corners: readonly [Corner, Corner];
  readonly beyond: readonly [string, string];
}

/** The ends of every seam except the tips of darts, where a panel meets itself in one corner. */
function seamEnds(garment: Garment): SeamEnd[] {
  return garment.seams.flatMap(({name, a, b}) => {
    const [a0, a1] = endsOf(garment, a);
    const [b0, b1] = endsOf(garment, b);
    const ends = [
      {seam: name, corners: [a0, b1], beyond: [edgeBefore(a0)?.name, edgeAfter(b1)?.name]},
      {seam: name, corners: [b0, a1], beyond: [edgeBefore(b0)?.name, edgeAfter(a1)?.name]},
    ] as const;
    return ends
      .filter(({corners: [p, q]}) => keyOf(p) !== keyOf(q))
      .map(({beyond: [p = '', q = ''], ...end}) => ({...end, beyond: [p, q] as const}));
  });
}

/** The angle that two panels fill together at a seam's end: 180 for a straight line. [degrees] */
export const anglesAt = ({corners: [p, q]}: SeamEnd): number => cornerAngle(p) + cornerAngle(q);

/**
 * The seam ends across which a line continues. Both panels end there unsewn (a hem, a neckline), or
 * both are sewn to the same panel (a sleeve, a waistband), or to two panels that a seam joins at
 * that very point. Where only three panels meet, one seam ends at the line of the other two: the
 * one whose angle is nearest to straight.
 */
export function crossedEnds(garment: Garment): SeamEnd[] {
  const partner = partners(garment);
  const point = sewnPoints(garment);
  const joins = (c: string, d: string, where: number): boolean =>
    garment.seams.some(
      ({a, b}) =>
        ((a[0] === c && b[0] === d) || (a[0] === d && b[0] === c)) &&
        endsOf(garment, a).some((corner) => point(corner) === where),
    );
  const ends = seamEnds(garment).filter(({corners: [p, q], beyond: [pEdge, qEdge]}) => {
    const c = partner.get(joined(p.panel.name, pEdge))?.[0];
    const d = partner.get(joined(q.panel.name, qEdge))?.[0];
    if (!c || !d) return !c && !d;
    const own = [p.panel.name, q.panel.name];
    // sewn to each other, or a dart beside the seam: no line crosses it
    if (own.includes(c) || own.includes(d)) return false;
    return c === d || joins(c, d, point(p));
  });
  const threefold = closedPoints(garment).flatMap((corners) => {
    const [first] = corners;
    return first && corners.length === 3 ? [point(first)] : [];
  });
  const isThreefold = ({corners: [p]}: SeamEnd): boolean => threefold.includes(point(p));
  const off = (end: SeamEnd): number => Math.abs(anglesAt(end) - 180);
  return [
    ...ends.filter((end) => !isThreefold(end)),
    ...threefold.flatMap((where) =>
      ends
        .filter(({corners: [p]}) => point(p) === where)
        .sort((one, other) => off(one) - off(other))
        .slice(0, 1),
    ),
  ];
}

/** A number for each corner; corners that are sewn together share it. */
function sewnPoints(garment: Garment): (corner: Corner) => number {
  const corners = garment.panels.flatMap((panel) => panel.edges.map((_, at) => ({panel, at})));
  const owner = new Map(corners.map((corner) => [keyOf(corner), keyOf(corner)]));
  const find = (key: string): string => {
    const up = owner.get(key) ?? key;
    return up === key ? key : find(up);
  };
  for (const {a, b} of garment.seams) {
    const [a0, a1] = endsOf(garment, a);
    const [b0, b1] = endsOf(garment, b);
    owner.set(find(keyOf(a0)), find(keyOf(b1)));
    owner.set(find(keyOf(a1)), find(keyOf(b0)));
  }
  const roots = [...new Set([...owner.keys()].map(find))];
  const numbers = new Map([...owner.keys()].map((key) => [key, roots.indexOf(find(key))]));
  return (corner) => numbers.get(keyOf(corner)) ?? -1;
}

/** The corners that meet at each point surrounded by fabric. */
export function closedPoints(garment: Garment): Corner[][] {
  const sewn = partners(garment);
  const point = sewnPoints(garment);
  const groups = new Map<number, Corner[]>();
  for (const panel of garment.panels) {
    panel.edges.forEach((_, at) => {
      const corner = {panel, at};
      groups.set(point(corner), [...(groups.get(point(corner)) ?? []), corner]);
    });
  }
  return [...groups.values()].filter((group) =>
    group.every((corner) =>
      [edgeBefore(corner), edgeAfter(corner)].every((edge) =>
        sewn.has(joined(corner.panel.name, edge?.name)),
      ),
    ),
  );
}
