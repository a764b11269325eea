/** Requests to the worker that makes cutting sheets. */
import type {CutSheet} from '../../cutting/cut-sheet.js';
import {norm, type Alignment, type Point} from '../../model/geometry/vectors.js';
import type {Box} from '../../model/geometry/polyline.js';
import type {Workbench} from '../../workbench/workbench.js';
import {asCut} from '../../model/print/as-cut.js';
import {imageCell} from '../../model/print/wallpaper.js';
import {dataUrlOf} from '../../image/data-url.js';
import {pixelsOfTile} from '../../image/embedded-tile.js';
import {cutMaterial, type CutMaterial} from '../../workbench/cutting/cut-material.js';
import {ask} from '../worker/ask.js';
import type {CutChoices} from './cut-choices.js';

interface CutJob extends CutMaterial {
  readonly choices: CutChoices;
}

export type Question = {readonly kind: 'plan' | 'file'} & CutJob;

/** Layout of the pieces, and of pages if there are any. Lengths in cm on the sheet, y up. */
export interface CutPlan {
  readonly widthCm: number;
  readonly heightCm: number;
  readonly pieces: readonly {
    /** The outline, then the holes. */
    readonly cut: readonly (readonly Point[])[];
    /** Place on the print, in the coordinates of the sheet; undefined for plain fabric. */
    readonly alignment?: Alignment;
  }[];
  /** The print as it is cut, if it has a picture. */
  readonly print?: PrintOnMap;
  readonly ownAllowances: CutSheet['ownAllowances'];
  readonly pages?: {
    readonly widthCm: number;
    readonly heightCm: number;
    readonly boxes: readonly (Box & {readonly name?: string})[];
    /** Number of further pages of a placing guide. */
    readonly guides: number;
  };
}

/** A print, small. */
export interface PrintOnMap {
  /** Sides of its picture on the fabric. [cm] */
  readonly cell: readonly [Point, Point];
  /** Picture of the cell as a `data:` URL. */
  readonly picture: string;
}

/** Request for the image of the print's cell in pixels. */
interface PixelRequest {
  readonly width: number;
  readonly height: number;
}

async function materialOf(
  workbench: Workbench,
  {allowanceCm, hemCm}: CutChoices,
): Promise<CutMaterial> {
  const material = await cutMaterial(workbench, {allowanceCm, hemCm});
  if (!material) throw new Error('There is no answer to cut.');
  return material;
}

function asked<Answer>(
  kind: Question['kind'],
  material: CutMaterial,
  choices: CutChoices,
  signal: AbortSignal,
): Promise<Answer> {
  const worker = new Worker(new URL('./cut.worker.js', import.meta.url), {type: 'module'});
  const {tile = ''} = material.print;
  return ask(worker, {kind, choices, ...material}, signal, (request) => {
    const {width, height} = request as PixelRequest;
    return pixelsOfTile(tile, width, height);
  });
}

/** Width of the picture of a print on the map. [px] */
const pictureWidth = 160;

/** Returns undefined if there is no picture that can be drawn; the map then shows the pieces alone. */
async function printOnMap({print}: CutMaterial): Promise<PrintOnMap | undefined> {
  if (print.tile === undefined) return undefined;
  const cell = imageCell(asCut(print));
  const [wide, high] = cell.map(norm) as [number, number];
  const png = await pixelsOfTile(print.tile, pictureWidth, (pictureWidth * high) / wide);
  return png && {cell, picture: await dataUrlOf(new Blob([png], {type: 'image/png'}))};
}

/** @throws {WorkerComplaint} a message of one sentence; the signal's reason when it fires */
export async function cutPlan(
  workbench: Workbench,
  choices: CutChoices,
  signal: AbortSignal,
): Promise<CutPlan> {
  const material = await materialOf(workbench, choices);
  const [plan, print] = await Promise.all([
    asked<CutPlan>('plan', material, choices, signal),
    printOnMap(material).catch(() => undefined),
  ]);
  return {...plan, ...(print && {print})};
}

/** @throws the errors of `cutPlan` */
export const cutFile = async (
  workbench: Workbench,
  choices: CutChoices,
  signal: AbortSignal,
): Promise<string | Uint8Array<ArrayBuffer>> =>
  asked('file', await materialOf(workbench, choices), choices, signal);
