/** Plaids and stripes: prints made of bands across the cell. */
import type {GroupName} from '@/model/print/repeating-print.js';
import type {Point} from '@/model/geometry/vectors.js';

import type {Chance} from './chance.js';
import {emptyCell, type Cell} from './drawn-print.js';
import {leastBroken, type RandomPrint} from './floral-prints.js';
import {palette, type Ink} from './inks.js';

/** A sett: colour along one direction of the cell, n samples; later bands cover earlier ones. */
type Sett = readonly Ink[];

interface Band {
  /** Middle and half width, as shares of the repeat. */
  readonly middle: number;
  readonly half: number;
  readonly ink: Ink;
}

/** Bands at the cell's samples, with mirrored ones in a symmetric sett. */
function settOf(bands: readonly Band[], ground: Ink, even: boolean, n: number): Sett {
  const coverage = (i: number, {middle, half}: Band): number => {
    const off = Math.abs(((((i / n - middle) % 1) + 1.5) % 1) - 0.5);
    return Math.max(0, Math.min(1, 0.5 + (half - off) * n));
  };
  return Array.from({length: n}, (_, i) =>
    bands.reduce<Ink>((below, band) => {
      const own = coverage(i, band);
      const share = even ? Math.max(own, coverage((n - i) % n, band)) : own;
      const mix = (c: 0 | 1 | 2): number => below[c] + share * (band.ink[c] - below[c]);
      return [mix(0), mix(1), mix(2)];
    }, ground),
  );
}

function randomBands(inks: readonly Ink[], chance: Chance): readonly Band[] {
  return Array.from({length: chance.whole(3, 5)}, () => ({
    middle: chance.next(),
    half: chance.between(0.01, 0.14),
    ink: chance.of(inks),
  }));
}

/**
 * Two bands that differ in colour only, half a repeat apart: half a repeat is no translation of the
 * print.
 */
const halfAlike = (inks: readonly Ink[], chance: Chance): readonly Band[] => {
  const half = chance.between(0.08, 0.2);
  const [first = inks[0], second = inks[1]] = [...inks].sort(() => chance.next() - 0.5);
  if (!first || !second) throw new RangeError('two inks are needed');
  return [
    {middle: 0, half, ink: first},
    {middle: 0.5, half, ink: second},
  ];
};

/** The warp runs along v, so its sett runs along u; each thread is visible half of the time. */
function woven(warp: Sett, weft: Sett, n: number): Cell {
  const cell = emptyCell(n, [0, 0, 0]);
  cell.planes.forEach((plane, c) => {
    for (let j = 0; j < n; j++) {
      const across = weft[j]?.[c] ?? 0;
      for (let i = 0; i < n; i++) plane[j * n + i] = 0.5 * (across + (warp[i]?.[c] ?? 0));
    }
  });
  return cell;
}

export const bandKinds = [
  'even-square-plaid',
  'even-oblong-plaid',
  'uneven-square-plaid',
  'uneven-plaid',
  'half-uneven-plaid',
  'half-alike-check',
] as const;
type BandKind = (typeof bandKinds)[number];

interface Woven {
  readonly group: GroupName;
  readonly square: boolean;
  readonly sett: (n: number) => readonly [Sett, Sett];
}

function wovenOf(kind: BandKind, chance: Chance): Woven {
  const {ground, inks} = palette(chance);
  const first = kind === 'half-alike-check' ? halfAlike(inks, chance) : randomBands(inks, chance);
  const second = randomBands(inks, chance);
  const along =
    (evens: readonly [boolean, boolean], same: boolean): Woven['sett'] =>
    (n) => [settOf(first, ground, evens[0], n), settOf(same ? first : second, ground, evens[1], n)];
  switch (kind) {
    case 'half-alike-check':
    case 'even-square-plaid':
      return {group: 'p4m', square: true, sett: along([true, true], true)};
    case 'even-oblong-plaid':
      return {group: 'pmm', square: false, sett: along([true, true], false)};
    case 'uneven-square-plaid':
      return {group: 'cm', square: true, sett: along([false, false], true)};
    case 'uneven-plaid':
      return {group: 'p1', square: chance.happens(0.5), sett: along([false, false], false)};
    case 'half-uneven-plaid':
      // w1 is parallel to the mirrors, so the symmetric sett runs along w2
      return {group: 'pm', square: chance.happens(0.5), sett: along([false, true], false)};
  }
}

/** @param n samples along a side, a power of two */
export function bandPrint(kind: BandKind, chance: Chance, n: number): RandomPrint {
  for (let attempt = 0; attempt < 200; attempt++) {
    const {group, square, sett} = wovenOf(kind, chance);
    const first = chance.between(4, 14);
    const second = square ? first : Math.min(20, first * chance.between(0.6, 1.7));
    const w1: Point = [first, 0];
    const w2: Point = [0, second];
    const print = {group, w1, w2, cell: woven(...sett(n), n)};
    const broken = leastBroken(print);
    if (broken >= 0.06) return {...print, broken};
  }
  throw new RangeError(`no ${kind} breaks what it lacks`);
}

/**
 * w1 across the stripes, w2 half a centimetre along them: an asymmetric stripe only has mirrors
 * perpendicular to it.
 */
export function stripePrint(even: boolean, chance: Chance, n: number): RandomPrint {
  for (let attempt = 0; attempt < 200; attempt++) {
    const {ground, inks} = palette(chance);
    const sett = settOf(randomBands(inks, chance), ground, even, n);
    const cell = woven(sett, sett, n);
    cell.planes.forEach((plane, c) => {
      for (let k = 0; k < plane.length; k++) plane[k] = sett[k % n]?.[c] ?? 0;
    });
    const w1: Point = [chance.between(3, 10), 0];
    // measured on a cell as high as it is wide, and along the stripe by halves only
    const broken = unevenness(sett);
    const periods = Math.min(...[2, 3, 4, 5, 6].map((parts) => shifted(sett, parts)));
    if (periods < 0.06 || (!even && broken < 0.06)) continue;
    return {
      group: even ? 'pmm' : 'pm',
      w1,
      w2: [0, 0.5],
      cell,
      broken: even ? periods : Math.min(broken, periods),
    };
  }
  throw new RangeError('no stripe breaks what it lacks');
}

/** Share of a sett's energy by which it differs from the permuted sett. */
function difference(sett: Sett, other: (i: number) => number): number {
  const n = sett.length;
  const mean = [0, 1, 2].map((c) => sett.reduce((sum, x) => sum + (x[c] ?? 0), 0) / n);
  let apart = 0;
  let energy = 0;
  sett.forEach((x, i) => {
    const y = sett[other(i)];
    for (let c = 0; c < 3; c++) {
      energy += ((x[c] ?? 0) - (mean[c] ?? 0)) ** 2;
      apart += ((x[c] ?? 0) - (y?.[c] ?? 0)) ** 2 / 2;
    }
  });
  return apart / energy;
}

function unevenness(sett: Sett): number {
  const n = sett.length;
  let least = Infinity;
  for (let sum = 0; sum < n; sum += Math.ceil(n / 128)) {
    least = Math.min(
      least,
      difference(sett, (i) => (sum - i + n) % n),
    );
  }
  return least;
}

function shifted(sett: Sett, parts: number): number {
  const n = sett.length;
  return Math.min(
    ...Array.from({length: parts - 1}, (_, k) =>
      difference(sett, (i) => (i + Math.round(((k + 1) * n) / parts)) % n),
    ),
  );
}
