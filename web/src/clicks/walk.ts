/**
 * Keyboard navigation on a sheet: from piece to piece, into a piece's seams, and across a seam to
 * its twin.
 */
import type {Box} from '../model/geometry/polyline.js';
import {ontoSheet} from '../model/geometry/sheet-place.js';
import type {PickIndex} from './pick-index.js';
import type {Side} from './sheet.js';

interface PiecePlace {
  readonly level: 'piece';
  readonly piece: number;
}

export interface SeamPlace {
  readonly level: 'seam';
  readonly piece: number;
  readonly seam: number;
  readonly side: Side;
}

export type Place = PiecePlace | SeamPlace;

export type Direction = 'left' | 'right' | 'up' | 'down';

interface PieceBox extends Box {
  readonly piece: number;
}

function boxesOf({sheet, pieces}: PickIndex): readonly PieceBox[] {
  return sheet.pieces.flatMap((shown, piece) => {
    const box = pieces[piece]?.outline.box;
    if (!box) return [];
    const [low, high] = [box.low, box.high].map((corner) => ontoSheet(shown, corner));
    if (!low || !high) return [];
    return [shown.isTurned ? {piece, low: high, high: low} : {piece, low, high}];
  });
}

const middle = ({low, high}: Box, axis: 0 | 1): number => (low[axis] + high[axis]) / 2;

/**
 * Returns the pieces row by row from the top, each row from the left. A row contains the pieces
 * with middles above the lower end of its highest piece.
 */
export function readingOrder(index: PickIndex): readonly number[] {
  const rows: PieceBox[][] = [];
  for (const box of [...boxesOf(index)].sort((a, b) => b.high[1] - a.high[1])) {
    const row = rows.at(-1);
    if (row?.[0] && middle(box, 1) > row[0].low[1]) row.push(box);
    else rows.push([box]);
  }
  return rows.flatMap((row) => row.sort((a, b) => a.low[0] - b.low[0]).map(({piece}) => piece));
}

/** Returns the sides of seams around a piece, counter-clockwise from the outline's start. */
export const seamsRound = (index: PickIndex, piece: number): readonly SeamPlace[] =>
  (index.pieces[piece]?.lines ?? []).flatMap(({name}) =>
    name.kind === 'seam' ? [{level: 'seam', piece, seam: name.seam, side: name.side}] : [],
  );

/**
 * Cost factors of a piece beside the direction, relative to one further along it: for the gap, and
 * for the distance of middles.
 */
const besideFactor = 2;
const middleFactor = 0.1;

/** Returns the next piece in a direction, or the same one if there is none. */
export function nextPiece(index: PickIndex, current: number, direction: Direction): number {
  const boxes = boxesOf(index);
  const from = boxes.find(({piece}) => piece === current);
  if (!from) return current;
  const axis = direction === 'left' || direction === 'right' ? 0 : 1;
  const across = axis === 0 ? 1 : 0;
  const isForward = direction === 'right' || direction === 'up';
  const gap = (near: Box, far: Box, on: 0 | 1): number => far.low[on] - near.high[on];
  const cost = (box: PieceBox): number => {
    const ahead = isForward ? gap(from, box, axis) : gap(box, from, axis);
    if (ahead < 0) return Infinity;
    const beside = Math.max(gap(from, box, across), gap(box, from, across), 0);
    const off = Math.abs(middle(box, across) - middle(from, across));
    return ahead + besideFactor * beside + middleFactor * off;
  };
  let best = current;
  let least = Infinity;
  for (const box of boxes) {
    const price = cost(box);
    if (price < least) [best, least] = [box.piece, price];
  }
  return best;
}

/**
 * Returns the next or the previous seam side around the same piece; the first one follows the last.
 */
export function nextSeam(index: PickIndex, current: SeamPlace, step: 1 | -1): SeamPlace {
  const round = seamsRound(index, current.piece);
  const at = round.findIndex(({seam, side}) => seam === current.seam && side === current.side);
  return round[(at + step + round.length) % round.length] ?? current;
}

/** Returns the first seam of a piece, if it has any. */
export const inwards = (index: PickIndex, place: Place): Place =>
  (place.level === 'piece' ? seamsRound(index, place.piece)[0] : undefined) ?? place;

/** Returns a seam's piece; undefined for a piece, which leaves the sheet. */
export const outwards = (place: Place): PiecePlace | undefined =>
  place.level === 'seam' ? {level: 'piece', piece: place.piece} : undefined;

/** Returns the other side of a seam. */
export function twin({sheet}: PickIndex, place: SeamPlace): SeamPlace {
  const side = place.side === 'a' ? 'b' : 'a';
  const piece = sheet.seams[place.seam]?.[side].piece;
  return piece === undefined ? place : {...place, piece, side};
}
