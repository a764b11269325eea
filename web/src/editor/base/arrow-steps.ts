import type {Point} from '../../model/geometry.js';

/** Which way the arrow keys move on a picture, whose y runs down. */
export const arrowSteps: Readonly<Record<string, Point>> = {
  ...{ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]},
};
