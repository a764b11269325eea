/** Draws a layout as SVG at a tenth of its true size. */
import {drawnMarks} from '../../cutting/draw-sheet-svg.js';
import {plus, type Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {fabricTile, fabricUnder, type PrintWithTile} from '../../picture/fabric.js';
import {drawingSpaces, escaped, linked, polyline, short} from '../../files/svg/written.js';
import {printOnFabric} from './plan-pieces.js';
import {leastWidth, planSheets, type PlanOptions, type PlanSheet} from './plan-sheets.js';
import {veils} from './veils.js';

const scale = 10;
/** [cm on paper] */
const margin = 1;
/** SVG units per cm of fabric, which make one unit a millimetre of fabric. */
const unit = 10;

type Page = (p: Point) => Point;

const closed = (loops: readonly (readonly Point[])[], page: Page): string =>
  loops.map((loop) => `${polyline(loop.map(page))}Z`).join('');

function drawnFabric(
  plan: LayPlan,
  print: PrintWithTile,
  {fabric}: PlanSheet,
  page: Page,
): {readonly defs: string; readonly drawn: string} {
  if (!fabric) return {defs: '', drawn: ''};
  const onSheet: Page = (p) => page(plus(fabric.at, p));
  const {printOrigin} = plan;
  const {around, outside, inside} = veils(plan, fabric, fabric.holes);
  const ground = (fill: string, loops: readonly (readonly Point[])[], opacity = 1): string =>
    `<path d="${closed(loops, onSheet)}" fill="${fill}" fill-opacity="${opacity}" fill-rule="evenodd"/>`;
  return {
    defs: printOrigin
      ? linked(
          fabricTile('tile', print, unit) +
            fabricUnder('fabric', 'tile', print, printOnFabric(printOrigin), onSheet),
        )
      : '',
    drawn: [
      ...(printOrigin ? [ground('url(#fabric)', [around])] : []),
      ground('#fff', outside.loops, outside.opacity),
      ground('#fff', inside.loops, inside.opacity),
      `<g fill="none" stroke-linejoin="round" stroke-linecap="round">${drawnMarks(fabric.marks, onSheet)}</g>`,
    ].join('\n'),
  };
}

/**
 * Draws a layout.
 * @param print its tile is drawn faintly below the pieces
 */
export function drawPlanSvg(
  plan: LayPlan,
  {print, ...options}: PlanOptions & {readonly print: PrintWithTile},
): string {
  const [sheet] = planSheets(plan, print, options, {
    ...{scale, isAsHighAsNeeded: true, isRoll: false, heightCm: Infinity},
    marginCm: margin * scale,
    widthCm: (leastWidth(plan, scale) + 2 * margin) * scale,
  });
  if (!sheet) throw new Error('a plan has a sheet');
  const [width, height] = [sheet.widthCm * unit, sheet.heightCm * unit];
  const page: Page = ([x, y]) => [unit * x, height - unit * y];
  const {defs, drawn} = drawnFabric(plan, print, sheet, page);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" ${drawingSpaces} width="${short(width / scale)}mm" height="${short(height / scale)}mm" viewBox="0 0 ${short(width)} ${short(height)}" font-family="'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif">`,
    `<title>${escaped(options.title ?? '')}</title>`,
    `<defs>${defs}</defs>`,
    '<rect width="100%" height="100%" fill="#fff"/>',
    drawn,
    `<g fill="none" stroke-linecap="round">${drawnMarks(sheet.marks, page)}</g>`,
    '</svg>\n',
  ].join('\n');
}
