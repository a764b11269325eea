/** Reads shown glyphs as texts with their places, and joins the parts of lines. */
import {after, apply, planeMap} from '../../../model/geometry/plane-map.js';
import {cross, distance, dot, minus, unit, type Point} from '../../../model/geometry/vectors.js';
import {growthOf, type Graphics, type TextState} from './graphics.js';
import type {InkText} from './ink.js';

/** A glyph of pdf.js, or a shift in thousandths of the font size. */
type Shown = number | {readonly unicode: string; readonly width: number; readonly isSpace: boolean};

/** The shown text, and the state after it. */
export function shownText(
  state: Graphics,
  glyphs: readonly Shown[],
  layer: string | undefined,
): {readonly ink: InkText | undefined; readonly text: TextState} {
  const {text} = state;
  let [along, letters] = [0, ''];
  for (const glyph of glyphs) {
    if (typeof glyph === 'number') {
      along -= (glyph / 1000) * text.size * text.scale;
      if (glyph < widestShift) letters += ' ';
      continue;
    }
    const {unicode, width, isSpace} = glyph;
    letters += unicode;
    const space = text.letterSpace + (isSpace ? text.wordSpace : 0);
    along += ((width / 1000) * text.size + space) * text.scale;
  }
  const map = after(state.map, text.matrix);
  const [from, to] = [apply(map, [0, text.rise]), apply(map, [along, text.rise])];
  const next = {...text, matrix: after(text.matrix, planeMap(1, 0, 0, 1, along, 0))};
  const size = Math.abs(text.size) * growthOf(map);
  const written = letters.normalize('NFKC').replaceAll(/[\p{Cc}\s]+/gu, ' ');
  const isSane = [...from, ...to, size].every((value) => Math.abs(value) < 1e5);
  if (written.trim() === '' || !isSane) return {ink: undefined, text: next};
  return {
    ink: {...{text: written, from, to, size}, ...(layer !== undefined && {layer})},
    text: next,
  };
}

/** A shift to the right by more than this is a space between words. [font size / 1000] */
const widestShift = -200;

/** Greatest gap between parts of one word, and between words of one line. [font sizes] */
const gaps = {letters: 0.15, words: 1.2};

/** A text with its continuation on the same line; undefined if the next one does not continue it. */
export function joinedText(before: InkText | undefined, next: InkText): InkText | undefined {
  const gap = before && gapBetween(before, next);
  if (!before || gap === undefined) return undefined;
  const space = gap > gaps.letters && !before.text.endsWith(' ') ? ' ' : '';
  return {...before, text: `${before.text}${space}${next.text}`, to: next.to};
}

/** The gap between two parts of a line in font sizes; undefined if they are on different lines. */
function gapBetween(a: InkText, b: InkText): number | undefined {
  if (Math.abs(a.size - b.size) > 0.05 * a.size || a.layer !== b.layer) return undefined;
  const way = directionOf(a);
  const isParallel = dot(way, directionOf(b)) > 0.99;
  const off = minus(b.from, a.to);
  const [along, aside] = [dot(off, way) / a.size, Math.abs(cross(way, off)) / a.size];
  return isParallel && aside < 0.2 && along > -gaps.letters && along < gaps.words
    ? along
    : undefined;
}

const directionOf = ({from, to}: InkText): Point =>
  distance(from, to) > 0 ? unit(minus(to, from)) : [1, 0];
