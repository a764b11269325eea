/**
 * The module that lays pieces on cloth as Embind shows it. Everything of type EmbindObject lives on the module's heap
 * until `delete()`; nothing outside this folder's neighbours should have to know that. Lengths are in cm, angles in radians,
 * lists of points flat: x, y after each other.
 */
import type {EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

export interface ModuleMarkerPiece {
  /** As sentences call it. */
  readonly name: string;
  /** Which garment it belongs to, from 0: what `nap: 'garment'` keeps together. */
  readonly garment: number;
  /** The cut line's outline in the coordinates of the piece's shape, counter-clockwise. */
  readonly outline: Float64Array;
  /** The alignment on the print: W(p) = R(angle)^T (p - translation). */
  readonly angle: number;
  readonly x: number;
  readonly y: number;
  /** By which turns of the print it may be laid: its grain's rule. */
  readonly turns: 'half' | 'quarter' | 'any';
  /** Direction of the grain line from foot to head, on the piece: which way is up. */
  readonly upX: number;
  readonly upY: number;
  /** Shifts of the print under it that fit as well, beside none. */
  readonly shifts: Float64Array;
  /** Where it has to lie on the cloth: angle, x, y of p_cloth = R(angle) p + translation; empty for anywhere. */
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
  /** How much the repeat on the bolt may be longer or shorter than told, as a share. */
  readonly repeatTolerance: number;
  readonly nap: 'none' | 'garment' | 'one-way';
  /** Lengths are rounded up to whole repeats along the warp. */
  readonly wholeRepeats: boolean;
  /** Pieces may lie anywhere, in steps of half a centimetre: the print does not matter. */
  readonly ignoresPrint: boolean;
  /** Distances of an origin of the print from the left edge, the best of which is chosen; at least one. */
  readonly phases: Float64Array;
  /** Of an origin of the print from the cut; NaN where the cut is free. Needed where there are flaws. */
  readonly start: number;
  /** Polygons of the cloth on which no piece may lie. */
  readonly flaws: readonly Float64Array[];
  /** Other widths to lay on, quickly. */
  readonly widths: Float64Array;
  /** Whether to lay without regard to the print, too. */
  readonly alsoFree: boolean;
  /** Multiplies the budget; 1 is meant to take about a second. 0: the first layout only, no proof. */
  readonly effort: number;
  readonly seed: number;
}

export type ModuleMarkerStage = 'tables' | 'lay' | 'prove' | 'free' | 'widths' | 'done';

export interface ModuleLayout {
  readonly length: number;
  /** The origin of the print on the cloth. */
  readonly originX: number;
  readonly originY: number;
  /** Per piece angle, x, y of p_cloth = R(angle) p + translation; NaN where it found no place. */
  readonly places: Float64Array;
}

export interface ModuleMarkerReport {
  readonly bound: number;
  readonly proven: boolean;
  /** 0 where nobody asked. */
  readonly freeLength: number;
  /** Per phase and per width of the request; NaN where a piece finds no place. */
  readonly phaseLengths: Float64Array;
  readonly widthLengths: Float64Array;
}

/** A layout that is sought step by step. After any call, `failure()` says whether it went wrong. */
export interface ModuleMarker extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Goes on until about so many million table reads are spent. False when there is nothing left to do. */
  advance(work: number): boolean;
  stage(): ModuleMarkerStage;
  /** 0 to 1 */
  fraction(): number;
  /** Counts the layouts that were the best so far; 0 while there is none. */
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
