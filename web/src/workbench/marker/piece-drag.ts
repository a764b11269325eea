/** A piece during a drag over the fabric: its free places, and the place that it would take. */
import {
  apartFrom,
  obstaclesTo,
  Places,
  turnAt,
  turnedRing,
  turnsOf,
  type Bolt,
  type LaidPiece,
  type Obstacles,
} from '../../marker/places.js';
import {minus, plus, type Alignment, type Point} from '../../model/geometry/vectors.js';
import type {PieceOnFabric} from './marker-work.js';

/** A dragged piece: its offset, and the place that it would take. */
export interface Dragged {
  readonly piece: PieceOnFabric;
  /** [cm] */
  readonly by: Point;
  readonly place: Alignment;
  readonly inWay: Obstacles;
  /** The cut line at the place that the piece would take. */
  readonly target: readonly Point[];
  /** Free places, each as the middle of the piece. */
  readonly dots: readonly Point[];
}

/** Returns the places of a piece at its present turn. @param k index of the piece */
export function placesOf(pieces: readonly LaidPiece[], k: number, bolt: Bolt): Places | undefined {
  const own = pieces[k];
  const turn = own && turnAt(turnsOf(own.piece, bolt), own.place.angle);
  return turn && new Places(pieces, k, turn, bolt);
}

export class PieceDrag {
  readonly piece: PieceOnFabric;
  readonly #pieces: readonly PieceOnFabric[];
  readonly #index: number;
  readonly #bolt: Bolt;
  readonly #places: Places | undefined;
  /**
   * Indices of the places by distance from the start; places before `#looked` have been checked.
   */
  readonly #order: readonly number[];
  #looked = 0;
  #dots: readonly Point[] = [];
  #by: Point = [0, 0];
  #target: Point;

  constructor(pieces: readonly PieceOnFabric[], piece: PieceOnFabric, bolt: Bolt) {
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

  /**
   * Moves the piece to the place nearest to the pointer.
   * @param by offset of the drag [cm]
   * @param takes true if the piece may overlap others
   */
  moveBy(by: Point, takes: boolean): void {
    this.#by = by;
    const wanted = apartFrom(plus(this.piece.place.translation, by));
    const found = takes ? this.#places?.leastOfAll(wanted) : this.#places?.least(wanted);
    this.#target = found ?? this.piece.place.translation;
  }

  /**
   * Checks which places are free, within a time limit.
   * @param time [ms]
   * @returns true if unchecked places remain
   */
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

  /** The place that the piece takes when dropped. */
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

  /** Offset from the start of the drag. [cm] */
  get way(): Point {
    return minus(this.#target, this.piece.place.translation);
  }
}
