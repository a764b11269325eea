/** Letters of other scripts as pictures in the fonts of the browser, which also joins letters. */
import type {LettersPicture, OtherLetters} from '../../files/pdf/fonts/other-letters.js';

/** Pixels per font size: 460 dots per inch at the size of a piece's name. */
const perEm = 128;
/** Room above the baseline, and of the whole line, relative to the font size. */
const [ascent, lineHeight] = [1.1, 1.5];
/** Least opacity of ink. */
const ink = 128;

function pictureOf(text: string): LettersPicture | undefined {
  const font = `${perEm}px sans-serif`;
  const ruler = new OffscreenCanvas(1, 1).getContext('2d');
  if (!ruler) return undefined;
  ruler.font = font;
  const width = Math.max(1, Math.ceil(ruler.measureText(text).width));
  const height = Math.ceil(lineHeight * perEm);
  const baseline = Math.round(ascent * perEm);
  const context = new OffscreenCanvas(width, height).getContext('2d');
  if (!context) return undefined;
  context.font = font;
  context.fillText(text, 0, baseline);
  const {data} = context.getImageData(0, 0, width, height);
  const row = Math.ceil(width / 8);
  const bits = new Uint8Array(row * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const at = y * row + (x >> 3);
      if ((data[4 * (y * width + x) + 3] ?? 0) >= ink)
        bits[at] = (bits[at] ?? 0) | (128 >> (x & 7));
    }
  }
  return {width, height, bits, perEm, baseline};
}

export const drawnLetters: OtherLetters = typeof OffscreenCanvas === 'undefined' ? {} : {pictureOf};
