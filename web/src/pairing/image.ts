/** The mirror image of an edge, by which seams of one half are those of the other. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment-document.js';
import {edgeAt} from './rank.js';
import {numberOf, scoresOf} from './scores.js';

/** On the same piece or on its twin; undefined where outlines and names leave none, or several. */
export function mirrorImage(garment: GarmentDocument, edge: EdgeOfPiece): EdgeOfPiece | undefined {
  const scores = scoresOf(garment);
  const image = scores.images[numberOf(scores.garment, edge)] ?? -1;
  return image < 0 ? undefined : edgeAt(scores, image);
}
