/** A design with its history of steps, for undo and redo. */
import type {Design} from '../model/design/design.js';
import type {History} from '../model/design/history.js';
import {Observable} from './observable.js';
import {askedFields} from './result-cache.js';
import type {ShownSheet} from './shown-sheet.js';
import type {Step, ViewState} from './state.js';
import {Steps} from './steps.js';

/** Hooks of a change of the design. */
interface HistoryHooks {
  /** Corrects the design of a new step before it is published. */
  readonly mended: (design: Design) => Design;
  /** Called when the present design may have changed. */
  readonly arrived: () => void;
}

export class DesignHistory extends Observable {
  readonly #steps = new Steps();
  readonly #sheet: ShownSheet;
  readonly #hooks: HistoryHooks;
  #beginnings = 0;

  /** @param sheet sheet whose view is stored with each step */
  constructor(sheet: ShownSheet, hooks: HistoryHooks) {
    super();
    this.#sheet = sheet;
    this.#hooks = hooks;
  }

  /** Undefined until there is a garment. */
  get design(): Design | undefined {
    return this.steps?.present.design;
  }

  get steps(): History<Step> | undefined {
    return this.#steps.history;
  }

  /** Number of histories that were begun; a new number means different work. */
  get beginnings(): number {
    return this.#beginnings;
  }

  get canUndo(): boolean {
    return (this.steps?.past.length ?? 0) > 0;
  }

  /** Starts, or starts over, with another history. */
  begin(history: History<Step>): void {
    this.#beginnings++;
    this.#steps.begin(history);
    this.#travel();
  }

  /**
   * Takes a step. Changes of one `kind` in quick succession, as by a slider or a drag, are one
   * step.
   */
  change(change: Partial<Design>, kind = ''): void {
    if (!this.design) return;
    // the effort of a result belongs to that result, not to the next request
    const {effort, ...options} = change.options ?? this.design.options;
    const asks = askedFields.some((field) => field in change);
    const taken = effort === undefined || !asks ? change : {...change, options};
    this.#steps.change(taken, kind, this.#view);
    this.#steps.mend(this.#hooks.mended(this.design));
    this.#arrive();
  }

  /** Changes the present design as part of the step that led to it. */
  mend(design: Design): void {
    this.#steps.mend(design);
    this.changed();
  }

  /** True during a drag, whose changes are one step. */
  get isHeld(): boolean {
    return this.#steps.isHeld;
  }

  /**
   * Begins a drag. Until it ends, its changes are one step, however long it pauses.
   * @returns the function that ends it
   */
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
    const view = this.steps?.present.view;
    if (view) this.#sheet.view?.set(view);
  }
}
