/**
 * Converts raster images to PDF images. JPEG and most PNG data stay unchanged; transparent images
 * are composited on white.
 */
import {FileError} from '../../model/base/versioned-file.js';
import {inflated} from '../base/inflated.js';

/** An image for `PdfDocument.packedStream`. */
export interface PdfImage {
  readonly entries: string;
  readonly data: Uint8Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
}

type Bytes = Uint8Array<ArrayBuffer>;

const hex = (bytes: Uint8Array): string =>
  Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');

const overWhite = (value: number, alpha: number): number =>
  Math.round((value * alpha + 255 * (255 - alpha)) / 255);

async function deflated(data: Bytes): Promise<Bytes> {
  const through = new Blob([data]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(through).arrayBuffer());
}

const entriesOf = (width: number, height: number, bits: number, more: string): string =>
  `/Type/XObject/Subtype/Image/Width ${width}/Height ${height}/BitsPerComponent ${bits}/Interpolate true${more}`;

/** Dictionary entries for Flate data with PNG filters. */
const predicted = (colours: number, bits: number, width: number): string =>
  `/Filter/FlateDecode/DecodeParms<</Predictor 15/Colors ${colours}/BitsPerComponent ${bits}/Columns ${width}>>`;

interface Png {
  readonly width: number;
  readonly height: number;
  readonly bits: number;
  readonly kind: number;
  readonly isInterlaced: boolean;
  readonly palette: Bytes;
  readonly transparency: Bytes | undefined;
  readonly data: Bytes;
}

function readPng(bytes: Bytes): Png {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts: Bytes[] = [];
  const chunks = new Map<string, Bytes>();
  for (let at = 8; at < bytes.length;) {
    const length = view.getUint32(at);
    const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const body = bytes.subarray(at + 8, at + 8 + length);
    if (body.length < length) throw new RangeError('cut off');
    if (name === 'IDAT') parts.push(body);
    else chunks.set(name, body);
    if (name === 'IEND') break;
    at += length + 12;
  }
  const head = chunks.get('IHDR');
  if (head?.length !== 13 || parts.length === 0) throw new RangeError('no picture');
  const data = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    data.set(part, at);
    at += part.length;
  }
  const [width, height] = [0, 4].map((k) =>
    new DataView(head.buffer, head.byteOffset).getUint32(k),
  );
  return {
    ...{width: width ?? 0, height: height ?? 0, bits: head[8] ?? 0, kind: head[9] ?? 0},
    isInterlaced: head[12] !== 0,
    palette: chunks.get('PLTE') ?? new Uint8Array(),
    transparency: chunks.get('tRNS'),
    data,
  };
}

/** The prediction of a PNG filter for a byte, from its left, upper and upper left neighbours. */
function predictedBy(filter: number, left: number, above: number, corner: number): number {
  if (filter === 1) return left;
  if (filter === 2) return above;
  if (filter === 3) return (left + above) >> 1;
  if (filter !== 4) return 0;
  const sum = left + above - corner;
  const [a, b, c] = [Math.abs(sum - left), Math.abs(sum - above), Math.abs(sum - corner)];
  return a <= b && a <= c ? left : b <= c ? above : corner;
}

/**
 * Composites grey or RGB with alpha, 8 bits each, on white; rows have PNG filters for the PDF
 * decoder.
 */
async function flattened({data, width, height, kind}: Png): Promise<Bytes> {
  const colours = kind === 4 ? 1 : 3;
  const depth = colours + 1;
  const row = width * depth;
  const raw = await inflated(data, height * (row + 1));
  const out = new Uint8Array(height * (width * colours + 1));
  let above = new Uint8Array(row);
  let before = new Uint8Array(width * colours);
  for (let y = 0; y < height; y++) {
    const from = y * (row + 1);
    const now = raw.slice(from + 1, from + 1 + row);
    const filter = raw[from] ?? 0;
    for (let x = 0; x < row; x++) {
      const left = now[x - depth] ?? 0;
      const corner = x < depth ? 0 : (above[x - depth] ?? 0);
      now[x] = (now[x] ?? 0) + predictedBy(filter, left, above[x] ?? 0, corner);
    }
    above = now;
    const laid = new Uint8Array(width * colours);
    const to = y * (laid.length + 1);
    out[to] = 2; // each byte as its difference from the one above
    for (let k = 0; k < laid.length; k++) {
      const pixel = Math.floor(k / colours) * depth;
      laid[k] = overWhite(now[pixel + (k % colours)] ?? 0, now[pixel + colours] ?? 0);
      out[to + 1 + k] = (laid[k] ?? 0) - (before[k] ?? 0);
    }
    before = laid;
  }
  return deflated(out);
}

/** The palette composited on white, for colours with transparency. */
const paletteOnWhite = (palette: Bytes, transparency: Bytes | undefined): Bytes =>
  palette.map((value, k) => overWhite(value, transparency?.[Math.floor(k / 3)] ?? 255));

/** @throws {FileError} for a PNG that PDF cannot contain */
async function pngImage(bytes: Bytes, called: string): Promise<PdfImage> {
  const png = readPng(bytes);
  const {width, height, bits, kind, isInterlaced, palette, transparency, data} = png;
  const hasAlpha = kind === 4 || kind === 6;
  if (isInterlaced || (hasAlpha && bits !== 8)) {
    const what = isInterlaced ? 'an interlaced PNG' : 'a PNG of 16 bits with transparency';
    throw new FileError(
      called,
      `is ${what}, which no PDF holds; save it with 8 bits, not interlaced.`,
    );
  }
  const image = (colours: number, space: string, content: Bytes): PdfImage => ({
    ...{width, height, data: content},
    entries: entriesOf(
      width,
      height,
      bits,
      `/ColorSpace${space}${predicted(colours, bits, width)}`,
    ),
  });
  if (kind === 3) {
    const table = paletteOnWhite(palette, transparency);
    const last = Math.floor(table.length / 3) - 1;
    if (last < 0) throw new RangeError('no palette');
    return image(1, `[/Indexed/DeviceRGB ${last}<${hex(table)}>]`, data);
  }
  const isGrey = kind === 0 || kind === 4;
  const space = isGrey ? '/DeviceGray' : '/DeviceRGB';
  const shown = image(isGrey ? 1 : 3, space, hasAlpha ? await flattened(png) : data);
  if (!transparency || hasAlpha) return shown;
  // a single transparent colour
  const key = Array.from({length: isGrey ? 1 : 3}, (_, k) => {
    const value = ((transparency[2 * k] ?? 0) << 8) | (transparency[2 * k + 1] ?? 0);
    return `${value} ${value}`;
  });
  return {...shown, entries: `${shown.entries}/Mask[${key.join(' ')}]`};
}

/** @throws {RangeError} if the size is missing */
function jpegImage(bytes: Bytes): PdfImage {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let isAdobe = false;
  for (let at = 2; ; at += 2 + view.getUint16(at + 2)) {
    while (view.getUint8(at + 1) === 0xff) at++;
    const marker = view.getUint8(at + 1);
    if (marker === 0xee) isAdobe = true;
    const isFrame = marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
    if (!isFrame) continue;
    const [height, width, colours] = [
      view.getUint16(at + 5),
      view.getUint16(at + 7),
      view.getUint8(at + 9),
    ];
    const space = colours === 1 ? 'Gray' : colours === 3 ? 'RGB' : 'CMYK';
    // Adobe programs write inverted inks
    const decode = colours === 4 && isAdobe ? '/Decode[1 0 1 0 1 0 1 0]' : '';
    return {
      ...{width, height, data: bytes},
      entries: entriesOf(width, height, 8, `/ColorSpace/Device${space}${decode}/Filter/DCTDecode`),
    };
  }
}

/**
 * A PNG or JPEG image; undefined for any other format.
 * @param called name of the image in messages
 * @throws {FileError} if PDF cannot contain the image or the file is damaged
 */
export async function pdfImage(bytes: Bytes, called: string): Promise<PdfImage | undefined> {
  const begins = (...start: number[]): boolean => start.every((byte, k) => bytes[k] === byte);
  try {
    const image = begins(0x89, 0x50, 0x4e, 0x47)
      ? await pngImage(bytes, called)
      : begins(0xff, 0xd8, 0xff)
        ? jpegImage(bytes)
        : undefined;
    if (image && !(image.width > 0 && image.height > 0)) throw new RangeError('no size');
    return image;
  } catch (cause) {
    if (cause instanceof FileError) throw cause;
    throw new FileError(called, 'is a damaged picture; save it again.', {cause});
  }
}
