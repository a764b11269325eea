/** Texts on a marker and on the places of its pieces. */
import {wholeRange} from '../../marker/draw/note-texts.js';
import {countedRepeats} from '../../marker/counted-repeats.js';
import {
  boxAt,
  isFree,
  obstaclesTo,
  type Bolt,
  type LaidPiece,
  type Obstacles,
} from '../../marker/places.js';
import {layCosts} from '../../model/result/pinned-plan.js';
import {degrees, type Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {fractionOrNumber, type Units} from '../../model/base/length-text.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import type {Format} from '../../texts/format.js';
import type {MarkerChoices} from './marker-choices.js';
import type {PieceOnFabric} from './marker-work.js';

/** Steps of the lengths that shops sell: 5 cm, an eighth of a yard. */
const soldCm = 5;
const yardCm = 91.44;
const eighths = 8;
/** Excess length that rounding up ignores. [cm] */
const slack = 0.01;
/** Least difference between lengths that counts as a cost or a range. [cm] */
export const leastCost = 0.5;

/** Returns the length to buy, rounded up: "1.45 m", "1 5/8 yd". */
export function soldLength(cm: number, units: Units, words: MarkerTexts, format: Format): string {
  if (units === 'inch') {
    const parts = Math.max(0, Math.ceil(((cm - slack) / yardCm) * eighths));
    return words.yards(fractionOrNumber(parts / eighths, 3));
  }
  return words.metres(format.number((Math.ceil((cm - slack) / soldCm) * soldCm) / 100, 2));
}

/** Rounds up to whole centimetres, or to sixteenths of an inch. */
export const roundedLength = (cm: number, units: Units, format: Format): string =>
  format.length(units === 'inch' ? cm : Math.ceil(cm - slack));

/** Returns the price of a length; undefined without the price of a metre or yard. */
export function costOfLength(
  cm: number,
  choices: Pick<MarkerChoices, 'price'> | undefined,
  units: Units,
  format: Format,
): string | undefined {
  const {price = 0} = choices ?? {};
  const unit = units === 'inch' ? yardCm : 100;
  return price > 0 ? format.number((price * cm) / unit, 2) : undefined;
}

/**
 * Returns a range such as "120 to 136 cm"; it contains the lengths as `roundedLength` shows them.
 */
export const lengthRange = (
  [least, most]: readonly [number, number],
  units: Units,
  words: MarkerTexts,
  format: Format,
): string =>
  words.range(
    units === 'inch' ? format.length(least) : format.number(wholeRange(least, most, slack)[0]),
    roundedLength(most, units, format),
  );

/**
 * Returns the fabric that the print costs and the fabric that pins cost; their sum if no marker
 * without pins exists.
 */
export function costWords(plan: LayPlan, words: MarkerTexts, format: Format): readonly string[] {
  const {printCm, pinsCm, bothCm} = layCosts(plan);
  const said = (cm: number | undefined, none: string, cost: (length: string) => string) =>
    cm === undefined ? [] : [cm < leastCost ? none : cost(format.length(cm))];
  return [
    ...said(printCm, words.costsNothing, words.costs),
    ...said(pinsCm, words.pinsCostNothing, words.pinsCost),
    ...said(bothCm, words.costsNothing, words.costsPinned),
  ];
}

/** Returns a position in repeats: "3rd repeat from the left, 2nd from the start". */
export function pointWords(at: Point, bolt: Bolt, words: MarkerTexts, format: Format): string {
  const counted = countedRepeats(at, bolt);
  return counted
    ? words.at(counted.across, counted.along)
    : words.atLength(format.length(at[0]), format.length(at[1]));
}

function andTurn(where: string, {place}: LaidPiece, words: MarkerTexts, format: Format): string {
  const turn = ((Math.round(degrees(place.angle)) % 360) + 360) % 360;
  return turn === 0 ? where : `${where}, ${words.turned(format.number(turn))}`;
}

/** Returns the position of a piece in repeats, and its turn. */
export const placeWords = (
  laid: LaidPiece,
  bolt: Bolt,
  words: MarkerTexts,
  format: Format,
): string => andTurn(pointWords(boxAt(laid).low, bolt, words, format), laid, words, format);

/**
 * Returns the position of a piece with its length along the fabric, which also changes within a
 * repeat: "3rd repeat from the left, 42 cm from the start".
 */
export function lyingWords(
  laid: LaidPiece,
  bolt: Bolt,
  words: MarkerTexts,
  format: Format,
): string {
  const {low} = boxAt(laid);
  const counted = countedRepeats(low, bolt);
  const where = counted
    ? words.atRow(counted.across, format.length(low[1]))
    : pointWords(low, bolt, words, format);
  return andTurn(where, laid, words, format);
}

/** Returns the position of a flaw. */
export function flawWords(
  flaw: readonly Point[],
  number: number,
  words: MarkerTexts,
  format: Format,
): string {
  const {low} = boxOf(flaw);
  return words.flawAt(number, format.length(low[0]), format.length(low[1]));
}

/** Returns the size of a flaw. */
export function flawSizeWords(flaw: readonly Point[], words: MarkerTexts, format: Format): string {
  const {low, high} = boxOf(flaw);
  return words.flawSize(format.length(high[0] - low[0]), format.length(high[1] - low[1]));
}

/** Returns the obstacle of a piece as a message; undefined without an obstacle. */
export function conflictWords(
  piece: PieceOnFabric,
  found: Obstacles,
  pieces: readonly PieceOnFabric[],
  label: (piece: PieceOnFabric) => string,
  words: MarkerTexts,
): string | undefined {
  if (isFree(found)) return undefined;
  const others = found.pieces.flatMap((n) => (pieces[n] ? [label(pieces[n])] : []));
  if (others.length > 0) return words.overlaps(label(piece), others.join(', '));
  return found.flaws.length > 0 ? words.onFlaw(label(piece)) : words.outside(label(piece));
}

/** Returns a message for each piece that is not free at its place, by piece number. */
export function conflicts(
  pieces: readonly PieceOnFabric[],
  bolt: Bolt,
  label: (piece: PieceOnFabric) => string,
  words: MarkerTexts,
): ReadonlyMap<number, string> {
  return new Map(
    pieces.flatMap((piece, k): (readonly [number, string])[] => {
      const found = obstaclesTo(pieces, k, piece.place, bolt);
      const said = conflictWords(piece, found, pieces, label, words);
      return said === undefined ? [] : [[piece.number, said]];
    }),
  );
}
