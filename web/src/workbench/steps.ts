/** A design with its history and views. */
import type {Design} from '../model/design/design.js';
import {amended, redone, stepped, undone, type History} from '../model/design/history.js';
import type {Step, ViewState} from './state.js';

/** Changes of one kind within this interval are one step; a held drag has no limit. [ms] */
const pause = 1000;

export class Steps {
  #history: History<Step> | undefined;
  /** Kind of change that may still be amended, and the time until which it may. */
  #amendable = {kind: '', until: 0};
  #isHeld = false;

  /** Undefined until a history is begun. */
  get history(): History<Step> | undefined {
    return this.#history;
  }

  begin(history: History<Step>): void {
    this.#history = history;
    this.#amendable = {kind: '', until: 0};
  }

  get isHeld(): boolean {
    return this.#isHeld;
  }

  /**
   * Begins a drag. Until it is released, changes of one kind are one separate step, however long
   * they pause.
   */
  hold(): void {
    this.#isHeld = true;
    this.#amendable = {kind: '', until: 0};
  }

  letGo(): void {
    this.#isHeld = false;
    this.#amendable = {kind: '', until: 0};
  }

  /** @param kind kind of changes that may form one step; empty for a separate step */
  change(change: Partial<Design>, kind: string, view: ViewState | null): void {
    if (!this.#history) return;
    const {present} = this.#history;
    const step = {design: {...present.design, ...change}, view};
    const now = performance.now();
    const isSoon = this.#isHeld || now < this.#amendable.until;
    const amends = kind !== '' && kind === this.#amendable.kind && isSoon;
    this.#amendable = {kind, until: now + pause};
    this.#history = amends
      ? amended(this.#history, step)
      : stepped(amended(this.#history, {...present, view}), step);
  }

  /** Changes the present design as part of the step that led to it. */
  mend(design: Design): void {
    if (this.#history) this.#history = amended(this.#history, {...this.#history.present, design});
  }

  /** Undoes a step. @returns whether there was one */
  undo(): boolean {
    return this.#travel(this.#history && undone(this.#history));
  }

  /** Redoes a step. @returns whether there was one */
  redo(): boolean {
    return this.#travel(this.#history && redone(this.#history));
  }

  #travel(history: History<Step> | undefined): boolean {
    if (history) this.begin(history);
    return history !== undefined;
  }
}
