/** Pleats, tucks and creases of a piece. Lengths in cm. */
import type {DraftedFold, FoldKind} from './garment-document.js';
import {nearestOn} from '../geometry/nearest.js';
import {middle, minus, plus, unit, type Point} from '../geometry/vectors.js';

/** Length of an arrowhead on paper. */
const onPaper = 0.6;

/** The fold under a map that keeps lines straight. */
export function mappedFold<Fold extends Pick<DraftedFold, 'line' | 'to'>>(
  fold: Fold,
  map: (p: Point) => Point,
): Fold {
  const mapped = ([from, to]: readonly [Point, Point]) => [map(from), map(to)] as const;
  return {...fold, line: mapped(fold.line), ...(fold.to && {to: mapped(fold.to)})};
}

/** Returns whether a fold hides fabric when it is closed: all but creases do. */
export const hidesFabric = ({kind}: Pick<DraftedFold, 'kind'>): boolean =>
  kind !== 'roll' && kind !== 'press';

/** The lines of a fold. */
export const foldLines = ({
  line,
  to,
}: Pick<DraftedFold, 'line' | 'to'>): readonly (readonly [Point, Point])[] =>
  to ? [line, to] : [line];

/**
 * Arrows between the lines of a pleat, each as a shaft and a head. A knife pleat and a tuck are
 * laid from one line onto the other; the lines of other pleats meet in the middle.
 * @param head length of an arrowhead
 */
export function foldArrows(
  fold: Pick<DraftedFold, 'kind' | 'line' | 'to'>,
  head = onPaper,
): readonly (readonly Point[])[] {
  const {kind, line, to} = fold;
  if (!to || !hidesFabric(fold)) return [];
  const from = middle(...line);
  const end = nearestOn(to, from, false).at;
  const meeting = middle(from, end);
  const shafts =
    kind === 'knife' || kind === 'tuck'
      ? [[from, end] as const]
      : [[from, meeting] as const, [end, meeting] as const];
  return shafts.flatMap(([tail, tip]) => {
    const [ux, uy] = unit(minus(tip, tail));
    const side: Point = [-uy, ux];
    const foot = plus(tip, [ux, uy], -head);
    return [
      [tail, tip],
      [plus(foot, side, head / 2), tip, plus(foot, side, -head / 2)],
    ];
  });
}

/** Text beside a line of a fold in a DXF file, such as "inverted fold 1" or "inverted fold 1 to". */
export const foldText = (kind: FoldKind, number: number, isSecond: boolean): string =>
  `${kind} fold ${number}${isSecond ? ' to' : ''}`;
