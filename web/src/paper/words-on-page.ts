/**
 * Moves the text of pieces off page joints, if the piece has room for it on one page. Lengths in
 * cm.
 */
import type {CutMark, CutText, LaidPiece} from '../cutting/cut-sheet.js';
import {distance, middle, type Point} from '../model/geometry/vectors.js';
import {boxOf, isInside, type Box} from '../model/geometry/polyline.js';
import {boxAt, crossesInto, grown, overlap, shared} from './boxes.js';
import {boxOfMark} from './draw-marks.js';
import type {SheetPage} from './pages.js';

/** Distance between tried places. */
const step = 0.5;
/** Least distance from joints and other marks. */
const clear = 0.3;

const within = (inner: Box, outer: Box): boolean =>
  inner.low[0] >= outer.low[0] &&
  inner.low[1] >= outer.low[1] &&
  inner.high[0] <= outer.high[0] &&
  inner.high[1] <= outer.high[1];

/** Returns whether a box is inside the sewn line and outside of holes. */
function liesOn(loops: readonly (readonly Point[])[], box: Box): boolean {
  const [outline = [], ...holes] = loops;
  return (
    isInside(outline, box.low) &&
    !holes.some((hole) => isInside(hole, box.low)) &&
    !loops.some((loop) => crossesInto(loop, box))
  );
}

/**
 * The place in a frame, within closed lines, that is nearest to the text's position; undefined
 * without room.
 */
export function placeIn(
  frame: Box,
  mark: CutText,
  {sewn}: Pick<LaidPiece, 'sewn'>,
  others: readonly Box[],
): Point | undefined {
  const {low, high} = boxOfMark(mark);
  const [width, height] = [high[0] - low[0], high[1] - low[1]];
  const room = shared(grown(frame, -clear), boxOf(sewn[0] ?? []));
  let best: Point | undefined;
  for (let y = room.low[1]; y + height <= room.high[1]; y += step) {
    for (let x = room.low[0]; x + width <= room.high[0]; x += step) {
      const box = boxAt([x, y], width, height);
      const at = middle(box.low, box.high);
      if (best && distance(at, mark.at) >= distance(best, mark.at)) continue;
      const near = grown(box, clear);
      if (others.some((other) => overlap(other, near))) continue;
      if (liesOn(sewn, box)) best = at;
    }
  }
  return best;
}

/** The marks of a piece, with its text moved off page joints. */
export function marksOnPages(piece: LaidPiece, pages: readonly SheetPage[]): readonly CutMark[] {
  const {marks} = piece;
  return marks.map((mark): CutMark => {
    if (mark.kind !== 'text' || mark.layer !== 'words') return mark;
    const box = boxOfMark(mark);
    const frames = pages.map(({frame}) => frame);
    if (frames.some((frame) => within(box, frame))) return mark;
    const others = marks.flatMap((other) =>
      other.layer === 'cut' || other.layer === 'sew' || other === mark ? [] : [boxOfMark(other)],
    );
    const around = boxOf(piece.sewn[0] ?? []);
    const [nearest] = frames
      .filter((frame) => overlap(frame, around))
      .map((frame) => placeIn(frame, mark, piece, others))
      .filter((at) => at !== undefined)
      .sort((a, b) => distance(a, mark.at) - distance(b, mark.at));
    return nearest ? {...mark, at: nearest} : mark;
  });
}
