/**
 * English texts of a layout's notes, and the formatting of a note in any language. Lengths in cm.
 */
import type {LayNote, LayNoteCode} from '../../model/result/lay-note.js';

/** Values of a note as text; lengths include their unit. */
export interface NoteWords {
  readonly pieces: string;
  /** Lengths rounded to a tenth of a millimetre, or as usual for the unit. */
  readonly lengths: readonly string[];
  /** Lengths rounded to a millimetre, or as usual for the unit. */
  readonly rounded: readonly string[];
  /** Enclosing whole centimetres of two lengths, for example "120" and "136 cm". */
  readonly range: readonly [least: string, most: string];
  readonly counts: readonly string[];
}

type NoteTexts = Readonly<Record<LayNoteCode, (words: NoteWords) => string>>;

export const noteTexts: NoteTexts = {
  plainPieces: ({pieces}) => `Pieces of plain cloth are not laid on the print: ${pieces}.`,
  pliesUnlike: () =>
    'This print never comes again along the cloth, so no length makes all plies start alike: lay them one by one.',
  pliesWhole: ({counts: [plies], lengths: [repeat]}) =>
    `Each of the ${plies} plies is a whole number of repeats long, of ${repeat}, so that all start alike.`,
  flawsFromCut: () =>
    'Flaws are counted from the cut, where the print is taken to start; say how far from it the print starts if it does not.',
  folded: ({rounded: [edge]}) =>
    `The cloth is folded ${edge} from its left edge, face to face, and both plies are cut at once.`,
  foldKeepsPrint: () =>
    'On folded cloth the print is moved under no piece, since the lower ply shows its mirror image.',
  phaseRange: ({range: [least, most]}) =>
    `${least} to ${most}, by where the print starts at the selvedge; measure it.`,
  phaseNowhere: ({counts: [nowhere, all]}) =>
    `At ${nowhere} of ${all} places where the print may start at the selvedge, not all pieces fit on the cloth.`,
};

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

export function saidNote(
  {code, pieces, lengthsCm, counts}: LayNote,
  texts: NoteTexts = noteTexts,
  {length, rounded, range, count, name}: NoteFormat = plain,
): string {
  const [least = 0, most = 0] = lengthsCm;
  return texts[code]({
    pieces: pieces.map(name).join(', '),
    lengths: lengthsCm.map(length),
    rounded: lengthsCm.map(rounded),
    range: range(least, most),
    counts: counts.map(count),
  });
}
