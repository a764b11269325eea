/** Finds the mirror image of an edge, which carries a seam of one half over to the other. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {imagesOf, numberOf} from './scores.js';

/**
 * Returns the image on the same piece or on its twin; undefined if outlines and names allow none or
 * several.
 */
export function mirrorImage(garment: GarmentDocument, edge: EdgeOfPiece): EdgeOfPiece | undefined {
  const {garment: own, images} = imagesOf(garment);
  return own.edges[images[numberOf(own, edge)] ?? -1]?.at;
}
