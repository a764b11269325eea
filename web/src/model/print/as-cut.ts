/**
 * The print, and pieces, on fabric before the wash. A piece is cut larger along warp and weft by the
 * shrinkage of its fabric, and shows the same part of the print.
 */
import {rotated, type Alignment, type Point} from '../geometry/vectors.js';
import {settled} from './print-scale.js';
import type {Delivered, Print} from './repeating-print.js';

type Stretch = (v: Point) => Point;

/** Returns whether pieces have to be cut larger or smaller. */
export const shrinks = ({shrinkage}: Delivered = {}): boolean =>
  shrinkage !== undefined && (shrinkage.warp !== 0 || shrinkage.weft !== 0);

/** The map from fabric after the wash to fabric as delivered; x runs along the weft. */
const unwashed = ({shrinkage}: Delivered): Stretch => {
  const [across, up] = [shrinkage?.weft ?? 0, shrinkage?.warp ?? 0].map(
    (percent) => 1 / (1 - percent / 100),
  ) as [number, number];
  return ([x, y]) => [across * x, up * y];
};

/** The print as it measures on the fabric before the wash. */
export function asCut<P extends Pick<Print, 'w1' | 'w2' | 'delivered'>>(print: P): P {
  const {delivered = {}} = print;
  if (!shrinks(delivered)) return print;
  const of = unwashed(delivered);
  return {...print, w1: settled(of(print.w1)), w2: settled(of(print.w2))};
}

/** The map from points of a piece to those of the piece as it is cut. */
export function cutMap({angle}: Pick<Alignment, 'angle'>, delivered: Delivered = {}): Stretch {
  if (!shrinks(delivered)) return (p) => p;
  const of = unwashed(delivered);
  return (p) => rotated(of(rotated(p, -angle)), angle);
}

/** The alignment of a piece as it is cut. */
export const cutAlignment = (alignment: Alignment, delivered: Delivered = {}): Alignment =>
  shrinks(delivered)
    ? {...alignment, translation: cutMap(alignment, delivered)(alignment.translation)}
    : alignment;
