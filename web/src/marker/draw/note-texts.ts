/** What is noted of a lay plan, in English, and how a note is said in any language. Lengths in cm. */
import type {LayNote, LayNoteCode} from '../../model/lay-note.js';

/** Values of a note as words, the lengths with their unit. */
export interface NoteWords {
  readonly pieces: string;
  /** Each to a tenth of a millimetre, or as its unit has it. */
  readonly lengths: readonly string[];
  /** The same to a millimetre, or as its unit has it. */
  readonly rounded: readonly string[];
  /** "120", "136 cm", where there are two: whole centimetres that both lie between. */
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

/** How values become words. */
export interface NoteFormat {
  readonly length: (cm: number) => string;
  readonly rounded: (cm: number) => string;
  readonly range: (least: number, most: number) => readonly [string, string];
  readonly count: (count: number) => string;
  /** What people call a piece. */
  readonly name: (piece: string) => string;
}

/** The whole centimetres that lengths lie between; what is off one by no more than `slack` is that one. */
export const wholeRange = (
  least: number,
  most: number,
  slack: number,
): readonly [least: number, most: number] => [Math.floor(least + slack), Math.ceil(most - slack)];

/** What is written to a millimetre is whole where that says so. [cm] */
const halfMillimetre = 0.05;

function plainRange(least: number, most: number): readonly [string, string] {
  const [from, to] = wholeRange(least, most, halfMillimetre);
  return [`${from}`, `${to} cm`];
}

/** As files have it. */
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
