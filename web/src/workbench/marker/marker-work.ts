/** Layout of one result: the steps of the user who works on it, and the data for its view. */
import {isMoved, movedPlan} from '../../marker/moved-plan.js';
import type {Bolt, LaidPiece} from '../../marker/places.js';
import type {MarkerOrder} from '../../marker/problem.js';
import {printOf, type Design, type DesignPrint} from '../../model/design/design.js';
import {begun, type History} from '../../model/design/history.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {SolveResult} from '../../model/result/result.js';
import {noPins, type LayStep} from './lay-step.js';
import {lastOf} from '../../model/base/last-of.js';

/** A piece on the fabric. */
export interface PieceOnFabric extends LaidPiece {
  /** Number among all pieces of the layout. */
  readonly number: number;
  /** Name in the garment file. */
  readonly name: string;
}

export class MarkerWork {
  readonly result: SolveResult;
  readonly print: DesignPrint;
  history: History<LayStep>;

  constructor(result: SolveResult, print: DesignPrint, history: History<LayStep>) {
    this.result = result;
    this.print = print;
    this.history = history;
  }

  /**
   * A new layout without pieces. It keeps the flaws, which belong to the bolt, if the print is the
   * same; it also keeps the number of garments.
   */
  static after(
    before: MarkerWork | undefined,
    result: SolveResult,
    print: DesignPrint,
    choices: LayStep['choices'],
  ): MarkerWork {
    const {flaws = [], plan} = before?.print === print ? before.step : {};
    const {copies} = before?.step.choices ?? choices;
    const step = {
      ...{choices: {...choices, copies}, flaws, pins: noPins, places: []},
      ...{failure: undefined, order: undefined},
      plan: flaws.length > 0 ? plan : undefined,
    };
    return new MarkerWork(result, print, begun(step));
  }

  get step(): LayStep {
    return this.history.present;
  }

  isOf(result: SolveResult | undefined, design: Design | undefined): boolean {
    return this.result === result && this.print === design?.print;
  }

  /** The plan with the present places of the pieces. */
  get plan(): LayPlan | undefined {
    const {order, plan, places} = this.step;
    return order && plan && this.#planOf(order, plan, places);
  }

  readonly #planOf = lastOf(movedPlan);

  /** True if the user has moved pieces since they were laid out. */
  get isMoved(): boolean {
    const {order, plan, places} = this.step;
    return order !== undefined && plan !== undefined && this.#areMoved(order, plan, places);
  }

  readonly #areMoved = lastOf(isMoved);

  /** All pieces that have a place. */
  get pieces(): readonly PieceOnFabric[] {
    const {order, places} = this.step;
    return order ? this.#piecesOf(order, places) : [];
  }

  readonly #piecesOf = lastOf(
    ({pieces, problem}: MarkerOrder, places: LayStep['places']): readonly PieceOnFabric[] =>
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
