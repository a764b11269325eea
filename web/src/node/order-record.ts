/** The record of an order: figures and a drawing for the cart and the workshop, as JSON. */
import {garmentTitle, panelMarks} from '../model/garment/panel-marks.js';
import type {FiledGarment, FiledPrint} from '../model/documents/filed-design.js';
import {decidedOf} from '../model/design/design.js';
import {seamCount} from '../model/result/seam-groups.js';
import {thumbnail} from '../picture/thumbnail.js';
import {seamGroupsOf} from '../scene/group-states.js';
import type {SolverService} from '../solver/service.js';
import type {Order} from './order.js';

export interface OrderRecordSettings {
  /** Image of the print's cell, as SVG text or `data:` URL, for the thumbnail. */
  readonly tile?: string;
}

/** A record as `seamwise-order/1`. */
export interface OrderRecord {
  readonly format: 'seamwise-order/1';
  /** Title of the garment. */
  readonly title: string;
  /** Files of the order, with their size and colourway. */
  readonly garment: FiledGarment;
  readonly print: FiledPrint;
  /** Version of the package that found the sold result, and the SHA-256 of that. */
  readonly solver: string;
  readonly result: string;
  /** True if the result equals the sold one, byte for byte. */
  readonly reproduced: boolean;
  /** Greatest displacement of the print from the sold result; null if it cannot be compared. [cm] */
  readonly differenceCm: number | null;
  readonly pieces: number;
  /** Number of visible seams, and how many of them match. */
  readonly visibleSeams: {readonly matched: number; readonly of: number};
  /** Fabric of the layout; null if the order was not laid out. Lengths in cm. */
  readonly cloth: {
    readonly widthCm: number;
    readonly lengthCm: number;
    /** True if no layout is shorter with the print starting there. */
    readonly proven: boolean;
  } | null;
  /** The pieces in their print, as SVG text. */
  readonly thumbnail: string;
}

/** @throws {SolverError} if the garment's file is invalid */
export async function recordOf(
  solver: Pick<SolverService, 'garment'>,
  {design, garment: text, print, result, reproduced, differenceCm, plan}: Order,
  {tile}: OrderRecordSettings,
): Promise<OrderRecord> {
  const {url} = design.garment;
  const garment = await solver.garment(text, {name: url});
  const {title = url} = garmentTitle(garment, url.split('/').at(-1));
  const {matched, counted} = seamCount(seamGroupsOf(result), design.options.weights);
  const {plain} = design.options;
  return {
    format: 'seamwise-order/1',
    ...{title, garment: design.garment, print: design.print},
    ...{solver: design.solver, result: design.result, reproduced, differenceCm},
    pieces: result.pieces.length,
    visibleSeams: {matched, of: counted},
    cloth: plan ? {widthCm: plan.widthCm, lengthCm: plan.lengthCm, proven: plan.proven} : null,
    thumbnail: thumbnail(
      result,
      {...print, ...(tile !== undefined && {tile})},
      {
        title,
        panels: panelMarks(garment, decidedOf(design)),
        ...(plain && {plain}),
      },
    ),
  };
}
