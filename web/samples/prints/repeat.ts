/** A manufacturer's name of a print's repeat: the rectangle in which it is printed. */
import {norm} from '../../src/model/geometry/vectors.js';
import {imageCell} from '../../src/model/print/wallpaper.js';
import type {Cell} from './tile.js';

/** Shorter repeats are those of a stripe along itself, where every length is a repeat. [cm] */
const shortest = 1;

export const isStripe = ({w2}: Cell): boolean => norm(w2) < shortest;

const rounded = (cm: number): string => String(Number(cm.toFixed(2)));

/**
 * Width across the fabric by height along it. A centred cell has its rectangle, which repeats in
 * half-drop; a slanted one its base, its height, and the offset of the next row. A stripe has its
 * width only.
 */
export function repeatName(cell: Cell): string {
  const [a, b] = imageCell(cell);
  if (isStripe(cell)) return `${rounded(a[0])} cm`;
  const turned = Math.abs(a[0]) < Math.abs(a[1]); // the image's x runs along the warp
  const [across, up] = turned ? [b, a] : [a, b];
  const size = `${rounded(Math.abs(across[0]))} × ${rounded(Math.abs(up[1]))} cm`;
  if (cell.cell === 'rectangular') return `${size} half-drop`;
  return Math.abs(up[0]) > 1e-9 ? `${size}, ${rounded(up[0])} cm aside` : size;
}
