/** The answer to the present design laid on cloth: for as long as somebody looks at it, with what is moved there by hand. */
import {movedPlan, placesIn} from '../marker/moved-plan.js';
import type {Bolt, LaidPiece} from '../marker/places.js';
import {layPlan} from '../marker/plan.js';
import type {MarkerOrder} from '../marker/problem.js';
import {printOf, type Design, type DesignPrint} from '../model/design.js';
import type {Failure} from '../model/failure.js';
import type {Alignment} from '../model/geometry.js';
import {amended, begun, redone, stepped, undone, type History} from '../model/history.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerAnswer, MarkerLayout} from '../model/marker.js';
import type {SolveResult} from '../model/result.js';
import {keepCloth, storedCloth, type ClothChoices} from './cloth-choices.js';
import {askedOf, noPins, offersFor, orderOf, type Flaw, type LayStep} from './lay-step.js';
import {lastOf} from './last-of.js';
import {toFailure} from './latest-solve.js';
import {Observable} from './observable.js';
import type {Workbench} from './workbench.js';

/** `waiting`: for an answer to be laid; `laying`: the best so far is shown. */
type LayingState =
  | {readonly kind: 'waiting' | 'done' | 'cancelled'}
  | {readonly kind: 'laying'; readonly fraction: number}
  | {readonly kind: 'failed'; readonly failure: Failure};

/** One design on its cloth. */
interface Work {
  readonly result: SolveResult;
  readonly print: DesignPrint;
  /** Undefined where it cannot be laid at all. */
  order: MarkerOrder | undefined;
  history: History<LayStep>;
}

/** A piece on the cloth. */
export interface PieceOnCloth extends LaidPiece {
  /** Among all that are laid. */
  readonly number: number;
  /** By the garment's file. */
  readonly name: string;
}

type Source = Pick<
  Workbench,
  'design' | 'garment' | 'result' | 'subscribe' | 'solver' | 'preferences'
>;

export class Laying extends Observable {
  readonly #source: Source;
  /** What is shown, and what takes its place once there is something of it. */
  #work: Work | undefined;
  #next: Work | undefined;
  /** Of answers that somebody may come back to. */
  readonly #known = new WeakMap<SolveResult, Work>();
  #state: LayingState = {kind: 'waiting'};
  #running: AbortController | undefined;
  #viewers = 0;
  #end: (() => void) | undefined;

  constructor(source: Source) {
    super();
    this.#source = source;
  }

  get state(): LayingState {
    return this.#state;
  }

  /** Undefined until something is laid. */
  get step(): LayStep | undefined {
    return this.#work?.history.present;
  }

  /** What is shown is laid of another answer than the present one. */
  get isStale(): boolean {
    const {result, design} = this.#source;
    return this.#work !== undefined && !isOf(this.#work, result, design);
  }

  /** What there is to be taken back; undefined for nothing, as where another design is to be laid. */
  get history(): History<LayStep> | undefined {
    return this.isStale ? undefined : this.#work?.history;
  }

  /** The plan with the pieces as they lie now. */
  get plan(): LayPlan | undefined {
    const {order} = this.#work ?? {};
    const {plan, places = []} = this.step ?? {};
    return order && plan && this.#planOf(order, plan, places);
  }

  readonly #planOf = lastOf(movedPlan);

  /** Somebody has moved pieces since they were laid. */
  get isMoved(): boolean {
    const {order} = this.#work ?? {};
    const {plan, places = []} = this.step ?? {};
    return order !== undefined && plan !== undefined && areMoved(placesIn(order, plan), places);
  }

  /** All that have a place. */
  get pieces(): readonly PieceOnCloth[] {
    const {order} = this.#work ?? {};
    return order ? this.#piecesOf(order, this.step?.places ?? []) : [];
  }

  readonly #piecesOf = lastOf(
    ({pieces, problem}: MarkerOrder, places: LayStep['places']): readonly PieceOnCloth[] =>
      pieces.flatMap(({piece: name}, number) => {
        const [place, piece] = [places[number], problem.pieces[number]];
        return place && piece ? [{number, name, place, piece}] : [];
      }),
  );

  /** Names of all that are laid, by their numbers. */
  get names(): readonly string[] {
    return (this.#work?.order ?? this.#next?.order)?.pieces.map(({piece}) => piece) ?? [];
  }

  /** The cloth that is shown; undefined until something is laid. */
  get bolt(): Bolt | undefined {
    const {print} = this.#work ?? {};
    return this.step?.plan && print && this.#boltOf(this.step.plan, this.step, print);
  }

  readonly #boltOf = lastOf(
    ({printOrigin}: LayPlan, {choices, flaws}: LayStep, print: DesignPrint): Bolt => {
      const {widthCm, selvedgeCm, gapCm, isOneWay} = choices;
      const repeat = printOf(print);
      return {
        ...{repeat, origin: printOrigin ?? [0, 0], widthCm, selvedgeCm, gapCm, flaws},
        isOneWay: isOneWay || repeat.oneWay === true,
      };
    },
  );

  /** What the print is on that is shown. */
  get print(): DesignPrint | undefined {
    return this.#work?.print;
  }

  /** As it is shown, or about to be. */
  get choices(): ClothChoices | undefined {
    const {design} = this.#source;
    const work = this.#next ?? this.#work;
    return work?.history.present.choices ?? (design && storedCloth(design.print));
  }

  /** Shows what there is, and lays from now on. @returns what ends that */
  show(): () => void {
    this.#viewers += 1;
    this.#end ??= this.#source.subscribe(['history', 'solving'], () => {
      this.#follow();
    });
    this.#follow();
    return () => {
      this.#viewers -= 1;
      if (this.#viewers > 0) return;
      this.#end?.();
      this.#end = undefined;
      if (this.#state.kind !== 'laying') return;
      this.#stop();
      this.#become({kind: this.step?.plan && !this.#next ? 'cancelled' : 'waiting'});
      this.#next = undefined;
    };
  }

  /** Ends what is under way; the best so far stays. */
  cancel(): void {
    if (this.#state.kind !== 'laying') return;
    this.#stop();
    this.#become({kind: 'cancelled'});
  }

  /** Lays all but the pinned ones anew. */
  pack(): void {
    this.#change({}, true);
  }

  /** Cloth or rules are others, so that nothing stays where it is. */
  choose(change: Partial<ClothChoices>): void {
    const {choices} = this;
    const {design} = this.#source;
    if (!choices || !design) return;
    const next = {...choices, ...change};
    if (JSON.stringify(next) === JSON.stringify(choices)) return;
    keepCloth(design.print, next);
    this.#change({choices: next, pins: noPins}, true);
  }

  setFlaws(flaws: readonly Flaw[]): void {
    this.#change({flaws}, true);
  }

  move(number: number, place: Alignment): void {
    const {places = []} = this.step ?? {};
    this.#change({places: places.map((one, k) => (k === number ? place : one))}, false);
  }

  togglePin(number: number): void {
    const pins = new Set(this.step?.pins);
    if (!pins.delete(number)) pins.add(number);
    this.#change({pins}, false);
  }

  /** @returns whether there was something to take back */
  undo(): boolean {
    return this.#travel(undone);
  }

  redo(): boolean {
    return this.#travel(redone);
  }

  #travel(way: (history: History<LayStep>) => History<LayStep> | undefined): boolean {
    const history = this.history && way(this.history);
    if (!this.#work || !history) return false;
    this.#stop();
    this.#work.history = history;
    keepCloth(this.#work.print, history.present.choices);
    this.#settle(history.present);
    return true;
  }

  /** @param packs the pieces are laid anew, as a part of the step */
  #change(change: Partial<LayStep>, packs: boolean): void {
    const work = this.#next ?? this.#work;
    if (!work || !isOf(work, this.#source.result, this.#source.design)) return;
    this.#stop();
    const {history} = work;
    const next = {...history.present, ...change, failure: undefined};
    work.history = history.present.plan ? stepped(history, next) : amended(history, next);
    if (packs) void this.#run(work);
    else this.#become({kind: 'done'});
  }

  #settle({failure}: LayStep): void {
    this.#become(failure ? {kind: 'failed', failure} : {kind: 'done'});
  }

  #become(state: LayingState): void {
    this.#state = state;
    this.changed();
  }

  #stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  #follow(): void {
    const {design, garment, result} = this.#source;
    if (!design || !garment || !result) {
      this.#stop();
      this.#next = undefined;
      this.#become({kind: 'waiting'});
      return;
    }
    const work = this.#next ?? this.#work;
    if (work && isOf(work, result, design) && this.#state.kind !== 'waiting') return;
    this.#stop();
    const known = this.#known.get(result);
    if (known?.print === design.print && known.history.present.plan) {
      this.#next = undefined;
      this.#work = known;
      this.#settle(known.history.present);
      return;
    }
    // flaws are those of a bolt, whatever is cut from it
    const {flaws = [], plan} = work?.print === design.print ? work.history.present : {};
    const choices = storedCloth(design.print);
    this.#next = {
      ...{result, print: design.print, order: undefined},
      history: begun({
        choices,
        flaws,
        pins: noPins,
        places: [],
        failure: undefined,
        plan: flaws.length > 0 ? plan : undefined,
      }),
    };
    this.#known.set(result, this.#next);
    void this.#run(this.#next);
  }

  #offer(work: Work, plan: LayPlan, cheaper: LayPlan['cheaper']): void {
    const {present} = work.history;
    if (present.plan !== plan || cheaper.length === 0) return;
    work.history = amended(work.history, {...present, plan: {...plan, cheaper}});
    this.changed();
  }

  async #run(work: Work): Promise<void> {
    const {garment, design} = this.#source;
    if (!garment || !design) return;
    const running = new AbortController();
    this.#running = running;
    this.#become({kind: 'laying', fraction: 0});
    const step = work.history.present;
    const isOver = (): boolean => running.signal.aborted;
    try {
      await new Promise((resolve) => setTimeout(resolve)); // what is shown of it comes first
      if (isOver()) return;
      const toLay = {design, garment, result: work.result, choices: step.choices};
      const order = orderOf(toLay);
      const problem = askedOf(order.problem, step);
      const take = (layout: MarkerLayout & Partial<MarkerAnswer>): void => {
        const plan = layPlan({...order, problem}, layout);
        work.order = order;
        work.history = amended(work.history, {...step, plan, places: placesIn(order, plan)});
        this.#work = work;
        this.#next = undefined;
      };
      const answer = await this.#source.solver.marker(problem, {
        signal: running.signal,
        onProgress: ({fraction}) => {
          if (isOver()) return;
          this.#state = {kind: 'laying', fraction};
          this.changedOften();
        },
        onLayout: (layout) => {
          if (isOver()) return;
          take(layout);
          this.changed();
        },
      });
      if (isOver()) return;
      take(answer);
      this.#become({kind: 'done'});
      const {plan} = work.history.present;
      // of a bolt that lies there, nothing is to be chosen any more
      if (plan && problem.startCm === undefined) {
        const cheaper = await offersFor(toLay, plan, this.#source.solver, running.signal);
        if (isOver()) return;
        this.#offer(work, plan, cheaper);
      }
      this.#running = undefined;
    } catch (error) {
      if (isOver()) return;
      this.#running = undefined;
      const failure = toFailure(error);
      const places = work.order?.pieces.map(() => undefined) ?? [];
      work.history = amended(work.history, {...step, places, failure});
      this.#become({kind: 'failed', failure});
    }
  }
}

const isOf = (work: Work, result: SolveResult | undefined, design: Design | undefined): boolean =>
  work.result === result && work.print === design?.print;

const areMoved = (laid: LayStep['places'], places: LayStep['places']): boolean =>
  JSON.stringify(laid) !== JSON.stringify(places);

const known = new WeakMap<Source, Laying>();

/** The one of a workbench, begun when it is first asked for. */
export function layingOf(workbench: Workbench): Laying {
  const laying = known.get(workbench) ?? new Laying(workbench);
  known.set(workbench, laying);
  return laying;
}
