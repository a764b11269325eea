/** Sides of seams as lines on the sheet. Lengths in cm. */
import type {Point} from '../model/geometry/vectors.js';
import type {SeamSide} from '../model/result/result.js';
import {ontoSheet} from '../model/geometry/sheet-place.js';
import {pick} from './marks.js';
import type {PatternScene} from './scene.js';

export function lineOf({pieces}: PatternScene, {piece, vertices}: SeamSide): Point[] {
  const shown = pieces[piece];
  return shown ? pick(shown.points, vertices).map((point) => ontoSheet(shown, point)) : [];
}
