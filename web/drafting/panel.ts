/** Panels, stitches, and the GarmentCode specification they are written as. */
import {length, minus, mirrored, norm, reversed, type Curve, type Point} from './geometry.js';

/** Sides are the wearer's. */
export type Side = 'left' | 'right';
const other = (side: Side): Side => (side === 'left' ? 'right' : 'left');

/** Where a panel hangs before it is sewn: turned about the fixed axes x, y, z in this order (degrees), then moved (cm). */
export interface Placement {
  readonly translation: readonly [number, number, number];
  readonly rotation: readonly [number, number, number];
}

/** One edge of an outline. Its name is unique in its panel and says what it is sewn as. */
export interface Edge {
  readonly name: string;
  readonly curve: Curve;
}

/** A cut piece, face side up, in its own coordinates: a counter-clockwise outline that starts with its lowest edge. */
export interface Panel {
  readonly name: string;
  readonly edges: readonly Edge[];
  readonly placement: Placement;
}

/** Two edges sewn to each other: the start of one meets the end of the other. */
export interface Seam {
  readonly a: EdgeName;
  readonly b: EdgeName;
  /** How much longer `a` is drafted than `b`, as a factor (gathers), or in cm (ease). Neither: equal. */
  readonly gathers?: number;
  readonly ease?: number;
}
export type EdgeName = readonly [panel: string, edge: string];

export interface Garment {
  readonly name: string;
  readonly panels: readonly Panel[];
  readonly seams: readonly Seam[];
}

export const edge = (name: string, curve: Curve): Edge => ({name, curve});

/** A panel that is its own mirror image: `half` runs up its +x side, from the end of `bottom` to the start of `top`. */
export function symmetricPanel(
  name: string,
  parts: {
    readonly bottom: Edge;
    readonly half: readonly Edge[];
    readonly top: Edge;
    readonly side: Side;
  },
  placement: Placement,
): Panel {
  const near = parts.half.map(({name: part, curve}) => edge(`${part} ${parts.side}`, curve));
  const far = parts.half.map(({name: part, curve}) =>
    edge(`${part} ${other(parts.side)}`, reversed(mirrored(curve))),
  );
  return {name, edges: [parts.bottom, ...near, parts.top, ...far.reverse()], placement};
}

/** The panel drafted on one side of the body and its mirror image for the other. Edge names stay. */
export function pairOf(
  name: string,
  side: Side,
  edges: readonly Edge[],
  placement: Placement,
): readonly [Panel, Panel] {
  const [bottom, ...rest] = edges.map(({name: part, curve}) =>
    edge(part, reversed(mirrored(curve))),
  );
  const [x, y, z] = placement.translation;
  const [rx, ry, rz] = placement.rotation;
  const twin: Placement = {translation: [-x, y, z], rotation: [rx, -ry, -rz]};
  return [
    {name: `${name}_${side}`, edges, placement},
    {
      name: `${name}_${other(side)}`,
      edges: bottom ? [bottom, ...rest.reverse()] : [],
      placement: twin,
    },
  ];
}

/** The same seam on both sides of the body. `*` in a panel or edge name stands for the side. */
export function onBothSides(
  a: EdgeName,
  b: EdgeName,
  how: {readonly gathers?: number; readonly ease?: number} = {},
): Seam[] {
  const at = (names: EdgeName, side: Side): EdgeName => [
    names[0].replace('*', side),
    names[1].replace('*', side),
  ];
  return (['left', 'right'] as const).map((side) => ({a: at(a, side), b: at(b, side), ...how}));
}

/** @throws {Error} for a name that the garment does not have. */
export function findEdge(
  garment: Garment,
  [panelName, edgeName]: EdgeName,
): {readonly index: number; readonly curve: Curve} {
  const edges = garment.panels.find((panel) => panel.name === panelName)?.edges ?? [];
  const index = edges.findIndex(({name}) => name === edgeName);
  const found = edges[index];
  if (!found)
    throw new Error(`no edge '${edgeName}' on panel '${panelName}' of the ${garment.name}`);
  return {index, curve: found.curve};
}

/** What the two sides of a seam differ by beyond what is stated. [cm] */
export function untrue(garment: Garment, seam: Seam): number {
  const a = length(findEdge(garment, seam.a).curve);
  const b = length(findEdge(garment, seam.b).curve);
  return Math.abs(a - b * (seam.gathers ?? 1) - (seam.ease ?? 0));
}

const rounded = (value: number, digits: number): number => Number(value.toFixed(digits)) + 0;
const roundedPoint = ([x, y]: Point): [number, number] => [rounded(x, 6), rounded(y, 6)];

/** A control point as GarmentCode has it: along the edge and to its left, both as fractions of the edge. */
function relative(control: Point, {from, to}: Curve): [number, number] {
  const [ex, ey] = minus(to, from);
  const [cx, cy] = minus(control, from);
  const square = norm([ex, ey]) ** 2;
  return [rounded((cx * ex + cy * ey) / square, 12), rounded((cy * ex - cx * ey) / square, 12)];
}

function panelSpecification({edges, placement}: Panel): object {
  return {
    translation: placement.translation.map((v) => rounded(v, 3)),
    rotation: placement.rotation.map((v) => rounded(v, 3)),
    vertices: edges.map(({curve}) => roundedPoint(curve.from)),
    edges: edges.map(({name, curve}, k) => ({
      endpoints: [k, (k + 1) % edges.length],
      ...(curve.controls && {
        curvature: {type: 'cubic', params: curve.controls.map((c) => relative(c, curve))},
      }),
      label: name,
    })),
  };
}

/** The text of the garment's GarmentCode specification file. */
export function specification(garment: Garment): string {
  const at = (names: EdgeName): object => ({panel: names[0], edge: findEdge(garment, names).index});
  const text = JSON.stringify(
    {
      pattern: {
        panels: Object.fromEntries(
          garment.panels.map((panel) => [panel.name, panelSpecification(panel)]),
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
    },
    null,
    1,
  );
  // one point, one edge and one stitch a line
  return (
    text
      .replace(/(\[|\{)([^[\]{}]*)(\]|\})/g, joined)
      .replace(/\[\s+(\[[^[\]]*\]),\s+(\[[^[\]]*\])\s+\]/g, '[$1, $2]')
      .replace(/\[\s+(\{[^{}]*\}),\s+(\{[^{}]*\})\s+\]/g, '[$1, $2]') + '\n'
  );
}

const joined = (_: string, open: string, inside: string, close: string): string =>
  open + inside.trim().replace(/\s*\n\s*/g, ' ') + close;
