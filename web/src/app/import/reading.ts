/** Requests to the worker that reads drawings. */
import type {Choices, DefaultChoices} from '../../files/to-garment.js';
import type {SvgUse} from '../../files/svg/read-svg.js';
import type {Drawing, DrawingOptions} from '../../model/garment/imported-drawing.js';
import {ask} from '../worker/ask.js';
import type {PieceShape} from './piece-shape.js';

/** A drawing with the shapes of its pieces, one for each, and the initial choices. */
export interface ShownDrawing {
  readonly drawing: Drawing;
  readonly shapes: readonly PieceShape[];
  readonly first: DefaultChoices;
}

/** Conversion of a drawing to a garment. */
export interface Making {
  readonly drawing: Drawing;
  readonly choices: Choices;
  /** Sews the outer line instead of the inner one if both are drawn. */
  readonly isOuterSewn: boolean;
}

export type Question =
  | {readonly kind: 'use'; readonly file: File}
  | {readonly kind: 'drawing'; readonly file: File; readonly options: DrawingOptions}
  | ({readonly kind: 'garment'} & Making);

const asked = <Answer>(question: Question, signal: AbortSignal): Promise<Answer> =>
  ask(
    new Worker(new URL('./drawing.worker.js', import.meta.url), {type: 'module'}),
    question,
    signal,
  );

/** Returns the possible uses of an SVG. */
export const svgUse = (file: File, signal: AbortSignal): Promise<SvgUse> =>
  asked({kind: 'use', file}, signal);

/**
 * @throws {WorkerComplaint} a message of one sentence if the file cannot be read; the signal's
 * reason when it fires
 */
export const drawingIn = (
  file: File,
  signal: AbortSignal,
  options: DrawingOptions = {},
): Promise<ShownDrawing> => asked({kind: 'drawing', file, options}, signal);

/** Returns the text of the garment's file. @throws the errors of `drawingIn` */
export const garmentFrom = (making: Making, signal: AbortSignal): Promise<string> =>
  asked({kind: 'garment', ...making}, signal);
