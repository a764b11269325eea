/** Folds of the garment on the displayed pieces. Lengths in cm. */
import {foldLines} from '../model/garment/folds.js';
import type {DraftedFold} from '../model/garment/garment-document.js';
import {carried} from '../model/geometry/triangles.js';
import type {Point} from '../model/geometry/vectors.js';
import type {LineLook, Overlay} from './overlay.js';
import type {PatternScene} from './scene.js';

type Lines = NonNullable<Overlay['lines']>;

/** Converts a point of the drafted piece, face up, to the displayed piece. */
export function onShown({pieces, pattern}: PatternScene, piece: number, point: Point): Point {
  const {triangles = [], points = []} = pieces[piece] ?? {};
  const {rest = []} = pattern.pieces[piece] ?? {};
  return points === rest ? point : carried(triangles, rest, points, point);
}

/** Lines of the drafted piece as marks of the displayed one. */
export const linesIn = (
  scene: PatternScene,
  piece: number,
  lines: readonly (readonly Point[])[],
  look: LineLook,
): Lines => lines.map((line) => ({piece, line: line.map((p) => onShown(scene, piece, p)), look}));

/** The lines of a fold. */
export const shownFold = (
  scene: PatternScene,
  piece: number,
  fold: DraftedFold,
  look: LineLook = 'fold',
): Lines => linesIn(scene, piece, foldLines(fold), look);
