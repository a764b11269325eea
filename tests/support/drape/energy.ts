/** Elastic energy and weight of a drape's fabric, from a drape file alone. SI units. */
import type {DrapeFile, Place} from '@/model/documents/drape-file.js';
import {distance, dot, minus, norm, towards, type Point} from '@/model/geometry/vectors.js';
import {at, sum} from '../plane.js';
import type {ClothTriangle, SewnCloth} from './sewn-cloth.js';
import {dot3, middle3, norm3, plus3} from './space.js';

const gravity = 9.81;
/**
 * Factor of the bending energy for irregular triangles, so that a strip of them sags like a plate.
 */
const hinge = 1.25;

/**
 * Triangles within this distance of the longer side of a gathered seam represent folds: they yield
 * to compression. [cm]
 */
const besideGathers = 3;
const gathered = 1.1;
const gatheredStiffness = 0.002;

type Fabric = DrapeFile['fabric'];

/** A drape, and the ratios of its seams' drafted lengths, side a over side b. */
export interface RatedDrape {
  readonly file: DrapeFile;
  readonly ratios: readonly number[];
}

export interface Energies {
  readonly membrane: number;
  readonly bending: number;
  readonly weight: number;
}

/** Force of the fabric around a vertex, and its weight. */
interface Forces {
  readonly pull: Place;
  readonly weight: number;
}

/** Area of a triangle as cut. [cm2] */
export function cutArea({cut: [a, b, c]}: ClothTriangle): number {
  const [u, v] = [minus(b, a), minus(c, a)];
  return (u[0] * v[1] - u[1] * v[0]) / 2;
}

/** Derivative of the image of a direction in the cut piece with respect to each corner. [1/cm] */
function hatsOf({cut: [a, b, c]}: ClothTriangle, direction: Point): readonly number[] {
  const [u, v] = [minus(b, a), minus(c, a)];
  const area = u[0] * v[1] - u[1] * v[0];
  const s = (direction[0] * v[1] - direction[1] * v[0]) / area;
  const t = (u[0] * direction[1] - u[1] * direction[0]) / area;
  return [-s - t, s, t];
}

const weighted = (places: readonly Place[], weights: readonly number[]): Place =>
  places.reduce((total, place, k) => plus3(total, place, at(weights, k)), [0, 0, 0]);

/** Image in space of a direction in the cut piece; its length is the stretch. */
export const imageOf = (triangle: ClothTriangle, direction: Point): Place =>
  weighted(triangle.worn, hatsOf(triangle, direction));

/** Energies without the contact with the form, which is too small to show in the sum. [J] */
export function energiesOf(drape: RatedDrape, cloth: SewnCloth): Energies {
  const triangles = wholeOf(cloth);
  const gathers = gathersOf(drape);
  return {
    membrane: sum(triangles.map((one) => membraneOf(one, drape.file, gathers(one)).energy)),
    bending: sum(
      hingesOf(triangles, drape.file).map(
        ({bend, stiffness}) => (stiffness * dot3(bend, bend)) / 2,
      ),
    ),
    weight: sum(
      triangles.map((one) => (weightOf(one, drape.file) * middle3(...one.worn)[1]) / 100),
    ),
  };
}

/** Forces on every vertex of the fabric, except contact. */
export function forcesOf(drape: RatedDrape, cloth: SewnCloth): ReadonlyMap<number, Forces> {
  const triangles = wholeOf(cloth);
  const gathers = gathersOf(drape);
  const forces = new Map<number, Forces>();
  const add = (vertex: number, pull: Place, weight: number) => {
    const known = forces.get(vertex) ?? {pull: [0, 0, 0], weight: 0};
    forces.set(vertex, {pull: plus3(known.pull, pull), weight: known.weight + weight});
  };
  for (const triangle of triangles) {
    const {pulls} = membraneOf(triangle, drape.file, gathers(triangle));
    const third = weightOf(triangle, drape.file) / 3;
    triangle.corners.forEach((vertex, k) => {
      add(vertex, at(pulls, k), third);
    });
  }
  for (const {ends, weights, bend, stiffness} of hingesOf(triangles, drape.file)) {
    ends.forEach((vertex, k) => {
      add(vertex, weighted([bend], [-100 * stiffness * at(weights, k)]), 0);
    });
  }
  return forces;
}

/**
 * Gathered thread directions of a triangle: it is beside the longer side of a gathered seam, which
 * runs along them.
 */
interface Gathers {
  readonly weft: boolean;
  readonly warp: boolean;
}

function gathersOf({file, ratios}: RatedDrape): (triangle: ClothTriangle) => Gathers {
  const beside = file.pieces.map(() => ({weft: new Set<number>(), warp: new Set<number>()}));
  for (const {a, b, stitch} of file.seams) {
    const ratio = at(ratios, stitch);
    if (ratio <= gathered && ratio >= 1 / gathered) continue;
    const {piece, vertices} = ratio > 1 ? a : b;
    const {rest, grainAngle} = at(file.pieces, piece);
    const [x, y] = towards(grainAngle);
    const edges = vertices.slice(1).map((vertex, k) => {
      const [from, to] = [at(rest, at(vertices, k)), at(rest, vertex)];
      return [to[0] - from[0], to[1] - from[1]] as const;
    });
    const along = sum(edges.map((edge) => Math.abs(x * edge[0] + y * edge[1])));
    const across = sum(edges.map((edge) => Math.abs(y * edge[0] - x * edge[1])));
    const threads = at(beside, piece)[along > across ? 'warp' : 'weft'];
    rest.forEach((point, vertex) => {
      const isNear = vertices.some((other) => distance(point, at(rest, other)) < besideGathers);
      if (isNear) threads.add(vertex);
    });
  }
  return ({piece, vertices}) => {
    const {weft, warp} = at(beside, piece);
    const isIn = (threads: ReadonlySet<number>) => vertices.some((vertex) => threads.has(vertex));
    return {weft: isIn(weft), warp: isIn(warp)};
  };
}

/** Triangles that keep an area after sewing. */
const wholeOf = ({triangles}: SewnCloth): ClothTriangle[] =>
  triangles.filter((one) => new Set(one.corners).size === 3 && cutArea(one) > 0);

const warpOf = ({pieces}: DrapeFile, {piece}: ClothTriangle): Point =>
  towards(at(pieces, piece).grainAngle);

/** Weight of a triangle. [N] */
const weightOf = (triangle: ClothTriangle, {fabric}: DrapeFile): number =>
  fabric.density * gravity * cutArea(triangle) * 1e-4;

/** Energy of stretch and shear of a triangle, in J, and its forces on the corners, in N. */
function membraneOf(
  triangle: ClothTriangle,
  file: DrapeFile,
  gathers: Gathers,
): {readonly energy: number; readonly pulls: readonly Place[]} {
  const fabric = gathers.weft || gathers.warp ? {...file.fabric, coupling: 0} : file.fabric;
  const warp = warpOf(file, triangle);
  const hats = [hatsOf(triangle, [warp[1], -warp[0]]), hatsOf(triangle, warp)] as const;
  const [across, along] = [weighted(triangle.worn, hats[0]), weighted(triangle.worn, hats[1])];
  const [eu, ev] = [norm3(across) - 1, norm3(along) - 1];
  const [weft, straight] = [
    spring(fabric, fabric.weft, eu, gathers.weft),
    spring(fabric, fabric.warp, ev, gathers.warp),
  ];
  const skew = dot3(across, along);
  const shear = fabric.shear * skew;
  const area = cutArea(triangle) * 1e-4;
  const tension = [
    (weft.slope + fabric.coupling * ev) / (1 + eu),
    (straight.slope + fabric.coupling * eu) / (1 + ev),
  ] as const;
  return {
    energy: area * (weft.energy + straight.energy + fabric.coupling * eu * ev + (shear * skew) / 2),
    pulls: [0, 1, 2].map((k) => {
      const [u, v] = [at(hats[0], k), at(hats[1], k)];
      const [by, more] = [u * tension[0] + v * shear, v * tension[1] + u * shear];
      return weighted([across, along], [-100 * area * by, -100 * area * more]);
    }),
  };
}

/** Energy density of a stretch. */
function spring(
  {stiffFrom, stiffening}: Fabric,
  taut: number,
  strain: number,
  isGathered: boolean,
): {readonly energy: number; readonly slope: number} {
  const stiffness = isGathered && strain < 0 ? gatheredStiffness * taut : taut;
  const beyond = Math.max(0, strain - stiffFrom);
  return {
    energy: (stiffness * (strain ** 2 + (stiffening - 1) * beyond ** 2)) / 2,
    slope: stiffness * (strain + (stiffening - 1) * beyond),
  };
}

/** One triangle's part of the bend at its edge. */
interface Wing {
  readonly opposite: number;
  readonly area: number;
  /** Cotangents of its angles at the ends of the edge. */
  readonly cotangents: readonly [number, number];
  /** Bend of the warp for a bend of the edge. */
  readonly warp: number;
}

/** The two triangles at an edge, also across seams. */
interface Hinge {
  readonly ends: readonly number[];
  readonly weights: readonly number[];
  /** The weighted sum of the ends' positions. [cm] */
  readonly bend: Place;
  /** The energy is this times the bend squared, over 2. [J/cm2] */
  readonly stiffness: number;
}

function hingesOf(triangles: readonly ClothTriangle[], file: DrapeFile): Hinge[] {
  const {bendingWarp, bendingWeft} = file.fabric;
  const wings = new Map<string, Wing[]>();
  const places = new Map<number, Place>();
  for (const triangle of triangles) {
    for (const k of [0, 1, 2]) {
      places.set(at(triangle.corners, k), at(triangle.worn, k));
      const [from, to] = [(k + 1) % 3, (k + 2) % 3].sort(
        (a, b) => at(triangle.corners, a) - at(triangle.corners, b),
      ) as [number, number];
      const key = `${at(triangle.corners, from)},${at(triangle.corners, to)}`;
      const wing = wingOf(triangle, k, from, to, warpOf(file, triangle));
      wings.set(key, [...(wings.get(key) ?? []), wing]);
    }
  }
  return [...wings].flatMap(([key, [one, other, more]]) => {
    if (!one || !other || more || one.opposite === other.opposite) return [];
    const ends = [...key.split(',').map(Number), one.opposite, other.opposite];
    const [p, q] = [one.cotangents, other.cotangents];
    const weights = [p[1] + q[1], p[0] + q[0], -p[0] - p[1], -q[0] - q[1]];
    const bend = weighted(
      ends.map((vertex) => places.get(vertex) ?? [NaN, NaN, NaN]),
      weights,
    );
    const share = (one.warp + other.warp) / 2;
    const stiffness = share * bendingWarp + (1 - share) * bendingWeft;
    return [{ends, weights, bend, stiffness: (hinge * stiffness) / (one.area + other.area)}];
  });
}

function wingOf(triangle: ClothTriangle, tip: number, from: number, to: number, warp: Point): Wing {
  const [p, q, r] = [at(triangle.cut, from), at(triangle.cut, to), at(triangle.cut, tip)];
  const edge = minus(q, p);
  const twice = 2 * cutArea(triangle);
  return {
    opposite: at(triangle.corners, tip),
    area: cutArea(triangle),
    cotangents: [dot(edge, minus(r, p)) / twice, -dot(edge, minus(r, q)) / twice],
    warp: 1 - (dot(edge, warp) / norm(edge)) ** 2,
  };
}
