// `npm run fonts`: writes the letters of Liberation Sans that PDF files embed, from the fonts of pdfjs-dist.
import {readFileSync, writeFileSync} from 'node:fs';
import {deflateSync} from 'node:zlib';

import {subsetOf} from '../../dist/files/pdf/fonts/subset.js';
import {readTrueType} from '../../dist/files/pdf/fonts/true-type.js';
import {root} from './shell.mjs';

/** Latin, Greek and Cyrillic letters with their punctuation, currencies, arrows and signs. */
const ranges = [
  [0x20, 0x7e],
  [0xa0, 0x218f],
  [0x2190, 0x22ff],
  [0x25a0, 0x25cf],
  [0x2640, 0x2642],
];

const folder = `${root}/web/src/files/pdf/fonts`;
const source = (name) =>
  `${root}/node_modules/pdfjs-dist/standard_fonts/LiberationSans-${name}.ttf`;
const fonts = {};
for (const [weight, name] of [
  ['regular', 'Regular'],
  ['bold', 'Bold'],
]) {
  fonts[weight] = await readTrueType(new Uint8Array(readFileSync(source(name))), name);
}

const codes = ranges
  .flatMap(([first, last]) => Array.from({length: last - first + 1}, (_, k) => first + k))
  .filter((code) => Object.values(fonts).every((font) => font.glyphOf(code) > 0));
const runs = [];
for (const code of codes) {
  const run = runs.at(-1);
  if (run?.[1] === code - 1) run[1] = code;
  else runs.push([code, code]);
}
const head = '// written by `npm run fonts`';
const constant = 'export const';
const widths = ({unitsPerEm, glyphOf, widthOf}) =>
  codes.map((code) => Math.round((1000 * widthOf(glyphOf(code))) / unitsPerEm)).join(' ');
const outlines = (font) => {
  const {glyphOf} = font;
  return deflateSync(subsetOf(font, [0, ...codes.map(glyphOf)]), {level: 9}).toString('base64');
};

writeFileSync(
  `${folder}/sans-widths.ts`,
  `${head}
/** Code points of the letters, as first and last of consecutive ones. */
${constant} sansRanges =
  '${runs.map((run) => run.join('-')).join(' ')}';

/** Widths of the letters in thousandths of the font size. */
${constant} sansWidths = {
  regular:
    '${widths(fonts.regular)}',
  bold: '${widths(fonts.bold)}',
};
`,
);
writeFileSync(
  `${folder}/sans-outlines.ts`,
  `${head}
/**
 * Liberation Sans (SIL Open Font License 1.1) as deflated TrueType files in base 64: glyph 0 is the
 * missing letter, the letters of \`sansRanges\` follow.
 */
${constant} sansOutlines = {
  regular:
    '${outlines(fonts.regular)}',
  bold: '${outlines(fonts.bold)}',
};
`,
);
