/** Several sizes of a pattern in one PDF, each on its own layer. */
import type {CutMark, CutSheet} from '../cutting/cut-sheet.js';
import type {PrintWithTile} from '../picture/fabric.js';
import type {SheetTexts} from '../texts/sheet-texts.js';

/** A sheet of one size, with the print in the size of its result. */
export interface SizeSheet {
  readonly sheet: CutSheet;
  readonly print: PrintWithTile;
}

/** Dashes of cut lines by size, which differ where all layers are shown. [mm] */
const dashesMm: readonly (readonly number[])[] = [
  ...[[], [8, 3], [4, 2], [8, 2, 2, 2], [2, 2], [12, 3, 2, 3, 2, 3], [6, 6]],
];

/** The marks of a piece with the cut line of its size. */
export function withDashes(marks: readonly CutMark[], index: number): readonly CutMark[] {
  const dashMm = dashesMm[index % dashesMm.length] ?? [];
  return dashMm.length === 0
    ? marks
    : marks.map((mark) =>
        mark.kind === 'line' && mark.layer === 'cut' ? {...mark, dashMm} : mark,
      );
}

const sizesOf = (sheets: readonly CutSheet[]): string =>
  sheets.flatMap(({size}) => size ?? []).join(', ');

/** A sheet with the pieces of all sizes, whose heading and facts name the sizes. */
export function together(sheets: readonly CutSheet[], texts: SheetTexts): CutSheet | undefined {
  const [first] = sheets;
  if (!first || sheets.length === 1) return first;
  const heading = [first.title ?? '', texts.sizes(sizesOf(sheets))].filter((one) => one !== '');
  return {
    ...first,
    heading: heading.join(', '),
    facts: [texts.sizeLayers, ...first.facts],
    pieces: sheets.flatMap(({pieces}) => pieces),
  };
}

/** Title and size or sizes, which are on every page. */
export function headingWords(sheets: readonly CutSheet[], texts: SheetTexts): readonly string[] {
  const [first] = sheets;
  if (sheets.length > 1) return [first?.title ?? '', texts.sizes(sizesOf(sheets))];
  return first?.size === undefined
    ? [first?.heading ?? '']
    : [first.title ?? '', texts.size(first.size)];
}
