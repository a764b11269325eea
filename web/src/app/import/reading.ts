/** What is asked of the worker that reads drawings. */
import type {Choices, DefaultChoices} from '../../formats/to-garment.js';
import type {SvgUse} from '../../formats/svg/read-svg.js';
import type {Drawing} from '../../model/drawing.js';
import {ask} from '../worker/ask.js';
import type {PieceShape} from './piece-shape.js';

/** A drawing with what its pieces look like, one for each, and what is chosen of it at first. */
export interface ShownDrawing {
  readonly drawing: Drawing;
  readonly shapes: readonly PieceShape[];
  readonly first: DefaultChoices;
}

/** What is made of a drawing. */
export interface Making {
  readonly drawing: Drawing;
  readonly choices: Choices;
  /** Where both are drawn, the outer line is sewn and not the inner one. */
  readonly isOuterSewn: boolean;
}

export type Question =
  | {readonly kind: 'use'; readonly file: File}
  | {readonly kind: 'drawing'; readonly file: File; readonly size: string | undefined}
  | ({readonly kind: 'garment'} & Making);

const asked = <Answer>(question: Question, signal: AbortSignal): Promise<Answer> =>
  ask(
    new Worker(new URL('./drawing.worker.js', import.meta.url), {type: 'module'}),
    question,
    signal,
  );

/** What an SVG may be. */
export const svgUse = (file: File, signal: AbortSignal): Promise<SvgUse> =>
  asked({kind: 'use', file}, signal);

/** @throws {WorkerComplaint} with one sentence for what cannot be read; the signal's reason when it fires */
export const drawingIn = (file: File, signal: AbortSignal, size?: string): Promise<ShownDrawing> =>
  asked({kind: 'drawing', file, size}, signal);

/** The text of the garment's file. @throws as `drawingIn` */
export const garmentFrom = (making: Making, signal: AbortSignal): Promise<string> =>
  asked({kind: 'garment', ...making}, signal);
