/** Random settings for layouts, the same for the same number. */
import type {MarkerSettings, Nap} from 'seamwise/node';

import {warpRepeat} from '@/marker/repeats.js';
import {mirrorLines} from '@/model/print/mirror-lines.js';
import type {Point} from '@/model/geometry/vectors.js';
import type {Repeat} from '@/model/print/wallpaper.js';
import type {PlanRules} from './plan-rules.js';
import {at} from '../plane.js';

/** A sequence of random numbers from 0 to 1. */
export function chance(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    const mixed = Math.imul(state ^ (state >>> 15), state | 1);
    const more = mixed ^ (mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61));
    return ((more ^ (more >>> 14)) >>> 0) / 2 ** 32;
  };
}

interface RandomLay {
  readonly settings: MarkerSettings;
  /** Rules that a check needs in addition to the plan. */
  readonly rules: PlanRules;
}

export function randomLay(repeat: Repeat, next: () => number): RandomLay {
  const pick = <T>(choices: readonly T[]): T => at(choices, Math.floor(next() * choices.length));
  const length = (least: number, most: number): number =>
    Math.round(10 * (least + next() * (most - least))) / 10;
  const isMirrored = mirrorLines(repeat).some(({along}) => Math.abs(along[0]) < 1e-6);
  const fold = next() < 0.25 && isMirrored;
  const widthCm = fold ? length(170, 300) : length(90, 200);
  const box = (): readonly Point[] => {
    const [x, y, w, h] = [length(0, widthCm), length(0, 200), length(1, 15), length(1, 15)];
    return [
      [x, y],
      [x + w, y],
      [x + w, y + h],
      [x, y + h],
    ];
  };
  const flaws = Array.from({length: pick([0, 0, 0, 1, 3])}, box);
  const nap = pick<Nap>(['none', 'none', 'garment', 'one-way']);
  const shift = pick(['kept', 'component'] as const);
  const copies = fold ? 2 : pick([1, 1, 2]);
  const plies = pick([1, 1, 1, 4]);
  const [isPlaced, isStarted, ignoresPrint] = [next() < 0.6, next() < 0.2, next() < 0.1];
  const settings = {
    ...{widthCm, fold, nap, shift, copies, plies, flaws, ignoresPrint},
    ...{gapCm: pick([0, 0.2, 0.5, 1]), selvedgeCm: pick([0, 1, 2])},
    ...{allowanceCm: pick([0.5, 1, 1.5]), effort: pick([0, 0.02, 0.1])},
    ...{seed: Math.floor(1000 * next()), widthsCm: pick([[], [140]])},
    ...(isPlaced && {phaseCm: length(0, 40)}),
    ...(isStarted && {startCm: length(0, 20)}),
  };
  const isStartFixed = isStarted || flaws.length > 0;
  const wholeRepeats = plies > 1 && !ignoresPrint && warpRepeat(repeat) !== undefined;
  const rules: PlanRules = {
    turns: () => 'half',
    ...{copies, nap, shift: fold ? 'kept' : shift, flaws, isStartFixed, wholeRepeats},
  };
  return {settings, rules};
}
