/** Greatest number of pieces in a garment. */
import {FileError} from '../../model/base/versioned-file.js';

const mostPieces = 500;

/**
 * Checks the number of pieces.
 * @throws {FileError} if there are more pieces
 */
export function checkCount(count: number, file: string): void {
  if (count <= mostPieces) return;
  throw new FileError(
    file,
    `holds ${count} pieces, more than the ${mostPieces} of any garment; export those of one garment alone.`,
  );
}
