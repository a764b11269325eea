/** Photographs of prints in the 17 groups. */
import type {GroupName} from '@/model/print.js';

import type {CaseHead, PhotoCase} from './case.js';
import {Chance} from './chance.js';
import {conditionsOf, type PhotoLevel} from './conditions.js';
import type {Print} from './drawn-print.js';
import {clearlyBroken, floralPrint} from './floral-prints.js';
import {originNear, photographOf, type Photograph} from './photograph.js';

/** Samples along a side of a cell: as many as the greatest repeat of a picture has pixels. */
export const samplesFor = (longerSide: number): number =>
  2 ** Math.max(8, Math.ceil(Math.log2(longerSide / 2.4)));

/** @param broken least share of its energy by which the print breaks what it lacks */
export function printCase(
  head: Pick<CaseHead, 'name' | 'level' | 'kind' | 'seed' | 'f35'>,
  {pixels, view}: Photograph,
  {group, w1, w2, cell}: Print,
  broken: number,
): PhotoCase {
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

export interface PrintCaseAsked {
  readonly name: string;
  readonly group: GroupName;
  readonly level: PhotoLevel;
  readonly seed: number;
  readonly size: readonly [number, number];
}

export async function floralCase({name, group, level, seed, size}: PrintCaseAsked): Promise<PhotoCase> {
  const chance = new Chance(seed);
  const print = floralPrint(group, chance.branch(), samplesFor(Math.max(...size)));
  const conditions = conditionsOf(level, chance.branch());
  const photograph = await photographOf(print, conditions, size, chance.branch());
  const f35 = level === 'scan' || conditions.crop < 1 ? null : conditions.f35;
  return printCase({name, level, kind: 'floral', seed, f35}, photograph, print, print.broken);
}
