/** A photo of fabric, with its ground truth. */
import type {Point} from '@/model/geometry/vectors.js';

import {applied, homographyOf, inverse, type LatticeView, type Matrix3} from './camera.js';
import type {Chance} from './chance.js';
import {fabricPicture, printSampler, type Sampler} from './fabric-picture.js';
import type {Conditions} from './conditions.js';
import {creases} from './creases.js';
import type {Print} from './drawn-print.js';
import {throughJpeg} from './files.js';
import {lightOf} from './lamps.js';
import {coded, cropped, rgba, type Rgba} from './pixels.js';
import {defocused, noisy, sharpened, shaken} from './sensor.js';

export interface Photograph {
  readonly pixels: Rgba;
  readonly view: LatticeView;
}

/** The two vectors of the coordinates of the photographed scene. [cm] */
export type Sides = Pick<Print, 'w1' | 'w2'>;

function viewOf(
  {w1, w2}: Sides,
  {f35, tilt, axis, turn, repeats, cellsShown, lens}: Conditions,
  [width, height]: readonly [number, number],
  chance: Chance,
): LatticeView {
  const area = w1[0] * w2[1] - w1[1] * w2[0];
  const longest = Math.max(Math.hypot(...w1), Math.hypot(...w2));
  const longer = Math.max(width, height);
  const shorter = Math.min(width, height);
  const pxPerCm = Math.min(
    longer / (repeats * Math.sqrt(area)),
    cellsShown > 0 ? shorter / (cellsShown * longest) : Infinity,
  );
  const middle: Point = [chance.next(), chance.next()];
  const pose = {width, height, f35, tilt, axis, turn, pxPerCm, middle};
  return {
    homography: homographyOf(pose, w1, w2),
    lens,
    lensMiddle: [width / 2, height / 2],
    lensRadius: longer / 2,
  };
}

/** Photographs a scene given by lattice coordinates. */
export async function photographed(
  sampler: (view: LatticeView) => Sampler,
  sides: Sides,
  conditions: Conditions,
  size: readonly [number, number],
  chance: Chance,
): Promise<Photograph> {
  const [width, height] = size;
  const view = viewOf(sides, conditions, size, chance);
  const threads = chance.between(0.2, Math.PI / 2 - 0.2);
  const wave: Point = [20 * Math.cos(threads), 20 * Math.sin(threads)]; // 20 threads a cm
  const light = picture(sampler(view), view, sides, wave, conditions, size, chance);
  const exposed = noisy(
    shaken(defocused(light, conditions.defocus), conditions.motion, chance.between(0, Math.PI)),
    conditions.iso,
    chance,
  );
  const whole = rgba(sharpened(coded(exposed), conditions.halo));
  const {pixels, left, top} = cut(whole, conditions.crop, chance);
  return {
    pixels: await throughJpeg(pixels, conditions.quality),
    view:
      left === 0 && top === 0 && pixels.width === width && pixels.height === height
        ? view
        : moved(view, left, top),
  };
}

function picture(
  sampler: Sampler,
  view: LatticeView,
  {w1, w2}: Sides,
  wave: Point,
  conditions: Conditions,
  [width, height]: readonly [number, number],
  chance: Chance,
) {
  const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];
  return fabricPicture(sampler, view, [width, height], {
    creases:
      conditions.creases > 0
        ? creases(view.homography, width, height, conditions.creases, chance)
        : undefined,
    weave: {strength: conditions.weave, waves: [dot(wave, w1), dot(wave, w2)]},
    light: lightOf(conditions.lamps, width, height, chance),
  });
}

function cut(
  whole: Rgba,
  share: number,
  chance: Chance,
): {pixels: Rgba; left: number; top: number} {
  if (share >= 1) return {pixels: whole, left: 0, top: 0};
  const w = Math.round(whole.width * share);
  const h = Math.round(whole.height * share);
  const left = chance.whole(0, whole.width - w);
  const top = chance.whole(0, whole.height - h);
  return {pixels: cropped(whole, left, top, w, h), left, top};
}

function moved(view: LatticeView, left: number, top: number): LatticeView {
  const h = view.homography;
  // prettier-ignore
  const homography: Matrix3 = [
    h[0] - left * h[6], h[1] - left * h[7], h[2] - left * h[8],
    h[3] - top * h[6], h[4] - top * h[7], h[5] - top * h[8],
    h[6], h[7], h[8],
  ];
  return {
    ...view,
    homography,
    lensMiddle: [view.lensMiddle[0] - left, view.lensMiddle[1] - top],
  };
}

/** Photographs a print. */
export const photographOf = (
  print: Print,
  conditions: Conditions,
  size: readonly [number, number],
  chance: Chance,
): Promise<Photograph> =>
  photographed((view) => printSampler(print, view, ...size), print, conditions, size, chance);

/** The lattice point of the group's origin nearest to the image's middle. [px] */
export function originNear(view: LatticeView, width: number, height: number): Point {
  const [u, v] = applied(inverse(view.homography), [width / 2, height / 2]);
  return applied(view.homography, [Math.round(u), Math.round(v)]);
}
