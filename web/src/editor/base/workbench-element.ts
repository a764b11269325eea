/** Base class of every part: an element that shows a workbench and redraws after changes to it. */
import {LitElement} from 'lit';

import {formatFor, type Format} from '../../texts/format.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {Observable} from '../../workbench/observable.js';
import type {Workbench} from '../../workbench/workbench.js';

export abstract class WorkbenchElement extends LitElement {
  static override properties: Record<string, object> = {workbench: {attribute: false}};
  declare workbench: Workbench;
  /** Observables that the last update read, each with the function that ends its subscription. */
  readonly #followed = new Map<Observable, () => void>();

  override connectedCallback(): void {
    super.connectedCallback();
    this.requestUpdate(); // the element missed changes while it was disconnected
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#follow(new Set());
  }

  /** Subscribes to all observables that the update reads. */
  protected override performUpdate(): void {
    if (!this.isUpdatePending) return;
    const read = Observable.readBy(() => {
      super.performUpdate();
    });
    if (this.isConnected) this.#follow(read);
  }

  /** All texts in the user's language. */
  protected get texts(): Texts {
    const {language, messages} = this.workbench.preferences.chosen;
    return textsOf(language, messages);
  }

  /** Formats numbers in the user's language and units. */
  protected get format(): Format {
    const {language, units} = this.workbench.preferences.chosen;
    return formatFor(language, units);
  }

  /** Runs after a change to an observable that the last update read. */
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
 * A part that takes long to draw. It draws changes to the workbench in a separate task, so that it
 * delays no other part and no frame; it draws changes to its own properties at once.
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
