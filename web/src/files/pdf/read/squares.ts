/** Test squares: labelled squares that verify the scale of the paper. Lengths in mm. */
import {distance} from '../../../model/geometry/vectors.js';
import {boxOf} from '../../../model/geometry/polyline.js';
import {isRectangle} from '../../base/closed-lines.js';
import {isInBox} from './cut-lines.js';
import {middleOf, type InkLine, type InkText} from './ink.js';

const millimetres: Readonly<Record<string, number>> = {mm: 1, cm: 10, in: 25.4};

/** The lengths in a text. */
function lengthsIn(text: string): number[] {
  const found = text.matchAll(
    /(?<![\d.,])(\d{1,3}(?:[.,]\d{1,3})?)\s?(mm|cm|in(?:ch(?:es)?)?\b|"|″|”)/gi,
  );
  return [...found].map(([, number = '', unit = '']) => {
    const factor = millimetres[unit.slice(0, 2).toLowerCase()] ?? 25.4;
    return Number(number.replace(',', '.')) * factor;
  });
}

/** Sides of usual squares; others need a label that agrees. */
const least = 15;
const most = 160;

/** Greatest difference of the drawn from the stated side, as a share. */
const plausible = 0.2;
const exact = 0.003;

interface Squares {
  readonly squares: ReadonlySet<InkLine>;
  /** Stated size divided by drawn size; undefined without a label or with labels that disagree. */
  readonly ratio?: number;
}

function sideOf({points, isClosed}: InkLine): number | undefined {
  if (!isClosed || points.length > 8 || !isRectangle(points)) return undefined;
  const {low, high} = boxOf(points);
  const [width, height] = [high[0] - low[0], high[1] - low[1]];
  const isSquare = Math.abs(width - height) < 0.01 * width && width >= least && width <= most;
  const isUpright = points.every(
    (p) => Math.min(distance(p, low), distance(p, high)) < width + 0.1,
  );
  return isSquare && isUpright ? (width + height) / 2 : undefined;
}

/** Finds squares with the length of their side in them or close to them. */
export function testSquaresIn(lines: readonly InkLine[], texts: readonly InkText[]): Squares {
  const squares = new Set<InkLine>();
  const ratios: number[] = [];
  for (const line of lines) {
    const side = sideOf(line);
    if (side === undefined) continue;
    const {low, high} = boxOf(line.points);
    const reach = 0.25 * side;
    const around = {
      low: [low[0] - reach, low[1] - reach] as const,
      high: [high[0] + reach, high[1] + reach] as const,
    };
    const near = texts.filter((text) => isInBox(around, middleOf(text)));
    const off = (length: number): number => Math.abs(Math.log(length / side));
    const [stated] = near
      .flatMap(({text}) => lengthsIn(text))
      .filter((length) => off(length) < plausible)
      .sort((a, b) => off(a) - off(b));
    if (stated === undefined) continue;
    squares.add(line);
    ratios.push(stated / side);
  }
  const [first] = ratios;
  const isAgreed =
    first !== undefined && ratios.every((ratio) => Math.abs(ratio / first - 1) < exact);
  return {squares, ...(isAgreed && {ratio: first})};
}

/** Ratios nearer to 1 are rounding. */
export const isTrueToScale = (ratio: number): boolean => Math.abs(ratio - 1) <= exact;
