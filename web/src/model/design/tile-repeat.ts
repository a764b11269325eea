/** Repeats of the user's own image, and its measurements. */
import type {DesignPrint} from './design.js';
import type {PrintTile, TileRepeat} from '../print/opened-image.js';
import {coupledSize, type RepeatSize} from '../print/repeat.js';

/** Number of copies of the image in one cell of the print, across and up. */
export const copiesIn: Readonly<Record<TileRepeat, readonly [across: number, up: number]>> = {
  straight: [1, 1],
  halfDrop: [2, 1],
  brick: [1, 2],
  mirrored: [2, 2],
  mirroredAcross: [2, 1],
  mirroredUp: [1, 2],
};

/** The user's own image, and its size and turn on the fabric. */
export interface OwnPicture extends Omit<PrintTile, 'turnedDeg'> {
  readonly title: string;
  /** Size of the image itself. */
  readonly size: RepeatSize;
  /** Turn, counter-clockwise. [degrees] */
  readonly turnDeg: number;
  readonly unscaled?: boolean;
}

type Measured = Pick<DesignPrint, 'size' | 'turnDeg' | 'tile'>;

const swapped = ({width, height, angleDeg}: RepeatSize): RepeatSize => ({
  ...{width: height, height: width, angleDeg},
});

/** Sides of the opened image, or of the cell if there is none. [cm] */
export function tileSize({size, tile}: Pick<Measured, 'size' | 'tile'>): RepeatSize {
  if (!tile) return size;
  const [across, up] = copiesIn[tile.repeat];
  const upright = tile.turnedDeg === 0 ? size : swapped(size);
  return {...upright, width: upright.width / across, height: upright.height / up};
}

/** The inverse of `tileSize`. */
export function cellSize({tile}: Pick<Measured, 'tile'>, size: RepeatSize): RepeatSize {
  if (!tile) return size;
  const [across, up] = copiesIn[tile.repeat];
  const upright = {...size, width: size.width * across, height: size.height * up};
  return tile.turnedDeg === 0 ? upright : swapped(upright);
}

/** The same print with a measured size of its image, adjusted to its group. [cm] */
export const resized = (print: DesignPrint, size: RepeatSize): DesignPrint => ({
  ...print,
  own: undefined,
  size: coupledSize(print.group, cellSize(print, size)),
  ...(print.unscaled && {unscaled: false}),
});

/** Turn of the opened image, in (-180, 180]. [degrees] */
export function tileTurn({turnDeg, tile}: Pick<Measured, 'turnDeg' | 'tile'>): number {
  const turn = turnDeg - (tile?.turnedDeg ?? 0);
  return turn <= -180 ? turn + 360 : turn;
}

/** The image from which a print was made. */
export const pictureIn = (print: DesignPrint): OwnPicture => ({
  title: print.title,
  image: print.tile?.image ?? print.image,
  repeat: print.tile?.repeat ?? 'straight',
  size: tileSize(print),
  turnDeg: tileTurn(print),
  ...(print.unscaled && {unscaled: true}),
});

/** The inverse of `tileTurn`. */
export function cellTurn({tile}: Pick<Measured, 'tile'>, turnDeg: number): number {
  const turn = turnDeg + (tile?.turnedDeg ?? 0);
  return turn > 180 ? turn - 360 : turn;
}
