/** Outlines of motifs as distance functions. Lengths in cm, around the motif's middle. */
import type {Chance} from './chance.js';

export interface Outline {
  /** Greatest distance of its points from the middle. [cm] */
  readonly reach: number;
  /** Near the outline the distance from it, negative within. [cm] */
  readonly outside: (x: number, y: number) => number;
}

export const disc = (radius: number): Outline => ({
  reach: radius,
  outside: (x, y) => Math.sqrt(x * x + y * y) - radius,
});

/** @param turn  counter-clockwise, radians */
export function placed(outline: Outline, atX: number, atY: number, turn: number): Outline {
  const c = Math.cos(turn);
  const s = Math.sin(turn);
  return {
    reach: outline.reach + Math.hypot(atX, atY),
    outside: (x, y) =>
      outline.outside(c * (x - atX) + s * (y - atY), c * (y - atY) - s * (x - atX)),
  };
}

/** A round patch with a wavy radius. */
export function blob(radius: number, chance: Chance): Outline {
  const waves = [1, 2, 3, 4, 5].map((k) => ({
    k,
    size: chance.between(0, 0.55) / (1 + k),
    phase: chance.between(0, 2 * Math.PI),
  }));
  const steps = 256;
  const radii = Float64Array.from({length: steps + 1}, (_, i) => {
    const angle = (2 * Math.PI * i) / steps;
    return (
      radius * waves.reduce((r, {k, size, phase}) => r + size * Math.cos(k * angle + phase), 1)
    );
  });
  return {
    reach: Math.max(...radii),
    outside: (x, y) => {
      const turn = Math.atan2(y, x) / (2 * Math.PI);
      const place = (turn < 0 ? turn + 1 : turn) * steps;
      const i = Math.min(steps - 1, Math.floor(place));
      const before = radii[i] ?? 0;
      return Math.sqrt(x * x + y * y) - before - (place - i) * ((radii[i + 1] ?? 0) - before);
    },
  };
}

/**
 * A leaf between two arcs, from the middle along +x; `bend` moves its tip aside, so that it has no
 * mirror.
 */
export function leaf(length: number, width: number, bend: number): Outline {
  return {
    reach: Math.hypot(length, Math.abs(bend) * length + width),
    outside: (x, y) => {
      const t = x / length;
      const middle = bend * length * t * t;
      const half = t > 0 && t < 1 ? 2.6 * width * t * (1 - t) * (1.25 - 0.7 * t) : 0;
      const aside = Math.abs(y - middle) - half;
      return Math.max(aside, -x, x - length);
    },
  };
}

/** A brush stroke along a bent line, from thick to thin. */
export function stroke(length: number, thickness: number, bend: number): Outline {
  const steps = 10;
  const points = Array.from({length: steps + 1}, (_, i) => {
    const t = i / steps - 0.5;
    return [length * t, bend * length * (4 * t * t * (1 + t) - 0.5)] as const;
  });
  const reach = Math.max(...points.map(([x, y]) => Math.hypot(x, y))) + thickness;
  return {
    reach,
    outside: (x, y) => {
      let least = Infinity;
      points.forEach(([px, py], i) => {
        const next = points[i + 1];
        if (!next) return;
        const dx = next[0] - px;
        const dy = next[1] - py;
        const along = ((x - px) * dx + (y - py) * dy) / (dx * dx + dy * dy);
        const t = along < 0 ? 0 : along > 1 ? 1 : along;
        const ex = x - px - t * dx;
        const ey = y - py - t * dy;
        const half = thickness * (1 - (0.75 * (i + t)) / steps);
        least = Math.min(least, Math.sqrt(ex * ex + ey * ey) - half);
      });
      return least;
    },
  };
}

/**
 * Petals around a middle, the first the longest, so that the flower has no rotation and no mirror.
 */
export function flower(radius: number, petals: number, chance: Chance): Outline {
  const parts = Array.from({length: petals}, (_, k) =>
    placed(
      leaf(radius * (k === 0 ? 1 : chance.between(0.65, 0.9)), radius * 0.28, 0.15),
      0,
      0,
      (2 * Math.PI * k) / petals,
    ),
  );
  return {
    reach: Math.max(...parts.map((part) => part.reach)),
    outside: (x, y) => {
      let least = Infinity;
      for (const part of parts) least = Math.min(least, part.outside(x, y));
      return least;
    },
  };
}
