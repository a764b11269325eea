/** Opens a user's file: a garment, a print, a project, or a result. */
import {FileError} from '../model/base/versioned-file.js';
import type {Design} from '../model/design/design.js';
import {SolverError} from '../model/base/failure.js';
import {isProject, readProject} from '../model/documents/project.js';
import {longestName, withoutEnding} from '../model/documents/project-name.js';
import {fieldOf} from '../model/base/read.js';
import {isDocument} from '../image/file-kind.js';
import {kindOf, looksLikePicture} from '../print/read-picture.js';
import {openPrint} from '../workbench/print/open-print.js';
import {spokenFailure} from '../workbench/spoken-failure.js';
import {textsOf, type Texts} from '../texts/texts.js';
import {toFailure} from '../workbench/latest-solve.js';
import type {Workbench} from '../workbench/workbench.js';
import type {DrawingPlace} from './import/open-drawing.js';
import type {Projects} from './projects/projects.js';

/** Limit of a file; no pattern is larger, and a browser could run out of memory. [bytes] */
const most = 64 * 2 ** 20;

/** Source of a file: a button for one kind, or a drop or paste of any kind. */
export type How = 'chosen as garment' | 'chosen as print' | 'handed over';

interface Opening extends DrawingPlace {
  readonly projects: Projects;
}

/** Returns a controller that Escape aborts while a file is being read. */
function endedByKey(): {readonly life: AbortController; readonly done: () => void} {
  const life = new AbortController();
  const heard = new AbortController();
  const pressed = ({key}: KeyboardEvent): void => {
    if (key === 'Escape') life.abort();
  };
  addEventListener('keydown', pressed, {capture: true, signal: heard.signal});
  return {
    life,
    done: () => {
      heard.abort();
    },
  };
}

/**
 * Opens a file; its kind depends on its first bytes, not on its name. An error is shown and changes
 * nothing.
 */
export async function openFile(
  opening: Opening,
  file: File,
  how: How = 'handed over',
): Promise<void> {
  const {workbench} = opening;
  const texts = textsOf(workbench.preferences.chosen.language);
  const {life, done} = endedByKey();
  try {
    const use = await useOf(opening, file, {how, texts, signal: life.signal});
    if (use === 'drawing') await openAsDrawing(opening, file, texts, life);
    if (use === 'document') await opened(opening, file, texts);
    if (use !== 'print') return;
    await openPrint(workbench, file);
    workbench.notices.say({tone: 'info', text: texts.app.takenAsPrint(file.name), undo: true});
  } catch (error) {
    if (life.signal.aborted) return;
    workbench.notices.say({tone: 'error', text: sentenceOn(error, workbench, texts)});
  } finally {
    done();
  }
}

/**
 * `document`: JSON, which names its own format. Undefined if the user declines both uses of an SVG.
 */
type Use = 'print' | 'drawing' | 'document';

/** @throws {Error} if the file has no use, or not the chosen one */
async function useOf(
  opening: Opening,
  file: File,
  {how, texts, signal}: {readonly how: How; readonly texts: Texts; readonly signal: AbortSignal},
): Promise<Use | undefined> {
  const {failures, print} = texts;
  const kind = await kindOf(file);
  if (kind === 'pdf' && how !== 'chosen as print') return 'drawing';
  if (kind && isDocument(kind))
    throw new Error(failures.document(file.name, print.files.kinds[kind]));
  if (kind === 'dxf') return 'drawing';
  if (kind === 'svg' && how !== 'chosen as print' && file.size <= most) {
    const {askUse, svgUse} = await import('./import/open-drawing.js');
    const use = await svgUse(file, signal);
    // readers of drawings report errors in the file
    if (use !== 'picture' && how === 'chosen as garment') return 'drawing';
    if (use === 'pattern') return askUse(file, opening);
  }
  // browsers take DXF for an image
  if (!kind && /\.dxf$/i.test(file.name)) return 'drawing';
  if (await looksLikePicture(file)) {
    if (how === 'chosen as garment') throw new Error(failures.picture(file.name));
    return 'print';
  }
  return (await isJson(file)) ? 'document' : 'drawing';
}

/**
 * Returns whether a file is JSON; all others go to the readers of drawings, which report errors
 * best.
 */
const isJson = async (file: File): Promise<boolean> =>
  /^\s*[[{"]/.test(await file.slice(0, 256).text());

async function openAsDrawing(
  opening: Opening,
  file: File,
  {failures}: Texts,
  life: AbortController,
): Promise<void> {
  if (file.size > most) throw new Error(failures.tooLarge(file.name));
  const {openDrawing} = await import('./import/open-drawing.js');
  await openDrawing(file, opening, life);
}

/**
 * Returns a sentence about the core's failures and about projects; all other errors are already in
 * the user's language.
 */
function sentenceOn(error: unknown, workbench: Workbench, texts: Texts): string {
  if (error instanceof FileError) return texts.failures.project(error.message);
  const failure = toFailure(error);
  return error instanceof SolverError ? spokenFailure(failure, workbench, texts) : failure.message;
}

async function opened(
  {workbench, projects}: Opening,
  file: File,
  {failures}: Texts,
): Promise<void> {
  const {name} = file;
  if (file.size > most) throw new Error(failures.tooLarge(name));
  const text = await file.text();
  const content = parsed(text);
  if (isProject(content)) {
    const {design, view = null, title = withoutEnding(name)} = readProject(text, name);
    projects.beginWith(design, {origin: 'own', title: title.slice(0, longestName)}, view);
  } else if (hasFormat(content, 'seamwise-print') || looksLikePrint(content)) {
    await openPrint(workbench, file);
  } else if (hasFormat(content, 'seamwise-result')) {
    projects.beginAsGiven(designIn(content, name, failures), {origin: 'own'});
  } else {
    await workbench.open({name, text});
  }
}

/** Returns undefined for invalid JSON, which the solver reports better. */
function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

const hasFormat = (content: unknown, format: string): boolean => {
  const written = fieldOf(content, 'format');
  return typeof written === 'string' && written.startsWith(`${format}/`);
};

const looksLikePrint = (content: unknown): boolean =>
  ['group', 'w1', 'w2'].every((name) => fieldOf(content, name) !== undefined);

/** Returns the design that a saved result contains. */
function designIn(content: unknown, name: string, {noDesign}: Texts['failures']): Design {
  const design = fieldOf(content, 'design');
  if (design === undefined) throw new Error(noDesign(name));
  return readProject(JSON.stringify({format: 'seamwise-project/1', design}), name).design;
}
