/** Photos of prints in the 17 groups. */
import type {GroupName} from '@/model/print/repeating-print.js';

import type {CaseHead, PhotoCase, PrintTruth} from './case.js';
import {Chance} from './chance.js';
import {conditionsOf, type Conditions, type PhotoLevel} from './conditions.js';
import type {Print} from './drawn-print.js';
import {clearlyBroken, floralPrint, type RandomPrint} from './floral-prints.js';
import {originNear, photographOf, type Photograph} from './photograph.js';
import {almostPrint, isStripe, specialPrints} from './special-prints.js';

/** Samples along a side of a cell: as many as the greatest repeat of an image has pixels. */
const samplesFor = (longerSide: number): number =>
  2 ** Math.max(8, Math.ceil(Math.log2(longerSide / 2.4)));

export interface PrintCase extends PhotoCase {
  readonly truth: CaseHead & PrintTruth;
}

/** @param broken  least share of its energy by which the print breaks a symmetry that it lacks */
export function printCase(
  head: Pick<CaseHead, 'name' | 'level' | 'kind' | 'seed' | 'f35'>,
  {pixels, view}: Photograph,
  {group, w1, w2, cell}: Print,
  broken: number,
): PrintCase {
  const {width, height} = pixels;
  return {
    truth: {
      ...head,
      width,
      height,
      group,
      ...view,
      w1,
      w2,
      origin: [0, 0],
      originPx: originNear(view, width, height),
      broken,
      near: broken < clearlyBroken,
    },
    pixels,
    cell,
  };
}

interface PrintCaseAsked {
  readonly name: string;
  readonly level: PhotoLevel;
  readonly seed: number;
  /** [px] */
  readonly size: readonly [number, number];
}

/** Photographs a print under the conditions of the level. */
async function taken(
  {name, level, seed, size}: PrintCaseAsked,
  kind: string,
  print: RandomPrint,
  chance: Chance,
): Promise<PhotoCase> {
  const conditions = conditionsOf(level, chance.branch());
  const framed = isStripe(kind) ? acrossStripes(conditions, print) : conditions;
  const photograph = await photographOf(print, framed, size, chance.branch());
  const f35 = level === 'scan' || conditions.crop < 1 ? null : conditions.f35;
  return printCase({name, level, kind, seed, f35}, photograph, print, print.broken);
}

/** Counts repeats across the stripes only, as the length along them is arbitrary. */
const acrossStripes = (conditions: Conditions, {w1, w2}: Print): Conditions => ({
  ...conditions,
  repeats: conditions.repeats * Math.sqrt(Math.hypot(...w1) / Math.hypot(...w2)),
});

export function floralCase(asked: PrintCaseAsked, group: GroupName): Promise<PhotoCase> {
  const chance = new Chance(asked.seed);
  const print = floralPrint(group, chance.branch(), samplesFor(Math.max(...asked.size)));
  return taken(asked, 'floral', print, chance);
}

/** @param kind  of `specialPrints` */
export function specialCase(asked: PrintCaseAsked, kind: string): Promise<PhotoCase> {
  const chance = new Chance(asked.seed);
  const make = specialPrints[kind];
  if (!make) throw new RangeError(`no print of the kind ${kind}`);
  return taken(asked, kind, make(chance.branch(), samplesFor(Math.max(...asked.size))), chance);
}

/** @param number  of the pair of groups in `almostPrint` */
export function almostCase(asked: PrintCaseAsked, number: number): Promise<PhotoCase> {
  const chance = new Chance(asked.seed);
  const print = almostPrint(number, chance.branch(), samplesFor(Math.max(...asked.size)));
  return taken(asked, 'almost', print, chance);
}
