import type {Point} from '../../model/geometry/vectors.js';

/** Directions of the arrow keys in an image, whose y axis points down. */
export const arrowSteps: Readonly<Record<string, Point>> = {
  ...{ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]},
};
