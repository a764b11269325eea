/** What a worn garment's cloth resists with and what it weighs, from a drape file alone. SI units. */
import type {DrapeFile, Place} from '@/model/drape-file.js';
import {dot, minus, norm, towards, type Point} from '@/model/geometry.js';
import {at, sum} from './plane.js';
import type {ClothTriangle, SewnCloth} from './sewn-cloth.js';
import {dot3, minus3, norm3, plus3} from './space.js';

const gravity = 9.81;
/** What a bend of irregular triangles counts, so that a strip of them sags as a plate does. */
const hinge = 1.25;

type Fabric = DrapeFile['fabric'];

export interface Energies {
  readonly membrane: number;
  readonly bending: number;
  readonly weight: number;
}

/** [cm2] */
export function cutArea({cut: [a, b, c]}: ClothTriangle): number {
  const [u, v] = [minus(b, a), minus(c, a)];
  return (u[0] * v[1] - u[1] * v[0]) / 2;
}

/** Where a direction of the piece as cut leads in space: as long as it is stretched. */
export function imageOf({cut: [a, b, c], worn}: ClothTriangle, direction: Point): Place {
  const [u, v] = [minus(b, a), minus(c, a)];
  const area = u[0] * v[1] - u[1] * v[0];
  const s = (direction[0] * v[1] - direction[1] * v[0]) / area;
  const t = (u[0] * direction[1] - u[1] * direction[0]) / area;
  const along = plus3([0, 0, 0], minus3(worn[1], worn[0]), s);
  return plus3(along, minus3(worn[2], worn[0]), t);
}

/** Without what presses it on the form, which is too little to be seen in the sum. [J] */
export function energiesOf({pieces, fabric}: DrapeFile, cloth: SewnCloth): Energies {
  const whole = cloth.triangles.filter((triangle) => {
    return new Set(triangle.corners).size === 3 && cutArea(triangle) > 0;
  });
  const warpOf = ({piece}: ClothTriangle) => towards(at(pieces, piece).grainAngle);
  return {
    membrane: sum(whole.map((triangle) => membrane(triangle, warpOf(triangle), fabric))),
    bending: bending(whole, warpOf, fabric),
    weight: sum(
      whole.map((triangle) => {
        const height = sum(triangle.worn.map((place) => place[1])) / 3;
        return fabric.density * gravity * cutArea(triangle) * 1e-4 * height * 1e-2;
      }),
    ),
  };
}

function membrane(triangle: ClothTriangle, warp: Point, fabric: Fabric): number {
  const weftImage = imageOf(triangle, [warp[1], -warp[0]]);
  const warpImage = imageOf(triangle, warp);
  const [eu, ev] = [norm3(weftImage) - 1, norm3(warpImage) - 1];
  const skew = dot3(weftImage, warpImage);
  const perArea =
    spring(fabric, fabric.weft, eu) +
    spring(fabric, fabric.warp, ev) +
    fabric.coupling * eu * ev +
    (fabric.shear * skew ** 2) / 2;
  return perArea * cutArea(triangle) * 1e-4;
}

function spring({stiffFrom, stiffening}: Fabric, stiffness: number, strain: number): number {
  const beyond = Math.max(0, strain - stiffFrom);
  return (stiffness * (strain ** 2 + (stiffening - 1) * beyond ** 2)) / 2;
}

/** One triangle's part of the bend at its edge. */
interface Wing {
  readonly opposite: number;
  readonly area: number;
  /** Of its angles at the ends of the edge. */
  readonly cotangents: readonly [number, number];
  /** How far bending the edge bends the warp. */
  readonly warp: number;
}

/** Of edges with two triangles, also across seams. */
function bending(
  triangles: readonly ClothTriangle[],
  warpOf: (triangle: ClothTriangle) => Point,
  fabric: Fabric,
): number {
  const wings = new Map<string, Wing[]>();
  const places = new Map<number, Place>();
  for (const triangle of triangles) {
    for (const k of [0, 1, 2]) {
      places.set(at(triangle.corners, k), at(triangle.worn, k));
      const [from, to] = [(k + 1) % 3, (k + 2) % 3].sort(
        (a, b) => at(triangle.corners, a) - at(triangle.corners, b),
      ) as [number, number];
      const key = `${at(triangle.corners, from)},${at(triangle.corners, to)}`;
      const wing = wingOf(triangle, k, from, to, warpOf(triangle));
      wings.set(key, [...(wings.get(key) ?? []), wing]);
    }
  }
  const place = (vertex: number) => places.get(vertex) ?? ([NaN, NaN, NaN] as const);
  return sum(
    [...wings].map(([key, [one, other, more]]) => {
      if (!one || !other || more || one.opposite === other.opposite) return 0;
      const [from = NaN, to = NaN] = key.split(',').map(Number);
      let bend: Place = [0, 0, 0];
      for (const {opposite, cotangents} of [one, other]) {
        bend = plus3(bend, place(from), cotangents[1]);
        bend = plus3(bend, place(to), cotangents[0]);
        bend = plus3(bend, place(opposite), -cotangents[0] - cotangents[1]);
      }
      const share = (one.warp + other.warp) / 2;
      const stiffness = share * fabric.bendingWarp + (1 - share) * fabric.bendingWeft;
      return (hinge * stiffness * dot3(bend, bend)) / 2 / (one.area + other.area);
    }),
  );
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
