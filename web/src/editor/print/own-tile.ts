/** Reads what somebody hands over as a print: a print file, or the picture of one cell. */
import {noPicture, type DesignPrint} from '../../model/design.js';
import {distance, norm} from '../../model/geometry.js';
import type {Print} from '../../model/print.js';
import {readPrintFile} from '../../model/print-file.js';
import {fieldOf} from '../../model/read.js';
import {latticeVectors, repeatOf} from '../../model/repeat.js';
import type {OwnPicture} from '../../model/tile-repeat.js';
import {FileError} from '../../model/versioned-file.js';
import {en, type Texts} from '../../texts/en.js';
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import {sizeInFile} from './file-size.js';
import {openEdgesOf, openPairs, type ReadsPictures} from './own-groups.js';
import {printOfPicture} from './own-print.js';
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
export async function readPrint(
  solver: ReadsPictures,
  file: File,
  words: Words = en.print.files,
): Promise<DesignPrint> {
  if (await looksLikePicture(file))
    return printOfPicture(solver, await readOwnPicture(file, words));
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
    workbench.change({print: await readPrint(workbench.solver, file, words)});
    return;
  }
  const own = await readOwnPicture(file, words);
  if (present?.image === noPicture && !present.sample) {
    workbench.change({print: {...present, image: own.image}});
    return;
  }
  const edges = await openEdgesOf(workbench.solver, own);
  if (edges.length > 0) {
    if (present) workbench.doubtful = {own, edges, beside: present};
    throw new OpenEdgesError(words.openEdges[openPairs(edges)](file.name));
  }
  workbench.change({print: await printOfPicture(workbench.solver, own)});
}

/** @throws {Error} */
export function printFrom(text: string, name: string, words: Words): DesignPrint {
  const {
    title,
    group,
    w1,
    w2,
    cell = 'primitive',
    oneWay = false,
    image,
    unscaled,
  } = read(text, name, words);
  const repeat = repeatOf({group, w1, w2, cell});
  const again = latticeVectors(group, repeat.size, repeat.turnDeg, cell);
  const off = Math.max(distance(w1, again[0]), distance(w2, again[1]));
  // also false where they are no numbers at all, as of vectors without a length
  if (!(off < 0.001 * norm(w1)) || repeat.size.angleDeg <= 0) {
    throw new Error(words.wrongLattice(name, group));
  }
  return {
    title: typeof title === 'string' ? title : name.replace(/\.[^.]*$/, ''),
    ...{group, ...repeat, oneWay, cell, ...(unscaled && {unscaled})},
    image: image?.startsWith('data:image/') ? image : noPicture,
  };
}

function read(text: string, name: string, words: Words): Print {
  try {
    return readPrintFile(text, name);
  } catch (cause) {
    if (!(cause instanceof FileError)) throw cause;
    throw new Error(isPattern(text) ? words.pattern(name) : words.noPrint(name), {cause});
  }
}

/** A sewing pattern has its pieces here, or says so. */
function isPattern(text: string): boolean {
  try {
    const file: unknown = JSON.parse(text);
    const has = (field: string): boolean => fieldOf(file, field) !== undefined;
    const isOwn = String(fieldOf(file, 'format')).startsWith('seamwise-garment/');
    return has('pattern') || has('panels') || isOwn;
  } catch {
    return false;
  }
}
