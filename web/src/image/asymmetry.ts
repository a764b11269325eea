/** Describes the symmetries of its group that an image lacks, in terms that people notice. */
import {angleOf, degrees} from '../model/geometry/vectors.js';
import type {GroupName} from '../model/print/repeating-print.js';
import {determinant, type PlaneMap} from '../model/geometry/plane-map.js';
import {visibleDifference, type TileCheck} from './tile-check.js';
import type {Pixels} from './tile-fabric.js';

/** `steps`: a glide reflection, as of footprints. */
const asymmetries = [
  ...(['leftRight', 'topBottom', 'diagonal', 'slanted', 'steps'] as const),
  ...(['upsideDown', 'quarterTurn', 'thirdTurn', 'sixthTurn', 'halfDrop'] as const),
] as const;

export type Asymmetry = (typeof asymmetries)[number];

const turns: ReadonlyMap<number, Asymmetry> = new Map([
  [180, 'upsideDown'],
  [90, 'quarterTurn'],
  [120, 'thirdTurn'],
  [60, 'sixthTurn'],
]);

/** @param turnDeg rotation of the displayed image, counter-clockwise, in multiples of 90 */
function kindOf(group: GroupName, map: PlaneMap, turnDeg: number): Asymmetry {
  const angle = Math.round(degrees(angleOf([map.xx, map.yx])));
  if (determinant(map) > 0) {
    return turns.get(Math.abs(angle)) ?? 'halfDrop';
  }
  const axis = (((angle / 2 + turnDeg) % 180) + 180) % 180;
  const across = angle / 2 === 90 || angle / 2 === -90;
  if (group === 'pg' || group === 'pgg' || (group === 'pmg' && across)) return 'steps';
  if (axis % 90 === 0) return axis === 90 ? 'leftRight' : 'topBottom';
  return axis % 45 === 0 ? 'diagonal' : 'slanted';
}

/** Missing symmetries, the most obvious first; empty if the image has them all. */
export function asymmetriesOf(
  {elements, breaks}: TileCheck,
  group: GroupName,
  turnDeg: number,
): readonly Asymmetry[] {
  if (breaks.length === 0) return [];
  const greatest = Math.max(...elements.map(({worst}) => worst));
  const least = Math.min(greatest, 2 * visibleDifference);
  const found = elements
    .filter(({worst}) => worst >= least)
    .map(({map}) => kindOf(group, map, turnDeg));
  return asymmetries.filter((one) => found.includes(one));
}

/** Returns whether an image is constant along its rows or columns. */
export function isStriped({width, height, data}: Pixels): boolean {
  const apart = (step: number, isSkipped: (pixel: number) => boolean): number => {
    let [sum, count] = [0, 0];
    for (let pixel = 0; pixel + step < width * height; pixel++) {
      if (isSkipped(pixel)) continue;
      for (let ink = 0; ink < 3; ink++) {
        sum += Math.abs((data[4 * pixel + ink] ?? 0) - (data[4 * (pixel + step) + ink] ?? 0));
      }
      count += 3;
    }
    return count === 0 ? 0 : sum / count;
  };
  const along = apart(1, (pixel) => pixel % width === width - 1);
  const down = apart(width, () => false);
  return Math.min(along, down) < 0.5 && Math.max(along, down) > 1;
}
