/** A design with its history: taken step by step, back and forth. */
import type {Design} from '../model/design.js';
import type {History} from '../model/history.js';
import {Observable} from './observable.js';
import {askedFields} from './result-cache.js';
import type {ShownSheet} from './shown-sheet.js';
import type {Step, ViewState} from './state.js';
import {improving, Steps} from './steps.js';

/** What belongs to a change of the design. */
interface HistoryHooks {
  /** A step has been taken: the design as it is to be, before anybody sees it. */
  readonly mended: (design: Design) => Design;
  /** The present design may be any other than before. */
  readonly arrived: () => void;
}

export class DesignHistory extends Observable {
  readonly #steps = new Steps();
  readonly #sheet: ShownSheet;
  readonly #hooks: HistoryHooks;
  #beginnings = 0;

  /** @param sheet with whose view each step is kept */
  constructor(sheet: ShownSheet, hooks: HistoryHooks) {
    super();
    this.#sheet = sheet;
    this.#hooks = hooks;
  }

  /** Undefined until a garment is there. */
  get design(): Design | undefined {
    return this.history?.present.design;
  }

  get history(): History<Step> | undefined {
    return this.#steps.history;
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
    this.#steps.begin(history);
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
    const asks = askedFields.some((field) => field in change);
    const taken = effort === undefined || !asks ? change : {...change, options};
    this.#steps.change(taken, kind, this.#view);
    this.#steps.mend(this.#hooks.mended(this.design));
    this.#arrive();
  }

  /** All better answers that are found in one go are one step. */
  improve(options: Design['options']): void {
    this.#steps.change({options}, improving, this.#view);
    this.changed();
  }

  /** As a part of the step that led to the present design. */
  mend(design: Design): void {
    this.#steps.mend(design);
    this.changed();
  }

  /** Whether a drag is under way, whose changes are one step. */
  get isHeld(): boolean {
    return this.#steps.isHeld;
  }

  /** For a drag: until it ends, its changes are one step, however long it rests. @returns what ends it */
  hold(): () => void {
    this.#steps.hold();
    return () => {
      this.#steps.letGo();
      this.changed();
    };
  }

  undo(): void {
    if (this.#steps.undo()) this.#travel();
  }

  redo(): void {
    if (this.#steps.redo()) this.#travel();
  }

  get #view(): ViewState | null {
    return this.#sheet.view?.get() ?? null;
  }

  #arrive(): void {
    Observable.together(() => {
      this.changed();
      this.#hooks.arrived();
    });
  }

  #travel(): void {
    this.#arrive();
    const view = this.history?.present.view;
    if (view) this.#sheet.view?.set(view);
  }
}
