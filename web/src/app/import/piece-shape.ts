/** Lines of a drawn piece as SVG paths, y down, and its size. Lengths in the file's unit. */
import type {DrawnPiece, Run} from '../../model/garment/imported-drawing.js';
import type {Point} from '../../model/geometry/vectors.js';

export interface PieceShape {
  /** Upper left corner, width and height, as in a `viewBox`. */
  readonly box: readonly [left: number, top: number, width: number, height: number];
  readonly sewn: string;
  readonly cut: string;
  /** Grain, and lines drawn on the piece. */
  readonly marks: string;
  readonly fold: string;
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
  const {sewn, cut = [], holes, grain, fold, internalLines} = piece;
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of along([...sewn, ...cut])) {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [low, high] = [Math.min(low, y), Math.max(high, y)];
  }
  return {
    box: [left, -high, right - left, high - low],
    sewn: [sewn, ...holes].map(path).join(''),
    cut: path(cut),
    marks: [...(grain ? [grain] : []), ...internalLines].map(line).join(''),
    fold: fold ? line(fold) : '',
  };
}
