/** What every part of the page is: an element that shows a workbench and is drawn again when that changes. */
import {LitElement, type PropertyValues} from 'lit';

import type {Format} from '../../texts/format.js';
import {formatFor} from '../../texts/format.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';

export abstract class WorkbenchElement extends LitElement {
  static override properties: Record<string, object> = {workbench: {attribute: false}};
  declare workbench: Workbench;
  #unsubscribe: (() => void) | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#follow();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#unsubscribe?.();
    this.#unsubscribe = undefined;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('workbench')) this.#follow();
  }

  /** All words, in the language of the user. */
  protected get texts(): Texts {
    const {language, messages} = this.workbench.preferences;
    return textsOf(language, messages);
  }

  /** All numbers, in the language and units of the user. */
  protected get format(): Format {
    const {language, units} = this.workbench.preferences;
    return formatFor(language, units);
  }

  protected deskChanged(): void {
    this.requestUpdate();
  }

  #follow(): void {
    this.#unsubscribe?.();
    // until the parent has set it there is nothing to follow
    this.#unsubscribe = (this.workbench as Workbench | undefined)?.subscribe(() => {
      this.deskChanged();
    });
  }
}

/**
 * A part that takes its time to be drawn. What the workbench tells it is drawn in a task of its own, so that it
 * holds up no other part and no frame; what is done to the part itself is answered at once.
 */
export abstract class PatientElement extends WorkbenchElement {
  #waits = false;

  protected override deskChanged(): void {
    this.#waits ||= !this.isUpdatePending;
    super.deskChanged();
  }

  protected override async scheduleUpdate(): Promise<void> {
    if (this.#waits) {
      await new Promise((resolve) => {
        setTimeout(resolve);
      });
      this.#waits = false;
    }
    await super.scheduleUpdate();
  }
}
