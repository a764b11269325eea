/**
 * Draws a result as one image: the pattern on the print before and after, with figures and a
 * legend.
 */
import {markAcross} from './watermark.js';
import {norm, type Alignment, type Point} from '../model/geometry/vectors.js';
import {pairLetter, seamLetter} from '../model/garment/letters.js';
import {pieceNames} from '../model/garment/piece-names.js';
import type {Print} from '../model/print/repeating-print.js';
import type {Pattern, SolveResult} from '../model/result/result.js';
import {imageCell, latticeType} from '../model/print/wallpaper.js';
import {fabricTile, type PrintWithTile} from './fabric.js';
import {mismatchSteps, stepLines} from '../scene/colours.js';
import {
  drawPieces,
  laidOut,
  margin,
  nameSize,
  seamLetterAt,
  strokeOf,
  width,
  type Scene,
} from './draw-pieces.js';
import {seamCount, type SeamCount} from '../model/result/seam-groups.js';
import {countAt, seamGroupsOf} from '../scene/group-states.js';
import {finalMismatch, mismatchOf, type PatternMismatch} from '../scene/mismatch.js';
import {escaped, short, text} from '../files/svg/written.js';
import type {Placements} from '../layout/on-body.js';

/**
 * Draws one stage of a solve for debugging: meshes, cells of the print on the pieces, and seam
 * letters.
 */
export interface Stage {
  readonly title: string;
  readonly pattern: Pattern;
  readonly outline: Scene['outline'];
  readonly alignments: readonly Alignment[];
}

const top = 76;

/** The stage as SVG text. Pieces have the names of their panel keys, as in files and messages. */
export function drawStage({title, pattern, outline, alignments}: Stage): string {
  const names = pattern.pieces.map(({name}) => name);
  const {layout, scale} = laidOut(pattern, names, undefined);
  const height = top + layout.height * scale + margin;
  const mismatch = mismatchOf(pattern, outline, alignments);
  const {group, w1, w2} = pattern.print;
  const print = {group, w1, w2};
  const scene: Scene = {
    ...{result: pattern, print, outline, alignments, mismatch, layout, names, scale},
    ...{id: 'stage', fabric: 'stage-fabric', isBare: false, hasMesh: true},
    corner: [(width - layout.width * scale) / 2, top],
  };
  const note = `${group}; mean mismatch ${(10 * mismatch.mean).toFixed(2)} mm, fit ${mismatch.total.toFixed(3)} cm²`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${short(height)}" viewBox="0 0 ${width} ${short(height)}" font-family="sans-serif">`,
    `<title>${escaped(title)}</title>`,
    `<defs>${fabricTile('stage-fabric', print, scale)}</defs>`,
    '<rect width="100%" height="100%" fill="#fff"/>',
    text([margin, 34], title, {size: 20, weight: 600}),
    text([margin, 56], note, {size: 13}),
    drawPieces(scene, nameSize),
    '</svg>\n',
  ].join('\n');
}

export interface PictureOptions {
  /** Title. Default: the print's group and repeat. */
  readonly title?: string;
  /** Watermark across the whole image, such as `notAsSold`. */
  readonly mark?: string;
  /** Displayed names of the pieces. Default: their panel keys as words. */
  readonly names?: readonly string[];
  /** Placements of the pieces on the body by panel key, for the layout of the page. */
  readonly placements?: Placements;
  /** Draws only the pieces in their print, without lines and names. */
  readonly clothOnly?: boolean;
  /** Prefix of all ids, for pages with several images. */
  readonly id?: string;
}

const ink = '#26282c';
const soft = '#6a6d73';

const millimetres = (cm: number): string => `${(cm * 10).toFixed(1)} mm`;
/** The sides of the cell as people describe it: the centred cell of a rhombic lattice. */
function repeatOf(print: Print): string {
  const cell =
    latticeType(print.group) === 'rhombic'
      ? imageCell({...print, cell: 'rectangular'})
      : [print.w1, print.w2];
  return `${cell.map((side) => Number(norm(side).toFixed(1))).join(' × ')} cm`;
}

function figure(x: number, y: number, label: string, value: string): string {
  return (
    text([x, y], label, {size: 13, fill: soft}) +
    text([x, y + 30], value, {size: 21, fill: ink, weight: 500})
  );
}

/** A rule with the section's heading and figures. */
function heading(y: number, title: string, note: string, count: SeamCount): string {
  return [
    `<path d="M${margin} ${y}H${width - margin}" stroke="#d5d3cd"/>`,
    text([margin, y + 26], title, {size: 16, weight: 600, fill: ink}),
    text([margin + title.length * 9 + 14, y + 26], note, {size: 13, fill: soft}),
    text([width - margin, y + 26], `${count.matched} of ${count.counted} visible seams match`, {
      size: 13,
      anchor: 'end',
      fill: soft,
    }),
  ].join('');
}

/** The legend of the lines, and a scale bar of 10 cm. */
function legend(y: number, scale: number, result: SolveResult, mismatch: PatternMismatch): string {
  const length = 52;
  const parts: string[] = [text([margin, y], 'Print mismatch along seams', {size: 13, fill: soft})];
  stepLines.forEach((line, k) => {
    const from = margin + k * (length + 12);
    const bound = mismatchSteps[k];
    const label = bound === undefined ? 'more' : `to ${(10 * bound).toFixed(0)} mm`;
    parts.push(
      `<path d="M${from} ${y + 16}h${length}" fill="none" stroke-linecap="round" ${strokeOf(line)}/>`,
      text([from + length / 2, y + 38], label, {size: 12, fill: soft, anchor: 'middle'}),
    );
  });

  let x = margin + stepLines.length * (length + 12) + 40;
  const entry = (drawing: string, label: string): void => {
    parts.push(
      `<g transform="translate(${x} ${y + 16})">${drawing}</g>`,
      text([x + 44, y + 20], label, {size: 13, fill: soft}),
    );
    x += 44 + label.length * 7 + 24;
  };
  if (result.symmetries.some(({kind}) => kind === 'piece'))
    entry(
      `<path d="M0 0H34" stroke="#2b2d31" stroke-width="1.2" stroke-dasharray="7 4"/>`,
      'symmetry axis',
    );
  if (result.symmetries.some(({kind}) => kind === 'pair')) {
    entry(
      `<circle cx="17" cy="0" r="11" fill="#fff" stroke="#2b2d31"/>${text([17, 5], pairLetter([0, 1]), {size: 13, weight: 600, anchor: 'middle'})}`,
      'mirrored pair',
    );
  }
  if (result.seams.length > 0) entry(seamLetterAt([17, 0], seamLetter(0)), 'sewn together');
  if (mismatch.seams.some(({counts}) => !counts))
    entry(
      `<path d="M0 0H34" stroke="#8d9096" stroke-width="2" stroke-linecap="round" stroke-dasharray="1 5"/>`,
      'not counted',
    );

  const bar = 10 * scale;
  const right = width - margin;
  parts.push(
    `<path d="M${short(right - bar)} ${y + 11}v10m0-5H${right}m0-5v10" fill="none" stroke="${ink}" stroke-width="1.2"/>`,
    text([right - bar / 2, y + 38], '10 cm', {size: 12, fill: soft, anchor: 'middle'}),
  );
  return parts.join('');
}

/**
 * The whole image as SVG text. `print.tile` is drawn at true scale, in its alignment on every
 * piece.
 */
export function drawResult(
  result: SolveResult,
  print: PrintWithTile,
  options: PictureOptions = {},
): string {
  const id = options.id ?? 'seamwise';
  const keys = result.pieces.map(({name}) => name);
  const called = pieceNames(new Map(keys.map((key) => [key, undefined])));
  const names = options.names ?? keys.map((key) => called.get(key) ?? key);
  const {layout, scale} = laidOut(result, names, options.placements);
  const left = (width - layout.width * scale) / 2;
  const tall = layout.height * scale;

  // files of earlier versions lack the drafted alignments; their pieces were upright
  const before = result.drafted ?? result.pieces.map(() => ({angle: 0, translation: [0, 0]}));
  const after = result.pieces.map(({alignment}) => alignment);
  const mismatches = {before: mismatchOf(result, 'rest', before), after: finalMismatch(result)};
  const groups = seamGroupsOf(result);
  const counts = {
    before: countAt(groups, undefined, mismatches.before.seams),
    after: seamCount(groups, undefined),
  };

  const title = options.title ?? `Print ${print.group}`;
  const top = {before: 140, after: 140 + 52 + tall + 20};
  const foot = top.after + 52 + tall + 24;
  const height = foot + 72;
  const scene = (name: 'before' | 'after', corner: Point): Scene => ({
    result,
    print,
    layout,
    corner,
    scale,
    fabric: `${id}-fabric`,
    names,
    isBare: options.clothOnly ?? false,
    id: `${id}-${name}`,
    mismatch: mismatches[name],
    outline: name === 'before' ? 'rest' : 'shape',
    alignments: name === 'before' ? before : after,
  });
  const {matched, counted} = counts.after;
  const summary = `${matched} of ${counted} visible seams match, ${counts.before.matched} before.`;

  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${short(height)}" viewBox="0 0 ${width} ${short(height)}" role="img" font-family="'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif" style="font-variant-numeric: tabular-nums">`,
    `<title>${escaped(title)}</title><desc>${escaped(summary)}</desc>`,
    `<defs>${fabricTile(`${id}-fabric`, print, scale)}</defs>`,
    `<rect width="100%" height="100%" fill="#fbfaf8"/>`,
    text([margin, 66], title, {size: 28, weight: 600, fill: ink}),
    text(
      [margin, 94],
      [
        ...(print.title === undefined ? [] : [print.title]),
        print.group,
        `repeat ${repeatOf(print)}`,
      ].join(', '),
      {size: 15, fill: soft},
    ),
    figure(
      width - margin - 340,
      64,
      'Visible seams that match',
      `${counts.before.matched} → ${matched} of ${counted}`,
    ),
    figure(width - margin - 110, 64, 'Largest change', millimetres(result.metrics.maxMovedCm)),
    heading(top.before, 'Before', 'cut on grain, as it comes', counts.before),
    drawPieces(scene('before', [left, top.before + 52]), nameSize),
    heading(top.after, 'After', 'aligned and reshaped', counts.after),
    drawPieces(scene('after', [left, top.after + 52]), nameSize),
    options.clothOnly ? '' : legend(foot + 12, scale, result, mismatches.after),
    options.mark === undefined ? '' : markAcross(options.mark, width, height),
    '</svg>\n',
  ].join('\n');
}
