/** Determines the scale of a garment relative to its pieces in the texture. */
import type {ObjMesh} from './parse.js';
import {nextSide} from './panels.js';

/** Factors from texture coordinates to the unit of the vertices. */
export interface FlatScale {
  readonly across: number;
  readonly up: number;
  /** Share of the sides of the mesh whose length agrees within 1 %. */
  readonly agreeing: number;
  /** True if the factors were measured, and differ from the ratios of units. */
  readonly isMeasured: boolean;
}

/** Greatest number of sampled sides. */
const measuredSides = 60_000;

/** Greatest difference from a ratio of units at which that ratio is taken. */
const snapping = 0.03;

/** Unit ratios of textures in true size: equal units, or millimetres, centimetres and metres. */
const unitRatios = [1, 10, 100, 1000, 0.1, 0.01, 0.001];

/** Least anisotropy of a texture that was squeezed to fit. */
const squeezed = 1.01;

/** Greatest difference between a side's length and its image for the two to agree. */
const alike = 0.01;

/** Number of rounds in which sides that miss the fit lose weight. */
const rounds = 12;

/** Difference at which a side has half of its weight, in the first round and the last. */
const usualMiss = {first: 0.01, last: 0.001};

/**
 * The factors a and b for which squared lengths are a^2 du^2 + b^2 dv^2, by least squares of
 * relative errors. Sides that fabric or folds stretch lose weight.
 */
export function flatScale(mesh: ObjMesh): FlatScale {
  const sides = sidesOf(mesh);
  const uniform = fitted(sides, true);
  const free = fitted(sides, false);
  const isSqueezed = Math.max(free.across / free.up, free.up / free.across) > squeezed;
  const isBetter = agreeingIn(sides, free) > agreeingIn(sides, uniform) + 0.05;
  const {across, up} = unbent(sides, isSqueezed && isBetter ? free : uniform);
  const known = unitRatios.find((ratio) =>
    [across, up].every((one) => Math.abs(one / ratio - 1) <= snapping),
  );
  const factors = known === undefined ? {across, up} : {across: known, up: known};
  return {...factors, agreeing: agreeingIn(sides, factors), isMeasured: known === undefined};
}

type Factors = Pick<FlatScale, 'across' | 'up'>;

/** Squared lengths of sides in space, and of their images across and up. */
interface Sides {
  readonly length: Float64Array;
  readonly across: Float64Array;
  readonly up: Float64Array;
}

const expected = ({across, up}: Sides, k: number, a: number, b: number): number =>
  a * (across[k] ?? 0) + b * (up[k] ?? 0);

/** The relative error of a side's length. */
const missOf = (sides: Sides, k: number, a: number, b: number): number =>
  Math.sqrt(Math.max(0, expected(sides, k, a, b)) / (sides.length[k] ?? 1)) - 1;

const agreeingIn = (sides: Sides, {across, up}: Factors): number => {
  const {length} = sides.length;
  let count = 0;
  for (let k = 0; k < length; k++) {
    if (Math.abs(missOf(sides, k, across ** 2, up ** 2)) <= alike) count++;
  }
  return length > 0 ? count / length : 1;
};

/** Difference within which the sides of a mesh agree that was only bent, and share of them. */
const bent = {alike: 0.004, share: 0.95, longest: 0.9};

/**
 * The factors for a mesh that was bent without stretch. Its sides are chords of arcs, which the
 * longest sides, along the axis of the bend, are not.
 */
function unbent(sides: Sides, {across, up}: Factors): Factors {
  const misses = sides.length.map((_, k) => missOf(sides, k, across ** 2, up ** 2));
  const alikes = misses.filter((miss) => Math.abs(miss) <= bent.alike);
  if (alikes.length < bent.share * misses.length) return {across, up};
  const least = alikes.sort()[Math.floor((1 - bent.longest) * alikes.length)] ?? 0;
  return {across: across / (1 + least), up: up / (1 + least)};
}

function fitted(sides: Sides, isUniform: boolean): Factors {
  let [a, b] = [medianRatio(sides), medianRatio(sides)];
  for (let round = 0; round < rounds; round++) {
    const usual = usualMiss.first * (usualMiss.last / usualMiss.first) ** (round / (rounds - 1));
    let [xx, xy, yy, xl, yl] = [0, 0, 0, 0, 0];
    for (let k = 0; k < sides.length.length; k++) {
      const weight = round === 0 ? 1 : 1 / (1 + (missOf(sides, k, a, b) / usual) ** 2);
      const length = sides.length[k] ?? 1;
      const [x, y] = [(sides.across[k] ?? 0) / length, (sides.up[k] ?? 0) / length];
      [xx, xy, yy] = [xx + weight * x * x, xy + weight * x * y, yy + weight * y * y];
      [xl, yl] = [xl + weight * x, yl + weight * y];
    }
    const both = (xl + yl) / (xx + 2 * xy + yy);
    const determinant = xx * yy - xy * xy;
    const [p, q] = [(xl * yy - yl * xy) / determinant, (yl * xx - xl * xy) / determinant];
    const isSound = !isUniform && determinant > 1e-9 * xx * yy && p > 0 && q > 0;
    [a, b] = isSound ? [p, q] : [both, both];
  }
  return a > 0 && b > 0 ? {across: Math.sqrt(a), up: Math.sqrt(b)} : {across: 1, up: 1};
}

/** The median ratio of squared lengths. */
function medianRatio({length, across, up}: Sides): number {
  const ratios = length.map((one, k) => one / ((across[k] ?? 0) + (up[k] ?? 0))).sort();
  return ratios[ratios.length >> 1] ?? 1;
}

function sidesOf({vertices, flat, corners, flatCorners}: ObjMesh): Sides {
  const found: Record<keyof Sides, number[]> = {length: [], across: [], up: []};
  const step = Math.max(1, Math.floor(corners.length / measuredSides));
  for (let side = 0; side < corners.length; side += step) {
    const next = nextSide(side);
    const [a, b] = [3 * (corners[side] ?? 0), 3 * (corners[next] ?? 0)];
    const [p, q] = [2 * (flatCorners[side] ?? 0), 2 * (flatCorners[next] ?? 0)];
    const away = (k: number): number => (vertices[b + k] ?? 0) - (vertices[a + k] ?? 0);
    const length = away(0) ** 2 + away(1) ** 2 + away(2) ** 2;
    const [du, dv] = [(flat[q] ?? 0) - (flat[p] ?? 0), (flat[q + 1] ?? 0) - (flat[p + 1] ?? 0)];
    if (!(length > 0 && du * du + dv * dv > 0)) continue;
    found.length.push(length);
    found.across.push(du * du);
    found.up.push(dv * dv);
  }
  return {
    length: Float64Array.from(found.length),
    across: Float64Array.from(found.across),
    up: Float64Array.from(found.up),
  };
}
