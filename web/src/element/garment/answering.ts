/** Starts the element's current request, and waits for the answer. */
import {SolverError} from '../../model/result/failure.js';
import type {SolveResult} from '../../model/result/result.js';
import type {Beginning} from './beginning.js';
import type {GarmentSession} from './session.js';
import type {Speech} from './speech.js';

export class Answering {
  readonly #session: GarmentSession;
  readonly #beginning: Beginning;
  readonly #speech: Speech;

  constructor(session: GarmentSession, beginning: Beginning, speech: Speech) {
    this.#session = session;
    this.#beginning = beginning;
    this.#speech = speech;
  }

  /** Starts the current request, unless it is running or answered. */
  start(): void {
    const {state} = this.#session;
    const isStuck = state === 'idle' || state === 'error' || state === 'stale';
    if (isStuck && !this.#beginning.isDue && !this.#session.solveAgain()) {
      this.#beginning.askAgain();
    }
    this.#beginning.now();
  }

  /**
   * @param isAskable whether the garment and the print are set
   * @throws the errors of the element's `solve`
   */
  async answer(isAskable: boolean, signal: AbortSignal | undefined): Promise<SolveResult> {
    if (!isAskable && (this.#session.state === 'idle' || this.#beginning.isDue)) {
      const message = this.#speech.texts.garment.noGarment;
      throw new SolverError({code: 'notAGarment', message});
    }
    this.start();
    return this.#session.answer(signal, () => {
      this.#beginning.abandon();
    });
  }
}
