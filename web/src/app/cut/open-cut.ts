/** Opens the dialog for a cutting sheet; loaded on first use. */
import type {Workbench} from '../../workbench/workbench.js';
import {cutTexts} from '../../texts/cut-texts.js';
import {CutDialog} from './cut-dialog.js';

const tag = 'sw-cut-dialog';

/** @param save receives the file and the ending of its name */
export async function openCut(
  workbench: Workbench,
  root: HTMLElement | DocumentFragment,
  save: (ending: string, content: Blob) => void,
): Promise<void> {
  if (!customElements.get(tag)) customElements.define(tag, CutDialog);
  const words = await cutTexts(workbench.preferences.chosen.language);
  const dialog = root.querySelector<CutDialog>(tag) ?? new CutDialog();
  Object.assign(dialog, {workbench, words, save});
  if (!dialog.isConnected) root.append(dialog);
  await dialog.open();
}
