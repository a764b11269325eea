/** Moves of a piece on the fabric by keys and buttons. */
import {
  onFrom,
  Places,
  apartFrom,
  turnAfter,
  turnedInPlace,
  turnsOf,
  type Bolt,
} from '../../marker/places.js';
import {minus, norm, wrapped, type Alignment, type Point} from '../../model/geometry/vectors.js';
import {reducedBasis} from '../../model/print/wallpaper.js';
import type {PieceOnCloth} from './marker-work.js';
import {placesOf} from './piece-drag.js';

export const ways: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Target of a move. */
interface Move {
  readonly place: Alignment;
  /**
   * Distance from the wanted position if nearer places are occupied; undefined at the nearest
   * place. [cm]
   */
  readonly fartherCm: number | undefined;
}

/**
 * Returns the place of least cost; undefined if there is none.
 * @param from wanted position
 * @param takes true if the piece may overlap others
 */
function moveTo(
  places: Places,
  cost: (at: Point) => number,
  from: Point,
  takes: boolean,
): Move | undefined {
  const nearest = places.leastOfAll(cost);
  const translation = takes ? nearest : places.least(cost);
  if (!translation) return undefined;
  return {
    place: {angle: places.angle, translation},
    fartherCm: translation === nearest ? undefined : norm(minus(translation, from)),
  };
}

/**
 * Returns the next place in a direction; undefined if there is none.
 * @param takes true if the piece may overlap others
 */
export function placeOn(
  pieces: readonly PieceOnCloth[],
  piece: PieceOnCloth,
  bolt: Bolt,
  way: Point,
  takes: boolean,
): Move | undefined {
  const places = placesOf(pieces, pieces.indexOf(piece), bolt);
  const {translation} = piece.place;
  return places && moveTo(places, onFrom(translation, way), translation, takes);
}

/** Least radius of nearby places, unless a repeat is longer. Chosen: a hand's breadth. [cm] */
const leastReach = 10;

/**
 * Greatest distance that a pinned piece may move when it turns, since the user wants it about
 * there. [cm]
 */
export const reachOfPinned = ({repeat: {w1, w2}}: Bolt): number =>
  Math.max(leastReach, ...reducedBasis(w1, w2).map(norm));

/** Returns whether a piece has more than one turn, free or occupied. */
export const canTurn = ({piece}: PieceOnCloth, bolt: Bolt): boolean =>
  turnsOf(piece, bolt).length > 1;

/**
 * Returns the nearest place at the next turn that has one; undefined if no turn has one.
 * @param reach greatest distance of the move [cm]
 */
export function placeTurned(
  pieces: readonly PieceOnCloth[],
  piece: PieceOnCloth,
  bolt: Bolt,
  {takes, reach}: {readonly takes: boolean; readonly reach: number},
): Move | undefined {
  const turns = turnsOf(piece.piece, bolt);
  const k = pieces.indexOf(piece);
  let {angle} = piece.place;
  for (let tries = 1; tries < turns.length; tries++) {
    const turn = turnAfter(turns, angle);
    if (!turn || Math.abs(wrapped(turn.angle - piece.place.angle)) < 1e-6) return undefined;
    angle = turn.angle;
    const places = new Places(pieces, k, turn, bolt);
    const inPlace = turnedInPlace(piece, angle);
    const apart = apartFrom(inPlace);
    const near = (at: Point): number => (apart(at) <= reach ** 2 ? apart(at) : Infinity);
    const move = moveTo(places, near, inPlace, takes);
    if (move) return move;
  }
  return undefined;
}
