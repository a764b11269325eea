/**
 * Moves texts of pieces off page joints: the name to where the piece has room for it on one page,
 * others by the shortest way. Lengths in cm.
 */
import {leastLetterMm, type CutMark, type CutText, type LaidPiece} from '../cutting/cut-sheet.js';
import {distance, middle, plus, type Point} from '../model/geometry/vectors.js';
import {boxOf, isInside, type Box} from '../model/geometry/polyline.js';
import {boxAt, crossesInto, grown, overlap, shared} from './boxes.js';
import {boxOfMark} from './draw-marks.js';
import type {SheetPage} from './pages.js';

/** Distance between tried places. */
const step = 0.5;
/** Least distance from joints and other marks. */
const clear = 0.3;
/** Least distance from joints without room in the piece. */
const edge = 0.1;
/** Scale of text where it has no room at its size. */
const smaller = 0.6;

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

/** Texts with fewer lines and smaller letters, for pieces without room for all. */
const shorter = (mark: CutText): readonly CutText[] =>
  mark.lines.flatMap((_, k) =>
    [1, smaller].map((scale) => ({
      ...mark,
      lines: mark.lines.slice(0, mark.lines.length - k),
      sizeMm: Math.max(leastLetterMm, scale * mark.sizeMm),
    })),
  );

/** The text, moved into a frame by the shortest way, wherever that is. */
function pushedInto(frame: Box, mark: CutText): CutText {
  const {low, high} = boxOfMark(mark);
  const room = grown(frame, -edge);
  const shift = ([0, 1] as const).map((axis) =>
    Math.max(room.low[axis] - low[axis], Math.min(0, room.high[axis] - high[axis])),
  );
  return {...mark, at: plus(mark.at, [shift[0] ?? 0, shift[1] ?? 0])};
}

const nearestTo = ({at}: CutText, places: readonly CutText[]): CutText | undefined =>
  [...places].sort((a, b) => distance(a.at, at) - distance(b.at, at))[0];

/** The marks of a piece, with its texts moved off page joints. */
export function marksOnPages(piece: LaidPiece, pages: readonly SheetPage[]): readonly CutMark[] {
  const {marks} = piece;
  const around = boxOf(piece.cut[0] ?? []);
  const frames = pages.map(({frame}) => frame).filter((frame) => overlap(frame, around));
  return marks.map((mark): CutMark => {
    if (mark.kind !== 'text') return mark;
    const box = boxOfMark(mark);
    if (frames.some((frame) => within(box, frame))) return mark;
    const others = marks.flatMap((other) =>
      other.layer === 'cut' || other.layer === 'sew' || other === mark ? [] : [boxOfMark(other)],
    );
    for (const text of mark.layer === 'words' ? shorter(mark) : []) {
      const places = frames.flatMap((frame): CutText[] => {
        const at = placeIn(frame, text, piece, others);
        return at ? [{...text, at}] : [];
      });
      const nearest = nearestTo(mark, places);
      if (nearest) return nearest;
    }
    const pushed = frames.map((frame) => pushedInto(frame, mark));
    return nearestTo(mark, pushed) ?? mark;
  });
}
