/**
 * Misleading prints: half-drops, halves of a repeat that differ in colour alone, rows with one
 * mirrored motif.
 */
import type {Point} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';

import {bandKinds, bandPrint, stripePrint} from './band-prints.js';
import type {Chance} from './chance.js';
import {drawn, type Design, type Patch} from './drawn-print.js';
import {elementsOf, shapeOf} from './group-elements.js';
import {
  barelyBroken,
  clearlyBroken,
  leastBroken,
  randomLattice,
  randomPatches,
  type RandomPrint,
} from './floral-prints.js';
import {palette, type Ink} from './inks.js';
import {leaf, placed} from './outlines.js';

const tries = 400;

/** The first design that breaks every symmetry it lacks by at least 2 % of its energy. */
function accepted(design: () => Design, n: number): RandomPrint {
  for (let attempt = 0; attempt < tries; attempt++) {
    const one = design();
    const broken = leastBroken(drawn(one, 128));
    if (broken >= barelyBroken) return {...drawn(one, n), broken};
  }
  throw new RangeError('no design breaks what it lacks');
}

/** Columns side by side, every other one lower by half: w1 = (a, b / 2), w2 = (0, b). */
function halfDrop(chance: Chance, n: number): RandomPrint {
  return accepted(() => {
    const group = chance.of(['p1', 'p2'] as const);
    const a = chance.between(4, 10);
    const b = a * chance.between(0.8, 1.7);
    const {ground, inks} = palette(chance);
    const w1: Point = [a, b / 2];
    const w2: Point = [0, b];
    const patches = randomPatches(w1, w2, elementsOf(group).length, chance, inks);
    return {group, w1, w2, ground, patches};
  }, n);
}

/** The same shapes half a repeat further, with one ink exchanged. */
function halfAlike(chance: Chance, n: number): RandomPrint {
  return accepted(() => {
    const group: GroupName = chance.of(['p1', 'p2', 'pm'] as const);
    const a = chance.between(8, 14);
    const w1: Point = [a, 0];
    const w2: Point = [0, a * chance.between(0.5, 0.9)];
    const {ground, inks} = palette(chance);
    const [changed, ...others] = inks;
    const instead = others.at(-1);
    if (!changed || !instead) throw new RangeError('two inks are needed');
    const other = (ink: Ink): Ink => (ink === changed ? instead : ink);
    const order = 2 * elementsOf(group).length;
    const first = randomPatches(w1, w2, order, chance, inks);
    const second = first.map((patch): Patch => ({
      ...patch,
      at: [patch.at[0] + 0.5, patch.at[1]],
      ink: other(patch.ink),
    }));
    return {
      group,
      w1,
      w2,
      ground,
      patches: first.flatMap((patch, k) => [patch, ...second.slice(k, k + 1)]),
    };
  }, n);
}

/** Six leaves in a row, one of them mirrored. */
function oneOfSix(chance: Chance, n: number): RandomPrint {
  return accepted(() => {
    const step = chance.between(2.5, 3.3);
    const {ground, inks} = palette(chance);
    const w1: Point = [6 * step, 0];
    const w2: Point = [0, step * chance.between(1.2, 1.8)];
    const mirrored = chance.whole(0, 5);
    const bend = chance.between(0.35, 0.6);
    const turn = chance.between(0, 2 * Math.PI);
    const patches = Array.from({length: 6}, (_, k): Patch[] => {
      const side = k === mirrored ? -1 : 1;
      const at: Point = [(k + 0.5) / 6, 0.4];
      const half = step * 0.55;
      return [
        {
          outline: placed(leaf(2 * half, half * 0.35, side * bend), -half, 0, side * turn),
          at,
          ink: inks[0] ?? ground,
        },
        {
          outline: placed(leaf(half, half * 0.25, side * 0.4), 0, 0, side * (turn + 1.1)),
          at,
          ink: inks[1] ?? ground,
        },
      ];
    }).flat();
    return {group: 'p1', w1, w2, ground, patches};
  }, n);
}

/** A group, and the subgroup that a single motif reduces it to, on the same w1, w2. */
const lessened = [
  ['p4m', 'p4'],
  ['p6m', 'p6'],
  ['p31m', 'p3'],
  ['p3m1', 'p3'],
  ['pmm', 'p2'],
  ['pmg', 'p2'],
  ['cmm', 'p2'],
  ['cm', 'p1'],
] as const;

/**
 * A print of one of those groups except for a single motif: it almost has the first group's
 * symmetries.
 */
export function almostPrint(number: number, chance: Chance, n: number): RandomPrint {
  const [group, left] = lessened[number % lessened.length] ?? lessened[0];
  const order = elementsOf(group).length;
  for (let attempt = 0; attempt < tries; attempt++) {
    const [w1, w2] = randomLattice(shapeOf(group), chance);
    const {ground, inks} = palette(chance);
    const [single, ...patches] = randomPatches(w1, w2, order, chance, inks);
    if (!single) continue;
    const design: Design = {
      group,
      w1,
      w2,
      ground,
      patches: [...patches, {...single, group: left}],
    };
    const broken = leastBroken({...drawn(design, 128), group: left});
    if (broken >= barelyBroken && broken < clearlyBroken) {
      return {...drawn(design, n), group: left, broken};
    }
  }
  throw new RangeError(`no print of ${left} almost is of ${group}`);
}

/** Generators by kind; `n` samples along a side of the cell. */
export const specialPrints: Readonly<Record<string, (chance: Chance, n: number) => RandomPrint>> = {
  ...Object.fromEntries(
    bandKinds.map((kind) => [kind, (chance: Chance, n: number) => bandPrint(kind, chance, n)]),
  ),
  'even-stripe': (chance, n) => stripePrint(true, chance, n),
  'uneven-stripe': (chance, n) => stripePrint(false, chance, n),
  'half-drop': halfDrop,
  'half-alike': halfAlike,
  'one-of-six': oneOfSix,
};

export const isStripe = (kind: string): boolean => kind.endsWith('-stripe');
