/** The print of a design on fabric as delivered, as the user enters it. Lengths in cm. */
import {fabricOnly, type DeliveredPrint, type DesignPrint} from '../../model/design/design.js';
import {asSewn, isSameFabric, withFabric} from '../../model/print/as-sewn.js';
import {rectangularRepeat, type Rectangle} from '../../model/print/rectangular-repeat.js';
import {latticeVectors, repeatOf} from '../../model/print/repeat.js';
import type {Delivered} from '../../model/print/repeating-print.js';

/** The print before its fabric was considered. */
const statedOf = ({
  group,
  size,
  turnDeg,
  cell,
  delivered,
}: DesignPrint): DeliveredPrint['stated'] => delivered?.stated ?? {group, size, turnDeg, cell};

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
  const [w1, w2] = latticeVectors(stated.group, stated.size, stated.turnDeg, stated.cell);
  const sewn = asSewn(withFabric({group: stated.group, w1, w2, cell: stated.cell}, fabric));
  return {
    ...own,
    ...{group: sewn.group, ...repeatOf(sewn), cell: sewn.cell},
    delivered: {...fabricOnly(fabric), stated},
  };
}
