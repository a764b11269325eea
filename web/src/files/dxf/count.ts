/** Checks the number of pieces of a file. */
import {FileError} from '../../model/base/versioned-file.js';

/** Greatest number of pieces in a garment. */
const mostPieces = 500;

/**
 * Checks the number of pieces.
 * @throws {FileError} if there are more pieces
 */
export function checkCount(count: number, file: string, most = mostPieces): void {
  if (count <= most) return;
  throw new FileError(
    file,
    `holds ${count} pieces, more than the ${most} of any garment; export those of one garment alone.`,
    {reason: 'complex'},
  );
}
