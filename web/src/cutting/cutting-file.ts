/** All pieces of a garment at true scale on one sheet, to cut along: SVG whose unit is the millimetre. */
import type {GarmentTitle, PanelMarks} from '../model/garment-marks.js';
import type {Point} from '../model/geometry.js';
import {readable} from '../model/piece-names.js';
import {repeatOf} from '../model/repeat.js';
import type {SolveResult} from '../model/result.js';
import {ontoSheet} from '../model/sheet-place.js';
import {formatLength, type Units} from '../model/units.js';
import {clothTile, clothUnder, type PrintWithTile} from '../picture/cloth.js';
import {layOut, type Layout} from '../layout/layout.js';
import {markAcross} from '../picture/mark.js';
import {placementsIn, type Placements} from '../layout/on-body.js';
import {seamLetters} from '../scene/seam-letters.js';
import {escaped, short, text} from '../picture/svg.js';
import {cutPiece, type CutPiece} from './cut-piece.js';
import {drawCutPiece} from './draw-cut-piece.js';

interface CuttingMarks extends GarmentTitle {
  readonly panels: ReadonlyMap<string, PanelMarks>;
}

export interface CuttingOptions {
  readonly allowanceCm: number;
  readonly units: Units;
  /** How numbers are written. Default 'en'. */
  readonly locale?: string;
  /** Words across the whole sheet, such as `notAsSold`. */
  readonly mark?: string;
  /** Pieces, by name, that are cut from unprinted cloth. */
  readonly plain?: readonly string[];
}

/** [mm] */
const unit = 10;
const margin = 15;
const foot = 82;
/** From a sewn line to the middle of its letter. [cm] */
const letterRoom = 0.6;
/** Between cut lines. [cm] */
const gap = 1.5;
/** Width to height of a sheet. */
const aspect = 1.4;
const ink = '#1d1f23';

/** What a piece is the mirror image of, by number. */
const twins = ({symmetries}: SolveResult): ReadonlyMap<number, number> =>
  new Map(
    symmetries.flatMap((symmetry) => {
      if (symmetry.kind !== 'pair') return [];
      const [first, second] = symmetry.pieces;
      return [
        [first, second],
        [second, first],
      ] as const;
    }),
  );

/** Pieces keep apart by their cut lines. */
function laidOut(result: SolveResult, cuts: readonly CutPiece[], placements: Placements): Layout {
  const pieces = result.pieces.map((piece, k) => {
    const rest = cuts[k]?.cut.flat() ?? [];
    return {...piece, rest, outline: rest.map((_, n) => n)};
  });
  const spacing = {gap, below: () => gap, least: () => 0};
  return layOut({...result, pieces}, aspect, spacing, placements, {isPacked: true});
}

/** Measured with a ruler, they show whether the paper has the right size. */
function testSquares([x, y]: Point): string {
  const square = (left: number, side: number, label: string): string =>
    `<rect x="${short(left)}" y="${short(y)}" width="${side}" height="${side}" fill="none" stroke="${ink}" stroke-width="0.3"/>${text([left + side / 2, y + side / 2 + 1.5], label, {size: 5, anchor: 'middle', fill: ink})}`;
  return square(x, 50, '5 cm') + square(x + 60, 50.8, '2 in');
}

/** What to buy or print the cloth by. */
function printFact(print: PrintWithTile, length: (cm: number) => string): string {
  const {width, height} = repeatOf(print).size;
  return `${print.title ?? `Print ${print.group}`}, repeat ${length(width)} × ${length(height)}`;
}

/** A file for a plotter, a print shop or a projector. `print.tile` is the picture of its cell, as SVG text or URL. */
export function cuttingFile(
  result: SolveResult,
  print: PrintWithTile,
  {title, size, panels}: CuttingMarks,
  {allowanceCm, units, locale = 'en', mark, plain = []}: CuttingOptions,
): string {
  const letters = seamLetters(result, letterRoom);
  const cuts = result.pieces.map((piece, k) =>
    cutPiece(piece, print, panels.get(piece.name) ?? {label: readable(piece.name)}, {
      ...{allowanceCm, isPlain: plain.includes(piece.name), letters: letters[k] ?? []},
    }),
  );
  const layout = laidOut(result, cuts, placementsIn(panels));
  const twinOf = twins(result);
  const width = Math.max(layout.width * unit, 240) + 2 * margin;
  const height = layout.height * unit + 2 * margin + foot;
  const page =
    (k: number) =>
    (point: Point): Point => {
      const [x, y] = ontoSheet(layout.places[k] ?? {offset: [0, 0]}, point);
      return [margin + unit * x, margin + unit * (layout.height - y)];
    };
  const heading = [title, size].filter((word) => word !== undefined).join(', ');
  const facts = [
    printFact(print, (cm) => formatLength(cm, units, locale)),
    allowanceCm > 0
      ? `Solid: cut. Dashed: sew, ${formatLength(allowanceCm, units, locale)} inside.`
      : 'Without allowance: sew along the solid line.',
    'Edges with the same letter are sewn together.',
    ...(cuts.some(({matches}) => matches.length > 0)
      ? [
          'Numbered crosses of a piece lie on the same point of the print;',
          'the faint frame around each shows one repeat.',
        ]
      : []),
    'Print at 100 %; measure the squares.',
  ];
  const below = height - margin - 58;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${short(width)}mm" height="${short(height)}mm" viewBox="0 0 ${short(width)} ${short(height)}" font-family="'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif">`,
    `<title>${escaped(heading)}</title>`,
    `<defs>${clothTile('cloth', print, unit)}${cuts.map(({alignment}, k) => clothUnder(`cloth-${k}`, 'cloth', print, alignment, page(k))).join('')}</defs>`,
    '<rect width="100%" height="100%" fill="#fff"/>',
    ...cuts.map((piece, k) => {
      const isPlain = plain.includes(piece.name);
      const twin = cuts[twinOf.get(k) ?? -1];
      return drawCutPiece(piece, {
        ...{id: `piece-${k}`, print, allowanceCm, page: page(k)},
        cloth: isPlain ? undefined : `cloth-${k}`,
        words: [
          piece.label,
          isPlain ? 'Cut 1 of plain cloth' : 'Cut 1',
          ...(twin ? [`Mirror image of ${twin.label}`] : []),
          ...(heading === '' ? [] : [heading]),
        ],
      });
    }),
    testSquares([margin, below]),
    text([margin + 122, below + 8], heading, {size: 8, weight: 600, fill: ink}),
    ...facts.map((line, k) =>
      text([margin + 122, below + 18 + 7 * k], line, {size: 4.5, fill: ink}),
    ),
    mark === undefined ? '' : markAcross(mark, width, height),
    '</svg>\n',
  ].join('\n');
}
