/** A design with its history: taken step by step, back and forth. */
import type {Design} from '../model/design.js';
import type {History} from '../model/history.js';
import {ViewState} from './view-state.js';
import type {Step} from './state.js';
import {Steps} from './steps.js';

export abstract class DesignHistory extends ViewState {
  protected readonly steps = new Steps();
  #beginnings = 0;

  /** Undefined until a garment is there. */
  get design(): Design | undefined {
    return this.history?.present.design;
  }

  get history(): History<Step> | undefined {
    return this.steps.history;
  }

  /** How many histories were begun: another number is another piece of work. */
  get beginnings(): number {
    return this.#beginnings;
  }

  get canUndo(): boolean {
    return (this.history?.past.length ?? 0) > 0;
  }

  get canRedo(): boolean {
    return (this.history?.future.length ?? 0) > 0;
  }

  /** Starts, or starts over, with a history of its own. */
  begin(history: History<Step>): void {
    this.#beginnings++;
    this.steps.begin(history);
    this.#travel();
  }

  /**
   * Takes a step. Changes of one `kind` that follow each other quickly, as a slider's or a drag's do,
   * are one step.
   */
  change(change: Partial<Design>, kind = ''): void {
    if (!this.design) return;
    // how long was looked for an answer belongs to that answer, not to the next question
    const {effort, ...options} = change.options ?? this.design.options;
    const taken = effort === undefined ? change : {...change, options};
    this.steps.change(taken, kind, this.view?.get() ?? null);
    this.stepped();
    this.clearNotice();
    this.arrive();
  }

  /** Whether a drag is under way, whose changes are one step. */
  get isHeld(): boolean {
    return this.steps.isHeld;
  }

  /** For a drag: until it ends, its changes are one step, however long it rests. @returns what ends it */
  hold(): () => void {
    this.steps.hold();
    return () => {
      this.steps.letGo();
      this.changed();
    };
  }

  undo(): void {
    if (this.steps.undo()) this.#travel();
  }

  redo(): void {
    if (this.steps.redo()) this.#travel();
  }

  /** A step has been taken, and may be mended before anybody sees it. */
  protected abstract stepped(): void;

  /** The present design may be any other than before. */
  protected abstract arrive(): void;

  #travel(): void {
    this.clearNotice();
    this.arrive();
    const view = this.history?.present.view;
    if (view) this.view?.set(view);
  }
}
