/** A way round a sheet by keys: from piece to piece, into one's seams, and across a seam to its twin. */
import type {Box} from '../model/polyline.js';
import {ontoSheet} from '../model/sheet-place.js';
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

/** The pieces row by row from above, each from the left. In a row are those whose middle is higher than the foot of its highest piece. */
export function readingOrder(index: PickIndex): readonly number[] {
  const rows: PieceBox[][] = [];
  for (const box of [...boxesOf(index)].sort((a, b) => b.high[1] - a.high[1])) {
    const row = rows.at(-1);
    if (row?.[0] && middle(box, 1) > row[0].low[1]) row.push(box);
    else rows.push([box]);
  }
  return rows.flatMap((row) => row.sort((a, b) => a.low[0] - b.low[0]).map(({piece}) => piece));
}

/** Sides of seams round a piece, counter-clockwise from where its outline begins. */
export const seamsRound = (index: PickIndex, piece: number): readonly SeamPlace[] =>
  (index.pieces[piece]?.lines ?? []).flatMap(({name}) =>
    name.kind === 'seam' ? [{level: 'seam', piece, seam: name.seam, side: name.side}] : [],
  );

/** How much a piece beside the way counts more than one further along it, by gap and by middle. */
const besideFactor = 2;
const middleFactor = 0.1;

/** The next piece in a direction; the same one where there is none. */
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

/** The next side of a seam round the same piece, or the one before; after the last comes the first. */
export function nextSeam(index: PickIndex, current: SeamPlace, step: 1 | -1): SeamPlace {
  const round = seamsRound(index, current.piece);
  const at = round.findIndex(({seam, side}) => seam === current.seam && side === current.side);
  return round[(at + step + round.length) % round.length] ?? current;
}

/** To the first seam of a piece, if it has any. */
export const inwards = (index: PickIndex, place: Place): Place =>
  (place.level === 'piece' ? seamsRound(index, place.piece)[0] : undefined) ?? place;

/** From a seam to its piece, from a piece off the sheet. */
export const outwards = (place: Place): PiecePlace | undefined =>
  place.level === 'seam' ? {level: 'piece', piece: place.piece} : undefined;

/** To what a side of a seam is sewn to. */
export function twin({sheet}: PickIndex, place: SeamPlace): SeamPlace {
  const side = place.side === 'a' ? 'b' : 'a';
  const piece = sheet.seams[place.seam]?.[side].piece;
  return piece === undefined ? place : {...place, piece, side};
}
