/** What a garment file says about its panels that a result does not repeat. */
import type {Point} from '../model/geometry.js';
import type {Garment} from '../model/garment.js';
import type {Placement} from '../picture/on-body.js';

export interface PanelMarks {
  /** What people call the piece. */
  readonly label?: string;
  /** In the coordinates of the file, not yet mirrored. [cm] */
  readonly grain?: readonly [Point, Point];
  /** Where it is on the body. [cm] */
  readonly placement?: Placement;
}

const field = (value: unknown, name: string): unknown =>
  typeof value === 'object' && value !== null ? Reflect.get(value, name) : undefined;

function pointOf(value: unknown, unit: number): Point | undefined {
  if (!Array.isArray(value)) return undefined;
  const [x, y] = value as readonly unknown[];
  return typeof x === 'number' && typeof y === 'number' ? [x * unit, y * unit] : undefined;
}

type Vector = Placement['translation'];

function vectorOf(value: unknown, unit: number): Vector | undefined {
  if (!Array.isArray(value)) return undefined;
  const [x, y, z] = value as readonly unknown[];
  return typeof x === 'number' && typeof y === 'number' && typeof z === 'number'
    ? [x * unit, y * unit, z * unit]
    : undefined;
}

function placementOf(panel: unknown, unit: number): Placement | undefined {
  const translation = vectorOf(field(panel, 'translation'), unit);
  const rotation = vectorOf(field(panel, 'rotation'), 1);
  return translation && {translation, ...(rotation && {rotation})};
}

/** Labels, grain lines and placements by panel name. A garment that shows none has none; the solver has checked the file. */
export function panelMarks(garment: Garment): ReadonlyMap<string, PanelMarks> {
  const unitsInMetre = field(garment.properties, 'units_in_meter');
  const unit = typeof unitsInMetre === 'number' ? 100 / unitsInMetre : 1;
  const panels = field(garment.pattern, 'panels');
  const entries = typeof panels === 'object' && panels !== null ? Object.entries(panels) : [];
  return new Map(
    entries.map(([name, panel]: [string, unknown]): [string, PanelMarks] => {
      const label = field(panel, 'label');
      const line = field(field(panel, 'grain'), 'line');
      const placement = placementOf(panel, unit);
      const [from, to] = (Array.isArray(line) ? line : []).map((p: unknown) => pointOf(p, unit));
      return [
        name,
        {
          ...(typeof label === 'string' && {label}),
          ...(from && to && {grain: [from, to] as const}),
          ...(placement && {placement}),
        },
      ];
    }),
  );
}
