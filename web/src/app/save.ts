/** Saves projects, results and pictures as files. */
import {fileNameOf} from '../model/documents/project-name.js';
import {writeProject} from '../model/documents/project.js';
import {written} from '../model/design/written-design.js';
import type {Workbench} from '../workbench/workbench.js';
import {saveFile} from './files.js';
import type {Projects} from './projects/projects.js';

/** Source of a saved file and of its name. */
interface Saved {
  readonly workbench: Workbench;
  readonly projects: Projects;
}

/** Returns a file's name without its ending. */
export const stem = ({projects}: Saved): string => fileNameOf(projects.name);

export function saveProject(saved: Saved): void {
  const {workbench, projects} = saved;
  if (!workbench.history.design) return;
  const [view, title] = [workbench.sheet.view?.get(), projects.present?.title];
  const content = writeProject(workbench.history.design, {
    ...(view && {view}),
    ...(title !== undefined && {title}),
  });
  saveFile(`${stem(saved)}.seamwise.json`, content);
}

/** Saves the result with its design, so that it can be opened again. */
export function saveResult(saved: Saved): void {
  const {design} = saved.workbench.history;
  const {result} = saved.workbench.solving;
  if (!design || !result) return;
  const content = JSON.stringify({...result, design: written(design)});
  saveFile(`${stem(saved)}.result.json`, content);
}

/** Saves the whole sheet as shown. */
export async function savePicture(saved: Saved): Promise<void> {
  const picture = await saved.workbench.sheet.view?.picture();
  if (picture) saveFile(`${stem(saved)}.png`, picture);
}
