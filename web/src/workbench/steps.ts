/** A design with its history, and where it was looked at. */
import type {Design} from '../model/design.js';
import {amended, redone, stepped, undone, type History} from '../model/history.js';
import type {Step, ViewState} from './state.js';

/** Changes of one kind that follow each other within this are one step, unless something is held. [ms] */
const pause = 1000;

/** The kind of change that is one step however long it takes: one better answer after the other. */
export const improving = 'improve';

export class Steps {
  #history: History<Step> | undefined;
  /** The kind of change that may still be amended, and until when. */
  #amendable = {kind: '', until: 0};
  #isHeld = false;

  /** Undefined until it is begun. */
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

  /** From now until it is let go, changes of one kind are one step of their own, however long they pause. */
  hold(): void {
    this.#isHeld = true;
    this.#amendable = {kind: '', until: 0};
  }

  letGo(): void {
    this.#isHeld = false;
    this.#amendable = {kind: '', until: 0};
  }

  /** @param kind changes of which may be one step; empty for one that stands alone */
  change(change: Partial<Design>, kind: string, view: ViewState | null): void {
    if (!this.#history) return;
    const {present} = this.#history;
    const step = {design: {...present.design, ...change}, view};
    const now = performance.now();
    const isSoon = this.#isHeld || kind === improving || now < this.#amendable.until;
    const amends = kind !== '' && kind === this.#amendable.kind && isSoon;
    this.#amendable = {kind, until: now + pause};
    this.#history = amends
      ? amended(this.#history, step)
      : stepped(amended(this.#history, {...present, view}), step);
  }

  /** Mends the present design, as a part of the step that led to it. */
  mend(design: Design): void {
    if (this.#history) this.#history = amended(this.#history, {...this.#history.present, design});
  }

  /** @returns whether there was a step to take back */
  undo(): boolean {
    return this.#travel(this.#history && undone(this.#history));
  }

  /** @returns whether there was a step to take again */
  redo(): boolean {
    return this.#travel(this.#history && redone(this.#history));
  }

  #travel(history: History<Step> | undefined): boolean {
    if (history) this.begin(history);
    return history !== undefined;
  }
}
