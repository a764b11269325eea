/** The common print of the garments on one fabric. Lengths in cm. */
import {SolverError} from '../model/base/failure.js';
import type {MarkerGarment} from '../model/design/marker-garment.js';
import {cross, distance, norm} from '../model/geometry/vectors.js';
import {asCut} from '../model/print/as-cut.js';
import {imageCell, type Repeat} from '../model/print/wallpaper.js';

/** Repeats of two results that differ by less are the same, as a share. */
const sameRepeat = 1e-5;

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/** The name of a garment in messages: its file, or its number. */
export const calledBy = ({name}: Pick<MarkerGarment, 'name'>, k: number): string =>
  name ?? `result ${k + 1}`;

type Solved = MarkerGarment['result']['print'];

const isSame = (one: Solved, other: Solved): boolean =>
  one.group === other.group &&
  (['w1', 'w2'] as const).every((w) => distance(one[w], other[w]) < sameRepeat * norm(one[w]));

const isSameWash = (one: Solved, other: Solved): boolean =>
  (['warp', 'weft'] as const).every(
    (way) =>
      Math.abs((one.delivered?.shrinkage?.[way] ?? 0) - (other.delivered?.shrinkage?.[way] ?? 0)) <
      1e-9,
  );

/** Returns whether two repeats have the same group and shape, in any size and turn. */
function isSimilar(one: Repeat, other: Repeat): boolean {
  const [mine, theirs] = [one, other].map(({w1, w2}) => {
    const unit = norm(w1);
    return [norm(w2) / unit, cross(w1, w2) / (unit * unit)] as const;
  });
  return (
    one.group === other.group &&
    [0, 1].every((k) => Math.abs((mine?.[k] ?? 0) - (theirs?.[k] ?? 0)) < 1e-4)
  );
}

const short = (cm: number): string => String(Number(cm.toFixed(2)));

/** The sides of the print's cell: "10 x 14 cm". */
function sizeWords(repeat: Repeat): string {
  const [across, up] = imageCell({...repeat, cell: 'rectangular'});
  return `${short(norm(across))} x ${short(norm(up))} cm`;
}

/** "A.json and C.json on 9.6 x 9.6 cm, B.json on 10.4 x 10.4 cm" */
function sizesOf(garments: readonly MarkerGarment[]): string {
  const bySize = new Map<string, string[]>();
  for (const [k, garment] of garments.entries()) {
    const words = sizeWords(garment.result.print);
    bySize.set(words, [...(bySize.get(words) ?? []), calledBy(garment, k)]);
  }
  return [...bySize].map(([size, names]) => `${names.join(' and ')} on ${size}`).join(', ');
}

/**
 * The print that all results share, as it measures on the fabric before a wash.
 * @throws {SolverError} if results have different prints or fabrics, or one print in several sizes
 */
export function commonPrint(garments: readonly MarkerGarment[]): Repeat {
  const [first, ...others] = garments;
  if (!first) throw wrong('There is no result to lay; name at least one.');
  const {print} = first.result;
  const k = others.findIndex(({result}) => !isSame(result.print, print));
  const shrunk = others.findIndex(({result}) => !isSameWash(result.print, print));
  const other = others[shrunk];
  if (other) {
    throw wrong(
      `${calledBy(other, shrunk + 1)} was solved for fabric of another shrinkage than ${calledBy(first, 0)}; align both for the same fabric.`,
    );
  }
  const differs = others[k];
  if (!differs) {
    const {w1, w2} = asCut(print);
    return {group: print.group, w1, w2};
  }
  if (isSimilar(differs.result.print, print)) {
    throw wrong(
      `One fabric has one size of the print, but the repeat differs between garments: ${sizesOf(garments)}; align all of them together, or each with the same --print-size and --print-turn.`,
    );
  }
  throw wrong(
    `${calledBy(differs, k + 1)} was solved for another group or repeat than ${calledBy(first, 0)}; lay results of one print together.`,
  );
}
