/** Garment documents for tests. */
import type {
  DraftedEdge,
  GarmentDocument,
  GarmentPiece,
  GarmentSeam,
} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';

const corners: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

/** A square with sides of 4 cm, like `squarePiece`. */
export const draftedSquare = (name: string, changes: Partial<GarmentPiece> = {}): GarmentPiece => ({
  name,
  mirroredFromInput: false,
  outline: corners.map((from, k): DraftedEdge => ({points: [from, corners[(k + 1) % 4] ?? from]})),
  ...{holes: [], internalLines: []},
  ...changes,
});

/** A piece of straight edges. @param corners counter-clockwise [cm] */
export const draftedPolygon = (
  name: string,
  corners: readonly Point[],
  changes: Partial<GarmentPiece> = {},
): GarmentPiece =>
  draftedSquare(name, {
    outline: corners.map((from, k): DraftedEdge => ({
      points: [from, corners[(k + 1) % corners.length] ?? from],
    })),
    ...changes,
  });

/** A rectangle with a corner at the origin. [cm] */
export const draftedRectangle = (
  name: string,
  width: number,
  height: number,
  changes: Partial<GarmentPiece> = {},
): GarmentPiece =>
  draftedPolygon(
    name,
    [
      [0, 0],
      [width, 0],
      [width, height],
      [0, height],
    ],
    changes,
  );

export const draftedSeam = (changes: Partial<GarmentSeam> = {}): GarmentSeam => ({
  ...{a: {piece: 0, edge: 1}, b: {piece: 1, edge: 3}},
  ...{sameDirection: false, weight: 1, matched: true},
  ...changes,
});

export const documentOf = (
  pieces: readonly GarmentPiece[],
  changes: Partial<GarmentDocument> = {},
): GarmentDocument => ({
  ...{pieces, seams: [], matches: [], symmetries: [], questions: []},
  ...changes,
});
