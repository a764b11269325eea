/** Somebody's own picture as a print: what groups it has, and what becomes of it in each. */
import type {DesignPrint} from '../../model/design.js';
import {coupledSize, type FittingGroup, type RepeatSize} from '../../model/repeat.js';
import {latticeType} from '../../model/wallpaper.js';
import type {FoundGroup, TileCheck} from '../../picture/tile-check.js';
import type {Pixels} from '../../picture/tile-cloth.js';
import {alongStripe, groupOf, turnsOver, type Choice} from './choices.js';
import {loadPicture, pixelsOf, quarterTurned} from './picture.js';

interface Looked {
  readonly image: string;
  readonly pixels: Promise<Pixels>;
  /** Those it has, with the sizes of a cell that is 1 cm wide. */
  readonly groups: Promise<readonly FoundGroup[]>;
}

let last: Looked | undefined;

/** The last picture is kept, since it is looked at again with every group that is tried. */
function lookedAt(image: string): Looked {
  if (last?.image !== image) {
    const pixels = loadPicture(image).then(pixelsOf);
    const groups = Promise.all([import('../../picture/tile-check.js'), pixels]).then(
      ([{groupsOf}, known]) => groupsOf(known, rectangle(1, known)),
    );
    last = {image, pixels, groups};
  }
  return last;
}

/** Compares the picture of a print with itself under its group. */
export async function checked({image, group, size, cell}: DesignPrint): Promise<TileCheck> {
  const [{checkTile}, pixels] = await Promise.all([
    import('../../picture/tile-check.js'),
    lookedAt(image).pixels,
  ]);
  return checkTile(pixels, group, size, cell);
}

/** Groups that a picture has, the one with most symmetries first, when its cell is so wide. [cm] */
export async function groupsIn(image: string, width: number): Promise<readonly FoundGroup[]> {
  const groups = await lookedAt(image).groups;
  return groups.map((found) => {
    const {width: across, height: up, angleDeg} = found.size;
    return {...found, size: {width: across * width, height: up * width, angleDeg}};
  });
}

const rectangle = (width: number, pixels: Pixels): RepeatSize => ({
  width,
  height: (width * pixels.height) / pixels.width,
  angleDeg: 90,
});

/** With another group on the same cloth, which looks as before. A picture that has to be turned is an own one. */
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

/** With a group that its picture has. */
export const withFound = async (print: DesignPrint, found: FoundGroup): Promise<DesignPrint> => ({
  ...(await withGroup(print, found)),
  oneWay: !turnsOver(found.group),
});

/** As a group that it may not have: the whole picture is the cell, and is stretched where the group demands it. */
export async function ownPrintAs(print: DesignPrint, choice: Choice): Promise<DesignPrint> {
  const group = groupOf(choice);
  const {width} = print.size;
  if (choice !== 'stripes') {
    const found = (await groupsIn(print.image, width)).find((one) => one.group === group);
    if (found) return withFound(print, found);
  }
  const size = rectangle(width, await lookedAt(print.image).pixels);
  const centred = ['rhombic', 'hexagonal'].includes(latticeType(group));
  return {
    ...print,
    group,
    size: coupledSize(group, choice === 'stripes' ? {...size, height: alongStripe} : size),
    oneWay: !turnsOver(group),
    cell: centred ? 'rectangular' : 'primitive',
  };
}
