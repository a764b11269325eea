/** Lays pieces without a grain the same way up on fabric with a nap. Angles in radians. */
import {determinant} from '../model/geometry/plane-map.js';
import {
  minus,
  rotated,
  towards,
  wrapped,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {printElements, type Repeat} from '../model/print/wallpaper.js';
import type {MarkerPiece} from '../model/result/marker-search.js';

/** A piece has no upper end on the fabric if it rises by less than this share of its length. */
export const leastRise = 0.2;

/** Differences of the rise that are rounding. */
const sameRise = 1e-6;

type Aligned = Pick<MarkerPiece, 'alignment' | 'up'>;

/** The direction of a piece on the fabric. */
const lying = ({alignment, up}: Aligned): Point => rotated(up, -alignment.angle);

/** The direction of the piece that is the length of the fabric. */
export const warpOf = ({angle}: Alignment): Point => towards(angle + Math.PI / 2);

/**
 * The alignments at which a piece shows the same print, one for each rotation of the group, the
 * given one first.
 */
function sameAlignments({angle, translation}: Alignment, print: Repeat): readonly Alignment[] {
  return printElements(print)
    .filter((element) => determinant(element) > 0)
    .map(({xx, yx, shift}) => ({turn: Math.atan2(yx, xx), shift}))
    .sort((a, b) => Math.abs(wrapped(a.turn)) - Math.abs(wrapped(b.turn)))
    .map(({turn, shift}) => {
      const turned = wrapped(angle - turn);
      return {angle: turned, translation: minus(translation, rotated(shift, turned))};
    });
}

/**
 * Turns pieces by rotations of the print so that their upper ends point up the fabric. Pieces that
 * lie across it in any case point the same way, that of most of them. A piece that only points
 * down keeps its direction.
 */
export function uprightPieces<T extends Aligned>(
  pieces: readonly T[],
  print: Repeat,
): readonly T[] {
  const found = pieces.map((piece) => {
    const ways = sameAlignments(piece.alignment, print).map((alignment) => ({
      alignment,
      on: lying({...piece, alignment}),
    }));
    const rise = Math.max(...ways.map(({on}) => on[1]));
    const isAcross = Math.abs(rise) < leastRise;
    const isKept = (y: number): boolean => y > (isAcross ? -leastRise : rise - sameRise);
    return {isAcross, ways: ways.filter(({on}) => isKept(on[1]))};
  });
  const across = found.flatMap(({isAcross, ways: [first]}) =>
    isAcross && first ? [first.on[0]] : [],
  );
  const side = across.reduce((sum, x) => sum + Math.sign(x), 0) || (across[0] ?? 0);
  return pieces.map((piece, k) => {
    const {isAcross = false, ways = []} = found[k] ?? {};
    const way = ways.find(({on}) => !isAcross || on[0] * side > 0) ?? ways[0];
    if (!way || way.on[1] < -leastRise) return piece;
    const {alignment} = way;
    return {...piece, alignment, ...(isAcross && {up: warpOf(alignment)})};
  });
}
