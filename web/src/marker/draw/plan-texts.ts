/** English texts of a layout. Lengths are passed as text with their unit. */
import type {LayNoteCode} from '../../model/result/lay-note.js';
import {noteTexts, type NoteWords} from './note-texts.js';

/** The sentence of each note, by code. */
const notes: Readonly<Record<LayNoteCode, (words: NoteWords) => string>> = noteTexts;

export const planTexts = {
  title: (scale: number) => `Lay plan 1 : ${scale}`,
  length: 'Length',
  proven: 'proven: none is shorter',
  atBest: (length: string) => `at best ${length}`,
  lying: 'of the pieces that lie',
  buy: 'Buy',
  roundedUp: (step: string) => `rounded up to ${step}`,
  use: 'Cloth used',
  ofWidth: (width: string) => `of a width of ${width}`,
  cost: 'The print costs',
  without: (length: string) => `without it ${length}`,
  share: (share: string) => `${share} %`,
  cloth: (width: string, selvedge: string, gap: string, allowance: string) =>
    `Cloth ${width} wide, selvedges ${selvedge}, ${gap} between pieces, allowance ${allowance}; single layer, face up.`,
  folded: (width: string, selvedge: string, gap: string, allowance: string, fold: string) =>
    `Cloth ${width} wide, selvedges ${selvedge}, ${gap} between pieces, allowance ${allowance}; folded lengthwise ${fold} from the left edge, face to face, shown spread.`,
  print: (name: string, across: string, along: string) =>
    `${name}: the ring is on a corner of its repeat, ${across} from the left edge, ${along} from the start.`,
  plain: 'The print is not regarded: pieces lie anywhere.',
  unplaced: (pieces: string) => `Without a place: ${pieces}.`,
  pinned: (length: string) => `Pinned pieces cost ${length} more.`,
  start: 'Start of the cloth',
  page: (number: number, count: number) => `page ${number} of ${count}`,
  garment: (piece: string, garment: number) => `${piece}, garment ${garment}`,
  crosses: 'Crosses of a piece lie on one and the same point of the print',
  crossesUnit: (unit: string) => `Each from the left edge × from the start of the cloth [${unit}]`,
  number: 'No.',
  piece: 'Piece',
  cross: (number: number) => `Cross ${number}`,
  phases: 'The print may start elsewhere at the left edge',
  phase: 'It starts at',
  widths: 'Other cloth',
  width: 'Width',
  none: '–',
  notes,
};

export type PlanTexts = typeof planTexts;
