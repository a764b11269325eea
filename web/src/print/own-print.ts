/** The user's own image as a print: its groups, and the print in each of them. */
import type {DesignPrint} from '../model/design/design.js';
import {
  coupledSize,
  alongStripe,
  turnsOver,
  wrappedTurn,
  type FittingGroup,
  type RepeatSize,
} from '../model/print/repeat.js';
import {cellTurn, copiesIn, pictureIn, type OwnPicture} from '../model/design/tile-repeat.js';
import type {PrintTile, TileRepeat} from '../model/print/opened-image.js';
import {isCentred} from '../model/print/wallpaper.js';
import {dataUrlOf} from '../image/data-url.js';
import type {TileCheck, WholeCell} from '../image/tile-check.js';
import type {Pixels} from '../image/tile-fabric.js';
import {cellPicture, pngOf} from '../photo/photo-picture.js';
import {measuresOf, tileSettings} from '../photo/photo-step.js';
import {groupOf, type Choice} from './group-choice.js';
import {
  groupsIn,
  lastOf,
  pixelsIn,
  type CutCell,
  type FoundGroup,
  type ReadsPictures,
} from './own-groups.js';
import {arranged, loadPicture, pixelsOf, quarterTurned} from './picture-pixels.js';

const cellOfOwn = lastOf((image = '', repeat = '') => arranged(image, repeat as TileRepeat));
const tilePixels = lastOf(async (image = '') => pixelsOf(await loadPicture(image)));

/** Compares the image of a print with itself under its group. */
export async function checked({image, group, size, cell}: DesignPrint): Promise<TileCheck> {
  const [{checkTile}, pixels] = await Promise.all([
    import('../image/tile-check.js'),
    pixelsIn(image),
  ]);
  return checkTile(pixels, group, size, cell);
}

/** Returns the pixels of the image that the user opened. */
export const pixelsOfTile = ({image}: Pick<OwnPicture, 'image'>): Promise<Pixels> =>
  tilePixels(image);

/** Returns the size of the upright cell of an own image, in the image's own proportions. [cm] */
async function uprightSize({image, repeat, size}: OwnPicture): Promise<RepeatSize> {
  const [across, up] = copiesIn[repeat];
  const {width, height} = await tilePixels(image);
  const tall = (size.width * height) / width;
  return {width: across * size.width, height: up * tall, angleDeg: 90};
}

/** Returns the groups of an own image with its repeat, as `groupsIn` sorts them. */
export async function groupsOfOwn(
  solver: ReadsPictures,
  own: OwnPicture,
): Promise<readonly FoundGroup[]> {
  const [image, size] = await Promise.all([cellOfOwn(own.image, own.repeat), uprightSize(own)]);
  // no cell is cut out for other repeats, which keep the opened image
  return groupsIn(solver, image, size, own.repeat === 'straight');
}

/** Returns an image as a print, in the first group that it has. */
export async function printOfPicture(solver: ReadsPictures, own: OwnPicture): Promise<DesignPrint> {
  const [found] = await groupsOfOwn(solver, own);
  if (!found) throw new Error('A picture has at least the group p1.');
  return asFound(solver, own, found);
}

/** Returns the image of a print's cell, made from the image that the user opened. */
export async function pictureOfTile({image, repeat, turnedDeg}: PrintTile): Promise<string> {
  const upright = await cellOfOwn(image, repeat);
  return turnedDeg === 90 ? quarterTurned(upright) : upright;
}

/** Returns an own image as a print, in one of its groups. */
const asFound = (
  solver: ReadsPictures,
  own: OwnPicture,
  found: FoundGroup,
): Promise<DesignPrint> => ('cut' in found ? asCut(solver, own, found) : asWhole(own, found));

async function asWhole(
  own: OwnPicture,
  {group, size, cell, turnDeg}: WholeCell,
): Promise<DesignPrint> {
  const tile: PrintTile = {image: own.image, repeat: own.repeat, turnedDeg: turnDeg};
  const isAsOpened = turnDeg === 0 && own.repeat === 'straight';
  return {
    title: own.title,
    ...{group, size, cell, oneWay: !turnsOver(group)},
    turnDeg: cellTurn({tile}, own.turnDeg),
    image: await pictureOfTile(tile),
    ...(!isAsOpened && {tile}),
    ...(own.unscaled && {unscaled: true}),
  };
}

/**
 * Returns a print of one cell cut out of the image, with the same appearance as the whole image.
 */
async function asCut(
  solver: ReadsPictures,
  own: OwnPicture,
  {cut, picture}: CutCell,
): Promise<DesignPrint> {
  const measures = measuresOf(cut);
  const tile = await solver.photoTile({...tileSettings(cut), isTile: true, picture});
  return {
    title: own.title,
    ...measures,
    turnDeg: wrappedTurn(measures.turnDeg + own.turnDeg),
    image: await dataUrlOf(await pngOf(cellPicture(tile, measures))),
    ...(own.unscaled && {unscaled: true}),
  };
}

/**
 * Sets a smaller group without a change in appearance. A print whose image is turned becomes the
 * user's own.
 */
export async function withGroup(
  print: DesignPrint,
  {group, size, cell, turnDeg}: FittingGroup,
): Promise<DesignPrint> {
  if (turnDeg === 0) return {...print, group, size, cell};
  const {title, oneWay, isPrinted} = print;
  const image = await quarterTurned(print.image);
  const turned = print.turnDeg > 90 ? print.turnDeg - 270 : print.turnDeg + 90;
  const own = {title, oneWay, group, size, cell, image, turnDeg: turned};
  return {...own, ...(isPrinted && {isPrinted})};
}

/** Keeps what is known of the file if the image stays the same. */
const inPlaceOf = (print: DesignPrint, found: DesignPrint): DesignPrint => {
  if (found.image === print.image && !found.tile && !print.tile) return {...print, ...found};
  return {...found, ...(print.isPrinted && {isPrinted: true})};
};

/** Returns the print with a group that its image has. */
export const withFound = async (
  solver: ReadsPictures,
  print: DesignPrint,
  found: FoundGroup,
): Promise<DesignPrint> => inPlaceOf(print, await asFound(solver, pictureIn(print), found));

/**
 * Returns the print with a group that its image may not have. The whole image is the cell, and is
 * stretched if the group requires it.
 */
export async function ownPrintAs(
  solver: ReadsPictures,
  print: DesignPrint,
  choice: Choice,
): Promise<DesignPrint> {
  const group = groupOf(choice);
  const own = pictureIn(print);
  if (choice !== 'stripes') {
    const found = (await groupsOfOwn(solver, own)).find((one) => one.group === group);
    if (found) return withFound(solver, print, found);
  }
  const size = await uprightSize(own);
  const made = await asWhole(own, {
    ...{group, turnDeg: 0, cell: isCentred(group) ? 'rectangular' : 'primitive'},
    size: coupledSize(group, choice === 'stripes' ? {...size, height: alongStripe} : size),
  });
  return inPlaceOf(print, made);
}
