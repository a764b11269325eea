/** State of a workbench as plain data. */
import type {Design, DesignPrint} from '../model/design/design.js';
import type {Failure} from '../model/base/failure.js';
import type {OwnPicture} from '../model/design/tile-repeat.js';
import type {OpenEdge} from '../model/print/photo-reading.js';

/** Position of a view of the sheet. Scale in CSS px per cm. */
export interface ViewState {
  readonly centre: readonly [number, number];
  readonly scale: number;
}

/** Window of the sheet: its view, and images of the whole sheet. */
export interface SheetWindow {
  get(): ViewState | null;
  set(view: ViewState): void;
  /** A PNG image; the default width suits storage. [px] */
  picture(width?: number): Promise<Blob>;
  /** The whole sheet on white, for printing; undefined where it cannot be drawn. */
  onPaper(): HTMLCanvasElement | undefined;
  /** Greatest width of such an image. [px] */
  readonly widest: number;
  /** True if the browser has taken the graphics context away and not restored it. */
  readonly isLost: boolean;
}

/** One step of the history: a design and its view. */
export interface Step {
  readonly design: Design;
  readonly view: ViewState | null;
  /** The design is an order, a result or a link, whose answer is shown as it was given. */
  readonly isGiven?: boolean;
}

/**
 * `opening`: the first design is loading; `empty`: there is none; `stale`: the display belongs to
 * an earlier design.
 */
export type SolveState =
  | {readonly kind: 'opening' | 'empty' | 'solving' | 'done'}
  | {readonly kind: 'stale'; readonly cancelled: boolean}
  | {readonly kind: 'failed'; readonly failure: Failure};

/** A message that is shown once, beside its subject. */
export interface Notice {
  readonly tone: 'error' | 'info';
  readonly text: string;
  /** Offers to undo the last step. */
  readonly undo?: boolean;
  /** Offers another action. */
  readonly action?: {readonly label: string; readonly act: () => void};
}

/** An image that was opened as a print and does not meet its copies. */
export interface DoubtfulPicture {
  readonly own: OwnPicture;
  readonly edges: readonly OpenEdge[];
  /** The print that stays meanwhile; a change of the print ends the question. */
  readonly beside: DesignPrint;
}

/** A part of the pattern that the user refers to. */
export type Target =
  | {readonly kind: 'piece'; readonly piece: number}
  | {readonly kind: 'seam'; readonly seam: number; readonly side: 'a' | 'b'};

export const sameTarget = (a: Target | undefined, b: Target | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);
