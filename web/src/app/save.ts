/** What a user takes away. */
import {linkOf} from '../model/link.js';
import {writeProject} from '../model/project.js';
import {textsOf, toFailure, type Workbench} from '../element/index.js';
import {cuttingSvg} from './cutting-svg.js';
import {saveFile} from './files.js';

const stem = (desk: Workbench): string =>
  (desk.design?.garment.name ?? 'garment').replace(/(\.seamwise)?\.json$/i, '');

export function saveProject(desk: Workbench): void {
  if (desk.design) {
    const view = desk.view?.get();
    saveFile(`${stem(desk)}.seamwise.json`, writeProject(desk.design, view ? {view} : {}));
  }
}

/** With the design that it is the answer to, so that it can be opened again. */
export function saveResult(desk: Workbench): void {
  if (desk.result)
    saveFile(`${stem(desk)}.result.json`, JSON.stringify({...desk.result, design: desk.design}));
}

/** The whole sheet as it is shown. */
export async function savePicture(desk: Workbench): Promise<void> {
  const picture = await desk.view?.picture();
  if (picture) saveFile(`${stem(desk)}.png`, picture);
}

export async function saveCutting(desk: Workbench, allowanceCm: number): Promise<void> {
  try {
    const file = await cuttingSvg(desk, allowanceCm);
    if (file !== undefined) saveFile(`${stem(desk)}.cut.svg`, file, 'image/svg+xml');
  } catch (error) {
    desk.say({tone: 'error', text: toFailure(error).message});
  }
}

/** The address of this page with the design in it. */
export async function copyLink(desk: Workbench): Promise<void> {
  const {app} = textsOf(desk.preferences.language);
  const link = desk.design && linkOf(desk.design);
  if (link === undefined) {
    desk.say({tone: 'info', text: app.noLink});
    return;
  }
  await navigator.clipboard.writeText(new URL(link, location.href).href);
  desk.say({tone: 'info', text: app.linkCopied});
}
