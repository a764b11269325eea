/** The image of a sample print's cell as fabric for photos. */
import {pixelGrid, type Pixels} from '@/image/tile-fabric.js';
import {combined} from '@/model/geometry/vectors.js';
import type {Print as PrintFile} from '@/model/print/repeating-print.js';

import {emptyCell, type Print} from './drawn-print.js';
import {toLinear} from './inks.js';

const linear = Float32Array.from({length: 256}, (_, x) => toLinear(x / 255));

/**
 * @param n  samples along w1 and w2, a power of two; each is interpolated bilinearly between pixels
 */
export function sampledPrint(
  {group, w1, w2, cell: imageCell = 'primitive'}: PrintFile,
  {width, height, data}: Pixels,
  n: number,
): Print {
  const {pixel} = pixelGrid({group, w1, w2, cell: imageCell}, width, height);
  const wrap = (value: number, size: number): number => ((value % size) + size) % size;
  const cell = emptyCell(n, [0, 0, 0]);
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const [x, y] = pixel(combined([w1, w2], i / n, j / n));
      const [left, top] = [Math.floor(x), Math.floor(y)];
      for (const [right, below] of [
        [0, 0],
        [1, 0],
        [0, 1],
        [1, 1],
      ] as const) {
        const share = (right ? x - left : 1 - x + left) * (below ? y - top : 1 - y + top);
        const from = 4 * (wrap(top + below, height) * width + wrap(left + right, width));
        cell.planes.forEach((plane, c) => {
          plane[j * n + i] = (plane[j * n + i] ?? 0) + share * (linear[data[from + c] ?? 0] ?? 0);
        });
      }
    }
  }
  return {group, w1, w2, cell};
}
