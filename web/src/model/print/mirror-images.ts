/** Alignments in which two pieces show each other's mirror image on a print. */
import type {PlaneMap} from '../geometry/plane-map.js';
import {
  angleOf,
  minus,
  norm,
  plus,
  rotated,
  wrapped,
  type Alignment,
  type MirrorMap,
} from '../geometry/vectors.js';
import {mirrored, mirrorLines, type AngleRule} from './mirror-lines.js';
import {reduced, type Repeat} from './wallpaper.js';

/** The inverse map: from the second piece of a pair to the first. */
export function inverse({angle, translation: [x, y]}: MirrorMap): MirrorMap {
  const [tx, ty] = rotated([0 - x, y], angle);
  return {angle, translation: [0 - tx, 0 - ty]};
}

function imageBy(map: MirrorMap, first: Alignment, element: PlaneMap): Alignment {
  const turn = angleOf([element.xx, element.yx]);
  const angle = wrapped(map.angle - first.angle - turn - Math.PI);
  const [x, y] = rotated([0 - first.translation[0], first.translation[1]], map.angle);
  const [ax, ay] = rotated(element.shift, angle);
  return {angle, translation: [x + map.translation[0] - ax, y + map.translation[1] - ay]};
}

/**
 * The alignment of a pair's second piece that shows the mirror image of the first one's print.
 * Every mirror or glide of the print gives the same image; the result is the alignment nearest to
 * `like`. Undefined on a print that has neither.
 * @param map from the first piece to the second, p' = R F p + t
 */
export function mirrorAlignment(
  repeat: Repeat,
  map: MirrorMap,
  first: Alignment,
  like: Alignment = first,
): Alignment | undefined {
  const [nearest] = mirrored(repeat)
    .map((element) => imageBy(map, first, element))
    .map((image) => ({image, turn: Math.abs(wrapped(image.angle - like.angle))}))
    .sort((one, other) => one.turn - other.turn);
  if (!nearest) return undefined;
  const {angle, translation} = nearest.image;
  const off = rotated(minus(translation, like.translation), -angle);
  return {angle, translation: plus(like.translation, rotated(reduced(repeat, off), angle))};
}

/** Tolerance, equal to the solver's. [cm, over pieces of 10 cm] */
const exact = 1e-6;

/**
 * Returns whether two alignments show each other's mirror image. They belong to a pair, or both are
 * the same one of a symmetric piece.
 */
export function mirrors(
  repeat: Repeat,
  map: MirrorMap,
  first: Alignment,
  second: Alignment,
): boolean {
  return mirrored(repeat).some((element) => {
    const {angle, translation} = imageBy(map, first, element);
    const off = minus(second.translation, translation);
    return (
      Math.abs(wrapped(second.angle - angle)) < exact / 10 &&
      norm(reduced(repeat, rotated(off, -angle))) < exact / 2
    );
  });
}

/**
 * The least counter-clockwise turn of the print that lets a pair, or a symmetric piece, mirror and
 * keep its angles; 0 when no turn is needed. The group must carry the symmetry. [rad]
 */
export function turnToGrain(
  repeat: Repeat,
  map: MirrorMap,
  [first, second]: readonly [AngleRule | undefined, AngleRule | undefined],
  isSingle: boolean,
): number {
  if (!first || !second) return 0;
  // R(over) diag(1, -1) is the linear part of a mirror or glide of the print
  const overs = isSingle
    ? mirrorLines(repeat).map(({along}) => 2 * angleOf(along))
    : mirrored(repeat).map(({xx, yx}) => angleOf([xx, yx]));
  const turns = overs.flatMap((over) =>
    first.angles.flatMap((angle, k) =>
      (isSingle ? first.angles.slice(k, k + 1) : second.angles).map(
        // turning the print by a turns its axes by a, and `over` by 2 a
        (other) => wrapped(map.angle - angle - other - over - Math.PI) / 2,
      ),
    ),
  );
  const least = turns.reduce((one, other) => (Math.abs(other) < Math.abs(one) ? other : one), 4);
  return Math.abs(2 * least) <= first.tolerance + second.tolerance + 1e-6 ? 0 : least;
}
