/** How large a picture is to be printed, as its file says it. */
import {exifTags, jpegSegments} from './exif.js';
import type {FileKind} from './file-kind.js';

/** Pixels per cm, to the right and down, as the picture is stored. */
interface Resolution {
  readonly across: number;
  readonly down: number;
}

const cmPerInch = 2.54;

export const dpiOf = (perCm: number): number => perCm * cmPerInch;

const usable = (across: number, down: number): Resolution | undefined =>
  across > 0 && down > 0 && Number.isFinite(across * down) ? {across, down} : undefined;

/**
 * PNG says it in its part pHYs; JPEG in its first segment, or in the EXIF data of a camera or a program.
 * Undefined where a file says nothing, or only proportions.
 */
export function resolutionOf(bytes: Uint8Array, kind: FileKind): Resolution | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    if (kind === 'png') return pngResolution(view);
    return kind === 'jpeg' ? jpegResolution(view) : undefined;
  } catch (error) {
    if (error instanceof RangeError) return undefined; // the file ends too early
    throw error;
  }
}

function pngResolution(view: DataView): Resolution | undefined {
  for (let at = 8; ;) {
    const type = view.getUint32(at + 4);
    if (type === 0x49444154) return undefined; // IDAT: what describes the pixels lies before them
    if (type === 0x70485973) {
      const isPerMetre = view.getUint8(at + 16) === 1;
      const perCm = (offset: number): number => view.getUint32(at + offset) / 100;
      return isPerMetre ? usable(perCm(8), perCm(12)) : undefined;
    }
    at += 12 + view.getUint32(at);
  }
}

function jpegResolution(view: DataView): Resolution | undefined {
  for (const {marker, at} of jpegSegments(view)) {
    const isJfif = marker === 0xffe0 && view.getUint32(at + 4) === 0x4a464946;
    const unit = isJfif ? view.getUint8(at + 11) : 0;
    if (unit !== 1 && unit !== 2) continue;
    const perCm = (offset: number): number =>
      view.getUint16(at + offset) / (unit === 1 ? cmPerInch : 1);
    const found = usable(perCm(12), perCm(14));
    if (found) return found;
  }
  const {resolution: [across, down] = [0, 0], resolutionUnit: unit = 2} = exifTags(view);
  const perUnit = unit === 2 ? cmPerInch : 1;
  return unit === 2 || unit === 3 ? usable(across / perUnit, down / perUnit) : undefined;
}

/** Centimetres of the units that stand for a length on paper. */
const paperUnits: Readonly<Record<string, number>> = {
  ...{cm: 1, mm: 0.1, in: cmPerInch, pt: cmPerInch / 72, pc: cmPerInch / 6},
};

/** A side of an SVG, as its attribute has it; undefined where that is in pixels or in shares of a page. [cm] */
export function lengthOnPaper(attribute: string | undefined): number | undefined {
  const [, value, unit] =
    /^\s*([\d.]+(?:e[+-]?\d+)?)\s*([a-z]{2})\s*$/i.exec(attribute ?? '') ?? [];
  const length = Number(value) * (paperUnits[unit?.toLowerCase() ?? ''] ?? NaN);
  return length > 0 ? length : undefined;
}
