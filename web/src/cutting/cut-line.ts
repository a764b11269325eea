/** The cut line of a piece: its sewn outline with the allowances. Lengths in cm. */
import {Clipper, FillRule} from 'clipper2-ts';

import {dot, minus, unit, type Point} from '../model/geometry/vectors.js';
import {isInside, signedArea} from '../model/geometry/polyline.js';
import type {AllowanceRule} from './allowance-rule.js';
import {allowancesOf, type Allowances} from './allowances.js';
import {bandOf, cornerFabric, longer, turnedCorner, type Band, type Corner} from './corners.js';
import {allowedLoops, garmentEdges, type EdgeKey, type GarmentEdges} from './garment-edges.js';
import {drained} from '../model/base/drained.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import {readable} from '../model/garment/piece-names.js';
import type {SolveResult} from '../model/result/result.js';

/** Decimal places of a centimetre in clipping. */
const precision = 5;
/** Least area that is no rounding error. [cm2] */
const leastArea = 0.01;
/** Cosine of a turn sharper than any corner. */
const spike = -0.98;
/** Points of a cut line this close to the line between their neighbours are removed. */
const straight = 1e-4;

interface AllowedEdge {
  readonly key: EdgeKey;
  /** From start to end, with the piece to the left. */
  readonly points: readonly Point[];
}

type Polygon = readonly Point[];

const paths = (polygons: readonly Polygon[]) =>
  polygons.map((polygon) => polygon.map(([x, y]) => ({x, y})));

const polygons = (found: readonly (readonly {x: number; y: number}[])[]): readonly Polygon[] =>
  found.map((path) => path.map(({x, y}): Point => [x, y]));

const anticlockwise = (polygon: Polygon): Polygon =>
  signedArea(polygon) < 0 ? [...polygon].reverse() : polygon;

const union = (all: readonly Polygon[]): readonly Polygon[] =>
  polygons(Clipper.unionD(paths(all), [], FillRule.NonZero, precision));

const without = (all: readonly Polygon[], less: readonly Polygon[]): readonly Polygon[] =>
  polygons(
    Clipper.differenceD(paths(all), paths(less.map(anticlockwise)), FillRule.NonZero, precision),
  );

/** The corner at the start of an edge. */
function cornerBefore(
  edge: AllowedEdge,
  before: AllowedEdge,
  widths: Allowances['widths'],
): Corner | undefined {
  const [p, q] = before.points.slice(-2);
  const [r, s] = edge.points;
  if (!p || !q || !r || !s) return undefined;
  return {
    ...{at: r, before: unit(minus(q, p)), after: unit(minus(s, r))},
    widthBefore: widths.get(before.key) ?? 0,
    widthAfter: widths.get(edge.key) ?? 0,
  };
}

/** The whole allowance of one closed line. */
function fabricBeyond(
  loop: readonly AllowedEdge[],
  {widths, corners}: Allowances,
): readonly Polygon[] {
  const bands = loop.map(({key, points}): Band => bandOf(points, widths.get(key) ?? 0));
  const fabric = bands.map((band) => [...band.fabric]);
  const less = bands.map((): Polygon[] => []);
  const fill: Polygon[] = [];
  for (const [k, edge] of loop.entries()) {
    const last = (k + loop.length - 1) % loop.length;
    const corner = loop[last] && cornerBefore(edge, loop[last], widths);
    if (!corner) continue;
    const {turned: own, square} = corners.get(edge.key) ?? {};
    const [hem, other] = own === 'before' ? [last, k] : [k, last];
    const otherCut = bands[other]?.cut ?? [];
    const turned =
      own && turnedCorner(corner, own, other === k ? otherCut : [...otherCut].reverse());
    if (turned) {
      const beside = own === 'before' ? 'after' : 'before';
      fabric[hem]?.push(turned.more, longer(corner, beside, square?.[beside] ?? 0));
      less[hem]?.push(turned.less);
      fill.push(turned.beside);
    } else fill.push(...cornerFabric(corner, square));
  }
  return [
    ...fabric.flatMap((polygons, k) => {
      const all = polygons.filter((polygon) => polygon.length > 2);
      const off = less[k] ?? [];
      return off.length > 0 ? without(all.map(anticlockwise), off) : all;
    }),
    ...fill,
  ].filter((polygon) => polygon.length > 2);
}

/** Removes points where a line reverses, which rounding leaves at touching polygons. */
function withoutSpikes(line: Polygon): Polygon {
  const kept = line.filter((p, k) => {
    const [before = p, after = p] = [line.at(k - 1), line[(k + 1) % line.length]];
    return dot(unit(minus(p, before)), unit(minus(after, p))) > spike;
  });
  return kept.length < line.length ? withoutSpikes(kept) : kept;
}

/**
 * The cut lines outside an outline and inside its holes, without self-intersections; small holes
 * close.
 * @param loops edges of the outline counter-clockwise, then of the holes clockwise
 */
export function cutLine(
  loops: readonly (readonly AllowedEdge[])[],
  allowances: Allowances,
): readonly Polygon[] {
  const lines = loops.map((loop) => loop.flatMap(({points}) => points.slice(0, -1)));
  const fabric = loops.flatMap((loop) => fabricBeyond(loop, allowances)).map(anticlockwise);
  if (fabric.length === 0) return lines;
  const [, ...holes] = lines;
  return union([...lines, ...fabric]).flatMap((line) => {
    const area = signedArea(line);
    const kept =
      polygons([Clipper.simplifyPathD(paths([withoutSpikes(line)])[0] ?? [], straight, true)])[0] ??
      [];
    // a gap closed off by allowances is no hole
    const isHole = area < 0 && holes.some((hole) => line.some((p) => isInside(hole, p)));
    return Math.abs(area) > leastArea && (area > 0 || isHole) ? [kept] : [];
  });
}

/** Sewn and cut lines of a garment's pieces, from its file and an allowance rule. Lengths in cm. */
interface CutLines {
  /** Indexed by piece, like all following fields. */
  readonly marks: readonly PanelMarks[];
  readonly garment: GarmentEdges;
  readonly allowances: Allowances;
  readonly loops: readonly ReturnType<typeof allowedLoops>[];
  /** In coordinates of the shape: the outline counter-clockwise, then the holes clockwise. */
  readonly cut: readonly (readonly (readonly Point[])[])[];
}

/**
 * Computes the lines in steps of about ten milliseconds.
 * @param panels marks from the garment file, by piece name
 */
export function* cutLineSteps(
  result: Pick<SolveResult, 'pieces' | 'seams'>,
  panels: ReadonlyMap<string, PanelMarks>,
  rule: AllowanceRule,
): Generator<undefined, CutLines> {
  const marks = result.pieces.map(({name}) => panels.get(name) ?? {label: readable(name)});
  const garment = garmentEdges(result, (name) => panels.get(name)?.drafted);
  yield;
  const allowances = allowancesOf(garment, result.pieces, marks, rule);
  yield;
  const loops = result.pieces.map((_, k) => allowedLoops(garment, k));
  const cut: (readonly (readonly Point[])[])[] = [];
  for (const all of loops) {
    yield;
    cut.push(cutLine(all, allowances));
  }
  return {marks, garment, allowances, loops, cut};
}

/** Computes the lines in one call. */
export const cutLinesOf = (...asked: Parameters<typeof cutLineSteps>): CutLines =>
  drained(cutLineSteps(...asked));
