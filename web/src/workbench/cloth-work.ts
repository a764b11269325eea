/** One answer on its cloth: what is laid of it, the steps of whoever has it in hand, and what is to be seen of them. */
import {isMoved, movedPlan} from '../marker/moved-plan.js';
import type {Bolt, LaidPiece} from '../marker/places.js';
import type {MarkerOrder} from '../marker/problem.js';
import {printOf, type Design, type DesignPrint} from '../model/design.js';
import {begun, type History} from '../model/history.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {SolveResult} from '../model/result.js';
import {noPins, type LayStep} from './lay-step.js';
import {lastOf} from './last-of.js';

/** A piece on the cloth. */
export interface PieceOnCloth extends LaidPiece {
  /** Among all that are laid. */
  readonly number: number;
  /** By the garment's file. */
  readonly name: string;
}

export class ClothWork {
  readonly result: SolveResult;
  readonly print: DesignPrint;
  history: History<LayStep>;

  constructor(result: SolveResult, print: DesignPrint, history: History<LayStep>) {
    this.result = result;
    this.print = print;
    this.history = history;
  }

  /** A new one, with nothing laid yet. Flaws are those of a bolt, whatever is cut from it; and as many are cut. */
  static after(
    before: ClothWork | undefined,
    result: SolveResult,
    print: DesignPrint,
    choices: LayStep['choices'],
  ): ClothWork {
    const {flaws = [], plan} = before?.print === print ? before.step : {};
    const {copies} = before?.step.choices ?? choices;
    const step = {
      ...{choices: {...choices, copies}, flaws, pins: noPins, places: []},
      ...{failure: undefined, order: undefined},
      plan: flaws.length > 0 ? plan : undefined,
    };
    return new ClothWork(result, print, begun(step));
  }

  get step(): LayStep {
    return this.history.present;
  }

  isOf(result: SolveResult | undefined, design: Design | undefined): boolean {
    return this.result === result && this.print === design?.print;
  }

  /** The plan with the pieces as they lie now. */
  get plan(): LayPlan | undefined {
    const {order, plan, places} = this.step;
    return order && plan && this.#planOf(order, plan, places);
  }

  readonly #planOf = lastOf(movedPlan);

  /** Somebody has moved pieces since they were laid. */
  get isMoved(): boolean {
    const {order, plan, places} = this.step;
    return order !== undefined && plan !== undefined && this.#areMoved(order, plan, places);
  }

  readonly #areMoved = lastOf(isMoved);

  /** All that have a place. */
  get pieces(): readonly PieceOnCloth[] {
    const {order, places} = this.step;
    return order ? this.#piecesOf(order, places) : [];
  }

  readonly #piecesOf = lastOf(
    ({pieces, problem}: MarkerOrder, places: LayStep['places']): readonly PieceOnCloth[] =>
      pieces.flatMap(({piece: name}, number) => {
        const [place, piece] = [places[number], problem.pieces[number]];
        return place && piece ? [{number, name, place, piece}] : [];
      }),
  );

  get bolt(): Bolt | undefined {
    const {step, print} = this;
    return step.plan && this.#boltOf(step.plan, step.choices, step.flaws, print);
  }

  readonly #boltOf = lastOf(
    (
      {printOrigin}: LayPlan,
      {widthCm, selvedgeCm, gapCm, isOneWay}: LayStep['choices'],
      flaws: LayStep['flaws'],
      print: DesignPrint,
    ): Bolt => {
      const repeat = printOf(print);
      return {
        ...{repeat, origin: printOrigin ?? [0, 0], widthCm, selvedgeCm, gapCm, flaws},
        isOneWay: isOneWay || repeat.oneWay === true,
      };
    },
  );
}
