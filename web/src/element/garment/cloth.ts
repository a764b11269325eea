/** How much cloth the answer takes: laid in a worker, by code that is loaded when somebody asks. Lengths in cm. */
import type {Design} from '../../model/design.js';
import {SolverError} from '../../model/failure.js';
import type {LayPlan} from '../../model/lay-plan.js';
import type {SolveResult} from '../../model/result.js';
import {unlessAborted} from '../../solver/answers/unless-aborted.js';
import type {Texts} from '../../texts/texts.js';
import {lastOf} from '../../workbench/last-of.js';
import type {Emit} from './announcer.js';
import {asError} from './as-error.js';
import type {AttributeElement} from './attribute-element.js';
import type {LaidAnswer} from './lay-on-cloth.js';
import type {GarmentSession} from './session.js';

interface ClothOwner {
  readonly element: Pick<AttributeElement, 'clothWidth' | 'selvedge' | 'isConnected'>;
  readonly session: GarmentSession;
  readonly texts: () => Texts['garment'];
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

export class Cloth {
  readonly #owner: ClothOwner;
  /** The same object for the same answer on the same cloth. */
  readonly #answerOf = lastOf(
    (
      result: SolveResult,
      garment: Design['garment'],
      options: Design['options'],
      names: Design['names'],
      oneWay: boolean,
      widthCm: number,
      selvedgeCm: number,
    ): LaidAnswer => ({
      ...{result, garment, options, oneWay, widthCm, selvedgeCm},
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
    this.#laying.ending.abort(new DOMException(this.#owner.texts().cancelled, 'AbortError'));
  }

  /**
   * For the answer to what is asked for now, or to what takes its place before that is laid.
   * @param solve resolves when there is an answer
   * @throws {SolverError} where the width of the cloth is not said, and for what cannot be laid; what `solve` throws; the
   *   signal's reason
   */
  async plan(solve: () => Promise<unknown>, signal: AbortSignal | undefined): Promise<LayPlan> {
    this.#waiting += 1;
    try {
      if (this.#laying?.hasFailed) this.#end();
      for (;;) {
        this.#checkWidth();
        await solve();
        this.follow();
        const laying = this.#laying;
        if (!laying) continue; // another answer is asked for by now
        try {
          return await unlessAborted(laying.plan, signal);
        } catch (error) {
          if (signal?.aborted || laying === this.#laying) throw error;
        }
      }
    } finally {
      this.#waiting -= 1;
    }
  }

  get #answer(): LaidAnswer | undefined {
    const {element, session} = this.#owner;
    const {clothWidth, selvedge} = element;
    const {result, workbench} = session;
    if (clothWidth === null || !result || !workbench.design) return undefined;
    const {garment, options, names, print} = workbench.design;
    return this.#answerOf(result, garment, options, names, print.oneWay, clothWidth, selvedge);
  }

  #checkWidth(): void {
    if (this.#owner.element.clothWidth !== null) return;
    throw new SolverError({code: 'options', message: this.#owner.texts().noCloth});
  }

  #begin(answer: LaidAnswer): Laying {
    const ending = new AbortController();
    const plan = this.#lay(answer, ending.signal);
    const laying: Laying = {answer, ending, plan, lengthCm: null, hasFailed: false};
    const {emit, session} = this.#owner;
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

  /** @throws {SolverError}; the signal's reason */
  async #lay(answer: LaidAnswer, signal: AbortSignal): Promise<LayPlan> {
    const {session, texts} = this.#owner;
    const {layOnCloth} = await import('./lay-on-cloth.js').catch((error: unknown) => {
      const message = texts().noTools(asError(error).message);
      throw new SolverError({code: 'network', message});
    });
    signal.throwIfAborted();
    return layOnCloth(session.workbench, answer, signal);
  }

  #end(): void {
    this.#laying?.ending.abort();
    this.#laying = undefined;
  }
}
