/** What a workbench says about itself, as plain data. */
import type {Design, DesignPrint} from '../model/design.js';
import type {Failure} from '../model/failure.js';
import type {OwnPicture} from '../model/tile-repeat.js';
import type {OpenEdge} from '../model/photo.js';

/** Where a view of the sheet stood. Scale in CSS px per cm. */
export interface ViewState {
  readonly centre: readonly [number, number];
  readonly scale: number;
}

/** Whoever shows the sheet: where it stands, and a picture of all of it. */
export interface SheetWindow {
  get(): ViewState | null;
  set(view: ViewState): void;
  /** A PNG, by default as wide as is good to keep. [px] */
  picture(width?: number): Promise<Blob>;
  /** The whole sheet on white, for the printer; undefined where it cannot be drawn. */
  onPaper(): HTMLCanvasElement | undefined;
  /** The greatest width of such a picture. [px] */
  readonly widest: number;
  /** The browser has taken the graphics context away, and has not given it back. */
  readonly isLost: boolean;
}

/** One step of the history: a design, and how it was looked at. */
export interface Step {
  readonly design: Design;
  readonly view: ViewState | null;
}

/** `opening`: the first design is on its way; `empty`: there is none; `stale`: what is shown belongs to an earlier design. */
export type SolveState =
  | {readonly kind: 'opening' | 'empty' | 'solving' | 'done'}
  | {readonly kind: 'stale'; readonly cancelled: boolean}
  | {readonly kind: 'failed'; readonly failure: Failure};

/** Said once, beside what it is about. */
export interface Notice {
  readonly tone: 'error' | 'info';
  readonly text: string;
  /** Offers to take the last step back. */
  readonly undo?: boolean;
  /** Offers something else. */
  readonly action?: {readonly label: string; readonly act: () => void};
}

/** A picture that somebody opened as a print and that does not meet its copies. */
export interface DoubtfulPicture {
  readonly own: OwnPicture;
  readonly edges: readonly OpenEdge[];
  /** The print that stays meanwhile; with another, the question is over. */
  readonly beside: DesignPrint;
}

/** A part of the pattern that somebody means. */
export type Target =
  | {readonly kind: 'piece'; readonly piece: number}
  | {readonly kind: 'seam'; readonly seam: number; readonly side: 'a' | 'b'};

export const sameTarget = (a: Target | undefined, b: Target | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);
