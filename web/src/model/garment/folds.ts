/** Pleats, tucks and creases of a piece. Lengths in cm. */
import type {DraftedFold, FoldKind} from './garment-document.js';
import type {Point} from '../geometry/vectors.js';

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

/** Text beside a line of a fold in a DXF file, such as "inverted fold 1" or "inverted fold 1 to". */
export const foldText = (kind: FoldKind, number: number, isSecond: boolean): string =>
  `${kind} fold ${number}${isSecond ? ' to' : ''}`;
