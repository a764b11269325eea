/** Opens a drawing of another program with the choices of the user. */
import {drawingName} from '../../model/garment/imported-drawing.js';
import {spokenFailure} from '../../workbench/spoken-failure.js';
import {textsOf} from '../../texts/texts.js';
import {toFailure} from '../../workbench/latest-solve.js';
import type {Workbench} from '../../workbench/workbench.js';
import {shortened} from '../../model/documents/project-name.js';
import {importTexts, saidRefusal} from '../../texts/import-texts.js';
import {WorkerComplaint} from '../worker/ask.js';
import {ImportSheet, type FileUse} from './import-sheet.js';
import {drawingIn, type ShownDrawing} from './reading.js';

/** Target of an opened drawing. */
export interface DrawingPlace {
  readonly workbench: Workbench;
  /** Container of dialogs. */
  readonly root: HTMLElement | DocumentFragment;
}

const tag = 'sw-import-sheet';
/** Delay before a notice about reading appears. [ms] */
const patience = 400;

/** Returns the page's only import dialog, with texts in the user's language. */
async function sheetIn({root, workbench}: DrawingPlace): Promise<ImportSheet> {
  if (!customElements.get(tag)) customElements.define(tag, ImportSheet);
  const words = await importTexts(workbench.preferences.chosen.language);
  const sheet = root.querySelector<ImportSheet>(tag) ?? new ImportSheet();
  Object.assign(sheet, {workbench, words});
  if (!sheet.isConnected) root.append(sheet);
  return sheet;
}

export {svgUse} from './reading.js';

/** Offers the uses of an SVG that may be a pattern or a print; undefined for neither. */
export const askUse = async (file: File, place: DrawingPlace): Promise<FileUse | undefined> =>
  (await sheetIn(place)).askUse(file);

/** A notice that appears if reading takes long. */
interface ReadingNotice {
  readonly change: (text: string) => void;
  readonly remove: () => void;
}

function sayReading(workbench: Workbench, text: string, cancel: () => void): ReadingNotice {
  const {app} = textsOf(workbench.preferences.chosen.language);
  const saying = (text: string) =>
    ({tone: 'info', text, action: {label: app.cancel, act: cancel}}) as const;
  let notice = saying(text);
  let isShown = false;
  const timer = setTimeout(() => {
    isShown = true;
    workbench.notices.say(notice);
  }, patience);
  return {
    change: (text) => {
      const isCurrent = isShown && workbench.notices.notice === notice;
      notice = saying(text);
      if (isCurrent) workbench.notices.say(notice);
    },
    remove: () => {
      clearTimeout(timer);
      if (workbench.notices.notice === notice) workbench.notices.say(undefined);
    },
  };
}

/** Returns the drawing's title, or else the file's name. */
function titleOf({drawing}: ShownDrawing, file: File): string {
  const title = drawing.title?.trim() ?? '';
  return shortened(title === '' ? drawingName(file.name) : title);
}

/**
 * Shows the contents of a drawing in the import dialog, which opens it as a separate project.
 * @param life aborted if the user cancels
 * @throws {Error} if the file cannot be read; the message is one sentence
 */
export async function openDrawing(
  file: File,
  place: DrawingPlace,
  life: AbortController,
): Promise<void> {
  const {workbench} = place;
  const sheet = await sheetIn(place);
  const {words} = sheet;
  const said = sayReading(workbench, words.reading(file.name), () => {
    life.abort();
  });
  try {
    const shown = await drawingIn(file, life.signal, {}, ({read, count}) => {
      said.change(words.readingPage(file.name, read, count));
    });
    said.remove();
    await sheet.offer(file, shown, (text, signal) =>
      open(workbench, {name: titleOf(shown, file), text}, signal),
    );
  } catch (error) {
    if (life.signal.aborted) return;
    throw error instanceof WorkerComplaint
      ? new Error(saidRefusal(words, error, file.name))
      : error;
  } finally {
    said.remove();
  }
}

async function open(
  workbench: Workbench,
  garment: {readonly name: string; readonly text: string},
  signal: AbortSignal,
): Promise<void> {
  try {
    await workbench.solving.documentOf(garment); // reports errors before anything changes
    signal.throwIfAborted();
    await workbench.open(garment);
  } catch (error) {
    if (signal.aborted) throw error;
    const texts = textsOf(workbench.preferences.chosen.language);
    throw new Error(spokenFailure(toFailure(error), workbench, texts), {cause: error});
  }
}
