/** The picture that a print was made of, and how that repeats, in the words of those who design prints. */

/**
 * `halfDrop`: each column begins half a picture lower than its neighbour; `brick`: each row half a picture aside;
 * `mirrored`: every other picture is mirrored both ways, or only `mirroredAcross` (left to right) or `mirroredUp`.
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

/** A picture as it was opened, and what the print's own picture was made of it by. */
export interface PrintTile {
  /** As `image` of a print. */
  readonly image: string;
  readonly repeat: TileRepeat;
  /** Clockwise, to bring the group's axes to where its convention has them. [degrees] */
  readonly turnedDeg: 0 | 90;
}
