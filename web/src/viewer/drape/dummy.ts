/** A tailor's dummy: the form in linen, with a cap on its neck, a pole and a foot. */
import type {Form, Surface} from '../../model/result/draped-garment.js';
import {normalsOf} from './cloth-layer.js';

type Colour = readonly [number, number, number];

const linen: Colour = [0xd9 / 255, 0xd2 / 255, 0xc4 / 255];
const wood: Colour = [0.56, 0.43, 0.31];

/** Gap between the lowest part and the floor. [cm] */
const clearance = 15;
/** Half width of the band around the middle plane that locates pole and cap. [cm] */
const middleBand = 2.5;
/** Least height above the nape of a form with a head, which needs no cap. [cm] */
const neckRoom = 14;
const segments = 40;

/** Triangles with positions, normals and colours as triples per vertex. */
export interface Solid {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly colours: Float32Array;
  readonly triangles: Uint32Array;
}

/** Radius and height, from one end to the other. [cm] */
type Profile = readonly (readonly [radius: number, height: number])[];

export const footRadius = 13.5;

/** Returns the body, all in linen. */
export function bodyOf({vertices, triangles}: Surface): Solid {
  const colours = new Float32Array(vertices.length);
  for (let k = 0; k < vertices.length; k += 3) colours.set(linen, k);
  return {positions: vertices, normals: normalsOf(vertices, triangles), colours, triangles};
}

/** Floor, and the parts that do not belong to the body. [cm] */
export interface Stand {
  readonly floor: number;
  readonly parts: Solid;
  /** Place of pole and foot, towards the front. */
  readonly middle: number;
}

/** @param lowest lowest point of the garment [cm] */
export function standOf({surface, body}: Form, lowest: number): Stand {
  const {vertices} = surface;
  let [bottom, top] = [Infinity, -Infinity];
  for (let k = 0; k < vertices.length; k += 3) {
    if (Math.abs(vertices[k] ?? 0) > middleBand) continue;
    bottom = Math.min(bottom, vertices[k + 1] ?? 0);
    top = Math.max(top, vertices[k + 1] ?? 0);
  }
  const middle = middleNear(vertices, bottom);
  const floor = Math.max(0, Math.min(lowest, bottom) - clearance);
  const standing = turnedSolid(
    [
      [0, floor],
      [footRadius, floor],
      [footRadius, floor + 0.8],
      [footRadius - 1, floor + 1.3],
      [5, floor + 2.2],
      [2.6, floor + 3.4],
      [1.5, floor + 6],
      [1.3, bottom + 2],
    ],
    middle,
  );
  const nape = body.waistHeight + body.backLength;
  const parts =
    top - nape > neckRoom
      ? standing
      : joined(standing, capOn(vertices, top, neckWidth(vertices, top)));
  return {floor, parts, middle};
}

/** Returns a disc on the neck, and a knob to lift the dummy. */
function capOn(vertices: Float32Array, top: number, radius: number): Solid {
  const profile: Profile = [
    [radius, top - 0.9],
    [radius, top + 0.1],
    [radius - 0.5, top + 0.7],
    [1.5, top + 1.1],
    [1, top + 2],
    [1.7, top + 3.2],
    [1.5, top + 4.4],
    [0.7, top + 5],
    [0, top + 5.1],
  ];
  return turnedSolid(profile, middleNear(vertices, top));
}

function neckWidth(vertices: Float32Array, top: number): number {
  let radius = 2;
  for (let k = 0; k < vertices.length; k += 3) {
    if ((vertices[k + 1] ?? 0) > top - 1.5) radius = Math.max(radius, Math.abs(vertices[k] ?? 0));
  }
  return radius;
}

/**
 * Returns the depth of the body's middle at a height, towards the front, in its middle plane. [cm]
 */
function middleNear(vertices: Float32Array, height: number): number {
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < vertices.length; k += 3) {
    const isThere =
      Math.abs(vertices[k] ?? 0) < middleBand && Math.abs((vertices[k + 1] ?? 0) - height) < 3;
    if (!isThere) continue;
    low = Math.min(low, vertices[k + 2] ?? 0);
    high = Math.max(high, vertices[k + 2] ?? 0);
  }
  return low > high ? 0 : (low + high) / 2;
}

/** Revolves a profile around a vertical axis; separate vertices keep its edges sharp. */
function turnedSolid(profile: Profile, middle: number): Solid {
  const bands = profile.length - 1;
  const count = bands * 2 * (segments + 1);
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  const colours = new Float32Array(3 * count);
  const triangles: number[] = [];
  let vertex = 0;
  for (let band = 0; band < bands; band++) {
    const [from, to] = [profile[band], profile[band + 1]];
    if (!from || !to) continue;
    const [out, up] = [to[1] - from[1], from[0] - to[0]];
    const length = Math.hypot(out, up) || 1;
    const first = vertex;
    for (let k = 0; k <= segments; k++) {
      const angle = (2 * Math.PI * k) / segments;
      const [s, c] = [Math.sin(angle), Math.cos(angle)];
      for (const [radius, height] of [from, to]) {
        positions.set([radius * s, height, middle + radius * c], 3 * vertex);
        normals.set([(out * s) / length, up / length, (out * c) / length], 3 * vertex);
        colours.set(wood, 3 * vertex);
        vertex++;
      }
      if (k === segments) continue;
      const at = first + 2 * k;
      triangles.push(at, at + 2, at + 1, at + 1, at + 2, at + 3);
    }
  }
  return {positions, normals, colours, triangles: Uint32Array.from(triangles)};
}

function joined(one: Solid, other: Solid): Solid {
  const both = (a: Float32Array, b: Float32Array): Float32Array => Float32Array.of(...a, ...b);
  const first = one.positions.length / 3;
  return {
    positions: both(one.positions, other.positions),
    normals: both(one.normals, other.normals),
    colours: both(one.colours, other.colours),
    triangles: Uint32Array.of(...one.triangles, ...other.triangles.map((k) => first + k)),
  };
}
