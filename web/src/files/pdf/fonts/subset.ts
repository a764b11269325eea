/** Writes some glyphs of a TrueType font as a font for PDF. */
import {viewOf, type Bytes, type TrueType} from './true-type.js';

/** Flags of the parts of a composite glyph. */
const part = {words: 1, scale: 8, more: 32, twoScales: 64, matrix: 128, instructions: 256};

/** Visits the parts of a composite glyph. Returns the end of the last one. */
function eachPart(view: DataView, visit: (at: number, flags: number) => void): number {
  let [at, flags] = [10, part.more];
  while (flags & part.more) {
    flags = view.getUint16(at);
    visit(at, flags);
    const scale = flags & part.scale ? 2 : flags & part.twoScales ? 4 : flags & part.matrix ? 8 : 0;
    at += 4 + (flags & part.words ? 4 : 2) + scale;
  }
  return at;
}

/**
 * An outline without instructions, which only matter on coarse screens.
 * @param renumbered returns the number of a part's glyph in the subset
 */
function withoutInstructions(outline: Bytes, renumbered: (glyph: number) => number): Bytes {
  if (outline.length === 0) return outline;
  const out = outline.slice();
  const view = viewOf(out);
  const contours = view.getInt16(0);
  if (contours < 0) {
    const end = eachPart(view, (at, flags) => {
      view.setUint16(at, flags & ~part.instructions);
      view.setUint16(at + 2, renumbered(view.getUint16(at + 2)));
    });
    return out.slice(0, end);
  }
  const at = 10 + 2 * contours;
  const length = view.getUint16(at);
  view.setUint16(at, 0);
  const rest = out.subarray(at + 2 + length);
  out.copyWithin(at + 2, at + 2 + length);
  return out.slice(0, at + 2 + rest.length);
}

const joined = (parts: readonly Bytes[]): Bytes => {
  const out = new Uint8Array(parts.reduce((sum, {length}) => sum + length, 0));
  let at = 0;
  for (const one of parts) {
    out.set(one, at);
    at += one.length;
  }
  return out;
};

const padded = (bytes: Bytes): Bytes => {
  const out = new Uint8Array(4 * Math.ceil(bytes.length / 4));
  out.set(bytes);
  return out;
};

function checksum(bytes: Bytes): number {
  const view = viewOf(bytes);
  let sum = 0;
  for (let at = 0; at < bytes.length; at += 4) sum = (sum + view.getUint32(at)) >>> 0;
  return sum;
}

/** A file of tables, with checksums. */
function fileOf(tables: readonly (readonly [name: string, content: Bytes])[]): Bytes {
  const count = tables.length;
  const power = Math.floor(Math.log2(count));
  const head = new Uint8Array(12 + 16 * count);
  const view = viewOf(head);
  view.setUint32(0, 0x00010000);
  view.setUint16(4, count);
  view.setUint16(6, 16 * 2 ** power);
  view.setUint16(8, power);
  view.setUint16(10, 16 * (count - 2 ** power));
  let at = head.length;
  let headAt = 0;
  const bodies = tables.map(([name, content], k) => {
    const body = padded(content);
    if (name === 'head') headAt = at;
    head.set(new TextEncoder().encode(name), 12 + 16 * k);
    [checksum(body), at, content.length].forEach((value, n) => {
      view.setUint32(16 + 16 * k + 4 * n, value);
    });
    at += body.length;
    return body;
  });
  const file = joined([head, ...bodies]);
  viewOf(file).setUint32(headAt + 8, (0xb1b0afba - checksum(file)) >>> 0);
  return file;
}

/** Glyphs with the parts of composite ones, which are appended. */
function withParts(font: TrueType, glyphs: readonly number[]): readonly number[] {
  const all = [...glyphs];
  const known = new Set(all);
  for (const glyph of all) {
    const outline = font.outlineOf(glyph);
    const view = viewOf(outline);
    if (outline.length === 0 || view.getInt16(0) >= 0) continue;
    eachPart(view, (at) => {
      const one = view.getUint16(at + 2);
      if (!known.has(one)) all.push(one);
      known.add(one);
    });
  }
  return all;
}

/**
 * A font file of some glyphs, numbered in their order, with the parts of composite glyphs behind
 * them. It has the tables that PDF requires.
 */
export function subsetOf(font: TrueType, glyphs: readonly number[]): Bytes {
  const all = withParts(font, glyphs);
  const numbers = new Map(all.map((glyph, k) => [glyph, k]));
  const outlines = all.map((glyph) =>
    padded(withoutInstructions(font.outlineOf(glyph), (one) => numbers.get(one) ?? 0)),
  );
  const loca = new Uint8Array(4 * (all.length + 1));
  const hmtx = new Uint8Array(4 * all.length);
  const [places, metrics] = [viewOf(loca), viewOf(hmtx)];
  let end = 0;
  all.forEach((glyph, k) => {
    const outline = outlines[k] ?? new Uint8Array();
    end += outline.length;
    places.setUint32(4 * (k + 1), end);
    metrics.setUint16(4 * k, font.widthOf(glyph));
    // the left side bearing is the least x of the outline
    metrics.setInt16(4 * k + 2, outline.length > 0 ? viewOf(outline).getInt16(2) : 0);
  });
  const [head, hhea, maxp] = ['head', 'hhea', 'maxp'].map((name) => font.table(name).slice()) as [
    Bytes,
    Bytes,
    Bytes,
  ];
  viewOf(head).setUint32(8, 0);
  viewOf(head).setInt16(50, 1);
  viewOf(hhea).setUint16(34, all.length);
  viewOf(maxp).setUint16(4, all.length);
  return fileOf([
    ...[['glyf', joined(outlines)] as const, ['head', head] as const, ['hhea', hhea] as const],
    ...[['hmtx', hmtx] as const, ['loca', loca] as const, ['maxp', maxp] as const],
  ]);
}
