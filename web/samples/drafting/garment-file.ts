/**
 * The garment file (seamwise-garment/1, a superset of the GarmentCode specification) of a draft.
 */
import {minus, norm, plus, type Point} from '../../src/model/geometry/vectors.js';
import type {SizeName} from './body.js';
import {length, pointAt, type Curve} from './curves.js';
import {findEdge, type EdgeName, type Garment, type Panel, type Seam} from './panel.js';
import {seamWeights} from './seam-kinds.js';

const rounded = (value: number, digits: number): number => Number(value.toFixed(digits)) + 0;
const roundedPoint = ([x, y]: Point): [number, number] => [rounded(x, 6), rounded(y, 6)];

/**
 * A control point in GarmentCode's form: along the edge and to its left, both as fractions of the
 * edge.
 */
function relative(control: Point, {from, to}: Curve): [number, number] {
  const [ex, ey] = minus(to, from);
  const [cx, cy] = minus(control, from);
  const square = norm([ex, ey]) ** 2;
  return [rounded((cx * ex + cy * ey) / square, 12), rounded((cy * ex - cx * ey) / square, 12)];
}

/** Points along the outline, dense enough for the placement of marks. */
const traced = ({edges}: Panel): Point[] =>
  edges.flatMap(({curve}) =>
    Array.from({length: curve.controls ? 16 : 1}, (_, k) => pointAt(curve, k / 16)),
  );

/**
 * A line along the grain through the middle of the panel: two thirds of the longest stretch inside
 * the outline.
 */
export function grainLine(panel: Panel): [Point, Point] {
  const {grain = [0, 1]} = panel;
  const along = plus([0, 0], grain, 1 / norm(grain));
  const across: Point = [along[1], -along[0]];
  const outline = traced(panel).map((p): Point => [
    p[0] * across[0] + p[1] * across[1],
    p[0] * along[0] + p[1] * along[1],
  ]);
  const sides = outline.map(([x]) => x);
  const middle = (Math.min(...sides) + Math.max(...sides)) / 2;
  const heights = outline
    .flatMap(([x, y], k) => {
      const [nextX, nextY] = outline[(k + 1) % outline.length] ?? [x, y];
      return x > middle === nextX > middle ? [] : [y + ((nextY - y) * (middle - x)) / (nextX - x)];
    })
    .sort((one, other) => one - other);
  let [low, high] = [0, 0];
  for (let k = 0; k + 1 < heights.length; k += 2) {
    const [from = 0, to = 0] = heights.slice(k, k + 2);
    if (to - from > high - low) [low, high] = [from, to];
  }
  const at = (share: number): Point =>
    plus(plus([0, 0], across, middle), along, low + share * (high - low));
  return [at(1 / 6), at(5 / 6)];
}

export interface Notch {
  readonly edge: number;
  readonly at: number;
}

/**
 * The marks on the panel's edges. A mark has the same distance from the start of one side and from
 * the end of the other.
 */
export function notchesOf(panel: Panel, {seams}: Garment): Notch[] {
  const on = ([name, part]: EdgeName): number =>
    name === panel.name ? panel.edges.findIndex((candidate) => candidate.name === part) : -1;
  const marks = seams.flatMap(({a, b, notches = [], ownNotches = []}) => [
    ...[...notches, ...ownNotches].map((at) => ({edge: on(a), at: rounded(at, 6)})),
    ...notches.map((at) => ({edge: on(b), at: rounded(1 - at, 6)})),
  ]);
  return marks.filter(({edge}) => edge >= 0).sort((p, q) => p.edge - q.edge || p.at - q.at);
}

/** A panel's name on paper. */
export const titled = (name: string): string =>
  name.charAt(0).toUpperCase() + name.slice(1).replaceAll('_', ' ');

function panelEntry(panel: Panel, garment: Garment): object {
  const {name, edges, placement} = panel;
  const notches = notchesOf(panel, garment);
  return {
    label: titled(name),
    translation: placement.translation.map((v) => rounded(v, 3)),
    rotation: placement.rotation.map((v) => rounded(v, 3)),
    grain: {line: grainLine(panel).map(roundedPoint)},
    ...(notches.length > 0 && {notches}),
    ...(panel.folds && {
      folds: panel.folds.map(({line, to, kind}) => ({
        ...{line: line.map(roundedPoint), to: to.map(roundedPoint), kind},
      })),
    }),
    vertices: edges.map(({curve}) => roundedPoint(curve.from)),
    edges: edges.map(({name: label, curve}, k) => ({
      endpoints: [k, (k + 1) % edges.length],
      ...(curve.controls && {
        curvature: {type: 'cubic', params: curve.controls.map((c) => relative(c, curve))},
      }),
      label,
    })),
  };
}

function seamEntry(garment: Garment, {name, kind, a, b}: Seam, stitch: number): object {
  const [lengthA = NaN, lengthB = NaN] = [a, b].map((names) =>
    length(findEdge(garment, names).curve),
  );
  return {
    stitch,
    name,
    weight: seamWeights[kind],
    lengthRatio: rounded(lengthA / lengthB, 4),
  };
}

/** The text of the garment's file: one point, one edge, one stitch, one seam a line. */
export function garmentFile(garment: Garment, size: SizeName): string {
  const at = (names: EdgeName): object => ({panel: names[0], edge: findEdge(garment, names).index});
  const side = ({panel, line}: {panel: string; line: readonly Point[]}): object => ({
    piece: panel,
    line: line.map(roundedPoint),
  });
  const text = JSON.stringify(
    {
      format: 'seamwise-garment/1',
      title: garment.title,
      size: size.toUpperCase(),
      pattern: {
        panels: Object.fromEntries(
          garment.panels.map((panel) => [panel.name, panelEntry(panel, garment)]),
        ),
        stitches: garment.seams.map(({a, b}) => [at(a), at(b)]),
        panel_order: garment.panels.map(({name}) => name),
      },
      properties: {
        curvature_coords: 'relative',
        normalize_panel_translation: false,
        normalized_edge_loops: true,
        units_in_meter: 100,
      },
      seams: garment.seams.map((seam, k) => seamEntry(garment, seam, k)),
      ...(garment.matches && {
        matches: garment.matches.map(({name, a, b}) => ({name, a: side(a), b: side(b)})),
      }),
    },
    null,
    1,
  );
  return (
    text
      .replace(/(\[|\{)([^[\]{}]*)(\]|\})/g, joined)
      .replace(/\[\s+(\[[^[\]]*\]),\s+(\[[^[\]]*\])\s+\]/g, '[$1, $2]')
      .replace(/\[\s+(\{[^{}]*\}),\s+(\{[^{}]*\})\s+\]/g, '[$1, $2]') + '\n'
  );
}

const joined = (_: string, open: string, inside: string, close: string): string =>
  open + inside.trim().replace(/\s*\n\s*/g, ' ') + close;
