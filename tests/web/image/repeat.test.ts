/** The rectangular repeat of a print, as print shops take it. */
import {describe, expect, it} from 'vitest';

import {withPrintedSize} from '@/image/png-size.js';
import {resolutionOf} from '@/image/printed-size.js';
import {pixelsAt, repeatPixels} from '@/image/repeat-pixels.js';
import type {Pixels} from '@/image/tile-fabric.js';
import {asVariant} from '@/model/print/print-variant.js';
import {rectangularRepeat} from '@/model/print/rectangular-repeat.js';
import {latticeVectors, type RepeatSize} from '@/model/print/repeat.js';
import type {GroupName, Print} from '@/model/print/repeating-print.js';
import {repeatSvg} from '@/picture/repeat-svg.js';

const printOf = (group: GroupName, size: Partial<RepeatSize> = {}): Print => {
  const [w1, w2] = latticeVectors(group, {width: 6, height: 4, angleDeg: 90, ...size});
  return {group, w1, w2};
};
const turned = (print: Print, turnDeg: number): Print => asVariant(print, {scale: 1, turnDeg});

describe('the smallest upright rectangle that tiles a print', () => {
  it.each([
    ['a rectangular one', printOf('pmm'), 6, 4],
    ['a rhombic one', printOf('cmm'), 6, 4],
    ['a hexagonal one', printOf('p6m'), 6, 6 * Math.sqrt(3)],
    ['a half-drop', {group: 'p1', w1: [6, 2], w2: [0, 4]} as const, 12, 4],
    ['one turned by 90 degrees', turned(printOf('pmm'), 90), 4, 6],
    ['a square one turned by 45 degrees', turned(printOf('p4m'), 45), 8.485, 8.485],
  ])('is found for %s', (_, print, width, height) => {
    const found = rectangularRepeat(print);
    expect(found?.width).toBeCloseTo(width, 3);
    expect(found?.height).toBeCloseTo(height, 3);
  });

  it('is missing for a slanted lattice', () => {
    const slanted = printOf('p1', {angleDeg: 77});
    expect(rectangularRepeat(slanted)).toBeUndefined();
    expect(repeatSvg({...slanted, tile: '<svg/>'}, undefined)).toContain('url(#print)');
  });
});

/** An image of a cell without a visible joint: waves of one period. */
function waves(width: number, height: number): Pixels {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [s, t] = [(2 * Math.PI * x) / width, (2 * Math.PI * y) / height];
      const colour = [Math.sin(s), Math.cos(t), Math.sin(s + t)].map((wave) => 128 + 100 * wave);
      data.set([...colour, 255], 4 * (y * width + x));
    }
  }
  return {width, height, data};
}

/** Greatest difference of neighbours: within the picture, and where it meets its copy. */
function joints({width, height, data}: Pixels): {readonly within: number; readonly joint: number} {
  let [within, joint] = [0, 0];
  const off = (a: number, b: number): number =>
    Math.max(
      ...[0, 1, 2].map((ink) => Math.abs((data[4 * a + ink] ?? 0) - (data[4 * b + ink] ?? 0))),
    );
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const here = y * width + x;
      const right = off(here, y * width + ((x + 1) % width));
      const below = off(here, ((y + 1) % height) * width + x);
      if (x + 1 < width) within = Math.max(within, right);
      else joint = Math.max(joint, right);
      if (y + 1 < height) within = Math.max(within, below);
      else joint = Math.max(joint, below);
    }
  }
  return {within, joint};
}

it.each([
  ['of its own cell', printOf('pmm')],
  ['of two cells of a half-drop', {group: 'p1', w1: [6, 2], w2: [0, 4]} as const],
  ['of sheared cells', printOf('p6m')],
  ['turned by 45 degrees', turned(printOf('p4m'), 45)],
])('a picture %s meets its copies without a joint', (_, print) => {
  const rectangle = rectangularRepeat(print);
  if (!rectangle) throw new Error('no rectangle');
  const picture = repeatPixels(print, waves(90, 70), rectangle, pixelsAt(rectangle, 40));
  const {within, joint} = joints(picture);
  expect(within).toBeGreaterThan(5);
  expect(joint).toBeLessThanOrEqual(within + 1);
});

it('a PNG has its size on fabric, whatever the rounding of its sides', () => {
  const header = new Uint8Array(33);
  new DataView(header.buffer).setUint32(16, 240);
  new DataView(header.buffer).setUint32(20, 479);
  header.set([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52]);
  const sized = withPrintedSize(header, {width: 2.03, height: 4.05});
  const {across = 0, down = 0} = resolutionOf(sized, 'png') ?? {};
  expect(240 / across).toBeCloseTo(2.03, 3);
  expect(479 / down).toBeCloseTo(4.05, 3);
});

it('an SVG has its size in millimetres', () => {
  const print = {...printOf('pmm'), tile: '<svg xmlns="http://www.w3.org/2000/svg"/>'};
  expect(repeatSvg(print, rectangularRepeat(print))).toContain(
    '<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40">',
  );
});
