/** What a user takes away. */
import {fileNameOf} from '../model/project-name.js';
import {writeProject} from '../model/project.js';
import {toFailure, type Workbench} from '../editor/index.js';
import {cuttingSvg} from './cutting-svg.js';
import {saveFile} from './files.js';
import type {Projects} from './projects/projects.js';

/** What is saved of a desk, under which name. */
export interface Saved {
  readonly desk: Workbench;
  readonly projects: Projects;
}

const stem = ({projects}: Saved): string => fileNameOf(projects.name);

export function saveProject(saved: Saved): void {
  const {desk, projects} = saved;
  if (!desk.design) return;
  const [view, title] = [desk.view?.get(), projects.present?.title];
  const content = writeProject(desk.design, {
    ...(view && {view}),
    ...(title !== undefined && {title}),
  });
  saveFile(`${stem(saved)}.seamwise.json`, content);
}

/** With the design that it is the answer to, so that it can be opened again. */
export function saveResult(saved: Saved): void {
  const {desk} = saved;
  if (desk.result)
    saveFile(`${stem(saved)}.result.json`, JSON.stringify({...desk.result, design: desk.design}));
}

/** The whole sheet as it is shown. */
export async function savePicture(saved: Saved): Promise<void> {
  const picture = await saved.desk.view?.picture();
  if (picture) saveFile(`${stem(saved)}.png`, picture);
}

export async function saveCutting(saved: Saved, allowanceCm: number): Promise<void> {
  const {desk} = saved;
  try {
    const file = await cuttingSvg(desk, allowanceCm);
    if (file !== undefined) saveFile(`${stem(saved)}.cut.svg`, file, 'image/svg+xml');
  } catch (error) {
    desk.say({tone: 'error', text: toFailure(error).message});
  }
}
