/** Pictures and cutting sheets of a pattern, in the requested format. */
import {greatestAllowance, ruleOf} from '../../cutting/allowance-rule.js';
import type {PrintInk} from '../../cutting/print-ink.js';
import {SolverError} from '../../model/base/failure.js';
import {dxfStyles, dxfUnits, type DxfStyle, type DxfUnit} from '../../model/base/dxf-format.js';
import {dpiLimits} from '../../model/print/print-scale.js';
import type {Texts} from '../../texts/texts.js';
import type {CutFileKind} from '../../paper/cut-file.js';
import type {SheetWindow} from '../../workbench/state.js';
import type {Workbench} from '../../workbench/workbench.js';

const types = ['image/png', 'image/jpeg', 'image/webp'];

/** Kinds of cutting sheets by media type. */
const cutTypes: Readonly<Record<string, CutFileKind>> = {
  'application/pdf': 'pdf',
  'image/svg+xml': 'svg',
  'application/dxf': 'dxf',
  'application/vnd.hp-hpgl': 'plt',
};

/** Resolution of a repeat. [dots per inch] */
const usualDpi = 300;

/**
 * Options of `toBlob`: a picture, a cutting sheet if `type` is one of theirs, or the repeat of the
 * print.
 */
export interface BlobRequest {
  /**
   * `image/png`, the default, `image/jpeg`, `image/webp`; `application/pdf`, `image/svg+xml`,
   * `application/dxf` or `application/vnd.hp-hpgl` for a cutting sheet at true scale.
   */
  readonly type?: string | undefined;
  /** Width of a picture. [px] */
  readonly width?: number | undefined;
  /**
   * Paper of a PDF: a4, letter, a3, legal, tabloid, a2, a1, a0, 36in, projector, or a size such as
   * 60x90. Default a4.
   */
  readonly paper?: string | undefined;
  /** Seam allowance of a cutting sheet. Default 1. [cm] */
  readonly allowance?: number | undefined;
  /** Hem allowance. Default: the seam allowance if stated, otherwise 3. [cm] */
  readonly hem?: number | undefined;
  /**
   * Fills the pieces of a cutting sheet with the print, with a pale print to save ink (`pale`), or
   * draws lines only (`outline`). Default full.
   */
  readonly ink?: PrintInk | undefined;
  /**
   * Adds pages to a PDF that help to place the pieces on fabric that is printed already. Default
   * false.
   */
  readonly guide?: boolean | undefined;
  /** Dialect of a DXF file: AAMA-292 or ASTM D6673. Default aama. */
  readonly dxfStyle?: DxfStyle | undefined;
  /** Unit of a DXF file. Default mm. */
  readonly dxfUnit?: DxfUnit | undefined;
  /**
   * True for one repeat of the print in its size, for a print shop: PNG, or SVG if `type` is
   * `image/svg+xml`. Default false.
   */
  readonly repeat?: boolean | undefined;
  /** Resolution of a repeat, from 30 to 1200. Default 300. [dots per inch] */
  readonly dpi?: number | undefined;
}

/** @throws {SolverError} if there is no design, no rectangular repeat, or no such resolution */
async function repeatOf(
  workbench: Workbench,
  {type, dpi = usualDpi}: BlobRequest,
  {garment, repeat, controls}: Texts,
): Promise<Blob> {
  const wrong = (message: string): SolverError => new SolverError({code: 'options', message});
  const {design} = workbench.history;
  if (!design) throw wrong(garment.noAnswer);
  const [least, most] = dpiLimits;
  if (!(dpi >= least && dpi <= most)) {
    throw wrong(controls.between(`${least} dpi`, `${most} dpi`));
  }
  const {repeatFile} = await import('../../workbench/print/repeat-file.js');
  const kind = type === 'image/svg+xml' ? 'svg' : dpi;
  try {
    return (await repeatFile(design.print, kind, repeat)).content;
  } catch (error) {
    // its own errors are sentences about the print
    throw error instanceof SolverError || error instanceof TypeError
      ? error
      : wrong((error as Error).message);
  }
}

const isAllowance = (cm: number): boolean => cm >= 0 && cm <= greatestAllowance;

/**
 * Returns undefined for a type of pictures.
 * @throws {SolverError} a message of one sentence
 */
async function cutFileFor(
  workbench: Workbench,
  {
    type = '',
    paper = 'a4',
    allowance,
    hem,
    ink = 'full',
    guide = false,
    dxfStyle,
    dxfUnit,
  }: BlobRequest,
  {garment}: Texts,
): Promise<Blob | undefined> {
  const file = Object.hasOwn(cutTypes, type) ? cutTypes[type] : undefined;
  if (!file) {
    if (type === '' || types.includes(type)) return undefined;
    const known = [...types, ...Object.keys(cutTypes)].join(', ');
    throw new SolverError({code: 'options', message: garment.fileType(known)});
  }
  const rule = ruleOf({allowanceCm: allowance, hemCm: hem});
  if (!isAllowance(rule.allowanceCm) || !isAllowance(rule.hemCm)) {
    throw new SolverError({code: 'options', message: garment.allowance(`${greatestAllowance} cm`)});
  }
  const dxf = {style: dxfStyle ?? 'aama', unit: dxfUnit ?? 'mm'};
  if (!dxfStyles.includes(dxf.style) || !dxfUnits.includes(dxf.unit)) {
    throw new SolverError({code: 'options', message: garment.dxf});
  }
  const {cutHere} = await import('../../workbench/cutting/cut-material.js');
  const content = await cutHere(workbench, {file, paper, ink, guide, dxf, ...rule});
  if (content !== undefined) return new Blob([content], {type});
  throw new SolverError({code: 'options', message: garment.noAnswer});
}

/**
 * Converts a PNG to a type of pictures.
 * @throws {Error} if the browser cannot make a picture of this size
 */
async function pictureAs(png: Blob, type = 'image/png'): Promise<Blob> {
  if (type === png.type) return png;
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

/**
 * @throws {SolverError} if nothing is drawn, the width is out of range, or the picture cannot be
 * encoded; the message is one sentence
 */
async function pictureOf(
  view: SheetWindow | undefined,
  isDrawn: boolean,
  {type, width}: {readonly type: string | undefined; readonly width: number | undefined},
  {garment, pattern}: Texts,
): Promise<Blob> {
  if (view?.isLost) throw new SolverError({code: 'no-webgl', message: pattern.lost});
  if (!view || !isDrawn) throw new SolverError({code: 'no-webgl', message: garment.noDrawing});
  // NaN fails, too
  if (width !== undefined && !(width >= 1 && width <= view.widest)) {
    throw new SolverError({code: 'options', message: garment.pictureWidth(String(view.widest))});
  }
  try {
    return await pictureAs(await view.picture(width), type);
  } catch {
    throw new SolverError({code: 'internal', message: garment.noPicture});
  }
}

async function madeBlob(
  workbench: Workbench,
  isDrawn: () => boolean,
  request: BlobRequest,
  texts: Texts,
): Promise<Blob> {
  if (request.repeat) return repeatOf(workbench, request, texts);
  const file = await cutFileFor(workbench, request, texts);
  const {type, width} = request;
  return file ?? pictureOf(workbench.sheet.view, isDrawn(), {type, width}, texts);
}

/**
 * Returns the requested picture or file.
 * @throws {SolverError} as the element's `toBlob`; `network` if a part of the code cannot be loaded
 */
export async function blobOf(...asked: Parameters<typeof madeBlob>): Promise<Blob> {
  try {
    return await madeBlob(...asked);
  } catch (error) {
    if (error instanceof SolverError) throw error;
    const [, , , {garment}] = asked;
    const {message} = error as Error;
    // browsers reject an import that fails to load with a TypeError
    throw error instanceof TypeError
      ? new SolverError({code: 'network', message: garment.noTools(message)}, {cause: error})
      : new SolverError({code: 'internal', message}, {cause: error});
  }
}
