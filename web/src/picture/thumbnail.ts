/** Draws the shaped pieces of a result in their print, small and without words. */
import {pieceNames} from '../model/garment/piece-names.js';
import type {SolveResult} from '../model/result/result.js';
import {finalMismatch} from '../scene/mismatch.js';
import {placementsIn} from '../layout/on-body.js';
import {escaped, short} from '../files/svg/written.js';
import {fabricTile, type PrintWithTile} from './fabric.js';
import {drawPieces, laidOut, nameSize, type Scene} from './draw-pieces.js';

/** Width of the drawing, unless the page scales it. [px] */
const shownWidth = 480;
/** Space around the pieces. [px of the drawing] */
const margin = 12;

interface ThumbnailOptions {
  /** Title for readers that do not see the drawing. */
  readonly title: string;
  /** Panels with their placements on the body, for the layout of the page. */
  readonly panels: Parameters<typeof placementsIn>[0];
  /** Names of pieces that are cut from plain fabric. */
  readonly plain?: readonly string[];
}

/**
 * The drawing as SVG text. `print.tile` is drawn at the scale of the pieces, in its alignment on
 * each of them; without it the cells of the print are outlined.
 */
export function thumbnail(
  result: SolveResult,
  print: PrintWithTile,
  {title, panels, plain = []}: ThumbnailOptions,
): string {
  const keys = result.pieces.map(({name}) => name);
  const called = pieceNames(new Map(keys.map((key) => [key, undefined])));
  const names = keys.map((key) => called.get(key) ?? key);
  const {layout, scale} = laidOut(result, names, placementsIn(panels));
  const [wide, high] = [layout.width, layout.height].map((side) => side * scale + 2 * margin);
  const scene: Scene = {
    ...{result, print, layout, scale, names, plain},
    ...{corner: [margin, margin], id: 'piece', fabric: 'fabric', isBare: true, outline: 'shape'},
    alignments: result.pieces.map(({alignment}) => alignment),
    mismatch: finalMismatch(result),
  };
  const size = `width="${shownWidth}" height="${short((shownWidth * (high ?? 0)) / (wide ?? 1))}"`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" ${size} viewBox="0 0 ${short(wide ?? 0)} ${short(high ?? 0)}" role="img">`,
    `<title>${escaped(title)}</title>`,
    `<defs>${fabricTile('fabric', print, scale)}</defs>`,
    drawPieces(scene, nameSize),
    '</svg>\n',
  ].join('\n');
}
