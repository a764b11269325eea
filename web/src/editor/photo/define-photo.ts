/** Registers the photo dialog; loaded on demand. */
import {registerAll} from '../base/register.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {PhotoOfFabric} from '../../print/openable-files.js';
import {PhotoDialog} from './photo-dialog.js';
import type {PhotoKeeper} from '../../photo/photo-keeper.js';
import {PhotoMeasures} from './photo-measures.js';
import {PhotoPanel} from './photo-panel.js';
import {PhotoStage} from './photo-stage.js';
import {PhotoSwatch} from './photo-swatch.js';
import {PhotoWork} from './photo-work.js';

const tag = 'sw-photo';

/** Opens the dialog, with an image if one is given. */
export async function openPhoto(
  workbench: Workbench,
  root: HTMLElement | DocumentFragment,
  {given, keeper}: {readonly given?: PhotoOfFabric; readonly keeper?: PhotoKeeper},
): Promise<void> {
  registerAll({
    [tag]: PhotoDialog,
    'sw-photo-stage': PhotoStage,
    'sw-photo-measures': PhotoMeasures,
    'sw-photo-panel': PhotoPanel,
    'sw-photo-swatch': PhotoSwatch,
    'sw-photo-work': PhotoWork,
  });
  const dialog = root.querySelector<PhotoDialog>(tag) ?? new PhotoDialog();
  dialog.workbench = workbench;
  dialog.keeper = keeper;
  if (!dialog.isConnected) root.append(dialog);
  await dialog.open(given);
}
