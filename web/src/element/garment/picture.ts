/** A picture of the pattern, as somebody wants it. */
import {SolverError} from '../../model/failure.js';
import type {Texts} from '../../texts/texts.js';
import type {CutFileKind} from '../../paper/cut-file.js';
import type {SheetWindow} from '../../workbench/state.js';
import type {Workbench} from '../../workbench/workbench.js';

const types = ['image/png', 'image/jpeg', 'image/webp'];

/** What files to cut by are, by their types. */
const cutTypes: Readonly<Record<string, CutFileKind>> = {
  'application/pdf': 'pdf',
  'image/svg+xml': 'svg',
  'application/dxf': 'dxf',
  'application/vnd.hp-hpgl': 'plt',
};

/** What is asked of `toBlob`: a picture, or with one of their types a file to cut by. */
export interface BlobRequest {
  /**
   * `image/png`, the default, `image/jpeg`, `image/webp`; `application/pdf`, `image/svg+xml`, `application/dxf` or
   * `application/vnd.hp-hpgl` for the pieces to cut, at true scale.
   */
  readonly type?: string | undefined;
  /** Of a picture. [px] */
  readonly width?: number | undefined;
  /** Of a PDF: a4, letter, a3, legal, tabloid, a2, a1, a0, 36in, projector, or a size such as 60x90. Default a4. */
  readonly paper?: string | undefined;
  /** Around pieces to cut. Default 1. [cm] */
  readonly allowance?: number | undefined;
  /** Of hems. As the allowance by default. [cm] */
  readonly hem?: number | undefined;
  /** Pieces to cut in their print, or lines alone. Default full. */
  readonly ink?: 'full' | 'outline' | undefined;
}

/** More than anybody sews with. [cm] */
const greatestAllowance = 10;

const isAllowance = (cm: number): boolean => cm >= 0 && cm <= greatestAllowance;

/** Undefined for a type that is none of files to cut by. @throws {SolverError} with one sentence */
async function cutFileFor(
  workbench: Workbench,
  {type = '', paper = 'a4', allowance = 1, hem = allowance, ink = 'full'}: BlobRequest,
  {garment}: Texts,
): Promise<Blob | undefined> {
  const file = Object.hasOwn(cutTypes, type) ? cutTypes[type] : undefined;
  if (!file) return undefined;
  if (!isAllowance(allowance) || !isAllowance(hem)) {
    throw new SolverError({code: 'options', message: garment.allowance(`${greatestAllowance} cm`)});
  }
  const {cutHere} = await import('../../editor/cut/cut-here.js');
  try {
    const request = {file, paper, ink, allowanceCm: allowance, hemCm: hem};
    const content = await cutHere(workbench, request);
    if (content !== undefined) return new Blob([content], {type});
  } catch (error) {
    if (error instanceof SolverError) throw error;
    const {message} = error as Error;
    throw new SolverError({code: error instanceof RangeError ? 'options' : 'internal', message});
  }
  throw new SolverError({code: 'options', message: garment.noAnswer});
}

/** A type that cannot be written gives a PNG. @throws {Error} where the browser makes no picture of this size */
async function pictureAs(png: Blob, type = 'image/png'): Promise<Blob> {
  if (type === png.type || !types.includes(type)) return png;
  const picture = await createImageBitmap(png);
  const canvas = document.createElement('canvas');
  canvas.width = picture.width;
  canvas.height = picture.height;
  canvas.getContext('2d')?.drawImage(picture, 0, 0);
  picture.close();
  return new Promise((resolve, reject) => {
    const written = (blob: Blob | null): void => {
      if (blob) resolve(blob);
      else reject(new Error(`There is no ${type} of ${canvas.width} x ${canvas.height} pixels.`));
    };
    canvas.toBlob(written, type, 0.92);
  });
}

/** @throws {SolverError} with one sentence where nothing is drawn, for a wrong width, and where it cannot be written */
async function pictureOf(
  view: SheetWindow | undefined,
  isDrawn: boolean,
  {type, width}: {readonly type: string | undefined; readonly width: number | undefined},
  {garment, pattern}: Texts,
): Promise<Blob> {
  if (view?.isLost) throw new SolverError({code: 'no-webgl', message: pattern.lost});
  if (!view || !isDrawn) throw new SolverError({code: 'no-webgl', message: garment.noDrawing});
  // also for what is no number
  if (width !== undefined && !(width >= 1 && width <= view.widest)) {
    throw new SolverError({code: 'options', message: garment.pictureWidth(String(view.widest))});
  }
  try {
    return await pictureAs(await view.picture(width), type);
  } catch {
    throw new SolverError({code: 'internal', message: garment.noPicture});
  }
}

/** What is asked for. @throws {SolverError} as the element's `toBlob` does */
export const blobOf = async (
  workbench: Workbench,
  isDrawn: () => boolean,
  request: BlobRequest,
  texts: Texts,
): Promise<Blob> =>
  (await cutFileFor(workbench, request, texts)) ??
  pictureOf(workbench.view, isDrawn(), {type: request.type, width: request.width}, texts);
