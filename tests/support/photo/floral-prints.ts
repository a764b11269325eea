/** Random prints of motifs in a group, without further symmetry. */
import type {GroupName} from '@/model/print/repeating-print.js';
import type {Point} from '@/model/geometry/vectors.js';

import type {Chance} from './chance.js';
import {drawn, type Design, type Patch, type Print} from './drawn-print.js';
import {elementsOf, shapeOf, type Shape} from './group-elements.js';
import {palette, type Ink} from './inks.js';
import {blob, disc, flower, leaf, placed, stroke, type Outline} from './outlines.js';
import {nearSymmetries, SymmetryShares} from './symmetry-shares.js';

/**
 * Lattices whose sides and angle differ by no more than this could be mistaken for more special
 * ones.
 */
const likeness = 0.05;
/** A print lacks a symmetry that breaks at least this share of its energy. */
export const clearlyBroken = 0.06;
/** A smaller share is imperceptible; between the two the print almost has the symmetry. */
export const barelyBroken = 0.02;

/** w1 along +x, counter-clockwise. [cm] */
export function randomLattice(shape: Shape, chance: Chance): readonly [Point, Point] {
  const first = chance.between(4, 14);
  const of = (length: number, degrees: number): readonly [Point, Point] => {
    const angle = (degrees * Math.PI) / 180;
    return [
      [first, 0],
      [length * Math.cos(angle), length * Math.sin(angle)],
    ];
  };
  const other = Math.min(20, Math.max(4, first * chance.between(0.6, 1.7)));
  switch (shape) {
    case 'oblique':
      return of(other, chance.between(60, 120));
    case 'rectangular':
      return of(other, 90);
    case 'rhombic':
      return of(first, chance.between(45, 125));
    case 'square':
      return of(first, 90);
    case 'hexagonal':
      return of(first, 60);
  }
}

/** A lattice that the group allows; sometimes a more special one, which must not mislead. */
function latticeFor(group: GroupName, chance: Chance): readonly [Point, Point] {
  const own = shapeOf(group);
  const special: Readonly<Partial<Record<Shape, readonly Shape[]>>> = {
    oblique: ['rectangular', 'rhombic', 'square', 'hexagonal'],
    rectangular: ['square'],
    rhombic: ['square', 'hexagonal'],
  };
  const choices = special[own];
  return randomLattice(choices && chance.happens(0.3) ? chance.of(choices) : own, chance);
}

function motif(size: number, chance: Chance): Outline {
  const kind = chance.next();
  if (kind < 0.3) return blob(size * 0.75, chance);
  if (kind < 0.6) return leaf(size * 1.5, size * 0.35, chance.between(-0.5, 0.5));
  if (kind < 0.85)
    return stroke(size * 2, size * chance.between(0.12, 0.3), chance.between(-0.6, 0.6));
  return flower(size * 1.1, chance.whole(4, 7), chance);
}

/** Random motifs. @param order  of the group, which multiplies them */
export function randomPatches(
  w1: Point,
  w2: Point,
  order: number,
  chance: Chance,
  inks: readonly Ink[],
): readonly Patch[] {
  const area = w1[0] * w2[1] - w1[1] * w2[0];
  const count = Math.max(4, Math.round(chance.between(14, 44) / order));
  const size = Math.sqrt(area / (order * count)) * chance.between(0.45, 0.8);
  return Array.from({length: count}, () => {
    const at: Point = [chance.next(), chance.next()];
    const own = size * chance.between(0.5, 1.6);
    const turn = chance.between(0, 2 * Math.PI);
    const main = {outline: placed(motif(own, chance), 0, 0, turn), at, ink: chance.of(inks)};
    if (!chance.happens(0.4)) return [main];
    const eye = placed(disc(own * 0.22), own * 0.3, own * 0.1, turn);
    return [main, {outline: eye, at, ink: chance.of(inks)}];
  }).flat();
}

/** The least share of its energy by which a print breaks any symmetry that its group lacks. */
export function leastBroken({group, w1, w2, cell}: Print): number {
  const shares = new SymmetryShares(cell, w1, w2);
  const own = elementsOf(group).map(({m}) => m.join());
  return Math.min(
    shares.leastFraction(),
    ...nearSymmetries(w1, w2, likeness)
      .filter((m) => !own.includes(m.join()))
      .map((m) => shares.least(m)),
  );
}

export interface RandomPrint extends Print {
  /** The least share of its energy by which the print breaks a symmetry that it lacks. */
  readonly broken: number;
}

/** @param n  samples along a side of the cell, a power of two, 256 at least */
export function floralPrint(group: GroupName, chance: Chance, n: number): RandomPrint {
  const order = elementsOf(group).length;
  for (let attempt = 0; attempt < 400; attempt++) {
    const [w1, w2] = latticeFor(group, chance);
    const {ground, inks} = palette(chance);
    const patches = randomPatches(w1, w2, order, chance, inks);
    const design: Design = {group, w1, w2, ground, patches};
    const broken = leastBroken(drawn(design, 128));
    if (broken >= clearlyBroken) return {...drawn(design, n), broken};
  }
  throw new RangeError(`no print of ${group} breaks what it lacks`);
}
