/** Images in linear light, and as in files. */
import {toGamma} from './inks.js';

export interface LightPicture {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue, linear; 1 saturates the sensor. */
  readonly planes: readonly [Float32Array, Float32Array, Float32Array];
}

export interface Rgba {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray;
}

export function darkPicture(width: number, height: number): LightPicture {
  const plane = (): Float32Array => new Float32Array(width * height);
  return {width, height, planes: [plane(), plane(), plane()]};
}

const codes = 65535;
const gammaTable = Float32Array.from({length: codes + 1}, (_, k) => 255 * toGamma(k / codes));

/** Gamma-coded, 0 to 255, not yet rounded; clipped like a sensor's values. */
export function coded({planes, ...size}: LightPicture): LightPicture {
  const code = (plane: Float32Array): Float32Array =>
    plane.map((x) => gammaTable[x <= 0 ? 0 : x >= 1 ? codes : Math.round(x * codes)] ?? 0);
  return {...size, planes: [code(planes[0]), code(planes[1]), code(planes[2])]};
}

/** @param picture  gamma-coded */
export function rgba({width, height, planes}: LightPicture): Rgba {
  const data = new Uint8ClampedArray(4 * width * height);
  planes.forEach((plane, c) => {
    for (let k = 0; k < plane.length; k++) data[4 * k + c] = plane[k] ?? 0;
  });
  for (let k = 3; k < data.length; k += 4) data[k] = 255;
  return {width, height, data};
}

/** Pixels of a rectangle inside the image. */
export function cropped(
  {width, data}: Rgba,
  left: number,
  top: number,
  w: number,
  h: number,
): Rgba {
  const out = new Uint8ClampedArray(4 * w * h);
  for (let y = 0; y < h; y++) {
    const from = 4 * ((top + y) * width + left);
    out.set(data.subarray(from, from + 4 * w), 4 * y * w);
  }
  return {width: w, height: h, data: out};
}
