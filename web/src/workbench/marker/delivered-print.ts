/** The print of a design on fabric as delivered, as the user enters it. Lengths in cm. */
import {
  fabricOnly,
  printOf,
  type DeliveredPrint,
  type DesignPrint,
} from '../../model/design/design.js';
import {distance, norm} from '../../model/geometry/vectors.js';
import {asCut} from '../../model/print/as-cut.js';
import {asSewn, isSameFabric, withFabric} from '../../model/print/as-sewn.js';
import {rectangularRepeat, type Rectangle} from '../../model/print/rectangular-repeat.js';
import {latticeVectors, repeatOf} from '../../model/print/repeat.js';
import type {Delivered, Print} from '../../model/print/repeating-print.js';

type Stated = DeliveredPrint['stated'];

/** Repeats that differ by less are the same, as a share. */
const same = 1e-6;

/** The stated print after the wash of its fabric. */
function sewnFrom({group, size, turnDeg, cell}: Stated, fabric: Delivered): Print {
  const [w1, w2] = latticeVectors(group, size, turnDeg, cell);
  return asSewn(withFabric({group, w1, w2, cell}, fabric));
}

/**
 * The print before its fabric was considered. A print that was changed since then, such as in its
 * size, is taken back by its shrinkage alone.
 */
function statedOf(print: DesignPrint): Stated {
  const {group, size, turnDeg, cell, delivered} = print;
  if (!delivered) return {group, size, turnDeg, cell};
  const {stated} = delivered;
  const own = printOf(print);
  const sewn = sewnFrom(stated, fabricOnly(delivered));
  const isUnchanged =
    sewn.group === group &&
    (['w1', 'w2'] as const).every((w) => distance(sewn[w], own[w]) < same * norm(own[w]));
  return isUnchanged ? stated : {group, cell, ...repeatOf(asCut(own))};
}

/** The stated repeat straight across and up; undefined for a print without one, or without size. */
export function statedRepeat(print: DesignPrint): Rectangle | undefined {
  if (print.unscaled) return undefined;
  const {group, size, turnDeg, cell} = statedOf(print);
  const [w1, w2] = latticeVectors(group, size, turnDeg, cell);
  return rectangularRepeat({w1, w2});
}

/** The print on other fabric: after the wash, with the measured repeat. */
export function onDelivered(print: DesignPrint, fabric: Delivered): DesignPrint {
  const stated = statedOf(print);
  const own: DesignPrint = {...print, ...stated, delivered: undefined};
  if (isSameFabric(fabric)) return own;
  const sewn = sewnFrom(stated, fabric);
  return {
    ...own,
    ...{group: sewn.group, ...repeatOf(sewn), cell: sewn.cell ?? stated.cell},
    delivered: {...fabricOnly(fabric), stated},
  };
}
