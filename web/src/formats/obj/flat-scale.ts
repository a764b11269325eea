/** Determines the scale of a garment relative to its pieces in the texture. */
import type {ObjMesh} from './parse.js';
import {nextSide} from './panels.js';

/** Factors from texture coordinates to the unit of the vertices. */
export interface FlatScale {
  readonly across: number;
  readonly up: number;
}

/** Greatest number of sampled sides. */
const measuredSides = 60_000;

/**
 * Greatest stretch of fabric on a body; a ratio this close to a ratio of units is taken as that.
 */
const stretch = 1.3;

/** Unit ratios of textures in true size: equal units, or millimetres, centimetres and metres. */
const unitRatios = [1, 10, 100, 1000, 0.1, 0.01, 0.001];

/** Least anisotropy of a texture that was squeezed to fit. */
const squeezed = 1.05;

export function flatScale(mesh: ObjMesh): FlatScale {
  const {all, across, up} = ratios(mesh);
  const whole = median(all);
  const known = unitRatios.find((ratio) => whole < stretch * ratio && whole * stretch > ratio);
  if (known !== undefined && !isUnitSquare(mesh)) return {across: known, up: known};
  const [a, b] = [median(across), median(up)];
  return Math.max(a / b, b / a) > squeezed ? {across: a, up: b} : {across: whole, up: whole};
}

const median = (values: number[]): number =>
  values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? 1;

/** Returns whether the texture fills the unit square, as packed textures without true sizes do. */
function isUnitSquare({flat}: ObjMesh): boolean {
  let [low, high] = [Infinity, -Infinity];
  for (const value of flat) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return low >= -1e-6 && high <= 1 + 1e-6 && high > 0.9;
}

interface Ratios {
  readonly all: number[];
  readonly across: number[];
  readonly up: number[];
}

/**
 * Ratios of lengths in space to lengths in the texture: of all sides, and of horizontal and
 * vertical ones.
 */
function ratios({vertices, flat, corners, flatCorners}: ObjMesh): Ratios {
  const found: Ratios = {all: [], across: [], up: []};
  const step = Math.max(1, Math.floor(corners.length / measuredSides));
  for (let side = 0; side < corners.length; side += step) {
    const next = nextSide(side);
    const [a, b] = [3 * (corners[side] ?? 0), 3 * (corners[next] ?? 0)];
    const [p, q] = [2 * (flatCorners[side] ?? 0), 2 * (flatCorners[next] ?? 0)];
    const away = (k: number): number => (vertices[b + k] ?? 0) - (vertices[a + k] ?? 0);
    const length = Math.hypot(away(0), away(1), away(2));
    const [dx, dy] = [(flat[q] ?? 0) - (flat[p] ?? 0), (flat[q + 1] ?? 0) - (flat[p + 1] ?? 0)];
    const flatLength = Math.hypot(dx, dy);
    if (!(length > 0 && flatLength > 0)) continue;
    found.all.push(length / flatLength);
    if (Math.abs(dx) > 4 * Math.abs(dy)) found.across.push(length / flatLength);
    if (Math.abs(dy) > 4 * Math.abs(dx)) found.up.push(length / flatLength);
  }
  return found;
}
