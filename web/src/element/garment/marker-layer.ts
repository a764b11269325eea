/** Makes a fabric layout of each answer, in a worker. Lengths in cm. */
import type {Design} from '../../model/design/design.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {SolveResult} from '../../model/result/result.js';
import {unlessAborted} from '../../solver/answers/failures.js';
import {lastOf} from '../../model/base/last-of.js';
import {asError, type Emit} from './emitted-events.js';
import type {AttributeElement} from './attribute-element.js';
import type {GarmentSession} from './session.js';
import type {Texts} from '../../texts/texts.js';
import {layPlan} from '../../marker/plan.js';
import {markerOrder, type LaidPrint} from '../../marker/problem.js';
import type {Workbench} from '../../workbench/workbench.js';

export interface MarkerOwner {
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
  /** A failed layout is repeated only on request. */
  hasFailed: boolean;
}

export class MarkerLayer {
  readonly #owner: MarkerOwner;
  /** Returns the same object for the same answer on the same fabric. */
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

  constructor(owner: MarkerOwner) {
    this.#owner = owner;
  }

  /** Returns whether a promise of a layout is still pending. */
  get isAwaited(): boolean {
    return this.#waiting > 0;
  }

  /** Length of the current answer's layout; null until it is there. */
  get lengthCm(): number | null {
    const answer = this.#answer;
    return answer && answer === this.#laying?.answer ? this.#laying.lengthCm : null;
  }

  /**
   * Starts the layout of the current answer, replacing the previous one. During a drag it starts
   * only for a waiting caller.
   */
  follow(): void {
    const answer = this.#answer;
    if (answer === this.#laying?.answer) return;
    this.#end();
    const {element, session} = this.#owner;
    const isFinal = element.isConnected && !session.workbench.history.isHeld;
    if (answer && (isFinal || this.isAwaited)) this.#laying = this.#begin(answer);
  }

  /** Ends a running layout until the element is needed again. A finished one is kept. */
  pause(): void {
    if (this.#laying?.lengthCm === null) this.#end();
  }

  /** Ends a running layout and rejects its promise. */
  cancel(): void {
    if (this.#laying?.lengthCm !== null) return;
    this.#laying.hasFailed = true;
    this.#laying.ending.abort(
      new DOMException(this.#owner.texts().garment.cancelled, 'AbortError'),
    );
  }

  /**
   * Returns the layout of the next answer.
   * @param solve resolves once there is an answer
   * @throws the errors of the element's `layPlan`
   */
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
      if (!laying) continue; // the request has changed meanwhile
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
    if (clothWidth === null || !result || !workbench.history.design) return undefined;
    const {garment, options, names, print} = workbench.history.design;
    return this.#answerOf(result, garment, options, names, print, clothWidth, selvedge);
  }

  #begin(answer: LaidAnswer): Laying {
    const ending = new AbortController();
    const {emit, session} = this.#owner;
    const plan = layMarker(session.workbench, answer, ending.signal);
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

/** All inputs of a layout. */
interface LaidAnswer extends Pick<Design, 'garment' | 'options' | 'names'> {
  readonly result: SolveResult;
  readonly print: LaidPrint;
  /** Fabric width between its edges, and the unusable strip along each of them. [cm] */
  readonly widthCm: number;
  readonly selvedgeCm: number;
}

/**
 * @throws {SolverError} if a piece does not fit on the fabric, with the piece's name; the signal's
 * reason
 */
async function layMarker(
  workbench: Workbench,
  {result, garment, options, names, print, widthCm, selvedgeCm}: LaidAnswer,
  signal: AbortSignal,
): Promise<LayPlan> {
  const document = await workbench.solving.documentOf(garment);
  signal.throwIfAborted();
  const order = markerOrder(
    [{result, garment: document, options, ...(names && {names})}],
    {widthCm, selvedgeCm},
    print,
  );
  return layPlan(order, await workbench.solver.marker(order.problem, {signal}));
}
