/**
 * Test squares: rectangles labelled with their size, which verify the scale of a printed pattern.
 */
import {distance} from '../../model/geometry/vectors.js';
import {boxOf, type Box} from '../../model/geometry/polyline.js';
import type {Line} from './lines.js';
import {isRectangle} from '../base/closed-lines.js';
import {runsOf} from '../base/edges.js';
import {pointsOf, rimOf} from './outlines.js';
import {classesOf} from './styles.js';
import type {Sheet} from './walk.js';

const squareWords =
  /test|scale|square|measure|check|control|quadrat|kontroll|ma(?:ß|ss)stab|carr[ée]|[ée]chelle|quadrato|scala|verifica|cuadr|escala|prueba/i;

const millimetres: Readonly<Record<string, number>> = {mm: 1, cm: 10, in: 25.4};

/** The lengths in a text. [mm] */
function lengthsIn(text: string): number[] {
  const found = text.matchAll(
    /(?<!\d)(\d{1,6}(?:[.,]\d{1,6})?)\s{0,9}(mm|cm|in(?:ch(?:es)?)?\b|"|″|”|“|'')/gi,
  );
  return [...found].map(([, number = '', unit = '']) => {
    const factor = millimetres[unit.slice(0, 2).toLowerCase()] ?? 25.4;
    return Number(number.replace(',', '.')) * factor;
  });
}

interface Rectangle {
  readonly line: Line;
  /** The longer side first. [mm] */
  readonly sides: readonly [number, number];
  readonly box: Box;
  readonly classes: readonly string[];
}

function rectanglesIn({drawn}: Sheet): Rectangle[] {
  return drawn.flatMap(({lines, element}) =>
    lines
      .filter((line) => line.isClosed && line.cubics.length <= 8 && isRectangle(rimOf(line)))
      .map((line): Rectangle => {
        const [a, b, c] = runsOf(line).map(({start}) => start);
        const sides = a && b && c ? [distance(a, b), distance(b, c)] : [0, 0];
        const [short = 0, long = 0] = sides.sort((p, q) => p - q);
        return {
          line,
          sides: [long, short],
          box: boxOf(pointsOf(line)),
          classes: classesOf(element),
        };
      }),
  );
}

/** Greatest distance of text beside a square, as a share of its longer side. */
const beside = 0.25;

const isNear = ({low, high}: Box, [x, y]: readonly [number, number], reach: number): boolean =>
  x >= low[0] - reach && x <= high[0] + reach && y >= low[1] - reach && y <= high[1] + reach;

/** A text of nothing but lengths, as in `5 cm` or `2" x 2"`. */
const onlyLengths = /^(?:[\s\d.,()=:×xX*/\u2033\u201d"'-]|mm|cm|in|inch(?:es)?)+$/;

/** Sizes stated by the text in and beside a rectangle, the longer side first. [mm] */
function saidOf({sides: [long, short], box, classes}: Rectangle, {texts}: Sheet): number[][] {
  if (classes.includes('scalebox')) return [classes.includes('metric') ? [100, 50] : [101.6, 50.8]];
  const within = (reach: number): string[] =>
    texts.filter(({at}) => isNear(box, at, reach)).flatMap(({lines}) => lines);
  const inside = within(0);
  const near = within(beside * long);
  const isSaid = near.some((line) => squareWords.test(line));
  // text beside a rectangle may be about anything else
  const hasOwn = inside.some((line) => lengthsIn(line).length > 0);
  return (hasOwn ? inside : near).flatMap((line) => {
    const lengths = lengthsIn(line);
    const pairs = lengths.flatMap((one, k) => {
      const next = lengths[k + 1];
      return next === undefined ? [] : [[Math.max(one, next), Math.min(one, next)]];
    });
    // one side suffices for a square
    const isLabel = isSaid || lengths.length > 1 || (hasOwn && onlyLengths.test(line));
    const isSquare = long < 1.01 * short && isLabel;
    return [...pairs, ...(isSquare ? lengths.map((one) => [one, one]) : [])];
  });
}

const alike = 0.003;

/** A rectangle with the proportions stated by its text. */
interface Square {
  readonly line: Line;
  /** Stated size divided by drawn size. */
  readonly ratio: number;
}

function squaresIn(sheet: Sheet): Square[] {
  return rectanglesIn(sheet).flatMap((rectangle) =>
    saidOf(rectangle, sheet).flatMap(([long = 0, short = 0]) => {
      const [ratio, up] = [long / rectangle.sides[0], short / rectangle.sides[1]];
      const isOne = Math.abs(ratio / up - 1) < 2 * alike && ratio > 0.01 && ratio < 100;
      return isOne ? [{line: rectangle.line, ratio}] : [];
    }),
  );
}

/** The lines of test squares, which are no pieces. */
export const testSquares = (sheet: Sheet): ReadonlySet<Line> =>
  new Set(squaresIn(sheet).map(({line}) => line));

/**
 * Stated size divided by drawn size from the test squares; undefined without any. If they differ,
 * the most frequent ratio is used, then the nearest to 1.
 */
export function measuredScale(sheet: Sheet): number | undefined {
  const ratios = squaresIn(sheet).map(({ratio}) => ratio);
  const votes = (ratio: number): number =>
    ratios.filter((other) => Math.abs(other / ratio - 1) < alike).length;
  const off = (ratio: number): number => Math.abs(Math.log(ratio));
  return ratios.sort((a, b) => votes(b) - votes(a) || off(a) - off(b))[0];
}
