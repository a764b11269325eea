/** Draws a cutting sheet as SVG in millimetres, with test squares below the pieces. */
import {markAcross} from '../picture/watermark.js';
import {onPiece, type Point} from '../model/geometry/vectors.js';
import {fabricTile, fabricUnder, type PrintWithTile} from '../picture/fabric.js';
import {drawingSpaces, escaped, linked, polyline, short, text} from '../files/svg/written.js';
import {textWidth} from '../layout/name-lines.js';
import {lineColours} from './line-colours.js';
import {paleWhite, type PrintInk} from './print-ink.js';
import type {CutLine, CutMark, CutSheet, CutText, LaidPiece} from './cut-sheet.js';

/** [mm] */
const unit = 10;
const margin = 15;
/** Height of the test squares, and least height for the text beside them. */
const foot = 82;
const belowWords = 24;
const leading = 7;
const leastWidth = 240;
const wordColour = lineColours.words.hex;

type Page = (p: Point) => Point;

const pathOf = (page: Page, points: readonly Point[], isClosed: boolean): string =>
  polyline(points.map(page)) + (isClosed ? 'Z' : '');

const closed = (loops: readonly (readonly Point[])[], page: Page): string =>
  loops.map((loop) => pathOf(page, loop, true)).join('');

function drawnLine(
  {layer, points, isClosed, widthMm, dashMm, haloMm, isFaint}: CutLine,
  page: Page,
) {
  const d = pathOf(page, points, isClosed);
  const opacity = isFaint ? ' opacity="0.4"' : '';
  const halo =
    haloMm === undefined
      ? ''
      : `<path d="${d}" stroke="#fff" stroke-opacity="0.85" stroke-width="${short(widthMm + haloMm)}"${opacity}/>`;
  const dash = dashMm ? ` stroke-dasharray="${dashMm.join(' ')}"` : '';
  return {
    halo,
    line: `<path class="${layer}" d="${d}" stroke="${lineColours[layer].hex}" stroke-width="${short(widthMm)}"${dash}${opacity}/>`,
  };
}

/** The share of a text's width to the left of its point, and the SVG anchor, by alignment. */
const aligned = {
  left: {share: 0, anchor: 'start'},
  middle: {share: 0.5, anchor: 'middle'},
  right: {share: 1, anchor: 'end'},
} as const;

function drawnText(mark: CutText, page: Page): string {
  const {at, lines, sizeMm: size, hasPlate, angle = 0, align = 'middle', weight} = mark;
  const [x, y] = page(at);
  const leading = 1.25 * size;
  const {share, anchor} = aligned[align];
  const width = Math.max(...lines.map((line) => textWidth(line, size))) + size;
  const height = leading * lines.length + 0.4 * size;
  const ground = hasPlate
    ? `<rect x="${short(x - width * share)}" y="${short(y - height / 2)}" width="${short(width)}" height="${short(height)}" rx="${short(size / 3)}" fill="#fff" fill-opacity="0.85" stroke="none"/>`
    : '';
  const words = lines.map((line, k) => {
    const isBold = weight === undefined ? k === 0 : weight === 'bold';
    return text([x, y + leading * (k - (lines.length - 1) / 2) + 0.35 * size], line, {
      ...{size: Number(short(size)), anchor, fill: wordColour, weight: isBold ? 600 : 400},
    });
  });
  const turn =
    angle === 0
      ? ''
      : ` transform="rotate(${short((-180 / Math.PI) * angle)} ${short(x)} ${short(y)})"`;
  return `<g stroke="none"${turn}>${ground}${words.join('')}</g>`;
}

/** Draws marks. Consecutive lines share their halos, which are drawn beneath all of them. */
export function drawnMarks(marks: readonly CutMark[], page: Page): string {
  const drawn: string[] = [];
  let lines: string[] = [];
  const flush = (): void => {
    drawn.push(...lines);
    lines = [];
  };
  marks.forEach((mark, k) => {
    if (mark.kind === 'text' || mark.layer !== marks[k - 1]?.layer) flush();
    if (mark.kind === 'text') drawn.push(drawnText(mark, page));
    else {
      const {halo, line} = drawnLine(mark, page);
      drawn.push(halo);
      lines.push(line);
    }
  });
  flush();
  return drawn.join('');
}

/** A piece as a layer of drawing programs. */
function drawnPiece(piece: LaidPiece, k: number, page: Page, ink: PrintInk): string {
  const area = (fill: string): string =>
    `<path d="${closed(piece.cut, page)}" ${fill} fill-rule="evenodd"/>`;
  const isPrinted = piece.alignment && ink !== 'outline';
  const fabric = area(isPrinted ? `fill="url(#fabric-${k})"` : 'fill="#fff"');
  const tint = isPrinted && ink === 'pale' ? area(`fill="#fff" fill-opacity="${paleWhite}"`) : '';
  return `<g id="piece-${k}" inkscape:groupmode="layer" inkscape:label="${escaped(piece.label)}" aria-label="${escaped(piece.label)}" fill="none" stroke-linejoin="round" stroke-linecap="round">${fabric}${tint}${drawnMarks(piece.marks, page)}</g>`;
}

/** Squares that verify the print scale with a ruler. */
function testSquares([x, y]: Point): string {
  const square = (left: number, side: number, label: string): string =>
    `<rect x="${short(left)}" y="${short(y)}" width="${side}" height="${side}" fill="none" stroke="${wordColour}" stroke-width="0.3"/>${text([left + side / 2, y + side / 2 + 1.5], label, {size: 5, anchor: 'middle', fill: wordColour})}`;
  return square(x, 50, '5 cm') + square(x + 60, 50.8, '2 in');
}

interface SheetSvgOptions {
  /** Default full. */
  readonly ink?: PrintInk | undefined;
  /** Watermark across the whole sheet, such as `notAsSold`. */
  readonly mark?: string | undefined;
}

/** Draws the sheet. */
export function drawSheetSvg(
  {widthCm, heightCm, pieces, heading, facts}: CutSheet,
  print: PrintWithTile,
  {ink = 'full', mark}: SheetSvgOptions = {},
): string {
  const width = Math.max(widthCm * unit, leastWidth) + 2 * margin;
  const footHeight = Math.max(foot, belowWords + 18 + leading * facts.length);
  const height = heightCm * unit + 2 * margin + footHeight;
  const page: Page = ([x, y]) => [margin + unit * x, margin + unit * (heightCm - y)];
  const fabrics = pieces.map(({alignment, place}, k) =>
    alignment
      ? fabricUnder(`fabric-${k}`, 'fabric', print, alignment, (p) => page(onPiece(place, p)))
      : '',
  );
  const below = height - margin - footHeight + belowWords;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" ${drawingSpaces} width="${short(width)}mm" height="${short(height)}mm" viewBox="0 0 ${short(width)} ${short(height)}" font-family="'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif">`,
    `<title>${escaped(heading)}</title>`,
    ink === 'outline'
      ? ''
      : `<defs>${linked(fabricTile('fabric', print, unit) + fabrics.join(''))}</defs>`,
    '<rect width="100%" height="100%" fill="#fff"/>',
    ...pieces.map((piece, k) => drawnPiece(piece, k, page, ink)),
    testSquares([margin, below]),
    text([margin + 122, below + 8], heading, {size: 8, weight: 600, fill: wordColour}),
    ...facts.map((line, k) =>
      text([margin + 122, below + 18 + leading * k], line, {size: 4.5, fill: wordColour}),
    ),
    mark === undefined ? '' : markAcross(mark, width, height),
    '</svg>\n',
  ].join('\n');
}
