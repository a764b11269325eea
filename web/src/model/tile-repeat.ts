/** How a picture of somebody's own repeats, and what is measured of it. */
import type {DesignPrint} from './design.js';
import type {PrintTile, TileRepeat} from './print-tile.js';
import {coupledSize, type RepeatSize} from './repeat.js';

/** How often the picture stands beside and above itself in one cell of the print. */
export const copiesIn: Readonly<Record<TileRepeat, readonly [across: number, up: number]>> = {
  straight: [1, 1],
  halfDrop: [2, 1],
  brick: [1, 2],
  mirrored: [2, 2],
  mirroredAcross: [2, 1],
  mirroredUp: [1, 2],
};

/** A picture that somebody opened, and how it lies on the cloth. */
export interface OwnPicture extends Omit<PrintTile, 'turnedDeg'> {
  readonly title: string;
  /** Of the picture itself. */
  readonly size: RepeatSize;
  /** Counter-clockwise. [degrees] */
  readonly turnDeg: number;
  readonly unscaled?: boolean;
}

type Measured = Pick<DesignPrint, 'size' | 'turnDeg' | 'tile'>;

const swapped = ({width, height, angleDeg}: RepeatSize): RepeatSize => ({
  ...{width: height, height: width, angleDeg},
});

/** The sides of the picture that was opened, or of the cell where that is what was opened. [cm] */
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

/** The same picture, of a size on the cloth that is known from then on, as its group demands it. [cm] */
export const resized = (print: DesignPrint, size: RepeatSize): DesignPrint => ({
  ...print,
  size: coupledSize(print.group, cellSize(print, size)),
  ...(print.unscaled && {unscaled: false}),
});

/** The turn of the picture that was opened, above -180 degrees, up to 180. */
export function tileTurn({turnDeg, tile}: Pick<Measured, 'turnDeg' | 'tile'>): number {
  const turn = turnDeg - (tile?.turnedDeg ?? 0);
  return turn <= -180 ? turn + 360 : turn;
}

/** What an own print was made of. */
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
