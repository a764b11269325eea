/** The part of a print on which two points are measured. */
import {printOf, type DesignPrint} from '../../model/design.js';
import {norm} from '../../model/geometry.js';
import {imageCell} from '../../model/wallpaper.js';

/** Least shorter side of the window, as a share of the longer one. */
const narrowest = 0.4;

/** Returns the displayed part of a print: one cell on the fabric, turned by whole quarters. [cm] */
export function windowOn(print: DesignPrint) {
  const [a, b] = imageCell(printOf({...print, turnDeg: 90 * Math.round(print.turnDeg / 90)}));
  const reach = (k: 0 | 1): readonly [number, number] => {
    const corners = [0, a[k], b[k], a[k] + b[k]];
    return [Math.min(...corners), Math.max(...corners)];
  };
  const [[left, right], [bottom, top]] = [reach(0), reach(1)];
  // shows enough of a stripe to point at, since it may repeat after a few millimetres
  const longest = Math.max(right - left, top - bottom);
  const side = (length: number): number => Math.max(length, narrowest * longest);
  const sides = [norm(a), norm(b)] as const;
  // y points down in the image, against the second side of the cell
  const matrix = [
    ...[a[0] / sides[0], -a[1] / sides[0], -b[0] / sides[1], b[1] / sides[1]],
    ...[b[0] - left, top - b[1]],
  ];
  return {width: side(right - left), height: side(top - bottom), sides, matrix};
}
