/** Finds the mirror image of an edge, which carries a seam of one half over to the other. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {edgeAt} from './rank.js';
import {numberOf, scoresOf} from './scores.js';

/**
 * Returns the image on the same piece or on its twin; undefined if outlines and names allow none or
 * several.
 */
export function mirrorImage(garment: GarmentDocument, edge: EdgeOfPiece): EdgeOfPiece | undefined {
  const scores = scoresOf(garment);
  const image = scores.images[numberOf(scores.garment, edge)] ?? -1;
  return image < 0 ? undefined : edgeAt(scores, image);
}
