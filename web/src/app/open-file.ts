/** Opens whatever a user hands over: a garment, a print, a project, or a result. */
import type {Design} from '../model/design.js';
import {SolverError} from '../model/failure.js';
import {FileError, isProject, readProject} from '../model/project.js';
import {longestName, withoutEnding} from '../model/project-name.js';
import {fieldOf} from '../model/read.js';
import {isDocument} from '../recognition/file-kind.js';
import {
  kindOf,
  looksLikePicture,
  openPrint,
  spokenFailure,
  textsOf,
  toFailure,
  type Texts,
  type Workbench,
} from '../editor/index.js';
import type {Projects} from './projects/projects.js';

/** Nobody's pattern is larger, and a browser would choke on it. [bytes] */
const most = 64 * 2 ** 20;

/** By the button for garments, or dropped and pasted, which may be anything. */
export type How = 'chosen as garment' | 'handed over';

/** What a file is, its first bytes say, whatever it is called. What cannot be opened is said, and leaves everything as it is. */
export async function openFile(
  workbench: Workbench,
  projects: Projects,
  file: File,
  how: How = 'handed over',
): Promise<void> {
  const texts = textsOf(workbench.preferences.language);
  try {
    const kind = await kindOf(file);
    if (kind && isDocument(kind))
      throw new Error(texts.failures.document(file.name, texts.print.files.kinds[kind]));
    const isPicture = await looksLikePicture(file);
    if (isPicture && how === 'chosen as garment')
      throw new Error(texts.failures.picture(file.name));
    await (isPicture ? openPrint(workbench, file) : opened(workbench, projects, file, texts));
    if (isPicture)
      workbench.say({
        tone: 'info',
        text: texts.app.takenAsPrint(file.name),
        undo: true,
      });
  } catch (error) {
    workbench.say({tone: 'error', text: sentenceOn(error, workbench, texts)});
  }
}

/** Of the core's failures and of projects; whatever else goes wrong is said in the user's language already. */
function sentenceOn(error: unknown, workbench: Workbench, texts: Texts): string {
  if (error instanceof FileError) return texts.failures.project(error.message);
  const failure = toFailure(error);
  return error instanceof SolverError ? spokenFailure(failure, workbench, texts) : failure.message;
}

async function opened(
  workbench: Workbench,
  projects: Projects,
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
    projects.beginWith(designIn(content, name, failures), {origin: 'own'});
  } else {
    await workbench.open({name, text});
  }
}

/** Undefined when it is no JSON: the solver says so better. */
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

/** A result that was saved here holds the design that it is the answer to. */
function designIn(content: unknown, name: string, {noDesign}: Texts['failures']): Design {
  const design = fieldOf(content, 'design');
  if (design === undefined) throw new Error(noDesign(name));
  return readProject(JSON.stringify({format: 'seamwise-project/1', design}), name).design;
}
