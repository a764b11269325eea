/** Names of the internal lines of a piece, in the member `internalLineNames` of its panel. */
import type {GarmentPiece} from './garment-document.js';

const member = 'internalLineNames';

/** The names by number of the line; undefined for a line without. */
export function lineNamesOf(piece: GarmentPiece | undefined): readonly (string | undefined)[] {
  const names = piece?.more?.[member];
  if (!Array.isArray(names)) return [];
  return names.map((name: unknown) =>
    typeof name === 'string' && name.trim() !== '' ? name.trim() : undefined,
  );
}

/** The members of a piece with named lines; none if no line has a name. */
export const withLineNames = (
  names: readonly (string | undefined)[],
): Pick<GarmentPiece, 'more'> =>
  names.every((name) => name === undefined)
    ? {}
    : {more: {[member]: names.map((name) => name ?? '')}};
