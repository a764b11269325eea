/**
 * Marks for projectors, which lose thin lines and small letters: about a millimetre is a pixel.
 * Lengths in cm.
 */
import {leastLetterMm, type CutMark, type CutText, type LaidPiece} from '../cutting/cut-sheet.js';
import {distance} from '../model/geometry/vectors.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import {grown} from './boxes.js';
import {boxOfMark} from './draw-marks.js';
import {placeIn} from './words-on-page.js';

const cutMm = 1.5;
const projectedLetterMm = 15;
/** Greatest distance of a letter from the place of the mark that it names. */
const farthest = 6;
/** Space of a cross. */
const crossReach = 0.5;
const upright = Math.PI / 2;

/** Importance of texts: the piece, then its seams, its crosses, and ticks and names of lines. */
function rankOf({layer, sizeMm, weight}: CutText): number {
  if (layer === 'words') return weight === undefined ? 0 : 3;
  return layer === 'marks' ? 1 : sizeMm > leastLetterMm ? 2 : 3;
}

/** The words of a name in a number of lines of about equal length. */
function inLines(name: string, count: number): readonly string[] {
  const lines: string[] = [''];
  for (const word of name.split(' ')) {
    const longer = `${lines.at(-1) ?? ''} ${word}`.trim();
    const isLast = lines.length === count;
    if (isLast || longer.length <= name.length / count + word.length / 2)
      lines.splice(-1, 1, longer);
    else lines.push(word);
  }
  return lines;
}

/** The text with fewer lines, then the name in several; upright or not, by preference. */
function variants(mark: CutText): readonly CutText[] {
  const [name = ''] = mark.lines;
  const large = {...mark, sizeMm: projectedLetterMm};
  const fewer = mark.lines.map((_, k) => ({
    ...large,
    lines: mark.lines.slice(0, mark.lines.length - k),
  }));
  const divided = Array.from({length: name.split(' ').length - 1}, (_, k): CutText => ({
    ...{...large, weight: 'bold'},
    lines: inLines(name, k + 2),
  }));
  return [...fewer, ...divided].flatMap((text) => [text, {...text, angle: upright}]);
}

/** A text in large letters where the piece has room for it, or the name of a piece in any case. */
function enlarged(mark: CutText, piece: LaidPiece, others: readonly Box[]): CutText | undefined {
  const isName = rankOf(mark) === 0;
  const frame = boxOf(piece.cut[0] ?? []);
  const texts = isName ? variants(mark) : [{...mark, sizeMm: projectedLetterMm}];
  // the name of a piece may cover a cross
  for (const obstacles of isName ? [others, []] : [others]) {
    for (const text of texts) {
      const at = placeIn(frame, text, piece, obstacles);
      if (at && (isName || distance(at, mark.at) < farthest)) return {...text, at};
    }
  }
  return isName ? variants(mark).at(-2) : undefined;
}

/**
 * The marks of a piece with wide cut lines and large letters, without sewn lines. Names of marks
 * are left out where there is no room for them.
 */
export function projectedMarks(piece: LaidPiece): readonly CutMark[] {
  const texts = piece.marks.filter((mark) => mark.kind === 'text');
  const placed: CutText[] = [];
  const taken = piece.matchPoints.map(({at}) => grown({low: at, high: at}, crossReach));
  for (const mark of texts.toSorted((a, b) => rankOf(a) - rankOf(b))) {
    const text = enlarged(mark, piece, taken);
    if (!text) continue;
    placed.push(text);
    taken.push(boxOfMark(text));
  }
  const lines = piece.marks.flatMap((mark): readonly CutMark[] => {
    if (mark.kind === 'text' || mark.layer === 'sew') return [];
    return [mark.layer === 'cut' ? {...mark, widthMm: cutMm, haloMm: cutMm} : mark];
  });
  return [...lines, ...placed];
}
