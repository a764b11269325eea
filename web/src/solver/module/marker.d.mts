/**
 * The marker module's Embind interface. Every EmbindObject stays on the module's heap until
 * `delete()`; only the code in neighbouring folders should depend on that. Lengths are in cm,
 * angles in radians; lists of points are flat x, y pairs.
 */
import type {EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

export interface ModuleMarkerPiece {
  /** Name in messages. */
  readonly name: string;
  /** Index of its garment, from 0. `nap: 'garment'` lays all pieces of a garment the same way. */
  readonly garment: number;
  /** Outline of the cutting line in the coordinates of the piece's shape, counter-clockwise. */
  readonly outline: Float64Array;
  /** Alignment on the print: W(p) = R(angle)^T (p - translation). */
  readonly angle: number;
  readonly x: number;
  readonly y: number;
  /** Turns of the print by which the piece may be laid; they follow from its grain. */
  readonly turns: 'half' | 'quarter' | 'any';
  /** Direction of the grain line from foot to head, on the piece. */
  readonly upX: number;
  readonly upY: number;
  /** Shifts of the print under the piece that match as well as no shift. */
  readonly shifts: Float64Array;
  /**
   * Required place on the fabric: angle, x, y of p_cloth = R(angle) p + translation; empty for any
   * place.
   */
  readonly pin: Float64Array;
}

export interface ModuleMarkerRequest {
  readonly group: string;
  readonly w1x: number;
  readonly w1y: number;
  readonly w2x: number;
  readonly w2y: number;
  readonly pieces: readonly ModuleMarkerPiece[];
  readonly width: number;
  readonly selvedge: number;
  readonly gap: number;
  /** Greatest relative deviation of the repeat on the bolt from the given one. */
  readonly repeatTolerance: number;
  readonly nap: 'none' | 'garment' | 'one-way';
  /** True if lengths are rounded up to whole repeats along the warp. */
  readonly wholeRepeats: boolean;
  /**
   * True if pieces may be placed anywhere, in steps of half a centimetre, without regard to the
   * print.
   */
  readonly ignoresPrint: boolean;
  /**
   * Distances of an origin of the print from the left edge, at least one; the search chooses the
   * best one.
   */
  readonly phases: Float64Array;
  /**
   * Distance of an origin of the print from the cut; NaN where the cut is free. Required if there
   * are flaws.
   */
  readonly start: number;
  /** Polygons of the fabric that pieces must avoid. */
  readonly flaws: readonly Float64Array[];
  /** Other widths, on which the pieces are laid out quickly. */
  readonly widths: Float64Array;
  /** True to search also for a layout that ignores the print. */
  readonly alsoFree: boolean;
  /**
   * Multiplies the budget; 1 is meant to take about a second. 0: the first layout only, and no
   * proof.
   */
  readonly effort: number;
  readonly seed: number;
}

export type ModuleMarkerStage = 'tables' | 'lay' | 'prove' | 'free' | 'widths' | 'done';

export interface ModuleLayout {
  readonly length: number;
  /** Origin of the print on the fabric. */
  readonly originX: number;
  readonly originY: number;
  /** Per piece, angle, x, y of p_cloth = R(angle) p + translation; NaN where it found no place. */
  readonly places: Float64Array;
}

export interface ModuleMarkerReport {
  readonly bound: number;
  readonly proven: boolean;
  /** Length without regard to the print; 0 unless requested. */
  readonly freeLength: number;
  /** Lengths per phase and per width of the request; NaN where a piece finds no place. */
  readonly phaseLengths: Float64Array;
  readonly widthLengths: Float64Array;
}

/**
 * A search for a layout that is advanced step by step. After any call, `failure()` returns the
 * failure, if there was one.
 */
export interface ModuleMarker extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Continues for about so many million table reads. Returns false when nothing is left to do. */
  advance(work: number): boolean;
  stage(): ModuleMarkerStage;
  /** Share of the work done, 0 to 1. */
  fraction(): number;
  /** Number of layouts that were the best when found; 0 before the first one. */
  count(): number;
  /** The best layout so far. */
  layout(): ModuleLayout;
  report(): ModuleMarkerReport;
}

export interface MarkerModule {
  readonly Marker: new (request: ModuleMarkerRequest) => ModuleMarker;
}

declare const createMarker: (settings?: ModuleSettings) => Promise<MarkerModule>;
export default createMarker;
