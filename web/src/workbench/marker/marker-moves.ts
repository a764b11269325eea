/** Moves of a piece on the fabric by keys and buttons. */
import {
  apartFrom,
  onFrom,
  Places,
  turnAfter,
  turnedInPlace,
  turnsOf,
  type Bolt,
} from '../../marker/places.js';
import {minus, norm, wrapped, type Alignment, type Point} from '../../model/geometry/vectors.js';
import {reducedBasis} from '../../model/print/wallpaper.js';
import type {PieceOnFabric} from './marker-work.js';
import {placesOf} from './piece-drag.js';
import {boxOf} from '../../model/geometry/polyline.js';
import type {Units} from '../../model/base/length-text.js';
import type {Flaw} from './lay-step.js';

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
  pieces: readonly PieceOnFabric[],
  piece: PieceOnFabric,
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
export const canTurn = ({piece}: PieceOnFabric, bolt: Bolt): boolean =>
  turnsOf(piece, bolt).length > 1;

/**
 * Returns the nearest place at the next turn that has one; undefined if no turn has one.
 * @param reach greatest distance of the move [cm]
 */
export function placeTurned(
  pieces: readonly PieceOnFabric[],
  piece: PieceOnFabric,
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

// Moves and resizes a flaw of the fabric, by keys and by numbers. Lengths in cm.

/** Bounding box of a flaw: `left` from the left edge of the fabric, `start` from its cut edge. */
export interface FlawBox {
  readonly left: number;
  readonly start: number;
  readonly width: number;
  readonly length: number;
}

/** Least width and length of a flaw. */
export const leastFlaw = 0.5;
/** Greatest distance of a flaw from the cut edge; no marker is longer. */
export const mostStart = 5000;
/** Step of an arrow key, and width and length of a new flaw. */
const steps: Readonly<Record<Units, number>> = {cm: 1, inch: 1.27};
const firstSizes: Readonly<Record<Units, number>> = {cm: 5, inch: 5.08};

export function boxAround(flaw: Flaw): FlawBox {
  const {low, high} = boxOf(flaw);
  return {left: low[0], start: low[1], width: high[0] - low[0], length: high[1] - low[1]};
}

const cornersOf = ({left, start, width, length}: FlawBox): Flaw => [
  [left, start],
  [left + width, start],
  [left + width, start + length],
  [left, start + length],
];

const within = (value: number, least: number, most: number): number =>
  Math.max(least, Math.min(most, value));

/** Limits a box to the fabric. */
function onFabric(
  {left, start, width, length}: FlawBox,
  {widthCm}: Pick<Bolt, 'widthCm'>,
): FlawBox {
  const wide = within(width, leastFlaw, widthCm);
  const long = within(length, leastFlaw, mostStart);
  return {
    left: within(left, 0, widthCm - wide),
    start: within(start, 0, mostStart),
    ...{width: wide, length: long},
  };
}

/** Fits the outline of a flaw into its changed box. */
export function flawIn(flaw: Flaw, change: Partial<FlawBox>, bolt: Pick<Bolt, 'widthCm'>): Flaw {
  const from = boxAround(flaw);
  const to = onFabric({...from, ...change}, bolt);
  return flaw.map(([x, y]): Point => [
    to.left + ((x - from.left) * to.width) / from.width,
    to.start + ((y - from.start) * to.length) / from.length,
  ]);
}

/** Returns a new, square flaw, aligned to whole steps of the arrow keys. */
export function flawAround([x, y]: Point, units: Units, bolt: Pick<Bolt, 'widthCm'>): Flaw {
  const size = firstSizes[units];
  const onStep = (at: number): number => steps[units] * Math.round((at - size / 2) / steps[units]);
  const [left, start] = [onStep(x), onStep(y)];
  return cornersOf(onFabric({left, start, width: size, length: size}, bolt));
}

/**
 * Returns the flaw after a key: null if the key removes it, undefined for other keys. Shift with an
 * arrow changes its size.
 */
export function flawAfter(
  {key, shiftKey}: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  flaw: Flaw,
  units: Units,
  bolt: Pick<Bolt, 'widthCm'>,
): Flaw | null | undefined {
  if (key === 'Delete') return null;
  const way = ways[key];
  if (!way) return undefined;
  const [x, y] = [way[0] * steps[units], way[1] * steps[units]];
  const {left, start, width, length} = boxAround(flaw);
  if (!shiftKey) return flawIn(flaw, {left: left + x, start: start + y}, bolt);
  // a larger flaw keeps its left edge and its start
  return flawIn(flaw, {width: Math.min(width + x, bolt.widthCm - left), length: length + y}, bolt);
}
