/** Reads fonts with TrueType outlines from TTF and WOFF files. */
import {FileError} from '../../../model/base/versioned-file.js';
import {inflated} from '../../base/inflated.js';

export type Bytes = Uint8Array<ArrayBuffer>;

export interface TrueType {
  readonly unitsPerEm: number;
  readonly ascent: number;
  readonly descent: number;
  readonly box: readonly [number, number, number, number];
  /** The glyph of a code point; 0 if the font does not have it. */
  readonly glyphOf: (code: number) => number;
  /** Advance width. [font units] */
  readonly widthOf: (glyph: number) => number;
  readonly outlineOf: (glyph: number) => Bytes;
  readonly table: (name: string) => Bytes;
}

const woffMark = 0x774f4646;
const trueTypeMarks = [0x00010000, 0x74727565];
/** Largest font file. [bytes] */
const greatestFont = 32e6;

export const viewOf = (bytes: Bytes): DataView =>
  new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

async function tablesOf(bytes: Bytes): Promise<ReadonlyMap<string, Bytes>> {
  const view = viewOf(bytes);
  const isWoff = view.getUint32(0) === woffMark;
  if (!isWoff && !trueTypeMarks.includes(view.getUint32(0))) throw new RangeError('another format');
  const [count, first, entry] = isWoff ? [view.getUint16(12), 44, 20] : [view.getUint16(4), 12, 16];
  const tables = new Map<string, Bytes>();
  for (let k = 0; k < count; k++) {
    const at = first + entry * k;
    const name = String.fromCharCode(...bytes.subarray(at, at + 4));
    const start = view.getUint32(at + (isWoff ? 4 : 8));
    const packedLength = view.getUint32(at + (isWoff ? 8 : 12));
    const length = isWoff ? view.getUint32(at + 12) : packedLength;
    if (start + packedLength > bytes.length || length > greatestFont)
      throw new RangeError('cut off');
    const body = bytes.slice(start, start + packedLength);
    tables.set(name, length > packedLength ? await inflated(body, length) : body);
  }
  return tables;
}

/** Segments of consecutive code points and their first glyphs, from the best `cmap` subtable. */
function glyphsOf(cmap: Bytes): (code: number) => number {
  const view = viewOf(cmap);
  const found = Array.from({length: view.getUint16(2)}, (_, k) => {
    const offset = view.getUint32(8 + 8 * k);
    return {offset, format: view.getUint16(offset)};
  });
  const full = found.find(({format}) => format === 12);
  if (full) {
    const {offset} = full;
    const groups = view.getUint32(offset + 12);
    return (code) => {
      for (let k = 0; k < groups; k++) {
        const at = offset + 16 + 12 * k;
        const [first, last] = [view.getUint32(at), view.getUint32(at + 4)];
        if (code >= first && code <= last) return view.getUint32(at + 8) + code - first;
      }
      return 0;
    };
  }
  const plain = found.find(({format}) => format === 4);
  if (!plain) throw new RangeError('no table of letters');
  const {offset} = plain;
  const doubled = view.getUint16(offset + 6);
  return (code) => {
    for (let k = 0; k < doubled; k += 2) {
      if (code > view.getUint16(offset + 14 + k)) continue;
      const first = view.getUint16(offset + 16 + doubled + k);
      if (code < first) return 0;
      const delta = view.getUint16(offset + 16 + 2 * doubled + k);
      const at = offset + 16 + 3 * doubled + k;
      const range = view.getUint16(at);
      if (range === 0) return (code + delta) & 0xffff;
      const glyph = view.getUint16(at + range + 2 * (code - first));
      return glyph === 0 ? 0 : (glyph + delta) & 0xffff;
    }
    return 0;
  };
}

/**
 * Reads a font with TrueType outlines from a TTF or WOFF file.
 * @param called name of the file in messages
 * @throws {FileError} for other formats and damaged files
 */
export async function readTrueType(bytes: Bytes, called: string): Promise<TrueType> {
  try {
    const tables = await tablesOf(bytes);
    const table = (name: string): Bytes => {
      const found = tables.get(name);
      if (!found) throw new RangeError(`no table ${name}`);
      return found;
    };
    const [head, hhea, hmtx, loca] = ['head', 'hhea', 'hmtx', 'loca'].map((name) =>
      viewOf(table(name)),
    ) as [DataView, DataView, DataView, DataView];
    const glyf = table('glyf');
    let letters: ReturnType<typeof glyphsOf> | undefined;
    const measured = hhea.getUint16(34);
    const isLong = head.getInt16(50) === 1;
    const placeOf = (glyph: number): number =>
      isLong ? loca.getUint32(4 * glyph) : 2 * loca.getUint16(2 * glyph);
    return {
      unitsPerEm: head.getUint16(18),
      ...{ascent: hhea.getInt16(4), descent: hhea.getInt16(6)},
      box: [head.getInt16(36), head.getInt16(38), head.getInt16(40), head.getInt16(42)],
      glyphOf: (code) => (letters ??= glyphsOf(table('cmap')))(code),
      widthOf: (glyph) => hmtx.getUint16(4 * Math.min(glyph, measured - 1)),
      outlineOf: (glyph) => glyf.slice(placeOf(glyph), placeOf(glyph + 1)),
      table,
    };
  } catch (cause) {
    if (cause instanceof FileError) throw cause;
    throw new FileError(called, 'is no font with TrueType outlines; use a .ttf or .woff file.', {
      cause,
    });
  }
}
