/** Draws sewn lines inside cut lines, if the lines of a pattern include the seam allowance. */
import type {DrawnPiece, Run} from '../../../model/garment/imported-drawing.js';
import {signedArea} from '../../../model/geometry/polyline.js';
import {straight, tracedLoop} from '../../base/bezier.js';
import {runsOf} from '../../base/edges.js';
import {inset, insetToFold} from './inset.js';

/** Greatest deviation of traced outlines. [mm] */
const tolerance = 0.02;

interface Allowed {
  readonly pieces: readonly DrawnPiece[];
  readonly notes: readonly string[];
}

/**
 * Takes outlines as cut lines if an allowance is stated.
 * @param chosenCm the user's choice; 0 for sewn lines
 * @param statedCm the allowance that the file states
 */
export function withAllowance(
  pieces: readonly DrawnPiece[],
  chosenCm: number | undefined,
  statedCm: number | undefined,
): Allowed {
  const open = pieces.filter(({cut, doubt}) => !cut && doubt === undefined);
  if (open.length === 0) return {pieces, notes: []};
  const width = chosenCm ?? statedCm ?? 0;
  if (width === 0) {
    const isAsked = chosenCm === undefined && statedCm === undefined;
    return {pieces, notes: isAsked ? [question] : []};
  }
  const said =
    chosenCm === undefined
      ? [
          `The file says that its lines include a seam allowance of ${width.toFixed(2)} cm; the sewn lines are drawn inside them.`,
        ]
      : [];
  const lost: string[] = [];
  const changed = pieces.map((piece) => {
    if (piece.cut || piece.doubt !== undefined) return piece;
    const sewn = sewnInside(piece, 10 * width);
    if (!sewn) lost.push(piece.name);
    return sewn ? {...piece, sewn, cut: piece.sewn} : piece;
  });
  return {
    pieces: changed,
    notes: [
      ...said,
      ...lost.map(
        (name) =>
          `Piece '${name}' is too narrow for the allowance, and its line is taken as the sewn one.`,
      ),
    ],
  };
}

const question =
  'The lines are taken as sewn lines; if they include a seam allowance, state its width.';

/** The sewn line at a distance inside a cut line; on a fold there is no allowance. [mm] */
function sewnInside({sewn, fold}: DrawnPiece, width: number): readonly Run[] | undefined {
  const rim = tracedLoop(sewn, tolerance);
  const inner = fold ? insetToFold(rim, fold, width) : inset(rim, width);
  if (!inner || Math.abs(signedArea(inner)) < leastLeft * Math.abs(signedArea(rim))) {
    return undefined;
  }
  const [start = [0, 0], ...rest] = inner;
  return runsOf({start, cubics: [...rest, start].map((to, k) => straight(inner[k] ?? start, to))});
}

/** Least share of a piece inside its sewn line. */
const leastLeft = 0.2;
