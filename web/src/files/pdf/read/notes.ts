/** Notes on the pages of a PDF, and the reasons why none shows a piece. */
import {rangesOf} from '../../../model/base/number-ranges.js';
import type {Refusal} from '../../../model/base/versioned-file.js';
import type {Sheet} from './assemble.js';
import {isBare} from './ink.js';
import type {PdfPages} from './open-pdf.js';

/** Greatest number of joints that are named. */
const mostJoints = 5;

export function assemblyNotes(sheet: Sheet, {pages, hasPictures}: PdfPages): string[] {
  const {others, columns, rows, overlap, openJoints, notes} = sheet;
  const used = sheet.pages.map(({number}) => number);
  const pictures = others.filter(
    (number) => hasPictures && pages.some((page) => page.number === number && isBare(page)),
  );
  const cm = (mm: number): string => (mm / 10).toFixed(2);
  return [
    ...(overlap && used.length > 1
      ? [
          `Pages ${rangesOf(used)} are put together in ${columns} columns and ${rows} rows, with an overlap of ${cm(overlap[0])} x ${cm(overlap[1])} cm.`,
        ]
      : []),
    ...openJoints
      .slice(0, mostJoints)
      .map(
        ({pages: [a, b], misses}) =>
          `Pages ${a} and ${b} do not meet: ${misses} ${misses === 1 ? 'line ends' : 'lines end'} at their joint; check the rows, the trim and the overlap.`,
      ),
    ...(openJoints.length > mostJoints
      ? [`${openJoints.length - mostJoints} more joints of pages do not meet.`]
      : []),
    ...(others.length > 0
      ? [
          `${others.length === 1 ? 'Page' : 'Pages'} ${rangesOf(others)} ${others.length === 1 ? 'shows' : 'show'} no pattern, and ${others.length === 1 ? 'is' : 'are'} left out.`,
        ]
      : []),
    ...(pictures.length > 0
      ? [
          `Pictures are not read: ${pictures.length === 1 ? 'page' : 'pages'} ${rangesOf(pictures)}.`,
        ]
      : []),
    ...notes,
  ];
}

/** Why a file without a piece is no pattern. */
export function whyNoPiece(
  {pages, hasPictures}: PdfPages,
  {lines}: Pick<Sheet, 'lines'>,
  notes: readonly string[],
): Refusal {
  const drawn = pages.some((page) => page.lines.some(({style}) => style.stroke !== undefined));
  if (hasPictures && pages.every(isBare)) {
    return {
      refusal:
        'shows pictures alone, as scans do; only patterns drawn with lines can be read, so ask its maker for a PDF with lines.',
      reason: 'scan',
    };
  }
  if (!drawn) {
    return {
      refusal: 'shows no lines; choose the PDF of the pattern, and not that of its instructions.',
      reason: 'noPattern',
    };
  }
  const first = notes.find((note) => /does not close|as no pattern has/.test(note));
  if (first !== undefined) return {refusal: `shows no piece: ${first}`, reason: 'outline'};
  return lines.length === 0
    ? {
        refusal: 'shows no page with a pattern; name its pages, rows and columns.',
        reason: 'noPattern',
      }
    : {
        refusal:
          'shows no closed line of 4 cm² or more; name the pages of the pattern, or their rows and columns.',
        reason: 'outline',
      };
}
