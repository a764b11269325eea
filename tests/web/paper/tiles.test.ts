import {deflateSync, inflateSync} from 'node:zlib';

import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {pdfImage} from '@/files/pdf/image.js';
import {stepsOf} from '@/files/svg/paths.js';
import {vectorTile} from '@/paper/vector-tile.js';

const chunk = (name: string, data: readonly number[] | Uint8Array): Buffer => {
  const body = Buffer.from(data);
  const head = Buffer.alloc(8);
  head.writeUInt32BE(body.length);
  head.write(name, 4, 'latin1');
  return Buffer.concat([head, body, Buffer.alloc(4)]); // readers ignore checksums
};

/** @param rows  each with its filter first */
function png(
  [width, height]: Point,
  kind: number,
  rows: readonly (readonly number[])[],
  {bits = 8, interlace = 0, more = [] as readonly Buffer[]} = {},
): Uint8Array<ArrayBuffer> {
  const head = [0, 0, 0, width, 0, 0, 0, height, bits, kind, 0, 0, interlace];
  return new Uint8Array(
    Buffer.concat([
      Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
      chunk('IHDR', head),
      ...more,
      chunk('IDAT', deflateSync(Buffer.from(rows.flat()))),
      chunk('IEND', []),
    ]),
  );
}

describe('pictures of pixels', () => {
  it('go in as they are, with the filters of PNG', async () => {
    const image = await pdfImage(png([2, 1], 2, [[1, 10, 20, 30, 1, 1, 1]]), 'a.png');
    expect(image?.entries).toContain('/ColorSpace/DeviceRGB');
    expect(image?.entries).toContain('/Predictor 15/Colors 3/BitsPerComponent 8/Columns 2');
    expect([...inflateSync(image?.data ?? '')]).toEqual([1, 10, 20, 30, 1, 1, 1]);
  });

  it('lie on white where they are see-through', async () => {
    // the second row is the difference to the first, by its filter: alpha 128, then 0
    const rows = [
      [0, 0, 0, 0, 255],
      [2, 0, 0, 0, 129],
      [4, 5, 5, 5, 128],
    ];
    const image = await pdfImage(png([1, 3], 6, rows), 'a.png');
    const out = [...inflateSync(image?.data ?? '')];
    const values = [1, 5, 9].map((k) => out[k] ?? 0);
    const [first = 0, second = 0, third = 0] = values;
    expect(out.filter((_, k) => k % 4 === 0)).toEqual([2, 2, 2]);
    expect(first).toBe(0);
    expect((first + second) & 255).toBe(127);
    expect((first + second + third) & 255).toBe(255);
  });

  it('keep their palette, laid on white, too', async () => {
    const more = [chunk('PLTE', [0, 0, 0, 255, 0, 0]), chunk('tRNS', [0])];
    const image = await pdfImage(png([2, 1], 3, [[0, 0, 1]], {more}), 'a.png');
    expect(image?.entries).toContain('[/Indexed/DeviceRGB 1<ffffffff0000>]');
  });

  it('are refused with a remedy where PDF has no place for them', async () => {
    const interlaced = png([1, 1], 2, [[0, 1, 2, 3]], {interlace: 1});
    await expect(pdfImage(interlaced, 'a.png')).rejects.toThrow(
      'a.png is an interlaced PNG, which no PDF holds; save it with 8 bits, not interlaced.',
    );
    const whole = png([1, 1], 2, [[0, 1, 2, 3]]);
    await expect(pdfImage(whole.slice(0, 50), 'a.png')).rejects.toThrow(/damaged picture/);
    await expect(pdfImage(png([1, 9], 6, [[0, 1, 2, 3, 4]]), 'a.png')).rejects.toThrow(/damaged/);
    const swollen = png([1, 1], 6, [new Array<number>(100_000).fill(0)]);
    await expect(pdfImage(swollen, 'a.png')).rejects.toThrow(/damaged/);
    expect(await pdfImage(new TextEncoder().encode('GIF89a'), 'a.gif')).toBeUndefined();
  });

  it('stay JPEG, with the size that their frame says', async () => {
    const head = [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 1];
    const frame = [0xff, 0xc2, 0, 11, 8, 0, 20, 1, 0, 1, 1, 0x11, 0];
    const bytes = Uint8Array.from([...head, ...frame, 0xff, 0xd9]);
    const image = await pdfImage(bytes, 'a.jpg');
    expect(image).toMatchObject({width: 256, height: 20, data: bytes});
    expect(image?.entries).toContain('/DeviceGray/Filter/DCTDecode');
    await expect(pdfImage(Uint8Array.from(head), 'a.jpg')).rejects.toThrow(/damaged/);
  });
});

describe('pictures of areas', () => {
  const points = (data: string): Point[] => stepsOf(data).steps.flatMap((step) => step.points);

  it('read path data in all its short forms', () => {
    expect(points('M1 2h3V5l-1-1z m1,1 1 0')).toEqual([
      ...[[1, 2] as const, [4, 2] as const, [4, 5] as const, [3, 4] as const],
      ...[[2, 3] as const, [3, 3] as const],
    ]);
    expect(points('M0 0c0 1 1 1 1 0s1-1 1 0')).toContainEqual([1, -1]);
    const [x = 0, y = 0] = points('M0,0Q.5.5 1 0T2 0').at(-2) ?? [];
    expect([x, y].map((value) => 3 * value)).toEqual([expect.closeTo(5, 9), expect.closeTo(-1, 9)]);
    for (const bad of ['M1', 'M1 2 L', '1 2', 'M0 0 X', 'M0 0 l1 nan', 'M0 0a1 1 0 2 0 1 1']) {
      expect(stepsOf(bad).isDamaged, bad).toBe(true);
    }
  });

  it('draw arcs within a thousandth of their radius, their flags written together', () => {
    const {steps} = stepsOf('M10 0A10 10 0 1 0 0 10a10 10 0 01-10-10');
    let at: Point = [10, 0];
    for (const {kind, points: control} of steps.slice(1)) {
      expect(kind).toBe('c');
      const [one = at, two = at, to = at] = control;
      for (const t of [0.25, 0.5, 0.75, 1]) {
        const s = 1 - t;
        const [x = 0, y = 0] = ([0, 1] as const).map(
          (axis) =>
            s ** 3 * at[axis] +
            3 * s * s * t * one[axis] +
            3 * s * t * t * two[axis] +
            t ** 3 * to[axis],
        );
        expect(Math.hypot(x, y)).toBeCloseTo(10, 2);
      }
      at = to;
    }
    expect(steps).toHaveLength(5);
    expect(at).toEqual([-10, expect.closeTo(0, 9)]);
  });

  it('follow transforms, uses and styles, upside down, to the size of the cell', () => {
    const svg = `<?xml version="1.0"?><!-- a --><svg viewBox="0 0 100 50">
      <defs><path id="p" d="M0 0h10v10z"/></defs>
      <g transform="translate(20 10) scale(2)" style="fill:#0f0"><use href="#p" x="5"/></g></svg>`;
    const [group] = vectorTile(svg, 10, 5) ?? [];
    const [leaf] = group?.leaves ?? [];
    expect(leaf?.fill).toEqual([0, 1, 0]);
    const [from, to] = leaf?.path.flatMap((step) => step.points) ?? [];
    expect(from?.[0]).toBeCloseTo(3, 9);
    expect(from?.[1]).toBeCloseTo(4, 9);
    expect(to?.[0]).toBeCloseTo(5, 9);
  });

  it('keep what is seen through together', () => {
    const svg = `<svg viewBox="0 0 1 1"><rect width="1" height="1"/>
      <g opacity=".5"><rect width="1" height="1"/><rect width="1" height="1"/></g><rect width="1" height="1"/></svg>`;
    const groups = vectorTile(svg, 1, 1) ?? [];
    expect(groups.map(({opacity, leaves}) => [opacity, leaves.length])).toEqual([
      [1, 1],
      [0.5, 2],
      [1, 1],
    ]);
  });

  it.each([
    ['<svg viewBox="0 0 1 1"><text>a</text></svg>', 'words'],
    ['<svg viewBox="0 0 1 1"><style>a{}</style></svg>', 'style sheets'],
    ['<svg viewBox="0 0 1 1"><g id="a"><use href="#a"/></g></svg>', 'uses of themselves'],
    ['<svg viewBox="0 0 1 1"><g filter="url(#f)"/></svg>', 'filters'],
    ['<svg><rect width="1" height="1"/></svg>', 'no size'],
    ['<svg viewBox="0 0 1 1"><g></svg>', 'tags that do not close'],
  ])('leave %s to others', (svg) => {
    expect(vectorTile(svg, 1, 1)).toBeUndefined();
  });
});
