/** The upright rectangle with which a print repeats, as print shops take it. */
import {combined, norm, type Point} from '../geometry/vectors.js';
import type {Repeat} from './wallpaper.js';

/** Sides of a rectangle. [cm] */
export interface Rectangle {
  readonly width: number;
  readonly height: number;
}

/** Greatest number of steps along w1 and w2; larger rectangles are of no use to a print shop. */
const reach = 12;
/** Greatest slant of a side, as a share of its length; files round their vectors. */
const tolerance = 1e-5;

/**
 * The smallest upright rectangle that tiles a print; undefined if there is none of at most twelve
 * repeats each way. A lattice point is its lower left corner.
 */
export function rectangularRepeat({w1, w2}: Pick<Repeat, 'w1' | 'w2'>): Rectangle | undefined {
  const steps = Array.from({length: 2 * reach + 1}, (_, k) => k - reach);
  const vectors = steps.flatMap((i) => steps.map((j) => combined([w1, w2], i, j)));
  const least = (along: 0 | 1): number | undefined => {
    const lengths = vectors
      .filter((v) => v[along] > 0 && Math.abs(v[1 - along] ?? 0) <= tolerance * norm(v))
      .map((v: Point) => v[along]);
    return lengths.length > 0 ? Math.min(...lengths) : undefined;
  };
  const [width, height] = [least(0), least(1)];
  return width === undefined || height === undefined ? undefined : {width, height};
}
