/** A piece that is being dragged over its cloth: where it may lie, and where it would come to lie. */
import {
  apartFrom,
  obstaclesTo,
  Places,
  turnAt,
  turnedRing,
  turnsOf,
  type Bolt,
  type LaidPiece,
} from '../../marker/places.js';
import {minus, plus, type Alignment, type Point} from '../../model/geometry.js';
import type {PieceOnCloth} from '../../workbench/cloth-work.js';
import type {Dragged} from './cloth-sheet.js';

/** Places of a piece at the turn that it has. @param k its index */
export function placesOf(pieces: readonly LaidPiece[], k: number, bolt: Bolt): Places | undefined {
  const own = pieces[k];
  const turn = own && turnAt(turnsOf(own.piece, bolt), own.place.angle);
  return turn && new Places(pieces, k, turn, bolt);
}

export class PieceDrag {
  readonly piece: PieceOnCloth;
  readonly #pieces: readonly PieceOnCloth[];
  readonly #index: number;
  readonly #bolt: Bolt;
  readonly #places: Places | undefined;
  /** Numbers of the places, the nearest to where it began first; those behind `#looked` are known. */
  readonly #order: readonly number[];
  #looked = 0;
  #dots: readonly Point[] = [];
  #by: Point = [0, 0];
  #target: Point;

  constructor(pieces: readonly PieceOnCloth[], piece: PieceOnCloth, bolt: Bolt) {
    this.piece = piece;
    this.#pieces = pieces;
    this.#index = pieces.indexOf(piece);
    this.#bolt = bolt;
    this.#places = placesOf(pieces, this.#index, bolt);
    const {all = []} = this.#places ?? {};
    const far = all.map(apartFrom(piece.place.translation));
    this.#order = [...all.keys()].sort((a, b) => (far[a] ?? 0) - (far[b] ?? 0));
    this.#target = piece.place.translation;
  }

  /** @param by how far it is dragged [cm] @param takes whether it may go where others lie */
  moveBy(by: Point, takes: boolean): void {
    this.#by = by;
    const wanted = apartFrom(plus(this.piece.place.translation, by));
    const found = takes ? this.#places?.leastOfAll(wanted) : this.#places?.least(wanted);
    this.#target = found ?? this.piece.place.translation;
  }

  /** Finds out which places are free, for so long. @returns whether there are more @param time [ms] */
  look(time: number): boolean {
    const end = performance.now() + time;
    const {all = []} = this.#places ?? {};
    const {inner} = turnedRing(this.piece.piece.outline, this.place.angle);
    const found: Point[] = [];
    while (this.#looked < this.#order.length && performance.now() < end) {
      const n = this.#order[this.#looked++] ?? 0;
      const at = all[n];
      if (at && this.#places?.isFree(n)) found.push(plus(at, inner));
    }
    if (found.length > 0) this.#dots = [...this.#dots, ...found];
    return this.#looked < this.#order.length;
  }

  /** Where it goes when it is let go. */
  get place(): Alignment {
    const angle = this.#places?.angle ?? this.piece.place.angle;
    return {angle, translation: this.#target};
  }

  get shown(): Dragged {
    const {place} = this;
    const ring = turnedRing(this.piece.piece.outline, place.angle);
    return {
      ...{piece: this.piece, place, by: this.#by, dots: this.#dots},
      inWay: obstaclesTo(this.#pieces, this.#index, place, this.#bolt),
      target: ring.points.map((p) => plus(p, place.translation)),
    };
  }

  /** From where it lay. */
  get way(): Point {
    return minus(this.#target, this.piece.place.translation);
  }
}
