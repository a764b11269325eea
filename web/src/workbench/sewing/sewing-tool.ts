/** The sewing tool with its texts and keys; loaded on demand. */
import {loadSewTexts} from '../../texts/sew-texts.js';
import type {Workbench} from '../workbench.js';
import {SeamChooser} from './seam-chooser.js';
import {seamKey} from './seam-keys.js';

export class SewingTool {
  readonly chooser: SeamChooser;
  readonly #workbench: Workbench;

  constructor(workbench: Workbench, chooser: SeamChooser) {
    this.#workbench = workbench;
    this.chooser = chooser;
  }

  /** @returns true if the key has an effect */
  press(event: KeyboardEvent): boolean {
    return seamKey(this.chooser, this.#workbench, event);
  }

  /** Id of the chosen edge, for `aria-activedescendant`. */
  get activeId(): string | undefined {
    const {run, other} = this.chooser.state;
    const active = other[0] ?? run[0];
    return active && `edge-${active.piece}-${active.edge}`;
  }
}

/** Loads the texts and makes the tool. @throws {Error} if there is no network */
export async function sewingTool(workbench: Workbench, changed: () => void): Promise<SewingTool> {
  const {language, messages} = workbench.preferences.chosen;
  const texts = await loadSewTexts(language, messages);
  return new SewingTool(workbench, new SeamChooser(workbench, texts, changed));
}
