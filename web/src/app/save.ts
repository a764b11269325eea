/** What a user takes away. */
import type {Workbench} from '../element/index.js';
import {saveFile} from './files.js';

const stem = (desk: Workbench): string =>
  (desk.design?.garment.name ?? 'garment').replace(/\.json$/i, '');

export function saveProject(desk: Workbench): void {
  if (desk.design) saveFile(`${stem(desk)}.seamwise.json`, JSON.stringify(desk.design));
}

export function saveResult(desk: Workbench): void {
  if (desk.result) saveFile(`${stem(desk)}.result.json`, JSON.stringify(desk.result));
}
