/** What a garment file says about its panels that a result does not repeat. */
import type {Garment} from './garment.js';
import type {Point} from './geometry.js';
import {angleOf, type GrainRule} from './options.js';
import {pieceNames, titleOfFile, type PieceNames} from './piece-names.js';
import {fieldOf} from './read.js';

type Vector = readonly [x: number, y: number, z: number];

/** Of a panel: x to the wearer's left, y up, z to the front; turned about x, then y, then z. */
export interface Placement {
  readonly translation: Vector;
  /** [degrees] */
  readonly rotation?: Vector;
}

/** A mark on an edge of the outline, at a share of its length. The ends are in the coordinates of the file. [cm] */
export interface Notch {
  readonly from: Point;
  readonly to: Point;
  readonly at: number;
}

export interface PanelMarks {
  /** What people call the piece. */
  readonly label: string;
  /** In the coordinates of the file, not yet mirrored. [cm] */
  readonly grain?: readonly [Point, Point];
  /** Where the grain line was said to run, over the file: of the face-up piece, from its x axis. [degrees] */
  readonly grainDeg?: number;
  /** Where it is on the body. [cm] */
  readonly placement?: Placement;
  readonly notches?: readonly Notch[];
}

/** Of a garment's own words, those that belong on every sheet. */
export interface GarmentTitle {
  readonly title?: string;
  readonly size?: string;
}

const listed = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

/** All of a list's numbers in another unit, if it starts with so many of them. */
function numbers(value: unknown, count: number, unit: number): readonly number[] | undefined {
  const some = listed(value).slice(0, count);
  const scaled = some.flatMap((entry) => (typeof entry === 'number' ? [entry * unit] : []));
  return scaled.length === count ? scaled : undefined;
}

function pointOf(value: unknown, unit: number): Point | undefined {
  const [x, y] = numbers(value, 2, unit) ?? [];
  return x === undefined || y === undefined ? undefined : [x, y];
}

function vectorOf(value: unknown, unit: number): Vector | undefined {
  const [x, y, z] = numbers(value, 3, unit) ?? [];
  return x === undefined || y === undefined || z === undefined ? undefined : [x, y, z];
}

function placementOf(panel: unknown, unit: number): Placement | undefined {
  const translation = vectorOf(fieldOf(panel, 'translation'), unit);
  const rotation = vectorOf(fieldOf(panel, 'rotation'), 1);
  return translation && {translation, ...(rotation && {rotation})};
}

function notchesOf(panel: unknown, unit: number): readonly Notch[] {
  const vertices = listed(fieldOf(panel, 'vertices')).map((vertex) => pointOf(vertex, unit));
  const edges = listed(fieldOf(panel, 'edges')).map((edge) =>
    (numbers(fieldOf(edge, 'endpoints'), 2, 1) ?? []).map((end) => vertices[end]),
  );
  return listed(fieldOf(panel, 'notches')).flatMap((notch) => {
    const edge = fieldOf(notch, 'edge');
    const at = fieldOf(notch, 'at');
    const [from, to] = (typeof edge === 'number' ? edges[edge] : undefined) ?? [];
    return from && to && typeof at === 'number' ? [{from, to, at}] : [];
  });
}

/** What a person decided about panels, by their names, over what their file says. */
export interface PanelDecisions {
  readonly names?: PieceNames;
  readonly grain?: Readonly<Record<string, GrainRule>>;
}

/** The names that a garment's file, or a design, chooses for its pieces. */
export const chosenNames = (holder: unknown): PieceNames => {
  const names = fieldOf(holder, 'names');
  const entries = typeof names === 'object' && names !== null ? Object.entries(names) : [];
  return Object.fromEntries(
    entries.filter((entry): entry is [string, string] => typeof entry[1] === 'string'),
  );
};

/** By panel name. What a garment does not show is left out; the solver has checked the file. */
export function panelMarks(
  garment: Garment,
  {names = {}, grain: rules = {}}: PanelDecisions = {},
): ReadonlyMap<string, PanelMarks> {
  const unitsInMetre = fieldOf(garment.properties, 'units_in_meter');
  const unit = typeof unitsInMetre === 'number' ? 100 / unitsInMetre : 1;
  const panels = fieldOf(garment.pattern, 'panels');
  const entries = typeof panels === 'object' && panels !== null ? Object.entries(panels) : [];
  const labels = entries.map(([name, panel]: [string, unknown]): [string, string | undefined] => {
    const label = fieldOf(panel, 'label');
    return [name, typeof label === 'string' ? label : undefined];
  });
  const called = pieceNames(new Map(labels), {...chosenNames(garment), ...names});
  return new Map(
    entries.map(([name, panel]: [string, unknown]): [string, PanelMarks] => {
      const grainDeg = Object.hasOwn(rules, name) ? angleOf(rules[name]) : undefined;
      const placement = placementOf(panel, unit);
      const notches = notchesOf(panel, unit);
      const [from, to] = listed(fieldOf(fieldOf(panel, 'grain'), 'line')).map((p) =>
        pointOf(p, unit),
      );
      return [
        name,
        {
          label: called.get(name) ?? name,
          ...(from && to && {grain: [from, to] as const}),
          ...(grainDeg !== undefined && {grainDeg}),
          ...(placement && {placement}),
          ...(notches.length > 0 && {notches}),
        },
      ];
    }),
  );
}

/** @param file the garment's, which is what it is called when it says no title itself */
export function garmentTitle(garment: Garment, file?: string): GarmentTitle {
  const said = fieldOf(garment, 'title');
  const isSaid = typeof said === 'string' && said.trim() !== '';
  const title = isSaid ? said : file === undefined ? undefined : titleOfFile(file);
  const size = fieldOf(garment, 'size');
  return {...(title !== undefined && {title}), ...(typeof size === 'string' && {size})};
}
