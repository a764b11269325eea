/**
 * Finds cut lines that are drawn only along edges with an allowance, as those of half pieces are,
 * and closes them along the sewn line. Lengths in mm.
 */
import type {DrawnPiece} from '../../../model/garment/imported-drawing.js';
import {boxOf, isInside, lengthOf} from '../../../model/geometry/polyline.js';
import {tracedLoop} from '../../base/bezier.js';
import {nearestOn} from '../../../model/geometry/nearest.js';
import {runsOf} from '../../base/edges.js';
import {cutAround} from '../../svg/cut-around.js';
import type {Line} from '../../svg/lines.js';
import {pointsOf} from '../../svg/outlines.js';
import type {Sheet as DrawnSheet} from '../../svg/walk.js';

/** Greatest allowance, wider than any hem. */
const widest = 60;

/** Least length of a cut line as a share of the sewn line. */
const leastLength = 0.4;

/** Least distance of a cut line from the sewn line on most of its length. */
const leastWidth = 2;

/** Greatest deviation of traced lines. */
const tolerance = 0.05;

/** Number of points of a line that are compared. */
const samples = 48;

/** Adds such cut lines to pieces without one. */
export function withOpenCutLines(
  pieces: readonly DrawnPiece[],
  {drawn}: DrawnSheet,
): readonly DrawnPiece[] {
  const open = drawn
    .flatMap(({lines}) => lines)
    .filter(({isClosed}) => !isClosed)
    .map((line) => ({line, points: pointsOf(line)}))
    .filter(({points}) => points.length > 3)
    .map((one) => ({...one, length: lengthOf(one.points), box: boxOf(one.points)}));
  return pieces.map((piece) => {
    if (piece.cut || piece.doubt !== undefined) return piece;
    const rim = tracedLoop(piece.sewn, tolerance);
    const {low, high} = boxOf(rim);
    const whole = lengthOf(rim);
    const around = open.filter(({points, length, box}) => {
      const isNear = ([0, 1] as const).every(
        (k) => box.low[k] >= low[k] - widest && box.high[k] <= high[k] + widest,
      );
      if (!isNear || length < leastLength * whole) return false;
      const some = points.filter((_, k) => k % Math.ceil(points.length / samples) === 0);
      const outside = some.filter((p) => {
        const {off} = nearestOn(rim, p, true);
        return off <= widest && (off < leastWidth || !isInside(rim, p));
      });
      const wide = some.filter((p) => nearestOn(rim, p, true).off >= leastWidth);
      return outside.length >= 0.95 * some.length && wide.length >= 0.5 * some.length;
    });
    const [start = [0, 0]] = rim;
    const sewn: Line = {
      start,
      cubics: [...rim.slice(1), start].map((to) => [to, to, to]),
      isClosed: true,
    };
    const cut =
      around.length > 0
        ? cutAround(
            sewn,
            around.map(({line}) => line),
          )
        : undefined;
    return cut ? {...piece, cut: runsOf(cut)} : piece;
  });
}
