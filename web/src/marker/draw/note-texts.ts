/** Formats a note on a layout in any language. Lengths in cm. */
import type {LayNote} from '../../model/result/lay-note.js';
import {formatted} from '../../texts/base/message.js';
import {plan as english, type PlanTexts} from '../../texts/en/plan.js';

/** Formatting of a note's values. */
export interface NoteFormat {
  readonly length: (cm: number) => string;
  readonly rounded: (cm: number) => string;
  readonly range: (least: number, most: number) => readonly [string, string];
  readonly count: (count: number) => string;
  /** The displayed name of a piece. */
  readonly name: (piece: string) => string;
}

/**
 * The whole centimetres that enclose two lengths. A length within `slack` of a whole number counts
 * as whole.
 */
export const wholeRange = (
  least: number,
  most: number,
  slack: number,
): readonly [least: number, most: number] => [Math.floor(least + slack), Math.ceil(most - slack)];

/** Rounding error of lengths written to a millimetre. [cm] */
const halfMillimetre = 0.05;

function plainRange(least: number, most: number): readonly [string, string] {
  const [from, to] = wholeRange(least, most, halfMillimetre);
  return [`${from}`, `${to} cm`];
}

/** The format of notes in files. */
const plain: NoteFormat = {
  length: (cm) => `${cm.toFixed(2)} cm`,
  rounded: (cm) => `${cm.toFixed(1)} cm`,
  range: plainRange,
  count: String,
  name: (piece) => piece,
};

/** A note as a sentence. */
export function saidNote(
  {code, pieces, lengthsCm, counts}: LayNote,
  texts: PlanTexts['notes'] = english.notes,
  {length, rounded, range, count, name}: NoteFormat = plain,
): string {
  const [first = 0, second = 0] = lengthsCm;
  const [least, most] = range(first, second);
  const [some = '', all = ''] = counts.map(count);
  const values: Readonly<Record<string, string>> = {
    ...{pieces: pieces.map(name).join(', '), least, most, count: some, all},
    ...{length: length(first), rounded: rounded(first)},
  };
  return formatted(texts[code], (value) => values[value]);
}
