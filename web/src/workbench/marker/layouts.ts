/**
 * Layout of the design's garments on fabric, computed while it is on display, including pieces
 * moved by hand.
 */
import {withOffers} from '../../marker/cheaper.js';
import {placesIn} from '../../marker/moved-plan.js';
import {aroundPins} from '../../model/result/pinned-plan.js';
import type {PieceOfMarker} from '../../marker/pieces.js';
import type {Bolt} from '../../marker/places.js';
import type {DesignPrint} from '../../model/design/design.js';
import type {Failure} from '../../model/base/failure.js';
import type {Alignment} from '../../model/geometry/vectors.js';
import {
  amended,
  mapped,
  redone,
  stepped,
  undone,
  type History,
} from '../../model/design/history.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {SolveResult} from '../../model/result/result.js';
import {allowancesIn} from '../allowances.js';
import {AddedResults, type GarmentInWork, type SolvedGarment} from './added-results.js';
import {storedFabric, withFabric, type MarkerChoices} from './marker-choices.js';
import {MarkerWork, type PieceOnFabric} from './marker-work.js';
import {laid, offersFor, ownAllowancesOf, type ToLay} from './lay-run.js';
import {noPins, type Flaw, type LayStep} from './lay-step.js';
import {toFailure} from '../latest-solve.js';
import {Observable} from '../observable.js';
import type {Workbench} from '../workbench.js';

/**
 * `waiting`: there is no result to lay out; `laying`: the best layout so far is shown, or with
 * `inWork` an added garment is being solved.
 */
type LayoutsState =
  | {readonly kind: 'waiting' | 'done' | 'cancelled'}
  | {readonly kind: 'laying'; readonly fraction: number; readonly inWork?: GarmentInWork}
  | {readonly kind: 'failed'; readonly failure: Failure};

type Source = Pick<
  Workbench,
  'history' | 'solving' | 'subscribe' | 'solver' | 'preferences' | 'prefer'
>;

/** Number of stored layouts. */
const mostKnown = 12;

export class Layouts extends Observable {
  readonly #source: Source;
  /** Layout on display, and the one that replaces it as soon as it has pieces. */
  #work: MarkerWork | undefined;
  #next: MarkerWork | undefined;
  /** Layouts that the user may return to, the oldest first. */
  #known: readonly MarkerWork[] = [];
  readonly #results = new AddedResults();
  #state: LayoutsState = {kind: 'waiting'};
  #running: AbortController | undefined;
  /** True if the fabric was changed and has no layout yet: the display shows the fabric before. */
  #isAwaited = false;
  #viewers = 0;
  #end: (() => void) | undefined;

  constructor(source: Source) {
    super();
    this.#source = source;
  }

  get state(): LayoutsState {
    return this.#state;
  }

  /** Undefined until there is a layout. */
  get step(): LayStep | undefined {
    return this.#work?.step;
  }

  /** True if the display shows the layout of another result than the present one. */
  get isStale(): boolean {
    const {result} = this.#source.solving;
    const {design} = this.#source.history;
    return this.#work !== undefined && !this.#work.isOf(result, design);
  }

  /** True if the display shows other fabric, because the present fabric has no layout yet. */
  get isAwaited(): boolean {
    return this.#isAwaited;
  }

  /** Steps to undo; undefined if there are none, such as while another design is laid out. */
  get history(): History<LayStep> | undefined {
    return this.isStale ? undefined : this.#work?.history;
  }

  /** The plan with the present places of the pieces. */
  get plan(): LayPlan | undefined {
    return this.#work?.plan;
  }

  /** True if the user has moved pieces since they were laid out. */
  get isMoved(): boolean {
    return this.#work?.isMoved ?? false;
  }

  /** All pieces that have a place. */
  get pieces(): readonly PieceOnFabric[] {
    return this.#work?.pieces ?? [];
  }

  /** Sources of all pieces of the layout, by their numbers. */
  get sources(): readonly PieceOfMarker[] {
    return (this.#work ?? this.#next)?.step.order?.pieces ?? [];
  }

  /** The garments of the layout on display, the design's own first. */
  get garments(): readonly SolvedGarment[] {
    return this.#work?.garments ?? [];
  }

  /** Fabric on display; undefined until there is a layout. */
  get bolt(): Bolt | undefined {
    return this.#work?.bolt;
  }

  /** Print on display. */
  get print(): DesignPrint | undefined {
    return this.#work?.print;
  }

  /** Choices on display, or about to be. */
  get choices(): MarkerChoices | undefined {
    const {design} = this.#source.history;
    const preferences = this.#source.preferences.chosen;
    const work = this.#next ?? this.#work;
    return work?.step.choices ?? (design && storedFabric(design.print, preferences));
  }

  /** Edges of the garment that have allowances of their own; `none` until there is a layout. */
  get ownAllowances(): ReturnType<typeof ownAllowancesOf> {
    const toLay = this.#work?.step.order && !this.isStale ? this.#toLay(this.#work) : undefined;
    return toLay ? ownAllowancesOf(toLay) : 'none';
  }

  /** Shows the layout, and computes it from now on. @returns the function that ends this */
  show(): () => void {
    this.#viewers += 1;
    this.#end ??= this.#source.subscribe(['history', 'solving', 'preferences'], () => {
      this.#follow();
    });
    this.#follow();
    return () => {
      this.#viewers -= 1;
      if (this.#viewers > 0) return;
      this.#end?.();
      this.#end = undefined;
      if (this.#state.kind !== 'laying') return;
      const isShown = this.step?.plan && !this.#next && !this.#isAwaited;
      this.#leave();
      this.#become({kind: isShown ? 'cancelled' : 'waiting'});
      this.#next = undefined;
    };
  }

  /**
   * Ends the running layout and keeps the best one so far. If changed fabric has none yet, the
   * change is undone.
   */
  cancel(): void {
    if (this.#state.kind !== 'laying' || this.#withdraw()) return;
    this.#stop();
    this.#become({kind: 'cancelled'});
  }

  /** Stops a layout. If its fabric was changed, it starts again when the user returns to it. */
  #leave(): void {
    if (this.#isAwaited) this.#known = this.#known.filter((work) => work !== this.#work);
    this.#stop();
  }

  /** Undoes a change of the fabric that has no layout yet. @returns whether there was one */
  #withdraw(): boolean {
    const work = this.#work;
    const before = this.#isAwaited && work ? undone(work.history) : undefined;
    if (!work || !before) return false;
    this.#stop();
    work.history = {...before, future: []}; // there is nothing to redo
    this.#settle(before.present);
    this.#remember(before.present.choices);
    return true;
  }

  /** Lays out all pieces anew, except the pinned ones. */
  pack(): void {
    this.#change({}, true);
  }

  /** Changes fabric or rules, so that no piece keeps its place. */
  choose(change: Partial<MarkerChoices>): void {
    const {choices} = this;
    if (!choices) return;
    const next = {...choices, ...change};
    if (JSON.stringify(next) === JSON.stringify(choices)) return;
    this.#change({choices: next, pins: noPins}, true);
    this.#remember(next);
  }

  /** Notes the price of the fabric, on which no layout depends. */
  setPrice(price: number): void {
    const work = this.#next ?? this.#work;
    const {choices} = this;
    if (!work || !choices) return;
    const next = {...choices, price};
    work.history = mapped(work.history, (step) => ({...step, choices: {...step.choices, price}}));
    this.#remember(next);
    this.changed();
  }

  setFlaws(flaws: readonly Flaw[]): void {
    this.#change({flaws}, true);
  }

  move(number: number, place: Alignment): void {
    const {places = []} = this.step ?? {};
    this.#change({places: places.map((one, k) => (k === number ? place : one))}, false);
  }

  /** Takes a piece off the fabric, until the next layout. */
  remove(number: number): void {
    const {places = [], pins = noPins} = this.step ?? {};
    this.#change(
      {
        places: places.map((one, k) => (k === number ? undefined : one)),
        pins: new Set([...pins].filter((pin) => pin !== number)),
      },
      false,
    );
  }

  togglePin(number: number): void {
    const pins = new Set(this.step?.pins);
    if (!pins.delete(number)) pins.add(number);
    this.#change({pins}, false);
  }

  /** Undoes a step. @returns whether there was one */
  undo(): boolean {
    return this.#travel(undone);
  }

  redo(): boolean {
    return this.#travel(redone);
  }

  #travel(way: (history: History<LayStep>) => History<LayStep> | undefined): boolean {
    const history = this.history && way(this.history);
    if (way === undone && this.#withdraw()) return true;
    if (!this.#work || !history) return false;
    this.#stop();
    this.#work.history = history;
    this.#settle(history.present);
    this.#remember(history.present.choices);
    return true;
  }

  #remember(choices: MarkerChoices): void {
    const {design} = this.#source.history;
    const preferences = this.#source.preferences.chosen;
    if (design) this.#source.prefer(withFabric(design.print, choices, preferences));
  }

  /** @param packs true to lay out the pieces anew, as part of the step */
  #change(change: Partial<LayStep>, packs: boolean): void {
    const work = this.#next ?? this.#work;
    if (!work?.isOf(this.#source.solving.result, this.#source.history.design)) return;
    const isAwaited = this.#isAwaited;
    if (isAwaited && !packs) return; // the display is about to be replaced
    // offers belong to the plan, even if its pieces are moved meanwhile
    if (packs || this.#state.kind === 'laying') this.#stop();
    const {history, step} = work;
    const next = {...step, ...change, failure: undefined};
    work.history = step.plan && !isAwaited ? stepped(history, next) : amended(history, next);
    const isSameFabric = !isAwaited && next.choices === step.choices && next.flaws === step.flaws;
    this.#isAwaited = work === this.#work && !isSameFabric;
    if (packs) void this.#run(work, isSameFabric ? step.plan : undefined);
    else this.#become({kind: 'done'});
  }

  #settle({failure}: LayStep): void {
    this.#become(failure ? {kind: 'failed', failure} : {kind: 'done'});
  }

  #become(state: LayoutsState): void {
    this.#state = state;
    this.changed();
  }

  #stop(): void {
    this.#running?.abort();
    this.#running = undefined;
    this.#isAwaited = false;
  }

  #follow(): void {
    const {design} = this.#source.history;
    const {garment, result} = this.#source.solving;
    if (!design || !garment || !result) {
      this.#leave();
      this.#next = undefined;
      this.#become({kind: 'waiting'});
      return;
    }
    const work = this.#next ?? this.#work;
    if (!work?.isOf(result, design) || this.#state.kind === 'waiting') this.#begin(result, work);
    // cutting files use the same allowances
    this.choose(allowancesIn(this.#source.preferences.chosen));
  }

  /** Shows the known layout of a result, or computes it. @param before the layout on display */
  #begin(result: SolveResult, before: MarkerWork | undefined): void {
    const {design} = this.#source.history;
    const preferences = this.#source.preferences.chosen;
    if (!design) return;
    this.#leave();
    const known = this.#known.find((work) => work.isOf(result, design));
    if (known?.step.plan) {
      this.#next = undefined;
      this.#work = known;
      this.#settle(known.step);
      return;
    }
    const choices = storedFabric(design.print, preferences);
    this.#next = MarkerWork.after(before, result, design, choices);
    const others = this.#known.filter((work) => work !== known);
    this.#known = [...others, this.#next].slice(-mostKnown);
    void this.#run(this.#next);
  }

  #toLay({garments, print, step}: MarkerWork): ToLay {
    return {garments, print, step};
  }

  /** Solves the added garments. @returns false if there is no design to lay out any more */
  async #complete(work: MarkerWork, signal: AbortSignal): Promise<boolean> {
    const {garment: document} = this.#source.solving;
    const {design} = this.#source.history;
    if (!document || !design) return false;
    const own = {result: work.result, document};
    work.garments = await this.#results.of(design, own, this.#source, {
      signal,
      onProgress: (inWork, fraction) => {
        this.#state = {kind: 'laying', fraction, inWork};
        this.changedOften();
      },
    });
    return true;
  }

  /** @param before a plan of the same pieces on the same fabric */
  async #run(work: MarkerWork, before?: LayPlan): Promise<void> {
    const {step} = work;
    const {solver} = this.#source;
    const running = new AbortController();
    this.#running = running;
    this.#become({kind: 'laying', fraction: 0});
    try {
      if (!(await this.#complete(work, running.signal))) return;
      running.signal.throwIfAborted();
      const toLay = {...this.#toLay(work), step};
      await laid(toLay, solver, {
        signal: running.signal,
        onProgress: (fraction) => {
          this.#state = {kind: 'laying', fraction};
          this.changedOften();
        },
        onPlan: (order, found) => {
          const plan = step.pins.size > 0 ? aroundPins(found, before) : found;
          const isFirst = this.#work !== work;
          const places = placesIn(order, plan);
          work.history = amended(work.history, {...withPriceOf(work, step), order, plan, places});
          this.#isAwaited = false;
          this.#work = work;
          this.#next = undefined;
          if (isFirst) this.changed();
          else this.changedOften();
        },
      });
      this.#become({kind: 'done'});
      const {plan} = work.step;
      if (plan) this.#offer(work, plan, await offersFor(toLay, plan, solver, running.signal));
      this.#running = undefined;
    } catch (error) {
      if (running.signal.aborted) return;
      this.#stop();
      const failure = toFailure(error);
      const places = step.order?.pieces.map(() => undefined) ?? [];
      work.history = amended(work.history, {...withPriceOf(work, step), places, failure});
      this.#become({kind: 'failed', failure});
    }
  }

  /** Adds offers to the plan in all steps that have moved its pieces since. */
  #offer(work: MarkerWork, plan: LayPlan, cheaper: LayPlan['cheaper']): void {
    if (cheaper.length === 0) return;
    const offering = withOffers(plan, cheaper);
    work.history = mapped(work.history, (step) =>
      step.plan === plan ? {...step, plan: offering} : step,
    );
    this.changed();
  }
}

/** A step with the present price, which may change while the pieces are laid out. */
const withPriceOf = ({step: {choices}}: MarkerWork, step: LayStep): LayStep =>
  step.choices.price === choices.price
    ? step
    : {...step, choices: {...step.choices, price: choices.price}};

const known = new WeakMap<Source, Layouts>();

/** Layouts of a workbench, created at the first call. */
export function layoutsOf(workbench: Workbench): Layouts {
  const layouts = known.get(workbench) ?? new Layouts(workbench);
  known.set(workbench, layouts);
  return layouts;
}
