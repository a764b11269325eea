/** Somebody's own picture as a print: what groups it has, and what becomes of it in each. */
import type {DesignPrint} from '../../model/design.js';
import {coupledSize, type FittingGroup, type RepeatSize} from '../../model/repeat.js';
import {cellTurn, copiesIn, pictureIn, type OwnPicture} from '../../model/tile-repeat.js';
import type {PrintTile, TileRepeat} from '../../model/print-tile.js';
import {latticeType} from '../../model/wallpaper.js';
import type {FoundGroup, TileCheck} from '../../recognition/tile-check.js';
import type {OpenEdge} from '../../recognition/tile-edges.js';
import type {Pixels} from '../../recognition/tile-cloth.js';
import {alongStripe, groupOf, turnsOver, type Choice} from './choices.js';
import {arranged, loadPicture, pixelsOf, quarterTurned} from './picture.js';

/** The last of what was made of a text; it is asked for again with every group that is tried. */
function lastOf<T>(make: (...of: readonly string[]) => Promise<T>) {
  let last: {readonly key: string; readonly made: Promise<T>} | undefined;
  return (...of: readonly string[]): Promise<T> => {
    const key = of.join('\n');
    if (last?.key !== key) last = {key, made: make(...of)};
    return last.made;
  };
}

const pixelsIn = lastOf(async (image = '') => pixelsOf(await loadPicture(image)));
const cellPicture = lastOf((image = '', repeat = '') => arranged(image, repeat as TileRepeat));
const tilePixels = lastOf(async (image = '') => pixelsOf(await loadPicture(image)));

/** Of a cell whose height is that share of its width; sizes are of a cell that is 1 cm wide. */
const groupsOfShape = lastOf(async (image = '', share = '') => {
  const [{groupsOf}, pixels] = await Promise.all([
    import('../../recognition/tile-check.js'),
    pixelsIn(image),
  ]);
  return groupsOf(pixels, {width: 1, height: Number(share), angleDeg: 90});
});

/** Compares the picture of a print with itself under its group. */
export async function checked({image, group, size, cell}: DesignPrint): Promise<TileCheck> {
  const [{checkTile}, pixels] = await Promise.all([
    import('../../recognition/tile-check.js'),
    pixelsIn(image),
  ]);
  return checkTile(pixels, group, size, cell);
}

/** The pixels of the picture that somebody opened. */
export const pixelsOfTile = ({image}: Pick<OwnPicture, 'image'>): Promise<Pixels> =>
  tilePixels(image);

/** Where a picture does not meet its copies. */
export async function openEdgesOf(own: Pick<OwnPicture, 'image' | 'repeat'>) {
  const [{openEdges}, pixels] = await Promise.all([
    import('../../recognition/tile-edges.js'),
    pixelsOfTile(own),
  ]);
  return openEdges(pixels, own.repeat);
}

/** The ways to repeat a picture that let it meet its copies; mirrored, all do. */
export async function closedRepeats({
  image,
}: Pick<OwnPicture, 'image'>): Promise<readonly TileRepeat[]> {
  const [{openEdges}, pixels] = await Promise.all([
    import('../../recognition/tile-edges.js'),
    pixelsOfTile({image}),
  ]);
  const shifted = (['halfDrop', 'brick'] as const).filter(
    (repeat) => openEdges(pixels, repeat).length === 0,
  );
  const open = new Set(openEdges(pixels).map(({side}) => side));
  const mirrored = !open.has('top')
    ? 'mirroredAcross'
    : !open.has('left')
      ? 'mirroredUp'
      : 'mirrored';
  return [...shifted, mirrored];
}

/** Which of the edges of a picture do not meet. */
export const openPairs = (edges: readonly OpenEdge[]): 'across' | 'up' | 'both' => {
  const isAcross = edges.some(({side}) => side === 'left');
  const isUp = edges.some(({side}) => side === 'top');
  return isAcross && isUp ? 'both' : isAcross ? 'across' : 'up';
};

/** Of the upright cell of an own picture, in the picture's own proportions. [cm] */
async function uprightSize({image, repeat, size}: OwnPicture): Promise<RepeatSize> {
  const [across, up] = copiesIn[repeat];
  const {width, height} = await tilePixels(image);
  const tall = (size.width * height) / width;
  return {width: across * size.width, height: up * tall, angleDeg: 90};
}

/** Groups that an own picture has as it is repeated, the one with most symmetries first. */
export async function groupsIn(own: OwnPicture): Promise<readonly FoundGroup[]> {
  const [cell, {width, height}] = await Promise.all([
    cellPicture(own.image, own.repeat),
    uprightSize(own),
  ]);
  const groups = await groupsOfShape(cell, String(height / width));
  return groups.map((found) => {
    const {width: across, height: along, angleDeg} = found.size;
    return {...found, size: {width: across * width, height: along * width, angleDeg}};
  });
}

/** A picture as a print, in the group with most symmetries that it has. */
export async function printOfPicture(own: OwnPicture): Promise<DesignPrint> {
  const [found] = await groupsIn(own);
  if (!found) throw new Error('A picture has at least the group p1.');
  return asFound(own, found);
}

/** The picture of a print's cell, made of the one that somebody opened. */
export async function pictureOfTile({image, repeat, turnedDeg}: PrintTile): Promise<string> {
  const upright = await cellPicture(image, repeat);
  return turnedDeg === 90 ? quarterTurned(upright) : upright;
}

/** An own picture in a group that it has. */
async function asFound(
  own: OwnPicture,
  {group, size, cell, turnDeg}: FoundGroup,
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

/** With a smaller group on the same cloth, which looks as before. A picture that has to be turned is an own one. */
export async function withGroup(
  print: DesignPrint,
  {group, size, cell, turnDeg}: FittingGroup,
): Promise<DesignPrint> {
  if (turnDeg === 0) return {...print, group, size, cell};
  const {title, oneWay} = print;
  const image = await quarterTurned(print.image);
  const turned = print.turnDeg > 90 ? print.turnDeg - 270 : print.turnDeg + 90;
  return {title, oneWay, group, size, cell, image, turnDeg: turned};
}

/** Where the picture stays the same, so does what is known of its file. */
const inPlaceOf = (print: DesignPrint, found: DesignPrint): DesignPrint => {
  if (found.image !== print.image || found.tile || print.tile) return found;
  return {...print, ...found};
};

/** With a group that its picture has. */
export const withFound = async (print: DesignPrint, found: FoundGroup): Promise<DesignPrint> =>
  inPlaceOf(print, await asFound(pictureIn(print), found));

/** As a group that it may not have: the whole picture is the cell, and is stretched where the group demands it. */
export async function ownPrintAs(print: DesignPrint, choice: Choice): Promise<DesignPrint> {
  const group = groupOf(choice);
  const own = pictureIn(print);
  if (choice !== 'stripes') {
    const found = (await groupsIn(own)).find((one) => one.group === group);
    if (found) return withFound(print, found);
  }
  const size = await uprightSize(own);
  const centred = ['rhombic', 'hexagonal'].includes(latticeType(group));
  const made = await asFound(own, {
    ...{group, turnDeg: 0, worst: 0, cell: centred ? 'rectangular' : 'primitive'},
    size: coupledSize(group, choice === 'stripes' ? {...size, height: alongStripe} : size),
  });
  return inPlaceOf(print, made);
}
