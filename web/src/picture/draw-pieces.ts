/** Draws the pieces of a result, filled with their print. */
import type {Alignment, MirrorMap, Point} from '../model/geometry/vectors.js';
import {pairLetter} from '../model/garment/letters.js';
import {boxOf} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';
import type {Pattern, ResultPiece, SeamSide} from '../model/result/result.js';
import {ontoSheet} from '../model/geometry/sheet-place.js';
import {fabricUnder} from './fabric.js';
import {mismatchLine} from '../scene/colours.js';
import type {PatternMismatch} from '../scene/mismatch.js';
import {layOutNamed, type Layout} from '../layout/layout.js';
import {axisAlong, innermost, mirrorImage, pick} from '../scene/marks.js';
import {seamLetters} from '../scene/seam-letters.js';
import {escaped, polyline, short, text} from '../files/svg/written.js';
import {nameLines, textWidth} from '../layout/name-lines.js';
import type {Placements} from '../layout/on-body.js';

/** One of the two displayed states, and its position on the page. */
export interface Scene {
  readonly result: Pattern;
  readonly print: Print;
  readonly outline: 'rest' | 'shape';
  readonly alignments: readonly Alignment[];
  readonly mismatch: PatternMismatch;
  readonly layout: Layout;
  /** Upper left corner. [px] */
  readonly corner: Point;
  /** [px per cm] */
  readonly scale: number;
  /** Prefix of all ids of this scene. `fabric` is the id of the tile's pattern. */
  readonly id: string;
  readonly fabric: string;
  /** Displayed names of the pieces. */
  readonly names: readonly string[];
  /** Omits seams, axes and names. */
  readonly isBare: boolean;
  /** Draws the triangles of the pieces. */
  readonly hasMesh?: boolean;
  /** Names of pieces of plain fabric. */
  readonly plain?: readonly string[];
}

const outlineColour = '#4a4d52';
const quiet = '#8d9096';
const plainFabric = '#ece8dd';

/** The map from piece coordinates to the page. */
function toPage(scene: Scene, piece: number): (p: Point) => Point {
  const {corner, scale, layout} = scene;
  const place = layout.places[piece] ?? {offset: [0, 0]};
  return (point) => {
    const [x, y] = ontoSheet(place, point);
    return [corner[0] + scale * x, corner[1] + scale * (layout.height - y)];
  };
}

function body(scene: Scene, piece: ResultPiece, index: number): string {
  const page = toPage(scene, index);
  const path = [piece.outline, ...piece.holes]
    .map((loop) => `${polyline(pick(piece[scene.outline], loop).map(page))}Z`)
    .join('');
  const fill = scene.plain?.includes(piece.name) ? plainFabric : `url(#${scene.id}-${index})`;
  return `<path d="${path}" fill="${fill}" fill-rule="evenodd" stroke="${outlineColour}" stroke-width="1" stroke-linejoin="round"/>`;
}

function mesh(scene: Scene, piece: ResultPiece, index: number): string {
  const page = toPage(scene, index);
  const points = piece[scene.outline];
  const triangles = piece.triangles.map(
    (corners) => `${polyline(pick(points, corners).map(page))}Z`,
  );
  return `<path class="mesh" d="${triangles.join('')}" fill="none" stroke="${quiet}" stroke-width="0.4" stroke-linejoin="round"/>`;
}

/** SVG attributes of a line. */
export function strokeOf(line = mismatchLine(0)): string {
  const {colour, width, dash} = line;
  const gaps = dash ? ` stroke-dasharray="${dash.map(short).join(' ')}"` : '';
  return `stroke="${colour}" stroke-width="${short(width)}"${gaps}`;
}

/** One side of a seam: strokes of equal mismatch over a light casing. */
function seamSide(scene: Scene, side: SeamSide, mismatch: readonly number[]): string {
  const line = pick(scene.result.pieces[side.piece]?.[scene.outline] ?? [], side.vertices).map(
    toPage(scene, side.piece),
  );
  // one of a few shared styles, so that a seam is a few long strokes
  const drawn = mismatch.map((one) => mismatchLine(one));
  const strokes: string[] = [];
  for (let from = 0; from < drawn.length;) {
    let to = from + 1;
    while (to < drawn.length && drawn[to] === drawn[from]) to++;
    strokes.push(`<path d="${polyline(line.slice(from, to + 1))}" ${strokeOf(drawn[from])}/>`);
    from = to;
  }
  return `<path d="${polyline(line)}" stroke="#fff" stroke-opacity="0.9" stroke-width="6"/>${strokes.join('')}`;
}

function seams(scene: Scene): string {
  const sides = scene.result.seams.flatMap((seam, k) => {
    const {mismatch = [], counts = false} = scene.mismatch.seams[k] ?? {};
    if (counts) return [seam.a, seam.b].map((side) => seamSide(scene, side, mismatch));
    return [seam.a, seam.b].map((side) => {
      const line = pick(scene.result.pieces[side.piece]?.[scene.outline] ?? [], side.vertices).map(
        toPage(scene, side.piece),
      );
      return `<path d="${polyline(line)}" stroke="#fff" stroke-width="5"/><path d="${polyline(line)}" stroke="${quiet}" stroke-width="2" stroke-dasharray="1 5"/>`;
    });
  });
  return `<g fill="none" stroke-linecap="round" stroke-linejoin="round">${sides.join('')}</g>`;
}

/** The mirror axis of a symmetric piece, slightly longer than the piece. */
function axis(scene: Scene, piece: number, map: MirrorMap): string {
  const {outline = [], [scene.outline]: points = []} = scene.result.pieces[piece] ?? {};
  const line = polyline(
    axisAlong(map, pick(points, outline), 10 / scene.scale).map(toPage(scene, piece)),
  );
  return `<path d="${line}" fill="none" stroke="#fff" stroke-opacity="0.6" stroke-width="3"/><path d="${line}" fill="none" stroke="#2b2d31" stroke-width="1.2" stroke-dasharray="7 4"/>`;
}

function letter([x, y]: Point, content: string): string {
  return `<circle cx="${short(x)}" cy="${short(y)}" r="12" fill="#fff" stroke="#2b2d31" stroke-width="1"/>${text([x, y + 5], content, {size: 14, weight: 600, anchor: 'middle', fill: '#2b2d31'})}`;
}

function symmetries(scene: Scene): string {
  return scene.result.symmetries
    .map((symmetry) => {
      if (symmetry.kind === 'piece') return axis(scene, symmetry.piece, symmetry.map);
      const name = pairLetter(symmetry.pieces);
      const [first, second] = symmetry.pieces;
      const {outline = [], rest = []} = scene.result.pieces[first] ?? {};
      const here = innermost(pick(rest, outline)).at;
      const there = mirrorImage(symmetry.map, here); // the mirrored point of the other piece
      return letter(toPage(scene, first)(here), name) + letter(toPage(scene, second)(there), name);
    })
    .join('');
}

/** Distance from a seam to the centre of its letter. [px] */
const letterRoom = 10;

function letters(scene: Scene): string {
  return seamLetters(scene.result, letterRoom / scene.scale, scene.outline)
    .flatMap((some, piece) =>
      some.map(({letter: one, at}) => seamLetterAt(toPage(scene, piece)(at), one)),
    )
    .join('');
}

/** A seam letter on a light plate. */
export function seamLetterAt([x, y]: Point, one: string): string {
  const wide = textWidth(one, 10) + 5;
  return `<rect x="${short(x - wide / 2)}" y="${short(y - 6.5)}" width="${short(wide)}" height="13" rx="3" fill="#fff" fill-opacity="0.85"/>${text([x, y + 3.6], one, {size: 10, weight: 600, anchor: 'middle', fill: '#2b2d31'})}`;
}

/** Line spacing of a name, relative to its font size. */
const nameLeading = 1.2;
/**
 * Available width of a name below a piece of this width, including part of the gaps beside it. [px]
 */
const nameRoom = (pieceWidth: number): number => pieceWidth + 20;

function names(scene: Scene, size: number): string {
  return scene.result.pieces
    .map(({outline, rest}, k) => {
      const {low, high} = boxOf(pick(rest, outline).map(toPage(scene, k)));
      const foot = high[1] + 12 + size; // y runs down
      return nameLines(scene.names[k] ?? '', nameRoom(high[0] - low[0]), size)
        .map((line, n) =>
          text([(low[0] + high[0]) / 2, foot + n * nameLeading * size], line, {
            size,
            anchor: 'middle',
            fill: '#5d6066',
          }),
        )
        .join('');
    })
    .join('');
}

/** All pieces of a scene: print, outline, seams by mismatch, symmetries and names. */
export function drawPieces(scene: Scene, nameSize: number): string {
  const {pieces} = scene.result;
  const fabrics = pieces.map((_, k) => {
    const alignment = scene.alignments[k] ?? {angle: 0, translation: [0, 0]};
    return fabricUnder(`${scene.id}-${k}`, scene.fabric, scene.print, alignment, toPage(scene, k));
  });
  return [
    `<defs>${fabrics.join('')}</defs>`,
    ...pieces.map(
      (piece, k) =>
        `<g aria-label="${escaped(scene.names[k] ?? '')}">${body(scene, piece, k)}${scene.hasMesh ? mesh(scene, piece, k) : ''}</g>`,
    ),
    ...(scene.isBare
      ? []
      : [seams(scene), letters(scene), symmetries(scene), names(scene, nameSize)]),
  ].join('\n');
}

/** The page of drawn images. [px] */
export const width = 1200;
export const margin = 56;
export const nameSize = 13;

/** A layout of pieces with space for their names. Patterns of many pieces get more height. */
export function laidOut(
  pattern: Pattern,
  names: readonly string[],
  placements: Placements | undefined,
): ReturnType<typeof layOutNamed> {
  const room = width - 2 * margin;
  const widest = (name: string): number =>
    Math.max(...nameLines(name, 0, nameSize).map((word) => textWidth(word, nameSize)));
  const page = {
    width: room,
    height: room / (pattern.pieces.length > 16 ? 1.5 : 2.3),
    grows: true,
    greatestScale: 14,
    gap: 34,
    nameHeight: (piece: number, pieceWidth: number) =>
      28 +
      nameLines(names[piece] ?? '', nameRoom(pieceWidth), nameSize).length * nameLeading * nameSize,
    nameWidth: (piece: number) => widest(names[piece] ?? ''),
  };
  return layOutNamed(pattern, page, placements);
}
