/** Lays each answer on cloth, in a worker. Lengths in cm. */
import type {Design} from '../../model/design.js';
import type {LayPlan} from '../../model/lay-plan.js';
import type {SolveResult} from '../../model/result.js';
import {unlessAborted} from '../../solver/answers/unless-aborted.js';
import {lastOf} from '../../workbench/last-of.js';
import type {Emit} from './announcer.js';
import {asError} from './as-error.js';
import type {AttributeElement} from './attribute-element.js';
import {layOnCloth, type LaidAnswer} from './lay-on-cloth.js';
import type {GarmentSession} from './session.js';
import type {Texts} from '../../texts/texts.js';

export interface ClothOwner {
  readonly element: Pick<AttributeElement, 'clothWidth' | 'selvedge' | 'isConnected'>;
  readonly session: GarmentSession;
  readonly texts: () => Texts;
  readonly emit: Emit;
}

interface Laying {
  readonly answer: LaidAnswer;
  readonly ending: AbortController;
  readonly plan: Promise<LayPlan>;
  lengthCm: number | null;
  /** Not tried again, unless somebody asks. */
  hasFailed: boolean;
}

export class ClothLayer {
  readonly #owner: ClothOwner;
  /** The same object for the same answer on the same cloth. */
  readonly #answerOf = lastOf(
    (
      result: SolveResult,
      garment: Design['garment'],
      options: Design['options'],
      names: Design['names'],
      print: Design['print'],
      widthCm: number,
      selvedgeCm: number,
    ): LaidAnswer => ({
      ...{result, garment, options, print, widthCm, selvedgeCm},
      ...(names && {names}),
    }),
  );
  #laying: Laying | undefined;
  #waiting = 0;

  constructor(owner: ClothOwner) {
    this.#owner = owner;
  }

  /** Whether a promise of a plan has not been kept yet. */
  get isAwaited(): boolean {
    return this.#waiting > 0;
  }

  /** For the answer that is shown; null until it is laid. */
  get lengthCm(): number | null {
    const answer = this.#answer;
    return answer && answer === this.#laying?.answer ? this.#laying.lengthCm : null;
  }

  /** Lays what is shown now, in the place of what was; while the user drags something, only for who waits. */
  follow(): void {
    const answer = this.#answer;
    if (answer === this.#laying?.answer) return;
    this.#end();
    const {element, session} = this.#owner;
    const isFinal = element.isConnected && !session.workbench.isHeld;
    if (answer && (isFinal || this.isAwaited)) this.#laying = this.#begin(answer);
  }

  /** Ends what is under way, until somebody needs the element again. What is laid is kept. */
  pause(): void {
    if (this.#laying?.lengthCm === null) this.#end();
  }

  /** Ends what is under way; who waits hears of it. */
  cancel(): void {
    if (this.#laying?.lengthCm !== null) return;
    this.#laying.hasFailed = true;
    this.#laying.ending.abort(
      new DOMException(this.#owner.texts().garment.cancelled, 'AbortError'),
    );
  }

  /** @param solve resolves when there is an answer to lay @throws as the element's `layPlan` does */
  async plan(solve: () => Promise<unknown>, signal: AbortSignal | undefined): Promise<LayPlan> {
    this.#waiting += 1;
    try {
      return await unlessAborted(this.#plan(solve), signal);
    } finally {
      this.#waiting -= 1;
    }
  }

  async #plan(solve: () => Promise<unknown>): Promise<LayPlan> {
    if (this.#laying?.hasFailed) this.#end();
    for (;;) {
      await solve();
      this.follow();
      const laying = this.#laying;
      if (!laying) continue; // another answer is asked for by now
      try {
        return await laying.plan;
      } catch (error) {
        if (laying === this.#laying) throw error;
      }
    }
  }

  get #answer(): LaidAnswer | undefined {
    const {element, session} = this.#owner;
    const {clothWidth, selvedge} = element;
    const {result, workbench} = session;
    if (clothWidth === null || !result || !workbench.design) return undefined;
    const {garment, options, names, print} = workbench.design;
    return this.#answerOf(result, garment, options, names, print, clothWidth, selvedge);
  }

  #begin(answer: LaidAnswer): Laying {
    const ending = new AbortController();
    const {emit, session} = this.#owner;
    const plan = layOnCloth(session.workbench, answer, ending.signal);
    const laying: Laying = {answer, ending, plan, lengthCm: null, hasFailed: false};
    plan.then(
      ({lengthCm, proven, notes}) => {
        if (ending.signal.aborted) return;
        laying.lengthCm = lengthCm;
        emit('cloth', {widthCm: answer.widthCm, lengthCm, proven, notes});
      },
      (error: unknown) => {
        if (ending.signal.aborted) return;
        laying.hasFailed = true;
        session.report(asError(error));
      },
    );
    return laying;
  }

  #end(): void {
    this.#laying?.ending.abort();
    this.#laying = undefined;
  }
}
