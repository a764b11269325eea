import type {Allowance} from './garment-document.js';
import type {Point} from '../geometry/vectors.js';

/** One end of a stitch: an outline edge of a panel, by its number in the panel's loop. */
export interface StitchEnd {
  readonly panel: string;
  readonly edge: number;
}

/**
 * Two edges sewn to each other: the start of one meets the end of the other, unless "right_wrong".
 */
export type Stitch =
  readonly [StitchEnd, StitchEnd] | readonly [StitchEnd, StitchEnd, 'right_wrong' | null];

/** A control point (an older spelling of a quadratic curve), or a curve by its kind. */
export type Curvature =
  | Point
  | {readonly type: 'quadratic'; readonly params: readonly [Point]}
  | {readonly type: 'cubic'; readonly params: readonly [Point, Point]}
  | {readonly type: 'circle'; readonly params: readonly [number, number, number]}
  | {readonly type: 'path'; readonly params: readonly PathCubic[]};

/**
 * A cubic of a path: two control points and its end; the last cubic ends at the end of the edge.
 */
export type PathCubic = readonly [Point, Point, Point] | readonly [Point, Point];

export interface PanelEdge {
  readonly endpoints: readonly [number, number];
  readonly curvature?: Curvature;
  readonly label?: string;
  /** Seam allowance beyond the edge. [units of the file] */
  readonly allowance?: number | Allowance;
  /** True if the edge stays open. */
  readonly open?: boolean;
}

export interface Panel {
  readonly vertices: readonly Point[];
  readonly edges: readonly PanelEdge[];
  readonly translation?: readonly [number, number, number];
  /** XYZ Euler angles in degrees. */
  readonly rotation?: readonly [number, number, number];
}

/** A sewing pattern in the GarmentCode specification format, as existing files use it. */
export interface GarmentCodeSpecification {
  readonly pattern: {
    readonly panels: Readonly<Record<string, Panel>>;
    readonly stitches?: readonly Stitch[];
  };
  readonly properties?: {
    readonly curvature_coords?: 'relative' | 'absolute';
    readonly units_in_meter?: number;
  };
}

/** The project's own format. Its JSON Schema describes the fields; unknown fields are kept. */
export interface SeamwiseGarment {
  readonly format: `seamwise-garment/${number}`;
  readonly [field: string]: unknown;
}

export type Garment = GarmentCodeSpecification | SeamwiseGarment;
