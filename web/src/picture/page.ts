/** The page of drawn images. [px] */
import type {Pattern} from '../model/result/result.js';
import {nameLeading, nameRoom} from './draw-pieces.js';
import {layOutNamed} from '../layout/layout.js';
import type {Placements} from '../layout/on-body.js';
import {nameLines, textWidth} from '../layout/name-lines.js';

export const width = 1200;
export const margin = 56;
export const nameSize = 13;

/** A layout of pieces with space for their names. Patterns of many pieces get more height. */
export function laidOut(
  pattern: Pattern,
  names: readonly string[],
  placements: Placements | undefined,
): ReturnType<typeof layOutNamed> {
  const room = width - 2 * margin;
  const widest = (name: string): number =>
    Math.max(...nameLines(name, 0, nameSize).map((word) => textWidth(word, nameSize)));
  const page = {
    width: room,
    height: room / (pattern.pieces.length > 16 ? 1.5 : 2.3),
    grows: true,
    greatestScale: 14,
    gap: 34,
    nameHeight: (piece: number, pieceWidth: number) =>
      28 +
      nameLines(names[piece] ?? '', nameRoom(pieceWidth), nameSize).length * nameLeading * nameSize,
    nameWidth: (piece: number) => widest(names[piece] ?? ''),
  };
  return layOutNamed(pattern, page, placements);
}
