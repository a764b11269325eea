/** Files of a lay plan. */
import {drawPlanSvg} from '../marker/draw/draw-plan-svg.js';
import {planDxf} from '../marker/draw/plan-dxf.js';
import {planPdf, type PlanPdf} from '../marker/draw/plan-pdf.js';
import type {KnownPieces} from '../marker/draw/plan-pieces.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {Units} from '../model/units.js';
import type {CellPixels} from '../paper/cloth-cell.js';
import type {PrintWithTile} from '../picture/cloth.js';

export interface LayPlanSettings extends KnownPieces {
  /** The print of the cloth; `tile` is the picture of its cell, as SVG text or `data:` URL. */
  readonly print: PrintWithTile;
  readonly units?: Units;
  /** What stands above the plan. */
  readonly title?: string;
  /** Without it the same plan gives the same bytes. */
  readonly date?: Date;
  /** The cell as PNG or JPEG, asked for where `tile` is none and no simple SVG. */
  readonly pixels?: CellPixels;
}

export interface LayPlanFiles {
  /** A tenth of its true size. */
  readonly svg: () => string;
  /** The same on paper, with tables; or as wide as the cloth, for a plotter. @throws {FileError} where the print's picture can be drawn by nobody */
  readonly pdf: (scale?: 10 | 1) => Promise<PlanPdf>;
  /** For programs and machines that cut. */
  readonly dxf: () => string;
}

export function layPlanFilesOf(plan: LayPlan, settings: LayPlanSettings): LayPlanFiles {
  const {print, units = 'cm', title, date, pixels, names, results} = settings;
  const known = {...(names && {names}), ...(results && {results})};
  const options = {...known, print, words: {units}, ...(title !== undefined && {title})};
  return {
    svg: () => drawPlanSvg(plan, options),
    pdf: (scale = 10) =>
      planPdf(plan, {...options, scale, ...(date && {date}), ...(pixels && {pixels})}),
    dxf: () => planDxf(plan, known),
  };
}
