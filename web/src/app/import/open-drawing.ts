/** Opens a drawing of another program by way of what its user chooses of it. */
import {spokenFailure, textsOf, toFailure, type Workbench} from '../../editor/index.js';
import {drawingName, shortened} from '../../model/project-name.js';
import {importTexts} from '../../texts/import-texts.js';
import {WorkerComplaint} from '../worker/ask.js';
import {ImportSheet, type FileUse} from './import-sheet.js';
import {drawingIn, type ShownDrawing} from './reading.js';

/** Where a drawing is opened. */
export interface DrawingPlace {
  readonly workbench: Workbench;
  /** Where dialogs go. */
  readonly root: HTMLElement | DocumentFragment;
}

const tag = 'sw-import-sheet';
/** Who waits longer for a file is told that it is being read. [ms] */
const patience = 400;

/** The one sheet of a page, with words for its user. */
async function sheetIn({root, workbench}: DrawingPlace): Promise<ImportSheet> {
  if (!customElements.get(tag)) customElements.define(tag, ImportSheet);
  const words = await importTexts(workbench.preferences.language);
  const sheet = root.querySelector<ImportSheet>(tag) ?? new ImportSheet();
  Object.assign(sheet, {workbench, words});
  if (!sheet.isConnected) root.append(sheet);
  return sheet;
}

export {svgUse} from './reading.js';

/** Asks what an SVG is that may be a pattern or a print; undefined for neither. */
export const askUse = async (file: File, place: DrawingPlace): Promise<FileUse | undefined> =>
  (await sheetIn(place)).askUse(file);

/** Says so when reading takes long. @returns what ends that */
function sayReading(workbench: Workbench, text: string, cancel: () => void): () => void {
  const {app} = textsOf(workbench.preferences.language);
  const notice = {tone: 'info', text, action: {label: app.cancel, act: cancel}} as const;
  const timer = setTimeout(() => {
    workbench.say(notice);
  }, patience);
  return () => {
    clearTimeout(timer);
    if (workbench.notice === notice) workbench.say(undefined);
  };
}

/** The file's own title, else its name. */
function titleOf({drawing}: ShownDrawing, file: File): string {
  const title = drawing.title?.trim() ?? '';
  return shortened(title === '' ? drawingName(file.name) : title);
}

/**
 * Shows what a drawing holds. Once it is opened there, it is a project of its own.
 * @param life ended by whoever does not want to wait
 * @throws {Error} with one sentence for what cannot be read
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
    const shown = await drawingIn(file, life.signal);
    said();
    await sheet.offer(file, shown, (text, signal) =>
      open(workbench, {name: titleOf(shown, file), text}, signal),
    );
  } catch (error) {
    if (life.signal.aborted) return;
    throw error instanceof WorkerComplaint ? new Error(words.failed(error.message)) : error;
  } finally {
    said();
  }
}

async function open(
  workbench: Workbench,
  garment: {readonly name: string; readonly text: string},
  signal: AbortSignal,
): Promise<void> {
  try {
    await workbench.documentOf(garment); // what is wrong with it, before anything has changed
    signal.throwIfAborted();
    await workbench.open(garment);
  } catch (error) {
    if (signal.aborted) throw error;
    const texts = textsOf(workbench.preferences.language);
    throw new Error(spokenFailure(toFailure(error), workbench, texts), {cause: error});
  }
}
