/** Printed size of an image according to its file. */
import {fileKind} from '../image/file-kind.js';
import {dpiOf, lengthOnPaper, resolutionOf} from '../image/printed-size.js';
import {rootAttribute} from '../image/svg-size.js';
import {blobOf} from '../image/data-url.js';
import {leastRepeat, mostRepeat} from '../model/print/repeat.js';
import {loadPicture} from './picture-pixels.js';

export interface FileSize {
  /** Width of the image. [cm] */
  readonly width: number;
  /** Undefined for an SVG, which has a length instead. */
  readonly dpi: number | undefined;
}

/** Resolutions that programs write by default. [dpi] */
const unasked: ReadonlySet<number> = new Set([72, 96]);

export const isUnasked = ({dpi}: FileSize): boolean =>
  dpi !== undefined && unasked.has(Math.round(dpi));

/**
 * Returns undefined if the file has no size, or one that no print can have.
 * @param image a `data:` URL
 */
export async function sizeInFile(image: string): Promise<FileSize | undefined> {
  if (!image.startsWith('data:')) return undefined;
  const size = await sizeOf(image);
  return size && size.width >= leastRepeat && size.width <= mostRepeat ? size : undefined;
}

async function sizeOf(image: string): Promise<FileSize | undefined> {
  const bytes = new Uint8Array(await blobOf(image).arrayBuffer());
  const kind = fileKind(bytes);
  if (kind === 'svg') {
    const width = lengthOnPaper(rootAttribute(new TextDecoder().decode(bytes), 'width'));
    return width === undefined ? undefined : {width, dpi: undefined};
  }
  const resolution = kind && resolutionOf(bytes, kind);
  if (!resolution) return undefined;
  const {naturalWidth} = await loadPicture(image);
  return {width: naturalWidth / resolution.across, dpi: dpiOf(resolution.across)};
}
