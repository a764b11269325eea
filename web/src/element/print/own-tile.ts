/** Reads what somebody hands over as a print: a print file, or the picture of one cell. */
import {noPicture, type DesignPrint} from '../../model/design.js';
import {groupNames, type GroupName, type Print} from '../../model/print.js';
import {latticeVectors, repeatOf} from '../../model/repeat.js';
import type {Point} from '../../model/geometry.js';
import {hasOutsidePictures} from '../../picture/svg.js';
import {en, type Texts} from '../texts/en.js';
import {textsOf} from '../texts/texts.js';
import type {Workbench} from '../workbench/workbench.js';
import {groupsIn, withFound} from './own-print.js';
import {loadPicture} from './picture.js';

const mostBytes = 12 * 2 ** 20;
/** Longest side. [px] */
const mostPixels = 8192;
/** How wide the cell of a picture is until somebody has measured it. [cm] */
const firstWidth = 10;

const pictureTypes: Readonly<Record<string, string>> = {
  png: 'image/png',
  jpg: 'image/jpeg',
  jpeg: 'image/jpeg',
  webp: 'image/webp',
  svg: 'image/svg+xml',
};

/** What a file picker is to offer. */
export const printFiles = `.json,${Object.keys(pictureTypes)
  .map((ending) => `.${ending}`)
  .join()}`;

const pictureType = ({name, type}: File): string | undefined =>
  Object.values(pictureTypes).find((one) => one === type) ??
  pictureTypes[name.slice(name.lastIndexOf('.') + 1).toLowerCase()];

type Words = Texts['print']['files'];

/**
 * A print as a design holds it. A picture gets the group with most symmetries that it has. A print file names
 * its picture, which cannot be read from here: until that is opened, too, the cloth is bare.
 * @throws {Error} with one sentence that says what is wrong
 */
export async function readPrintFile(
  file: File,
  words: Words = en.print.files,
): Promise<DesignPrint> {
  if (file.size > mostBytes) throw new Error(words.tooLarge(file.name));
  const type = pictureType(file);
  if (type) return readPicture(file, type, words);
  return printFrom(await file.text(), file.name, words);
}

/** Reads a print and shows the design on it. The picture of a print that waits for its own becomes that. */
export async function openPrint(desk: Workbench, file: File): Promise<void> {
  const read = await readPrintFile(file, textsOf(desk.preferences.language).print.files);
  const present = desk.design?.print;
  const waits = present?.image === noPicture && pictureType(file) !== undefined;
  desk.change({print: waits ? {...present, image: read.image} : read});
}

async function readPicture(file: File, type: string, words: Words): Promise<DesignPrint> {
  if (type === pictureTypes.svg && hasOutsidePictures(await file.text())) {
    throw new Error(words.outsidePictures(file.name));
  }
  const image = await dataUrl(new Blob([file], {type}));
  const picture = await loadPicture(image).catch(() => {
    throw new Error(words.unreadable(file.name));
  });
  const {naturalWidth, naturalHeight} = picture;
  if (Math.max(naturalWidth, naturalHeight) > mostPixels) throw new Error(words.tooWide(file.name));
  const height = (firstWidth * naturalHeight) / naturalWidth;
  const print: DesignPrint = {
    title: file.name.replace(/\.[^.]*$/, ''),
    group: 'p1',
    size: {width: firstWidth, height, angleDeg: 90},
    turnDeg: 0,
    oneWay: true,
    cell: 'primitive',
    image,
  };
  const [found] = await groupsIn(image, firstWidth);
  return found ? withFound(print, found) : print;
}

function dataUrl(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => {
      resolve(typeof reader.result === 'string' ? reader.result : '');
    });
    reader.addEventListener('error', () => {
      reject(new Error(reader.error?.message));
    });
    reader.readAsDataURL(blob);
  });
}

/** @throws {Error} */
export function printFrom(text: string, name: string, words: Words): DesignPrint {
  const print = parsed(text);
  const {group, w1, w2} = print;
  if (!isGroup(group) || !isPoint(w1) || !isPoint(w2)) throw new Error(words.noPrint(name));
  const repeat = repeatOf({group, w1, w2});
  const again = latticeVectors(group, repeat.size, repeat.turnDeg);
  const off = [w1, w2].map(([x, y], k) =>
    Math.hypot(x - (again[k]?.[0] ?? 0), y - (again[k]?.[1] ?? 0)),
  );
  // also false where they are no numbers at all, as of vectors without a length
  if (!(Math.max(...off) < 0.001 * Math.hypot(...w1)) || repeat.size.angleDeg <= 0) {
    throw new Error(words.wrongLattice(name, group));
  }
  const {title, oneWay, cell, image} = print;
  return {
    title: typeof title === 'string' ? title : name.replace(/\.[^.]*$/, ''),
    ...{group, ...repeat, oneWay: oneWay === true},
    cell: cell === 'rectangular' ? cell : 'primitive',
    image: typeof image === 'string' && image.startsWith('data:image/') ? image : noPicture,
  };
}

function parsed(text: string): {readonly [Field in keyof Print]?: unknown} {
  try {
    return Object(JSON.parse(text)) as Record<string, unknown>;
  } catch {
    return {};
  }
}

const isGroup = (value: unknown): value is GroupName =>
  (groupNames as readonly unknown[]).includes(value);

const isPoint = (value: unknown): value is Point =>
  Array.isArray(value) && value.length === 2 && value.every((one) => Number.isFinite(one));
