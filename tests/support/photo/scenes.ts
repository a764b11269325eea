/** Fabric, paper and walls without a repeat: one square, of which an image shows a part. */
import type {Point} from '@/model/geometry/vectors.js';

import type {Chance} from './chance.js';
import {drawn, emptyCell, type Cell, type Patch} from './drawn-print.js';
import {transform} from './fourier.js';
import {inkOf, palette, toLinear, type Ink} from './inks.js';
import {blob, disc, flower, leaf, placed, stroke, type Outline} from './outlines.js';

/** Side of a scene. [cm] */
export const sceneSide = 60;
const samples = 2048;

function filled(n: number, of: (i: number, j: number) => readonly [number, number, number]): Cell {
  const cell = emptyCell(n, [0, 0, 0]);
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const colour = of(i, j);
      cell.planes.forEach((plane, c) => (plane[j * n + i] = colour[c] ?? 0));
    }
  }
  return cell;
}

export const whiteNoise = (chance: Chance): Cell => {
  const colour = chance.happens(0.5);
  return filled(1024, () => {
    const x = chance.next();
    return colour ? [x, chance.next(), chance.next()] : [x, x, x];
  });
};

/** Energy falls with the square of the frequency, as in natural images. */
export function cloudy(chance: Chance): Cell {
  const n = 512;
  const channels = [0, 1, 2].map(() => {
    const re = new Float64Array(n * n);
    const im = new Float64Array(n * n);
    for (let j = 0; j < n; j++) {
      for (let i = 0; i < n; i++) {
        const f = Math.hypot(Math.min(i, n - i), Math.min(j, n - j));
        if (f === 0) continue;
        re[j * n + i] = chance.normal() / f;
        im[j * n + i] = chance.normal() / f;
      }
    }
    transform({n, re, im}, 1);
    const spread = Math.sqrt(re.reduce((sum, x) => sum + x * x, 0) / re.length);
    return re.map((x) => x / spread);
  });
  const at = (c: number, k: number): number => channels[c]?.[k] ?? 0;
  return filled(n, (i, j) => {
    const k = j * n + i;
    const y = 0.4 + 0.15 * at(0, k);
    return [y + 0.05 * at(1, k), y, y + 0.05 * at(2, k)].map((x) =>
      toLinear(Math.max(0, Math.min(1, x))),
    ) as [number, number, number];
  });
}

/** Rows of equal height with random lengths, offsets and colours of the bricks. */
export function bricks(chance: Chance): Cell {
  const n = samples;
  const rows = chance.whole(14, 26);
  const length = n / chance.whole(8, 12);
  const height = n / rows;
  const laid = Array.from({length: rows}, () => {
    const colours: Ink[] = [];
    const ends: number[] = [];
    for (let x = -chance.between(0, length); x < n;) {
      x += length * chance.between(0.55, 1.45);
      ends.push(x);
      colours.push(
        inkOf(chance.between(0, 0.07), chance.between(0.4, 0.7), chance.between(0.3, 0.7)),
      );
    }
    return {ends, colours};
  });
  const joint = n / 300;
  return filled(n, (i, j) => {
    const row = laid[Math.floor(j / height) % rows];
    if (!row || j % height < joint) return [0.55, 0.53, 0.5];
    const k = row.ends.findIndex((end) => i < end);
    const end = row.ends[k] ?? n;
    return end - i < joint ? [0.55, 0.53, 0.5] : (row.colours[k] ?? [0, 0, 0]);
  });
}

/** Lines of words of random letters, each letter a different pattern. */
export function textPage(chance: Chance): Cell {
  const n = samples;
  const letters = Array.from({length: 26}, () =>
    Array.from({length: 20}, () => chance.happens(0.55)),
  );
  const cell = emptyCell(n, [0.85, 0.84, 0.8]);
  const dot = chance.whole(3, 5);
  for (let top = n - 40; top > 60; top -= dot * chance.whole(10, 12)) {
    let left = 40;
    while (left < n - 200) {
      for (let k = chance.whole(2, 9); k > 0; k--, left += 5 * dot) {
        chance.of(letters).forEach((inked, part) => {
          if (!inked) return;
          for (let y = 0; y < dot; y++) {
            for (let x = 0; x < dot; x++) {
              const place = (top - (part >> 2) * dot - y) * n + left + (part & 3) * dot + x;
              cell.planes.forEach((plane) => (plane[place] = 0.03));
            }
          }
        });
      }
      left += 4 * dot;
      if (chance.happens(0.04)) break;
    }
  }
  return cell;
}

/** Threads of uneven thickness and shade, warp and weft. */
export function plainLinen(chance: Chance): Cell {
  const n = samples;
  const base = inkOf(chance.next(), chance.between(0.05, 0.4), chance.between(0.5, 0.9));
  const threads = (): Float32Array => {
    const shade = new Float32Array(n);
    for (let i = 0; i < n;) {
      const thickness = chance.whole(3, 8);
      const value = 0.06 * chance.normal();
      for (let k = 0; k < thickness && i < n; k++, i++) shade[i] = value;
    }
    return shade;
  };
  const warp = threads();
  const weft = threads();
  return filled(n, (i, j) => {
    const s = 1 + (warp[i] ?? 0) + (weft[j] ?? 0) + 0.02 * chance.normal();
    return [base[0] * s, base[1] * s, base[2] * s];
  });
}

export function gradient(chance: Chance): Cell {
  const from = inkOf(chance.next(), 0.5, 0.9);
  const to = inkOf(chance.next(), 0.6, 0.4);
  const angle = chance.between(0, 2 * Math.PI);
  const n = 512;
  return filled(n, (i, j) => {
    // one wave along each side, so that the scene has no visible border
    const along = Math.cos((2 * Math.PI * i) / n + angle) + Math.cos((2 * Math.PI * j) / n);
    const t = 0.5 + 0.2 * along;
    return [0, 1, 2].map((c) => (from[c] ?? 0) + t * ((to[c] ?? 0) - (from[c] ?? 0))) as [
      number,
      number,
      number,
    ];
  });
}

const scene = (ground: Ink, patches: readonly Patch[]): Cell =>
  drawn({group: 'p1', w1: [sceneSide, 0], w2: [0, sceneSide], ground, patches}, samples).cell;

const someMotif = (size: number, chance: Chance): Outline =>
  chance.of([
    () => blob(size, chance),
    () => leaf(1.6 * size, 0.5 * size, 0.3),
    () => stroke(2 * size, 0.3 * size, 0.4),
    () => flower(1.2 * size, 5, chance),
  ])();

/**
 * Motifs at random places, no nearer to each other than their size (Poisson discs by dart
 * throwing).
 */
export function scattered(chance: Chance): Cell {
  const {ground, inks} = palette(chance);
  const apart = chance.between(2.5, 5);
  const places: Point[] = [];
  for (let attempt = 0; attempt < 4000; attempt++) {
    const p: Point = [chance.next(), chance.next()];
    const free = places.every(([x, y]) => {
      const dx = Math.abs(p[0] - x);
      const dy = Math.abs(p[1] - y);
      return Math.hypot(Math.min(dx, 1 - dx), Math.min(dy, 1 - dy)) * sceneSide > apart;
    });
    if (free) places.push(p);
  }
  const kinds = Array.from({length: chance.whole(1, 4)}, () => someMotif(apart * 0.4, chance));
  return scene(
    ground,
    places.map((at) => ({
      outline: placed(chance.of(kinds), 0, 0, chance.between(0, 2 * Math.PI)),
      at,
      ink: chance.of(inks),
    })),
  );
}

/** One motif on the places of a lattice, each copy with a random turn and colour. */
export function turnedAtRandom(chance: Chance): Cell {
  const {ground, inks} = palette(chance);
  const across = chance.whole(8, 12);
  const motif = stroke((1.2 * sceneSide) / across, (0.22 * sceneSide) / across, 0.5);
  const patches = Array.from({length: across * across}, (_, k): Patch => ({
    outline: placed(motif, 0, 0, chance.between(0, 2 * Math.PI)),
    at: [((k % across) + 0.5) / across, (Math.floor(k / across) + 0.5) / across],
    ink: chance.of(inks),
  }));
  return scene(ground, patches);
}

/** Heads with eyes and mouths, no two alike. */
export function faces(chance: Chance): Cell {
  const ground = inkOf(chance.next(), 0.3, 0.7);
  const patches = Array.from({length: 14}, (_, k): Patch[] => {
    const at: Point = [
      ((k % 4) + chance.between(0.2, 0.8)) / 4,
      (Math.floor(k / 4) + chance.between(0.2, 0.8)) / 4,
    ];
    const size = chance.between(4, 7);
    const skin = inkOf(0.07, chance.between(0.25, 0.6), chance.between(0.4, 0.95));
    const dark = inkOf(0.05, 0.6, 0.15);
    const turn = chance.between(-0.4, 0.4);
    const part = (outline: Outline, x: number, y: number, ink: Ink): Patch => ({
      outline: placed(placed(outline, x * size, y * size, 0), 0, 0, turn),
      at,
      ink,
    });
    return [
      part(blob(size * 1.15, chance), 0, 0.15, dark),
      part(blob(size, chance), 0, 0, skin),
      part(disc(size * 0.13), -0.35, 0.2, dark),
      part(disc(size * 0.13), 0.35, 0.2, dark),
      part(
        stroke(size * 0.8, size * 0.08, chance.between(-0.4, 0.4)),
        0,
        -0.45,
        inkOf(0, 0.7, 0.6),
      ),
    ];
  }).flat();
  return scene(ground, patches);
}
