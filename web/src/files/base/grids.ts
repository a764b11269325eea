/** Recognises grids of rectangles, and squares that test the scale of a print. [mm] */
import {distance} from '../../model/geometry/vectors.js';
import {isInside} from '../../model/geometry/polyline.js';
import {isRectangle, type ClosedLine, type Words} from './closed-lines.js';

/** Least number of equal rectangles in a grid. */
const fewestCells = 6;

/** Greatest gap between cells, and difference between their sizes. */
const gap = 0.2;

/** Equal rectangles side by side. */
export function gridCells<T extends ClosedLine>(lines: readonly T[]): ReadonlySet<T> {
  const groups = new Map<string, T[]>();
  for (const line of lines) {
    if (!isRectangle(line.rim)) continue;
    const [width, height] = [0, 1].map((k) => (line.box.high[k] ?? 0) - (line.box.low[k] ?? 0));
    const key = [width, height].map((side) => Math.round((side ?? 0) / gap)).join(' ');
    groups.set(key, [...(groups.get(key) ?? []), line]);
  }
  return new Set(
    [...groups.values()].flatMap((group) =>
      group.length < fewestCells ? [] : group.filter((cell) => group.some(isBeside(cell))),
    ),
  );
}

const isBeside =
  ({box}: ClosedLine) =>
  ({box: other}: ClosedLine): boolean =>
    [0, 1].some((axis) => {
      const isLevel = Math.abs((box.low[1 - axis] ?? 0) - (other.low[1 - axis] ?? 0)) <= gap;
      return isLevel && Math.abs((box.high[axis] ?? 0) - (other.low[axis] ?? 0)) <= gap;
    }) ||
    [0, 1].some((axis) => {
      const isLevel = Math.abs((box.low[1 - axis] ?? 0) - (other.low[1 - axis] ?? 0)) <= gap;
      return isLevel && Math.abs((other.high[axis] ?? 0) - (box.low[axis] ?? 0)) <= gap;
    });

/** Sides of test squares: 4, 5, 6 and 10 cm; 1 to 4 inches. */
const roundSides = [40, 50, 60, 100, 25.4, 50.8, 76.2, 101.6];

const squareWords =
  /test|scale|square|quadrat|ma(?:ß|ss)stab|carr[ée]|[ée]chelle|\d\s*(?:cm|mm|in)/i;

/** Returns whether a line is a square of a round size without a name. */
export function isRoundSquare(
  {rim, box: {low, high}}: ClosedLine,
  words: readonly Words[],
): boolean {
  const [width, height] = [high[0] - low[0], high[1] - low[1]];
  const isSquare = Math.abs(width - height) <= gap && isRectangle(rim);
  const diagonal = distance(low, high);
  if (!isSquare || !roundSides.some((side) => Math.abs(diagonal - side * Math.SQRT2) <= gap)) {
    return false;
  }
  const written = words.filter(({at}) => isInside(rim, at)).flatMap(({lines}) => lines);
  return written.every((one) => squareWords.test(one));
}
