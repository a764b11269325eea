/** The sewing tool with its texts and keys; loaded on demand. */
import {html, type TemplateResult} from 'lit';

import {loadSewTexts} from '../../texts/sew-texts.js';
import {registerAll} from '../base/register.js';
import type {Workbench} from '../../workbench/workbench.js';
import {SeamChooser} from './seam-chooser.js';
import {seamKey} from './seam-keys.js';
import {SewBar} from './sew-bar.js';

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

  /** List of the edges for screen readers. */
  options(label: string): TemplateResult {
    const {activeId} = this;
    return html`<div role="listbox" class="hidden" id="options" aria-label=${label}>
      ${this.chooser.options().map(({edge, text}) => {
        const id = `edge-${edge.piece}-${edge.edge}`;
        return html`<div role="option" id=${id} aria-selected=${id === activeId}>${text}</div>`;
      })}
    </div>`;
  }

  bar(): TemplateResult {
    const {chooser} = this;
    return html`<sw-sew-bar
      .workbench=${this.#workbench}
      .chooser=${chooser}
      .state=${chooser.state}
    ></sw-sew-bar>`;
  }
}

/** Loads the texts and makes the tool. @throws {Error} if there is no network */
export async function sewingTool(workbench: Workbench, changed: () => void): Promise<SewingTool> {
  const {language, messages} = workbench.preferences;
  const texts = await loadSewTexts(language, messages);
  registerAll({'sw-sew-bar': SewBar});
  return new SewingTool(workbench, new SeamChooser(workbench, texts, changed));
}
