/** Draws a piece to cut: cloth to the cut line, the line to sew along, marks and words. One unit is one millimetre. */
import {combined, minus, plus, rotated, unit, type Point} from '../model/geometry.js';
import type {Print} from '../model/print.js';
import {imageCell} from '../model/wallpaper.js';
import {escaped, polyline, short, text} from '../picture/svg.js';
import {textWidth} from '../layout/name-lines.js';
import type {CutPiece} from './cut-piece.js';

interface CutStyle {
  /** The pattern that fills the piece; plain paper without one. */
  readonly cloth: string | undefined;
  /** Names the clip path of this piece. */
  readonly id: string;
  readonly print: Print;
  /** Lines of words; the first is the name. */
  readonly words: readonly string[];
  /** Notches reach so far out of the sewn outline, or into the piece where there is no allowance. [cm] */
  readonly allowanceCm: number;
  /** Piece coordinates -> sheet. */
  readonly page: (p: Point) => Point;
}

const ink = '#1d1f23';
/** [mm] */
const markRadius = 3;
const arrow = 3.5;
const notchIntoPiece = 0.4; // [cm]
const greatestWords = 7;
const leastWords = 2;
const letterSize = 5.5;

/** A thin line over a wider light one, so that it shows on any print. */
const drawn = (path: string, width: number, dash = ''): string =>
  `<path d="${path}" stroke="#fff" stroke-opacity="0.85" stroke-width="${short(width + 0.7)}"/><path d="${path}" stroke="${ink}" stroke-width="${width}"${dash && ` stroke-dasharray="${dash}"`}/>`;

const closed = (loops: readonly (readonly Point[])[], page: (p: Point) => Point): string =>
  loops.map((loop) => `${polyline(loop.map(page))}Z`).join('');

/** Both ends have heads: the file says how the grain runs, not which end is up. */
function grainArrow([from, to]: readonly [Point, Point]): string {
  const [ux, uy] = unit(minus(to, from)).map((side) => side * arrow) as [number, number];
  const head = ([x, y]: Point, sign: 1 | -1): string =>
    polyline([
      [x - sign * ux - uy / 2, y - sign * uy + ux / 2],
      [x, y],
      [x - sign * ux + uy / 2, y - sign * uy - ux / 2],
    ]);
  return drawn(polyline([from, to]) + head(to, 1) + head(from, -1), 0.4);
}

function notches({notches: marks}: CutPiece, {allowanceCm, page}: CutStyle): string {
  const reach = allowanceCm > 0 ? allowanceCm : -notchIntoPiece;
  return marks
    .map(({at: [x, y], outward: [nx, ny]}) =>
      drawn(polyline([[x, y] as const, [x + reach * nx, y + reach * ny] as const].map(page)), 0.5),
    )
    .join('');
}

/** One repeat of the print around a point, so that the place is found on the cloth. */
function repeatAround(p: Point, piece: CutPiece, {print, page}: CutStyle): string {
  const [a, b] = imageCell(print).map((side) => rotated(side, piece.alignment.angle));
  if (!a || !b) return '';
  const corner = (s: number, t: number): Point => plus(p, combined([a, b], s, t));
  const half = 1 / 2;
  const frame = [
    corner(-half, -half),
    corner(half, -half),
    corner(half, half),
    corner(-half, half),
  ];
  return `${polyline(frame.map(page))}Z`;
}

function matchMark(p: Point, number: number, {page}: CutStyle): string {
  const [x, y] = page(p);
  const r = markRadius;
  const cross = `M${short(x - r - 1.5)} ${short(y)}h${2 * r + 3}M${short(x)} ${short(y - r - 1.5)}v${2 * r + 3}`;
  const ring = `M${short(x - r)} ${short(y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
  return drawn(cross + ring, 0.3) + plate([x + r + 3.5, y - r - 1], [String(number)], 3.5);
}

/** Words on a light ground, their middle at a point. */
function plate([x, y]: Point, lines: readonly string[], size: number): string {
  const leading = 1.25 * size;
  const width = Math.max(...lines.map((line) => textWidth(line, size))) + size;
  const height = leading * lines.length + 0.4 * size;
  const words = lines.map((line, k) =>
    text([x, y + leading * (k - (lines.length - 1) / 2) + 0.35 * size], line, {
      ...{size: Number(short(size)), anchor: 'middle', fill: ink, weight: k === 0 ? 600 : 400},
    }),
  );
  return `<rect x="${short(x - width / 2)}" y="${short(y - height / 2)}" width="${short(width)}" height="${short(height)}" rx="${short(size / 3)}" fill="#fff" fill-opacity="0.85" stroke="none"/><g stroke="none">${words.join('')}</g>`;
}

/** As large as the room for words allows. */
function wordsOn({words: {at, room}}: CutPiece, {words, page}: CutStyle): string {
  const longest = Math.max(...words.map((line) => textWidth(line, 1)));
  const diagonal = Math.hypot(longest + 1, 1.25 * words.length + 0.4);
  const size = Math.max(leastWords, Math.min(greatestWords, (20 * room) / diagonal));
  return plate(page(at), words, size);
}

export function drawCutPiece(piece: CutPiece, style: CutStyle): string {
  const {page, cloth, id} = style;
  const cut = closed(piece.cut, page);
  const frames = piece.matches.map((p) => repeatAround(p, piece, style)).join('');
  return [
    `<g id="${id}" aria-label="${escaped(piece.label)}" fill="none" stroke-linejoin="round" stroke-linecap="round">`,
    `<clipPath id="${id}-inside"><path d="${closed(piece.sewn, page)}" clip-rule="evenodd"/></clipPath>`,
    `<path d="${cut}" fill="${cloth === undefined ? '#fff' : `url(#${cloth})`}" fill-rule="evenodd" stroke="${ink}" stroke-width="0.5"/>`,
    frames && `<g clip-path="url(#${id}-inside)" opacity="0.4">${drawn(frames, 0.2, '2 2')}</g>`,
    drawn(closed(piece.sewn, page), 0.35, '4 2'),
    notches(piece, style),
    grainArrow([page(piece.grain[0]), page(piece.grain[1])]),
    ...piece.matches.map((p, k) => matchMark(p, k + 1, style)),
    ...piece.letters.map(({letter, at}) => plate(page(at), [letter], letterSize)),
    wordsOn(piece, style),
    '</g>',
  ].join('');
}
