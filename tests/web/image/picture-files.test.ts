import {readFileSync} from 'node:fs';
import {createCanvas} from '@napi-rs/canvas';
import {describe, expect, it} from 'vitest';

import {fileKind, isWhole} from '@/image/file-kind.js';
import {dpiOf, lengthOnPaper, resolutionOf, rootAttribute, sizedSvg} from '@/image/printed-size.js';
import {leaf, painted, pngOf} from '../../support/image/pictures.js';

const png = pngOf(painted(12, 8, leaf), 300);
const jpeg = createCanvas(12, 8).toBuffer('image/jpeg');
const webp = createCanvas(12, 8).toBuffer('image/webp');
const letters = (text: string): Uint8Array => Buffer.from(text, 'latin1');

describe('a file', () => {
  it.each([
    ['png', png],
    ['jpeg', jpeg],
    ['webp', webp],
    ['svg', letters('<?xml version="1.0"?>\n<!-- a leaf --><svg xmlns="...">')],
    ['gif', letters('GIF89a')],
    ['heic', letters('\0\0\0\x18ftypheic\0\0\0\0mif1heic')],
    ['avif', letters('\0\0\0\x1cftypavif\0\0\0\0mif1avif')],
    ['tiff', letters('II*\0\x08\0\0\0')],
    ['tiff', letters('MM\0*\0\0\0\x08')],
    ['bmp', letters(`BM\x40\0\0\0\0\0\0\0${' '.repeat(40)}`)],
    ['pdf', letters('%PDF-1.7')],
    ['photoshop', letters('8BPS\0\x01')],
    ['postscript', letters('%!PS-Adobe-3.0 EPSF-3.0')],
    ['zip', letters('PK\x03\x04\x14\0')],
    ['dxf', letters('  0\r\nSECTION\r\n  2\r\nHEADER\r\n')],
    ['dxf', letters('999\nby a pattern program\n0\nSECTION\n2\nENTITIES\n')],
    ['dxf', letters('AutoCAD Binary DXF\r\n\x1a\0')],
  ] as const)('is known as %s by how it begins', (kind, bytes) => {
    expect(fileKind(bytes)).toBe(kind);
  });

  it.each(['', 'hello', '{"group": "p1"}', '<html><body>', 'BMX is a sport of its own, you know'])(
    'is none of them when it begins as %o',
    (text) => {
      expect(fileKind(letters(text))).toBeUndefined();
    },
  );
});

describe('a picture', () => {
  it.each([
    ['png', png],
    ['jpeg', jpeg],
    ['webp', webp],
  ] as const)('is whole as %s, and damaged wherever it ends early', (kind, bytes) => {
    expect(isWhole(bytes, kind)).toBe(true);
    for (const share of [0.1, 0.5, 0.9]) {
      expect(isWhole(bytes.subarray(0, share * bytes.length), kind)).toBe(false);
    }
  });

  it('is damaged as PNG where a single byte has changed', () => {
    for (const at of [20, 50, png.length - 20]) {
      const changed = Buffer.from(png);
      changed[at] = (changed[at] ?? 0) ^ 1;
      expect(isWhole(changed, 'png')).toBe(false);
    }
  });

  it('is whole in all the prints that come along', () => {
    const tile = new URL('../../../public/prints/p4m.png', import.meta.url);
    expect(isWhole(readFileSync(tile), 'png')).toBe(true);
  });
});

/** The start of a JPEG file, with segments before its pixels. */
const jpegWith = (...segments: readonly string[]): Uint8Array =>
  letters(`\xff\xd8${segments.join('')}\xff\xda\0\x02..\xff\xd9`);
const jfif = (unit: number, density: number): string =>
  `\xff\xe0\0\x10JFIF\0\x01\x01${String.fromCharCode(unit, density >> 8, density & 255, density >> 8, density & 255)}\0\0`;
/** Big-endian: tags 11a and 11b are fractions at 50, tag 128 a unit. */
function exif(dots: number, unit: number): string {
  const tiff = Buffer.alloc(58);
  tiff.write('MM\0*', 'latin1');
  tiff.writeUInt32BE(8, 4);
  tiff.writeUInt16BE(3, 8);
  [
    [0x011a, 5, 1, 50],
    [0x011b, 5, 1, 50],
    [0x0128, 3, 1, unit << 16],
  ].forEach(([tag = 0, type = 0, count = 0, value = 0], k) => {
    tiff.writeUInt16BE(tag, 10 + 12 * k);
    tiff.writeUInt16BE(type, 12 + 12 * k);
    tiff.writeUInt32BE(count, 14 + 12 * k);
    tiff.writeUInt32BE(value, 18 + 12 * k);
  });
  tiff.writeUInt32BE(dots * 10, 50);
  tiff.writeUInt32BE(10, 54);
  return `\xff\xe1\0\x42Exif\0\0${tiff.toString('latin1')}`;
}

describe('the resolution of a picture', () => {
  const dpi = (bytes: Uint8Array, kind: 'png' | 'jpeg'): number | undefined => {
    const found = resolutionOf(bytes, kind);
    return found && Math.round(dpiOf(found.across));
  };

  it('is read from a PNG', () => {
    expect(dpi(png, 'png')).toBe(300);
    expect(dpi(pngOf(painted(4, 4, leaf)), 'png')).toBeUndefined();
  });

  it('is read from the first segment of a JPEG, per inch or per cm', () => {
    expect(dpi(jpegWith(jfif(1, 300)), 'jpeg')).toBe(300);
    expect(dpi(jpegWith(jfif(2, 100)), 'jpeg')).toBe(254);
  });

  it('is read from EXIF data where the first segment has only proportions', () => {
    expect(dpi(jpegWith(jfif(0, 1), exif(240, 2)), 'jpeg')).toBe(240);
    expect(dpi(jpegWith(exif(100, 3)), 'jpeg')).toBe(254);
    expect(dpi(jpegWith(exif(100, 1)), 'jpeg')).toBeUndefined();
  });

  it('is unknown where nothing is said, or the file ends', () => {
    expect(dpi(jpegWith(jfif(0, 1)), 'jpeg')).toBeUndefined();
    expect(dpi(jpegWith(jfif(1, 0)), 'jpeg')).toBeUndefined();
    expect(dpi(letters('\xff\xd8\xff\xe1\0\x42Exif\0\0MM'), 'jpeg')).toBeUndefined();
  });
});

it('takes a length of an SVG that is meant for paper', () => {
  expect(lengthOnPaper('12.4cm')).toBeCloseTo(12.4);
  expect(lengthOnPaper('124 mm')).toBeCloseTo(12.4);
  expect(lengthOnPaper('2in')).toBeCloseTo(5.08);
  for (const other of ['200', '200px', '100%', '0cm', undefined]) {
    expect(lengthOnPaper(other)).toBeUndefined();
  }
});

describe('an SVG', () => {
  it('gives itself a size in its outermost element', () => {
    const text = `<?xml version="1.0"?><!-- <svg width="1"> --><svg viewBox='0 0 3 4' width="12cm"><rect width="2"/></svg>`;
    expect(rootAttribute(text, 'width')).toBe('12cm');
    expect(rootAttribute(text, 'viewBox')).toBe('0 0 3 4');
    expect(rootAttribute(text, 'height')).toBeUndefined();
  });

  it('is drawn in the proportions of its view box where it does not', () => {
    const svg = (attributes: string): string => `<svg ${attributes}><g width="100%"/></svg>`;
    expect(sizedSvg(svg('viewBox="0 0 30 40" width="100%"'))).toBe(
      '<svg width="30" height="40" viewBox="0 0 30 40"><g width="100%"/></svg>',
    );
    expect(sizedSvg(svg('id="a"'))).toContain('<svg width="100" height="100" id="a">');
    expect(sizedSvg(svg('width="30mm" height="40"'))).toBe(svg('width="30mm" height="40"'));
  });
});
