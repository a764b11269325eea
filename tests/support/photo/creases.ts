/**
 * Displacement of fabric in its own plane: smooth, small, and not equivalent to a change of the
 * view.
 */
import type {Point} from '@/model/geometry/vectors.js';

import {applied, inverse, type Matrix3} from './camera.js';
import type {Chance} from './chance.js';

export interface Creases {
  /** Greatest displacement in the image, as a share of a repeat. */
  readonly most: number;
  /** Writes the offset of the lattice coordinates at a pixel. */
  at(x: number, y: number, out: Float64Array): void;
}

interface Wave {
  readonly kx: number;
  readonly ky: number;
  readonly phase: number;
  readonly du: number;
  readonly dv: number;
}

/**
 * Changes of (u, v) by a change of the homography; the fabric's own lattice must remain the best
 * fit.
 */
const projective = (u: number, v: number): readonly (readonly [number, number])[] => [
  [1, 0],
  [u, 0],
  [v, 0],
  [0, 1],
  [0, u],
  [0, v],
  [u * u, u * v],
  [u * v, v * v],
];

/** Solves a symmetric system in place, by elimination. */
function solved(rows: number[][], right: number[]): number[] {
  const n = right.length;
  const cell = (i: number, j: number): number => rows[i]?.[j] ?? 0;
  for (let k = 0; k < n; k++) {
    for (let i = k + 1; i < n; i++) {
      const factor = cell(i, k) / cell(k, k);
      rows[i] = (rows[i] ?? []).map((value, j) => value - factor * cell(k, j));
      right[i] = (right[i] ?? 0) - factor * (right[k] ?? 0);
    }
  }
  const x = new Array<number>(n).fill(0);
  for (let k = n - 1; k >= 0; k--) {
    let sum = right[k] ?? 0;
    for (let j = k + 1; j < n; j++) sum -= cell(k, j) * (x[j] ?? 0);
    x[k] = sum / cell(k, k);
  }
  return x;
}

/** @param most  greatest displacement, as a share of a repeat */
export function creases(
  h: Matrix3,
  width: number,
  height: number,
  most: number,
  chance: Chance,
): Creases {
  const back = inverse(h);
  const longer = Math.max(width, height);
  const waves: Wave[] = Array.from({length: 7}, () => {
    const angle = chance.between(0, 2 * Math.PI);
    const k = (2 * Math.PI * chance.between(0.7, 3)) / longer;
    const towards = chance.between(0, 2 * Math.PI);
    return {
      kx: k * Math.cos(angle),
      ky: k * Math.sin(angle),
      phase: chance.between(0, 2 * Math.PI),
      du: Math.cos(towards),
      dv: Math.sin(towards),
    };
  });
  const [u0, v0] = applied(back, [width / 2, height / 2]);
  const local = (x: number, y: number): Point => {
    const [u, v] = applied(back, [x, y]);
    return [u - u0, v - v0];
  };
  const raw = (x: number, y: number): [number, number] => {
    let du = 0;
    let dv = 0;
    for (const wave of waves) {
      const s = Math.sin(wave.kx * x + wave.ky * y + wave.phase);
      du += wave.du * s;
      dv += wave.dv * s;
    }
    return [du, dv];
  };
  const grid = Array.from({length: 21 * 21}, (_, k): Point => [
    ((k % 21) / 20) * width,
    (Math.floor(k / 21) / 20) * height,
  ]);
  const rows = Array.from({length: 8}, () => new Array<number>(8).fill(0));
  const right = new Array<number>(8).fill(0);
  for (const [x, y] of grid) {
    const modes = projective(...local(x, y));
    const [du, dv] = raw(x, y);
    modes.forEach(([p, q], i) => {
      right[i] = (right[i] ?? 0) + p * du + q * dv;
      const row = rows[i] ?? [];
      modes.forEach(([r, s], j) => (row[j] = (row[j] ?? 0) + p * r + q * s));
    });
  }
  const fit = solved(rows, right);
  const left = (x: number, y: number): [number, number] => {
    const [du, dv] = raw(x, y);
    return projective(...local(x, y)).reduce<[number, number]>(
      ([s, t], [p, q], i) => [s - p * (fit[i] ?? 0), t - q * (fit[i] ?? 0)],
      [du, dv],
    );
  };
  const greatest = Math.max(...grid.map(([x, y]) => Math.hypot(...left(x, y))));
  return tabled(left, width, height, most / greatest, most);
}

/** Interpolates from a grid of 8 px: the waves are hundreds of pixels long. */
function tabled(
  displacement: (x: number, y: number) => readonly [number, number],
  width: number,
  height: number,
  scale: number,
  most: number,
): Creases {
  const step = Math.max(8, Math.max(width, height) / 128);
  const across = Math.ceil(width / step) + 2;
  const down = Math.ceil(height / step) + 2;
  const table = new Float64Array(2 * across * down);
  for (let j = 0; j < down; j++) {
    for (let i = 0; i < across; i++) {
      const [du, dv] = displacement(i * step, j * step);
      table[2 * (j * across + i)] = scale * du;
      table[2 * (j * across + i) + 1] = scale * dv;
    }
  }
  return {
    most,
    at: (x, y, out) => {
      const i = Math.floor(x / step);
      const j = Math.floor(y / step);
      const s = x / step - i;
      const t = y / step - j;
      const k = 2 * (j * across + i);
      const below = k + 2 * across;
      for (let c = 0; c < 2; c++) {
        out[c] =
          (1 - t) * ((1 - s) * (table[k + c] ?? 0) + s * (table[k + 2 + c] ?? 0)) +
          t * ((1 - s) * (table[below + c] ?? 0) + s * (table[below + 2 + c] ?? 0));
      }
    },
  };
}
