/** What a user takes away. */
import {cuttingSvg, type Workbench} from '../element/index.js';
import {saveFile} from './files.js';

const stem = (desk: Workbench): string =>
  (desk.design?.garment.name ?? 'garment').replace(/(\.seamwise)?\.json$/i, '');

export function saveProject(desk: Workbench): void {
  if (desk.design) saveFile(`${stem(desk)}.seamwise.json`, JSON.stringify(desk.design));
}

export function saveResult(desk: Workbench): void {
  if (desk.result) saveFile(`${stem(desk)}.result.json`, JSON.stringify(desk.result));
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
    desk.say({tone: 'error', text: error instanceof Error ? error.message : String(error)});
  }
}
