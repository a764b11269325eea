/** Files of a layout. */
import {checkArguments, either} from '../model/base/arguments.js';
import {number} from '../model/base/read.js';
import {layPlanDxf} from './setting-checks.js';
import type {DxfFormat} from '../model/base/dxf-format.js';
import {drawPlanSvg} from '../marker/draw/draw-plan-svg.js';
import {planDxf} from '../marker/draw/plan-dxf.js';
import {planHpgl} from '../marker/draw/plan-hpgl.js';
import {planPdf, type PlanPdf} from '../marker/draw/plan-pdf.js';
import type {KnownPieces} from '../marker/draw/plan-pieces.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {Units} from '../model/base/length-text.js';
import type {CellPixels} from '../paper/fabric-cell.js';
import type {PrintWithTile} from '../picture/fabric.js';
import {lettersFrom} from './letters.js';

export interface LayPlanSettings extends KnownPieces {
  /** The print of the fabric. `tile` is the image of its cell, as SVG text or `data:` URL. */
  readonly print: PrintWithTile;
  readonly units?: Units;
  /** Title above the layout. */
  readonly title?: string;
  /** Creation date. Without it, the same layout gives the same bytes. */
  readonly date?: Date;
  /** Returns the cell as PNG or JPEG, for a `tile` that is neither and no simple SVG. */
  readonly pixels?: CellPixels;
}

export interface LayPlanFiles {
  /** A drawing at a tenth of true size. */
  readonly svg: () => string;
  /**
   * A drawing on paper with tables, or on a page as wide as the fabric for a plotter.
   * @throws {FileError} if the print's image cannot be drawn
   */
  readonly pdf: (scale?: 10 | 1) => Promise<PlanPdf>;
  /** For CAD programs and cutters. */
  readonly dxf: (format?: DxfFormat) => string;
  /**
   * For plotters, in frames of 80 cm.
   * @throws {SolverError} `options` if the fabric is wider than 163.8 cm
   */
  readonly hpgl: () => string;
}

export function layPlanFilesOf(plan: LayPlan, settings: LayPlanSettings): LayPlanFiles {
  const {print, units = 'cm', title, date, pixels, names, results} = settings;
  const known = {...(names && {names}), ...(results && {results})};
  const options = {...known, print, words: {units}, ...(title !== undefined && {title})};
  return {
    svg: () => drawPlanSvg(plan, options),
    pdf: async (scale = 10) => {
      checkArguments('pdf', ['scale', scale, either('10 or 1', number(1, 1), number(10, 10))]);
      return planPdf(plan, {
        ...{...options, scale, letters: lettersFrom()},
        ...(date && {date}),
        ...(pixels && {pixels}),
      });
    },
    hpgl: () => planHpgl(plan, known),
    dxf: (format = {}) => {
      checkArguments('dxf', ['format', format, layPlanDxf]);
      return planDxf(plan, {...known, ...format});
    },
  };
}
