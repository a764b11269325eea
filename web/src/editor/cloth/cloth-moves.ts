/** What is done to a piece on the cloth by keys and buttons. */
import {
  onFrom,
  Places,
  apartFrom,
  turnAfter,
  turnedInPlace,
  turnsOf,
  type Bolt,
} from '../../marker/places.js';
import {wrapped, type Alignment, type Point} from '../../model/geometry.js';
import type {PieceOnCloth} from '../../workbench/cloth-work.js';
import {placesOf} from './piece-drag.js';

export const ways: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** The next place in a direction; undefined where there is none. @param takes whether it may be where others lie */
export function placeOn(
  pieces: readonly PieceOnCloth[],
  piece: PieceOnCloth,
  bolt: Bolt,
  way: Point,
  takes: boolean,
): Alignment | undefined {
  const places = placesOf(pieces, pieces.indexOf(piece), bolt);
  const cost = onFrom(piece.place.translation, way);
  const translation = takes ? places?.leastOfAll(cost) : places?.least(cost);
  return places && translation && {angle: places.angle, translation};
}

/** The nearest place at its next turn that has one; undefined where it has no other turn. */
export function placeTurned(
  pieces: readonly PieceOnCloth[],
  piece: PieceOnCloth,
  bolt: Bolt,
  takes: boolean,
): Alignment | undefined {
  const turns = turnsOf(piece.piece, bolt);
  const k = pieces.indexOf(piece);
  let {angle} = piece.place;
  for (let tries = 1; tries < turns.length; tries++) {
    const turn = turnAfter(turns, angle);
    if (!turn || Math.abs(wrapped(turn.angle - piece.place.angle)) < 1e-6) return undefined;
    angle = turn.angle;
    const places = new Places(pieces, k, turn, bolt);
    const near = apartFrom(turnedInPlace(piece, angle));
    const translation = takes ? places.leastOfAll(near) : places.least(near);
    if (translation) return {angle, translation};
  }
  return undefined;
}
