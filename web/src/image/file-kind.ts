/**
 * Recognises image files by their first bytes, regardless of the name, and checks that they are
 * complete.
 */

/** Kinds of files: images for prints, other images and drawings, and documents. */
export type FileKind =
  | 'png'
  | 'jpeg'
  | 'webp'
  | 'svg'
  | 'gif'
  | 'heic'
  | 'avif'
  | 'tiff'
  | 'bmp'
  | 'photoshop'
  | 'pdf'
  | 'postscript'
  | 'dxf'
  | 'zip';

export const isDocument = (kind: FileKind): boolean => ['pdf', 'postscript', 'zip'].includes(kind);

/** Number of bytes examined for the start of a text. */
const beginning = 4096;

const heicBrands = new Set(['heic', 'heix', 'heim', 'heis', 'hevc', 'hevx', 'mif1', 'msf1']);

const viewOf = (bytes: Uint8Array): DataView =>
  new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

const letters = (bytes: Uint8Array, from: number, to: number): string =>
  String.fromCharCode(...bytes.subarray(from, to));

/** The kind of a file; undefined if it is none of these. */
export function fileKind(bytes: Uint8Array): FileKind | undefined {
  const first = letters(bytes, 0, 4);
  if (first === '\x89PNG') return 'png';
  if (first.startsWith('\xff\xd8\xff')) return 'jpeg';
  if (first === 'RIFF' && letters(bytes, 8, 12) === 'WEBP') return 'webp';
  if (first === 'GIF8') return 'gif';
  if (first === '%PDF') return 'pdf';
  if (first === '8BPS') return 'photoshop';
  if (first.startsWith('%!')) return 'postscript';
  if (first === 'PK\x03\x04') return 'zip';
  if (['II*\0', 'MM\0*', 'II+\0', 'MM\0+'].includes(first)) return 'tiff';
  if (first.startsWith('BM') && bytes.length > 26 && viewOf(bytes).getUint32(6) === 0) return 'bmp';
  if (letters(bytes, 4, 8) === 'ftyp') return mediaKind(bytes);
  const text = new TextDecoder().decode(bytes.subarray(0, beginning));
  if (/^AutoCAD Binary DXF|^(\s*999\r?\n.*\r?\n)*\s*0\s*\r?\n\s*SECTION\s/.test(text)) return 'dxf';
  return /^\s*<(\?xml|!doctype svg|!--|svg)/i.test(text) && /<(\w+:)?svg[\s>]/i.test(text)
    ? 'svg'
    : undefined;
}

/** The kind of a media file, from its compatible brands. */
function mediaKind(bytes: Uint8Array): FileKind | undefined {
  const end = Math.min(viewOf(bytes).getUint32(0), 256, bytes.length);
  const brands: string[] = [];
  for (let at = 8; at + 4 <= end; at += 4) brands.push(letters(bytes, at, at + 4));
  if (brands.some((brand) => brand === 'avif' || brand === 'avis')) return 'avif';
  return brands.some((brand) => heicBrands.has(brand)) ? 'heic' : undefined;
}

/**
 * Returns whether an image is complete, as far as its format permits a check, since browsers
 * display the rest of a damaged one. The parser of an SVG checks it instead.
 */
export function isWhole(bytes: Uint8Array, kind: FileKind): boolean {
  try {
    switch (kind) {
      case 'png':
        return isWholePng(bytes);
      case 'jpeg':
        return isWholeJpeg(bytes);
      case 'webp':
        return viewOf(bytes).getUint32(4, true) + 8 <= bytes.length;
      default:
        return true;
    }
  } catch (error) {
    if (error instanceof RangeError) return false; // the file ends too early
    throw error;
  }
}

const polynomial = 0xedb88320;
const remainders = Uint32Array.from({length: 256}, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? (value >>> 1) ^ polynomial : value >>> 1;
  return value;
});

/** The CRC-32 of PNG and zip files. */
export function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = (remainders[(crc ^ byte) & 0xff] ?? 0) ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** Checks that all chunks have correct checksums, up to the empty last one. */
function isWholePng(bytes: Uint8Array): boolean {
  const view = viewOf(bytes);
  let hasPixels = false;
  for (let at = 8; ;) {
    const length = view.getUint32(at);
    const type = letters(bytes, at + 4, at + 8);
    const end = at + 8 + length;
    if (view.getUint32(end) !== crc32(bytes.subarray(at + 4, end))) return false;
    hasPixels ||= type === 'IDAT';
    if (type === 'IEND') return hasPixels;
    at = end + 4;
  }
}

/** Checks that there are segments, and pixels with an end marker. */
function isWholeJpeg(bytes: Uint8Array): boolean {
  const view = viewOf(bytes);
  let at = 2;
  for (;;) {
    const marker = view.getUint16(at);
    if (marker === 0xffff) {
      at++; // padding
      continue;
    }
    if (marker <= 0xff01) return false;
    if (marker === 0xffd9) return false; // no pixels at all
    at += 2 + view.getUint16(at + 2);
    if (marker === 0xffda) break;
  }
  // within the pixels, ff is followed by 0 or by a restart marker; progressive files have segments
  // in between
  for (; at + 1 < bytes.length; at++) {
    if (bytes[at] === 0xff && bytes[at + 1] === 0xd9) return true;
  }
  return false;
}
