/** Layout of a design's garments: the steps of the user who works on it, and the data for its view. */
import {isMoved, movedPlan} from '../../marker/moved-plan.js';
import type {Bolt, LaidPiece} from '../../marker/places.js';
import type {MarkerOrder} from '../../marker/problem.js';
import {printOf, type Design, type DesignPrint} from '../../model/design/design.js';
import {begun, type History} from '../../model/design/history.js';
import {asCut} from '../../model/print/as-cut.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {SolveResult} from '../../model/result/result.js';
import type {SolvedGarment} from './added-results.js';
import {noPins, type LayStep} from './lay-step.js';
import {lastOf} from '../../model/base/last-of.js';

/** A piece on the fabric. */
export interface PieceOnFabric extends LaidPiece {
  /** Number among all pieces of the layout. */
  readonly number: number;
  /** Index of its garment; 0 is the design's own. */
  readonly garment: number;
  /** Name in the garment file. */
  readonly name: string;
}

/** The parts of a design on which its fabric layout depends, apart from the results. */
type LaidDesign = Pick<Design, 'print' | 'copies' | 'added'>;

export class MarkerWork {
  readonly result: SolveResult;
  readonly print: DesignPrint;
  history: History<LayStep>;
  /** All garments, once the added ones are solved; the design's own is the first. */
  garments: readonly SolvedGarment[] = [];
  readonly #copies: Design['copies'];
  readonly #added: Design['added'];

  constructor(result: SolveResult, {print, copies, added}: LaidDesign, history: History<LayStep>) {
    this.result = result;
    this.print = print;
    this.#copies = copies;
    this.#added = added;
    this.history = history;
  }

  /**
   * A new layout without pieces. It keeps the flaws, which belong to the bolt, if the print is the
   * same.
   */
  static after(
    before: MarkerWork | undefined,
    result: SolveResult,
    design: LaidDesign,
    choices: LayStep['choices'],
  ): MarkerWork {
    const {flaws = [], plan} = before?.print === design.print ? before.step : {};
    const step = {
      ...{choices, flaws, pins: noPins, places: []},
      ...{failure: undefined, order: undefined},
      plan: flaws.length > 0 ? plan : undefined,
    };
    return new MarkerWork(result, design, begun(step));
  }

  get step(): LayStep {
    return this.history.present;
  }

  isOf(result: SolveResult | undefined, design: Design | undefined): boolean {
    return (
      this.result === result &&
      this.print === design?.print &&
      this.#copies === design.copies &&
      this.#added === design.added
    );
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
      pieces.flatMap(({piece: name, result: garment}, number) => {
        const [place, piece] = [places[number], problem.pieces[number]];
        return place && piece ? [{number, garment, name, place, piece}] : [];
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
      const repeat = asCut(printOf(print));
      return {
        ...{repeat, origin: printOrigin ?? [0, 0], widthCm, selvedgeCm, gapCm, flaws},
        isOneWay: isOneWay || repeat.oneWay === true,
      };
    },
  );
}
