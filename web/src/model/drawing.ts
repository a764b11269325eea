/**
 * What a file of another program shows before anybody chose anything: pieces as drawn, right side up, y up, in the unit
 * of the file. `garmentOf` makes a garment of it.
 */
import type {FileUnit} from './garment-document.js';
import type {Point} from './geometry.js';

/** From corner to corner: a chain of Bezier curves, each by two control points and its end. */
export interface Run {
  readonly start: Point;
  readonly cubics: readonly (readonly [Point, Point, Point])[];
}

export type NotchKind = 'slit' | 'v' | 't' | 'castle' | 'check' | 'u';

export interface DrawnNotch {
  readonly at: Point;
  readonly depth?: number;
  readonly kind: NotchKind;
}

export interface DrawnPiece {
  readonly name: string;
  readonly size?: string;
  /** How many are cut as drawn, and how many as the mirror image. */
  readonly quantity: {readonly asDrawn: number; readonly mirrored: number};
  readonly material?: string;
  /** The line that is sewn, closed, either way round. Where a file draws only one line, this is it. */
  readonly sewn: readonly Run[];
  /** The line that is cut, if the file draws both. */
  readonly cut?: readonly Run[];
  readonly holes: readonly (readonly Run[])[];
  readonly notches: readonly DrawnNotch[];
  readonly grain?: readonly [Point, Point];
  /** The axis of a half piece: the cloth is folded along it. */
  readonly fold?: readonly [Point, Point];
  readonly internalLines: readonly (readonly Point[])[];
  readonly drillHoles: readonly Point[];
  readonly words: readonly string[];
}

/** Two runs of outlines that the file sews to each other (only meshes tell). */
export interface DrawnSeam {
  readonly a: {readonly piece: number; readonly run: number};
  readonly b: {readonly piece: number; readonly run: number};
  readonly sameDirection: boolean;
}

export interface UnitGuess {
  readonly unit: FileUnit;
  /** By what it is known. */
  readonly because: 'stated' | 'measured' | 'size' | 'program';
  readonly isSure: boolean;
  /** Units in which somebody could wear it, too. */
  readonly others: readonly FileUnit[];
}

export interface Drawing {
  readonly kind: 'dxf' | 'svg' | 'obj';
  readonly program?: string;
  readonly title?: string;
  /** All that the file holds; `pieces` are those of `sampleSize` unless another was asked for. */
  readonly sizes: readonly string[];
  readonly sampleSize?: string;
  readonly size?: string;
  readonly unit: UnitGuess;
  readonly pieces: readonly DrawnPiece[];
  readonly seams: readonly DrawnSeam[];
  /** One sentence each, of what was left out or assumed. */
  readonly notes: readonly string[];
}

/** How a file is read. */
export interface DrawingOptions {
  /** Of a nest of sizes, the one to take; by default the size that the others were graded from. */
  readonly size?: string;
  /** In which unit it is drawn, whatever it says. */
  readonly units?: FileUnit;
}
