/** Reads what somebody hands over as a print: a print file, or the picture of one cell. */
import {noPicture, type DesignPrint} from '../../model/design.js';
import type {Point} from '../../model/geometry.js';
import {
  groupNames,
  printCells,
  type GroupName,
  type Print,
  type PrintCell,
} from '../../model/print.js';
import {latticeVectors, repeatOf} from '../../model/repeat.js';
import type {OwnPicture} from '../../model/tile-repeat.js';
import {en, type Texts} from '../../texts/en.js';
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import {sizeInFile} from './file-size.js';
import {openEdgesOf, openPairs, printOfPicture} from './own-print.js';
import {OpenEdgesError} from './print-files.js';
import {looksLikePicture, readPicture} from './read-picture.js';

/** No print file is longer. [bytes] */
const mostBytes = 12 * 2 ** 20;
/** How wide a picture is until its file or somebody says so. [cm] */
export const firstWidth = 10;

type Words = Texts['print']['files'];

/** Reads a picture as it is opened: straight, and as large as its file says. @throws {Error} with one sentence */
async function readOwnPicture(file: File, words: Words): Promise<OwnPicture> {
  const {image, width, height} = await readPicture(file, words);
  const said = await sizeInFile(image);
  const across = said?.width ?? firstWidth;
  return {
    ...{title: file.name.replace(/\.[^.]*$/, ''), image, repeat: 'straight', turnDeg: 0},
    size: {width: across, height: (across * height) / width, angleDeg: 90},
  };
}

/**
 * A print as a design holds it. A picture gets the group with most symmetries that it has. A print file names
 * its picture, which cannot be read from here: until that is opened, too, the cloth is bare.
 * @throws {Error} with one sentence that says what is wrong
 */
export async function readPrintFile(
  file: File,
  words: Words = en.print.files,
): Promise<DesignPrint> {
  if (await looksLikePicture(file)) return printOfPicture(await readOwnPicture(file, words));
  if (file.size > mostBytes) throw new Error(words.tooLarge(file.name));
  return printFrom(await file.text(), file.name, words);
}

/**
 * Reads a print and shows the design on it. The picture of a print that waits for its own becomes that.
 * One that does not meet its copies is left for somebody to decide about.
 * @throws {Error} with one sentence that says what is wrong; the print stays as it is
 */
export async function openPrint(workbench: Workbench, file: File): Promise<void> {
  const {language, messages} = workbench.preferences;
  const words = textsOf(language, messages).print.files;
  const present = workbench.design?.print;
  workbench.doubtful = undefined;
  if (!(await looksLikePicture(file))) {
    workbench.change({print: await readPrintFile(file, words)});
    return;
  }
  const own = await readOwnPicture(file, words);
  if (present?.image === noPicture && !present.sample) {
    workbench.change({print: {...present, image: own.image}});
    return;
  }
  const edges = await openEdgesOf(own);
  if (edges.length > 0) {
    if (present) workbench.doubtful = {own, edges, beside: present};
    throw new OpenEdgesError(words.openEdges[openPairs(edges)](file.name));
  }
  workbench.change({print: await printOfPicture(own)});
}

/** @throws {Error} */
export function printFrom(text: string, name: string, words: Words): DesignPrint {
  const print = parsed(text);
  const {group, w1, w2} = print;
  if (isPattern(print)) throw new Error(words.pattern(name));
  if (!isGroup(group) || !isPoint(w1) || !isPoint(w2)) throw new Error(words.noPrint(name));
  const cell = isCell(print.cell) ? print.cell : 'primitive';
  const repeat = repeatOf({group, w1, w2, cell});
  const again = latticeVectors(group, repeat.size, repeat.turnDeg, cell);
  const off = [w1, w2].map(([x, y], k) =>
    Math.hypot(x - (again[k]?.[0] ?? 0), y - (again[k]?.[1] ?? 0)),
  );
  // also false where they are no numbers at all, as of vectors without a length
  if (!(Math.max(...off) < 0.001 * Math.hypot(...w1)) || repeat.size.angleDeg <= 0) {
    throw new Error(words.wrongLattice(name, group));
  }
  const {title, oneWay, image} = print;
  return {
    title: typeof title === 'string' ? title : name.replace(/\.[^.]*$/, ''),
    ...{group, ...repeat, oneWay: oneWay === true},
    cell,
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

const isCell = (value: unknown): value is PrintCell =>
  (printCells as readonly unknown[]).includes(value);

/** A sewing pattern has its pieces here, or says so. */
const isPattern = (file: object): boolean =>
  'pattern' in file ||
  'panels' in file ||
  String(Reflect.get(file, 'format')).startsWith('seamwise-garment/');

const isPoint = (value: unknown): value is Point =>
  Array.isArray(value) && value.length === 2 && value.every((one) => Number.isFinite(one));
