/** The image from which a print was made, and its repeat in the terms of textile design. */

/**
 * `halfDrop`: each column begins half an image lower than its neighbour; `brick`: each row is
 * shifted sideways by half an image; `mirrored`: every other image is mirrored both ways, or only
 * `mirroredAcross` (left to right) or `mirroredUp`.
 */
export const tileRepeats = [
  'straight',
  'halfDrop',
  'brick',
  'mirrored',
  'mirroredAcross',
  'mirroredUp',
] as const;

export type TileRepeat = (typeof tileRepeats)[number];

/** An image as it was opened, and the repeat and turn that made the print's own image from it. */
export interface PrintTile {
  /** A URL, as in `image` of a print. */
  readonly image: string;
  readonly repeat: TileRepeat;
  /**
   * Clockwise turn that brings the axes of the group to their conventional directions. [degrees]
   */
  readonly turnedDeg: 0 | 90;
}
