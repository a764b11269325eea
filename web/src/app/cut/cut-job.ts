/** Requests to the worker that makes cutting sheets. */
import type {CutSheet} from '../../cutting/cut-sheet.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {Box} from '../../model/geometry/polyline.js';
import type {Workbench} from '../../workbench/workbench.js';
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
  readonly outlines: readonly (readonly Point[])[];
  readonly ownAllowances: CutSheet['ownAllowances'];
  readonly pages?: {
    readonly widthCm: number;
    readonly heightCm: number;
    readonly boxes: readonly (Box & {readonly name?: string})[];
    /** Number of further pages of a placing guide. */
    readonly guides: number;
  };
}

/** Request for the image of the print's cell in pixels. */
interface PixelRequest {
  readonly width: number;
  readonly height: number;
}

async function asked<Answer>(
  kind: Question['kind'],
  workbench: Workbench,
  choices: CutChoices,
  signal: AbortSignal,
): Promise<Answer> {
  const {allowanceCm, hemCm} = choices;
  const material = await cutMaterial(workbench, {allowanceCm, hemCm});
  if (!material) throw new Error('There is no answer to cut.');
  const worker = new Worker(new URL('./cut.worker.js', import.meta.url), {type: 'module'});
  const {tile = ''} = material.print;
  return ask(worker, {kind, choices, ...material}, signal, (request) => {
    const {width, height} = request as PixelRequest;
    return pixelsOfTile(tile, width, height);
  });
}

/** @throws {WorkerComplaint} a message of one sentence; the signal's reason when it fires */
export const cutPlan = (
  workbench: Workbench,
  choices: CutChoices,
  signal: AbortSignal,
): Promise<CutPlan> => asked('plan', workbench, choices, signal);

/** @throws the errors of `cutPlan` */
export const cutFile = (
  workbench: Workbench,
  choices: CutChoices,
  signal: AbortSignal,
): Promise<string | Uint8Array<ArrayBuffer>> => asked('file', workbench, choices, signal);
