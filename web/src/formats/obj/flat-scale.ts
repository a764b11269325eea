/** How much larger a garment is than its pieces in the texture. */
import type {ObjMesh} from './parse.js';
import {nextSide} from './panels.js';

/** By what texture coordinates are to be multiplied, to be in the unit of the vertices. */
export interface FlatScale {
  readonly across: number;
  readonly up: number;
}

/** Sides that are measured; more change nothing. */
const measuredSides = 60_000;

/** Cloth stretches on a body; a ratio this near to that of two units is theirs. */
const stretch = 1.3;

/** Ratios of units in which a texture may hold true sizes: the same, or millimetres, centimetres and metres. */
const unitRatios = [1, 10, 100, 1000, 0.1, 0.01, 0.001];

/** Textures that were squeezed to fit have another scale across than up. */
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

/** Whether the texture fills the square from 0 to 1, as those do that were packed, and says nothing of sizes. */
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

/** Of sides in space to sides in the texture: of all, and of those that run across and up. */
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
