/** What every part of the page is: an element that shows a workbench, and is drawn again when what it shows changes. */
import {LitElement} from 'lit';

import type {Format} from '../../texts/format.js';
import {formatFor} from '../../texts/format.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {Observable} from '../../workbench/observable.js';
import type {Workbench} from '../../workbench/workbench.js';

export abstract class WorkbenchElement extends LitElement {
  static override properties: Record<string, object> = {workbench: {attribute: false}};
  declare workbench: Workbench;
  /** Those parts of the workbench that were read of when this was drawn last, and what ends following each. */
  readonly #followed = new Map<Observable, () => void>();

  override connectedCallback(): void {
    super.connectedCallback();
    this.requestUpdate(); // what has changed meanwhile was not told
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#follow(new Set());
  }

  /** Whatever is read of on the way is followed from then on. */
  protected override performUpdate(): void {
    if (!this.isUpdatePending) return;
    const read = Observable.readBy(() => {
      super.performUpdate();
    });
    if (this.isConnected) this.#follow(read);
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

  /** Something that this shows may be another. */
  protected workbenchChanged(): void {
    this.requestUpdate();
  }

  readonly #told = (): void => {
    this.workbenchChanged();
  };

  #follow(read: ReadonlySet<Observable>): void {
    for (const [part, end] of this.#followed) {
      if (read.has(part)) continue;
      end();
      this.#followed.delete(part);
    }
    for (const part of read) {
      if (!this.#followed.has(part)) this.#followed.set(part, part.subscribe(this.#told));
    }
  }
}

/**
 * A part that takes its time to be drawn. What the workbench tells it is drawn in a task of its own, so that it
 * holds up no other part and no frame; what is done to the part itself is answered at once.
 */
export abstract class PatientElement extends WorkbenchElement {
  #waits = false;

  protected override workbenchChanged(): void {
    this.#waits ||= !this.isUpdatePending;
    super.workbenchChanged();
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
