/** Test squares: rectangles of a size that is written in them, by which whoever prints a pattern checks its scale. */
import {distance} from '../../model/geometry.js';
import {boxOf, type Box} from '../../model/polyline.js';
import type {Line} from './lines.js';
import {isRectangle} from './nesting.js';
import {pointsOf, runsOf} from './outlines.js';
import {classesOf} from './styles.js';
import type {Sheet} from './walk.js';

const squareWords =
  /test|scale|square|measure|check|control|quadrat|kontroll|ma(?:ß|ss)stab|carr[ée]|[ée]chelle|quadrato|scala|verifica|cuadr|escala|prueba/i;

const millimetres: Readonly<Record<string, number>> = {mm: 1, cm: 10, in: 25.4};

/** The lengths that words name. [mm] */
function lengthsIn(text: string): number[] {
  const found = text.matchAll(/(\d+(?:[.,]\d+)?)\s*(mm|cm|in(?:ch(?:es)?)?\b|"|″|”|“|'')/gi);
  return [...found].map(([, number = '', unit = '']) => {
    const factor = millimetres[unit.slice(0, 2).toLowerCase()] ?? 25.4;
    return Number(number.replace(',', '.')) * factor;
  });
}

interface Rectangle {
  readonly line: Line;
  /** The longer one first. [mm] */
  readonly sides: readonly [number, number];
  readonly box: Box;
  readonly classes: readonly string[];
}

function rectanglesIn({drawn}: Sheet): Rectangle[] {
  return drawn.flatMap(({lines, element}) =>
    lines
      .filter((line) => line.isClosed && line.cubics.length <= 8 && isRectangle(line))
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

/** How far beside a square its words may stand, as a share of its longer side. */
const beside = 0.25;

const isNear = ({low, high}: Box, [x, y]: readonly [number, number], reach: number): boolean =>
  x >= low[0] - reach && x <= high[0] + reach && y >= low[1] - reach && y <= high[1] + reach;

/** Sizes that words in and beside a rectangle say it has, the longer side first. [mm] */
function saidOf({sides: [long, short], box, classes}: Rectangle, {texts}: Sheet): number[][] {
  if (classes.includes('scalebox')) return [classes.includes('metric') ? [100, 50] : [101.6, 50.8]];
  const near = texts.filter(({at}) => isNear(box, at, beside * long)).flatMap(({lines}) => lines);
  const isSaid = near.some((line) => squareWords.test(line));
  return near.flatMap((line) => {
    const lengths = lengthsIn(line);
    const pairs = lengths.flatMap((one, k) => {
      const next = lengths[k + 1];
      return next === undefined ? [] : [[Math.max(one, next), Math.min(one, next)]];
    });
    // of a square one side is enough
    const isSquare = long < 1.01 * short && (isSaid || lengths.length > 1);
    return [...pairs, ...(isSquare ? lengths.map((one) => [one, one]) : [])];
  });
}

const alike = 0.003;

/** A rectangle that has the shape that its words say. */
interface Square {
  readonly line: Line;
  /** By how much it is smaller than it says. */
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
 * By how much a drawing is smaller than it says by its test squares; undefined where it has none. Of several that differ,
 * what most say, then what is nearest to 1.
 */
export function measuredScale(sheet: Sheet): number | undefined {
  const ratios = squaresIn(sheet).map(({ratio}) => ratio);
  const votes = (ratio: number): number =>
    ratios.filter((other) => Math.abs(other / ratio - 1) < alike).length;
  const off = (ratio: number): number => Math.abs(Math.log(ratio));
  return ratios.sort((a, b) => votes(b) - votes(a) || off(a) - off(b))[0];
}
