/** Groups of the user's own image, their positions in it, and its open edges. */
import {groupNames} from '../model/base/core-tables.js';
import {blobOf} from '../image/data-url.js';
import type {WholeCell} from '../image/tile-check.js';
import type {Pixels} from '../image/tile-fabric.js';
import {SolverError} from '../model/base/failure.js';
import {cross, norm} from '../model/geometry/vectors.js';
import type {
  OpenEdge,
  PhotoGroup,
  PhotoReading,
  PhotoRequest,
  TileSeams,
} from '../model/print/photo-reading.js';
import {type GroupName} from '../model/print/repeating-print.js';
import type {PrintTile, TileRepeat} from '../model/print/opened-image.js';
import type {RepeatSize} from '../model/print/repeat.js';
import {printElements} from '../model/print/wallpaper.js';
import type {SolverService} from '../solver/service.js';
import {stepOf, type PhotoStep} from '../photo/photo-step.js';
import {isVector, loadPicture, pixelsOf} from './picture-pixels.js';

export type ReadsPictures = Pick<SolverService, 'photo' | 'photoTile'>;

/** A group of an image: the whole image is a cell of it, or a cell has to be cut out. */
export type FoundGroup = WholeCell | CutCell;

export interface CutCell {
  readonly group: GroupName;
  readonly picture: Picture;
  /** The same step as from a reading in the photo dialog. */
  readonly cut: PhotoStep;
}

type Picture = PhotoRequest['picture'];

/** Caches the last result by its texts, since every group that is tried needs the same one. */
export function lastOf<T>(make: (...of: readonly string[]) => Promise<T>) {
  let last: {readonly key: string; readonly made: Promise<T>} | undefined;
  return (...of: readonly string[]): Promise<T> => {
    const key = of.join('\n');
    if (last?.key !== key) last = {key, made: make(...of)};
    return last.made;
  };
}

/** Returns the image of a cell at the small size used for comparison. */
export const pixelsIn = lastOf(async (image = ''): Promise<Pixels> =>
  pixelsOf(await loadPicture(image)),
);

interface ReadPicture {
  readonly picture: Picture;
  readonly reading: PhotoReading;
}

/** Longest side of a vector image for reading. [px] */
const vectorRead = 1024;

/** Number of cached images: the opened image and its cell. */
const mostKept = 2;
const kept = new Map<string, Promise<ReadPicture | undefined>>();

async function pictureOf(image: string): Promise<Picture> {
  if (image.startsWith('data:') && !isVector(image)) return blobOf(image);
  return pixelsOf(await loadPicture(image), vectorRead);
}

/**
 * Reads a seamless image once; undefined if nothing can be read from it, such as from a few pixels.
 */
function readOnce(solver: ReadsPictures, image: string): Promise<ReadPicture | undefined> {
  const known = kept.get(image);
  if (known) return known;
  const read = readNow(solver, image);
  kept.set(image, read);
  for (const old of [...kept.keys()].slice(0, -mostKept)) kept.delete(old);
  read.catch(() => kept.delete(image)); // the next call tries again
  return read;
}

async function readNow(solver: ReadsPictures, image: string): Promise<ReadPicture | undefined> {
  const picture = await pictureOf(image);
  try {
    return {picture, reading: await solver.photo({picture, isTile: true, anyEdges: true})};
  } catch (error) {
    if (error instanceof SolverError && error.reason !== undefined) return undefined;
    throw error;
  }
}

/** Returns the open edges that count for a repeat: straight, half-drop, brick or mirrored. */
function edgesIn({straight, halfDrop, brick}: TileSeams, repeat: TileRepeat): readonly OpenEdge[] {
  const only = (...sides: readonly OpenEdge['side'][]): readonly OpenEdge[] =>
    straight.filter(({side}) => sides.includes(side));
  switch (repeat) {
    case 'straight':
      return straight;
    case 'halfDrop':
      return halfDrop;
    case 'brick':
      return brick;
    case 'mirrored':
      return [];
    case 'mirroredAcross':
      return only('top', 'bottom');
    case 'mirroredUp':
      return only('left', 'right');
  }
}

const shut: TileSeams = {straight: [], halfDrop: [], brick: []};

const seamsOf = async (solver: ReadsPictures, image: string): Promise<TileSeams> =>
  (await readOnce(solver, image))?.reading.seams ?? shut;

/** Returns the edges at which an image does not continue in its copies. */
export async function openEdgesOf(
  solver: ReadsPictures,
  {image, repeat}: Pick<PrintTile, 'image' | 'repeat'>,
): Promise<readonly OpenEdge[]> {
  return edgesIn(await seamsOf(solver, image), repeat);
}

/** Returns the repeats that make an image seamless; a mirrored repeat always does. */
export async function closedRepeats(
  solver: ReadsPictures,
  image: string,
): Promise<readonly TileRepeat[]> {
  const seams = await seamsOf(solver, image);
  const closed = (repeat: TileRepeat): boolean => edgesIn(seams, repeat).length === 0;
  const mirrored = (['mirroredAcross', 'mirroredUp', 'mirrored'] as const).find(closed);
  return [...(['halfDrop', 'brick'] as const).filter(closed), mirrored ?? 'mirrored'];
}

/** Returns the direction in which edges are open. */
export const openPairs = (edges: readonly OpenEdge[]): 'across' | 'up' | 'both' => {
  const isAcross = edges.some(({side}) => side === 'left');
  const isUp = edges.some(({side}) => side === 'top');
  return isAcross && isUp ? 'both' : isAcross ? 'across' : 'up';
};

/** Returns the number of the group's smallest cells that the image shows. */
const copiesOf = ({width, height}: PhotoReading, {map}: PhotoGroup): number => {
  const [a, b, , c, d] = map.homography;
  return Math.round((width * height) / Math.abs(cross([a, c], [b, d])));
};

/** Returns whether the image shows one cell across its stripes; any cell is valid along them. */
function isOneStripe({width, height}: PhotoReading, {map}: PhotoGroup): boolean {
  const [a, , , c] = map.homography;
  const side = Math.abs(a) > Math.abs(c) ? width : height;
  return Math.abs(norm([a, c]) / side - 1) < 0.01;
}

const orderOf = (group: GroupName): number => printElements({group, w1: [1, 0], w2: [0, 1]}).length;

/** The group p1, which is valid for any image of a cell. */
const plain = (size: RepeatSize): WholeCell => ({
  ...{group: 'p1', turnDeg: 0, cell: 'primitive'},
  size,
});

/**
 * Returns the groups of a cell's image: first the group of the reading, then those with more
 * symmetries. The whole image is the cell wherever possible.
 * @param size size of the image [cm]
 * @param mayCut true if a cell may be cut out of it
 */
export async function groupsIn(
  solver: ReadsPictures,
  image: string,
  size: RepeatSize,
  mayCut: boolean,
): Promise<readonly FoundGroup[]> {
  const [read, {wholeCell}, pixels] = await Promise.all([
    readOnce(solver, image),
    import('../image/tile-check.js'),
    pixelsIn(image),
  ]);
  if (!read) return [plain(size)];
  const {picture, reading} = read;
  const between = {from: [0, 0], to: [reading.width, 0], cm: size.width} as const;
  const found = reading.groups
    .filter(({verdict}) => verdict === 'has')
    .sort(
      (a, b) =>
        Number(b.name === reading.group) - Number(a.name === reading.group) ||
        orderOf(b.name) - orderOf(a.name) ||
        groupNames.indexOf(a.name) - groupNames.indexOf(b.name),
    )
    .flatMap((group): readonly FoundGroup[] => {
      const {name} = group;
      const isFree = reading.stripes && isOneStripe(reading, group);
      const whole = wholeCell(pixels, name, size, isFree ? undefined : copiesOf(reading, group));
      if (whole) return [whole];
      const cut = {...stepOf(reading), between, chosen: name};
      return mayCut ? [{group: name, cut, picture}] : [];
    });
  return found.length > 0 ? found : [plain(size)];
}
