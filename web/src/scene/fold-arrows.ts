/** Arrows of the garment's pleats on the displayed pieces. Lengths in cm. */
import {foldArrows} from '../model/garment/fold-arrows.js';
import type {DraftedFold} from '../model/garment/garment-document.js';
import {linesIn} from './folds.js';
import type {LineLook, Overlay} from './overlay.js';
import type {PatternScene} from './scene.js';

/** The arrows of a fold. @param head length of an arrowhead */
export const shownArrows = (
  scene: PatternScene,
  piece: number,
  fold: DraftedFold,
  {head, look = 'fold'}: {readonly head: number; readonly look?: LineLook},
): NonNullable<Overlay['lines']> => linesIn(scene, piece, foldArrows(fold, head), look);
