/** Reads the print size of an image from its file. */
import {exifTags, jpegSegments} from './exif.js';
import type {FileKind} from './file-kind.js';

/**
 * Reads and sets the size of an SVG in its text, since a parser would apply the page's content
 * security policy to its styles.
 */
const rootTag = /<(?:\w+:)?svg\b(?:[^>"']|"[^"]*"|'[^']*')*>/i;

/** Size of an SVG that states none. [px] */
const unsaid = 100;

const bare = (text: string): string => text.replaceAll(/<!--[^]*?-->/g, '');

/** An attribute of the root element; undefined if it is missing. */
export function rootAttribute(text: string, name: string): string | undefined {
  const tag = rootTag.exec(bare(text))?.[0] ?? '';
  return new RegExp(`\\s${name}\\s*=\\s*["']([^"']*)["']`).exec(tag)?.[1];
}

/**
 * The SVG with width and height in pixels from its view box, since some browsers do not draw images
 * without them.
 */
export function sizedSvg(text: string): string {
  const isSized = ['width', 'height'].every((name) =>
    /^\s*[\d.]+\s*([a-z]+\s*)?$/i.test(rootAttribute(text, name) ?? ''),
  );
  if (isSized) return text;
  const box = (rootAttribute(text, 'viewBox') ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const [width, height] = [box[2] ?? 0, box[3] ?? 0];
  const [across, up] = width > 0 && height > 0 ? [width, height] : [unsaid, unsaid];
  return bare(text).replace(rootTag, (tag) =>
    tag
      .replaceAll(/\s(?:width|height)\s*=\s*(?:"[^"]*"|'[^']*')/g, '')
      .replace(/svg\b/i, (name) => `${name} width="${across}" height="${up}"`),
  );
}

/** Pixels per cm, across and down, as stored. */
interface Resolution {
  readonly across: number;
  readonly down: number;
}

const cmPerInch = 2.54;

export const dpiOf = (perCm: number): number => perCm * cmPerInch;

const usable = (across: number, down: number): Resolution | undefined =>
  across > 0 && down > 0 && Number.isFinite(across * down) ? {across, down} : undefined;

/**
 * The resolution of an image: from the pHYs chunk of a PNG; from the first segment of a JPEG, or
 * its EXIF data. Undefined if the file states none, or only proportions.
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
    if (type === 0x49444154) return undefined; // IDAT: metadata precedes the pixels
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

/** Centimetres per absolute unit. */
const paperUnits: Readonly<Record<string, number>> = {
  ...{cm: 1, mm: 0.1, in: cmPerInch, pt: cmPerInch / 72, pc: cmPerInch / 6},
};

/** The length of an SVG size attribute; undefined for pixels or percentages. [cm] */
export function lengthOnPaper(attribute: string | undefined): number | undefined {
  const [, value, unit] =
    /^\s*([\d.]+(?:e[+-]?\d+)?)\s*([a-z]{2})\s*$/i.exec(attribute ?? '') ?? [];
  const length = Number(value) * (paperUnits[unit?.toLowerCase() ?? ''] ?? NaN);
  return length > 0 ? length : undefined;
}
