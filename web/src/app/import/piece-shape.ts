/** Lines of a drawn piece as SVG paths, y down, and its size. Lengths in the file's unit. */
import type {DrawnPiece, Run} from '../../model/garment/imported-drawing.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {minus, type Point} from '../../model/geometry/vectors.js';

export interface PieceShape {
  /** Upper left corner, width and height, as in a `viewBox`. */
  readonly box: readonly [left: number, top: number, width: number, height: number];
  /** The sewn line, and holes that are certain. */
  readonly sewn: string;
  /** Lines that are holes or drawn on the piece. */
  readonly doubtful: readonly DoubtfulLine[];
  readonly cut: string;
  /** Grain, and lines drawn on the piece. */
  readonly marks: string;
  readonly fold: string;
}

interface DoubtfulLine {
  /** Index among the holes of the piece. */
  readonly hole: number;
  readonly path: string;
  readonly size: readonly [width: number, height: number];
}

/** Number of steps for measuring a curve. */
const steps = 8;

/** Six digits: a hundredth of a millimetre of a piece of ten metres. */
const short = (value: number): string => String(Number(value.toPrecision(6)));
const at = ([x, y]: Point): string => `${short(x)} ${short(-y)}`;

const path = (runs: readonly Run[]): string => {
  const [first] = runs;
  if (!first) return '';
  const curves = runs.flatMap(({cubics}) => cubics.map((curve) => `C${curve.map(at).join(' ')}`));
  return `M${at(first.start)}${curves.join('')}Z`;
};

const line = (points: readonly Point[]): string =>
  points.length < 2 ? '' : `M${points.map(at).join('L')}`;

function* along(runs: readonly Run[]): Generator<Point> {
  for (const {start, cubics} of runs) {
    let from = start;
    for (const [a, b, to] of cubics) {
      for (let k = 1; k <= steps; k++) {
        const t = k / steps;
        const s = 1 - t;
        const [w0, w1, w2, w3] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
        const axis = (i: 0 | 1): number => w0 * from[i] + w1 * a[i] + w2 * b[i] + w3 * to[i];
        yield [axis(0), axis(1)];
      }
      from = to;
    }
  }
}

export function pieceShape(piece: DrawnPiece): PieceShape {
  const {sewn, cut = [], holes, doubtfulHoles = [], grain, fold, internalLines} = piece;
  const {low, high} = boxOf([...along([...sewn, ...cut])]);
  const certain = holes.filter((_, k) => !doubtfulHoles.includes(k));
  return {
    box: [low[0], -high[1], high[0] - low[0], high[1] - low[1]],
    sewn: [sewn, ...certain].map(path).join(''),
    doubtful: doubtfulHoles.map((hole) => {
      const runs = holes[hole] ?? [];
      const box = boxOf([...along(runs)]);
      return {hole, path: path(runs), size: minus(box.high, box.low)};
    }),
    cut: path(cut),
    marks: [...(grain ? [grain] : []), ...internalLines].map(line).join(''),
    fold: fold ? line(fold) : '',
  };
}
