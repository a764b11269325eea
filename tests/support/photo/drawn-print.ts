/** Prints on fabric: one cell, in which every symmetry permutes samples exactly. */
import type {GroupName} from '@/model/print/repeating-print.js';
import type {Point} from '@/model/geometry/vectors.js';

import {elementsOf} from './group-elements.js';
import type {Ink} from './inks.js';
import type {Outline} from './outlines.js';

/**
 * A patch of ink at a place of the cell, and by symmetry at all equivalent ones; later ones cover
 * earlier ones.
 */
export interface Patch {
  readonly outline: Outline;
  /** Position of the outline's middle, in lattice coordinates. */
  readonly at: Point;
  readonly ink: Ink;
  /** Group whose symmetries repeat it, on the same w1, w2; by default the design's. */
  readonly group?: GroupName;
}

export interface Design {
  readonly group: GroupName;
  /** Counter-clockwise. [cm] */
  readonly w1: Point;
  readonly w2: Point;
  readonly ground: Ink;
  readonly patches: readonly Patch[];
}

/** Linear light: sample j * n + i at (u, v) = (i / n, j / n); n is a power of two. */
export interface Cell {
  readonly n: number;
  readonly planes: readonly [Float32Array, Float32Array, Float32Array];
}

export interface Print extends Pick<Design, 'group' | 'w1' | 'w2'> {
  readonly cell: Cell;
}

export const emptyCell = (n: number, ground: Ink): Cell => ({
  n,
  planes: [
    new Float32Array(n * n).fill(ground[0]),
    new Float32Array(n * n).fill(ground[1]),
    new Float32Array(n * n).fill(ground[2]),
  ],
});

/** Image of sample (i, j) under an element of the group. */
type Placing = (i: number, j: number) => number;

const placings = (group: GroupName, n: number): readonly Placing[] =>
  elementsOf(group).map(({m: [a, b, c, d], a: [x, y]}) => {
    const mask = n - 1; // n is a power of two
    return (i, j) => ((c * i + d * j + y * n) & mask) * n + ((a * i + b * j + x * n) & mask);
  });

/**
 * Coverage of each sample by the patch and its images, as a union, so that it is exactly symmetric.
 */
class Cover {
  private readonly share: Float32Array;
  private readonly touched: number[] = [];

  constructor(private readonly n: number) {
    this.share = new Float32Array(n * n);
  }

  add(patch: Patch, {w1, w2}: Design, to: readonly Placing[]): void {
    const {n} = this;
    const area = w1[0] * w2[1] - w1[1] * w2[0];
    const sample = Math.sqrt(area) / n;
    const reach = patch.outline.reach + sample;
    const acrossU = Math.ceil((n * reach * Math.hypot(...w2)) / area);
    const acrossV = Math.ceil((n * reach * Math.hypot(...w1)) / area);
    const i0 = Math.round(patch.at[0] * n);
    const j0 = Math.round(patch.at[1] * n);
    for (let j = j0 - acrossV; j <= j0 + acrossV; j++) {
      const v = j / n - patch.at[1];
      for (let i = i0 - acrossU; i <= i0 + acrossU; i++) {
        const u = i / n - patch.at[0];
        const x = u * w1[0] + v * w2[0];
        const y = u * w1[1] + v * w2[1];
        if (x * x + y * y > reach * reach) continue;
        const covered = 0.5 - patch.outline.outside(x, y) / sample;
        if (covered > 0) this.cover(i, j, Math.min(1, covered), to);
      }
    }
  }

  private cover(i: number, j: number, covered: number, to: readonly Placing[]): void {
    for (const place of to) {
      const k = place(i, j);
      const known = this.share[k] ?? 0;
      if (known === 0) this.touched.push(k);
      if (covered > known) this.share[k] = covered;
    }
  }

  /** Prints the covered samples, and resets the coverage. */
  print(cell: Cell, ink: Ink): void {
    for (const k of this.touched) {
      const covered = this.share[k] ?? 0;
      cell.planes.forEach((plane, c) => {
        const before = plane[k] ?? 0;
        plane[k] = before + covered * ((ink[c] ?? 0) - before);
      });
      this.share[k] = 0;
    }
    this.touched.length = 0;
  }
}

/** @param n  samples along either side, a power of two */
export function drawn(design: Design, n: number): Print {
  const cell = emptyCell(n, design.ground);
  const cover = new Cover(n);
  for (const patch of design.patches) {
    cover.add(patch, design, placings(patch.group ?? design.group, n));
    cover.print(cell, patch.ink);
  }
  return {group: design.group, w1: design.w1, w2: design.w2, cell};
}

/**
 * The same cell with half as many samples: means of four. Its samples are offset by half a fine
 * step.
 */
export function halved({n, planes}: Cell): Cell {
  const half = n / 2;
  const mean = (plane: Float32Array): Float32Array => {
    const out = new Float32Array(half * half);
    for (let j = 0; j < half; j++) {
      for (let i = 0; i < half; i++) {
        const k = 2 * j * n + 2 * i;
        out[j * half + i] =
          0.25 *
          ((plane[k] ?? 0) + (plane[k + 1] ?? 0) + (plane[k + n] ?? 0) + (plane[k + n + 1] ?? 0));
      }
    }
    return out;
  };
  return {n: half, planes: [mean(planes[0]), mean(planes[1]), mean(planes[2])]};
}
