/** Photos of prints with an object on the fabric, or a seam or fold in it. */
import {applied, inverse, repeatsAt, type LatticeView} from './camera.js';
import type {PhotoCase} from './case.js';
import {Chance} from './chance.js';
import {printSampler, type Sampler} from './fabric-picture.js';
import {conditionsOf} from './conditions.js';
import {covers, type Cover} from './covers.js';
import {floralPrint} from './floral-prints.js';
import {allGroups} from './group-elements.js';
import {photographed} from './photograph.js';
import {printCase} from './print-cases.js';

type Size = readonly [number, number];

/** Limits of the share of the image that a cover hides. */
const least = 0.01;
const most = 1 / 3;

/** Share of the image that a cover hides, before the tilt. */
function hiddenShare(cover: Cover, [width, height]: Size): number {
  const steps = 60;
  const ratio = height / width;
  let hidden = 0;
  for (let j = 0; j < steps; j++) {
    for (let i = 0; i < steps; i++) {
      const [x, y] = [(2 * (i + 0.5)) / steps - 1, ratio * ((2 * (j + 0.5)) / steps - 1)];
      if (cover.hides(x, y)) hidden += 1;
    }
  }
  return hidden / (steps * steps);
}

function coverOf(kind: string, size: Size, chance: Chance): Cover {
  const make = covers[kind];
  if (!make) throw new RangeError(`no cover of the kind ${kind}`);
  for (let attempt = 0; attempt < 400; attempt++) {
    const cover = make(chance.branch());
    const share = hiddenShare(cover, size);
    if (share > least && share < most) return cover;
  }
  throw new RangeError(`no ${kind} hides a third at most`);
}

/** The fabric with the cover on it. */
function covered(fabric: Sampler, cover: Cover, view: LatticeView, [width, height]: Size): Sampler {
  const middle = [width / 2, height / 2] as const;
  const [u0, v0] = applied(inverse(view.homography), middle);
  const [a, b] = repeatsAt(view.homography, middle);
  const unit = Math.max(width, height) / 2;
  return (u, v, out) => {
    const x = ((u - u0) * a[0] + (v - v0) * b[0]) / unit;
    const y = ((u - u0) * a[1] + (v - v0) * b[1]) / unit;
    const [du, dv] = cover.displaced?.(x, y) ?? [0, 0];
    fabric(u + du, v + dv, out);
    cover.paint(x, y, out);
  };
}

interface CoverCaseAsked {
  readonly name: string;
  readonly seed: number;
  /** [px] */
  readonly size: Size;
}

/** @param kind  of `covers` */
export async function coverCase(
  {name, seed, size}: CoverCaseAsked,
  kind: string,
): Promise<PhotoCase> {
  const chance = new Chance(seed);
  const print = floralPrint(chance.of(allGroups), chance.branch(), 512);
  const conditions = conditionsOf('normal', chance.branch());
  const cover = coverOf(kind, size, chance.branch());
  const photograph = await photographed(
    (view) => covered(printSampler(print, view, ...size), cover, view, size),
    print,
    conditions,
    size,
    chance.branch(),
  );
  const head = {name, level: 'covered', kind, seed, f35: conditions.f35} as const;
  return printCase(head, photograph, print, print.broken);
}

export const coverKinds: readonly string[] = Object.keys(covers);
