/** Requests to the worker that reads drawings. */
import type {Choices, DefaultChoices} from '../../files/to-garment.js';
import type {SvgUse} from '../../files/svg/read-svg.js';
import type {OpenedPages} from '../../files/read-drawing.js';
import type {Drawing, DrawingOptions} from '../../model/garment/imported-drawing.js';
import {ask} from '../worker/ask.js';
import type {PieceShape} from './piece-shape.js';

/** A drawing with the shapes of its pieces, one for each, and the initial choices. */
export interface ShownDrawing {
  readonly drawing: Drawing;
  readonly shapes: readonly PieceShape[];
  readonly first: DefaultChoices;
  /** The read pages of a PDF, which are put together anew with other options. */
  readonly opened?: OpenedPages;
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
  | {
      readonly kind: 'pages';
      readonly opened: OpenedPages;
      readonly name: string;
      readonly options: DrawingOptions;
    }
  | ({readonly kind: 'garment'} & Making);

/** Progress of a worker that reads pages. */
export interface PagesRead {
  readonly read: number;
  readonly count: number;
}

const asked = <Answer>(
  question: Question,
  signal: AbortSignal,
  onPage?: (progress: PagesRead) => void,
): Promise<Answer> =>
  ask(
    new Worker(new URL('./drawing.worker.js', import.meta.url), {type: 'module'}),
    question,
    signal,
    (progress) => {
      onPage?.(progress as PagesRead);
      return Promise.resolve();
    },
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
  onPage?: (progress: PagesRead) => void,
): Promise<ShownDrawing> => asked({kind: 'drawing', file, options}, signal, onPage);

/** Puts the read pages of a PDF together anew. @throws the errors of `drawingIn` */
export const drawingAgain = async (
  opened: OpenedPages,
  name: string,
  options: DrawingOptions,
  signal: AbortSignal,
): Promise<ShownDrawing> => ({
  ...(await asked<ShownDrawing>({kind: 'pages', opened, name, options}, signal)),
  opened,
});

/** Returns the text of the garment's file. @throws the errors of `drawingIn` */
export const garmentFrom = (making: Making, signal: AbortSignal): Promise<string> =>
  asked({kind: 'garment', ...making}, signal);
