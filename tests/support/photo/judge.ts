/** Compares the output of `seamwise photo --json` with the truth of a case. */
import type {Point} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';

import {applied, inverse, repeatsAt, unlensed, type LatticeView, type Matrix3} from './camera.js';
import type {CaseHead, CaseTruth, PrintTruth} from './case.js';
import {elementsOf} from './group-elements.js';
import {agreement, type Basis} from './judge-groups.js';

/** The fields that are scored. There is no answer if the program refused the image. */
export interface PhotoAnswer {
  readonly homography: readonly number[];
  /** The origin nearest to the image's middle. [px] */
  readonly originPx: Point;
  readonly w1: Point | null;
  readonly w2: Point | null;
  readonly group: GroupName;
  readonly confidence: 'sure' | 'likely' | 'uncertain';
  readonly stripes: boolean;
}

export interface PrintVectors {
  readonly w1: Point;
  readonly w2: Point;
}

export interface Verdict {
  readonly name: string;
  readonly level: CaseTruth['level'];
  readonly kind: string;
  readonly answered: 'refused' | 'uncertain' | 'claimed';
  /** Undefined if there is nothing to compare. */
  readonly print: PrintVerdict | undefined;
}

interface PrintVerdict {
  /** The basis found spans exactly the print's lattice. */
  readonly primitive: boolean;
  /**
   * Cells of the print in the cell found; below 1 the answer claims a translation that the print
   * lacks.
   */
  readonly index: number;
  /** Greatest error of a basis vector at the image's middle, as a share of its length. */
  readonly latticeError: number;
  readonly exactGroup: boolean;
  /** True if the answer claims a symmetry that the print lacks, including translations. */
  readonly falseClaim: boolean;
  /** Distance of the origin from the nearest equivalent one, in square roots of the cell's area. */
  readonly originError: number;
  /**
   * Relative error of |w1| / |w2|, and error of their angle in degrees, if the answer has lengths
   * or a print is given.
   */
  readonly aspectError: number | undefined;
  readonly angleError: number | undefined;
  /** Relative error of their lengths, if the answer has lengths. */
  readonly scaleError: number | undefined;
  /** The print almost has a further symmetry; then claiming it is no mistake. */
  readonly near: boolean;
}

/** Integer combinations of the columns w1, w2. */
const columns = ([a, b]: Basis, [p, q, r, s]: readonly number[]): Basis => [
  [a[0] * (p ?? 0) + b[0] * (r ?? 0), a[1] * (p ?? 0) + b[1] * (r ?? 0)],
  [a[0] * (q ?? 0) + b[0] * (s ?? 0), a[1] * (q ?? 0) + b[1] * (s ?? 0)],
];

/** Coordinates of the vectors of `other` in `basis`, row by row. */
function within([a, b]: Basis, other: Basis): readonly number[] {
  const det = a[0] * b[1] - a[1] * b[0];
  const u = (v: Point): number => (v[0] * b[1] - v[1] * b[0]) / det;
  const v = (w: Point): number => (a[0] * w[1] - a[1] * w[0]) / det;
  return [u(other[0]), u(other[1]), v(other[0]), v(other[1])];
}

/** Position of a pixel's ray without the lens. */
function flattened(view: LatticeView, [x, y]: Point): Point {
  const dx = x - view.lensMiddle[0];
  const dy = y - view.lensMiddle[1];
  const factor = unlensed(view, dx * dx + dy * dy);
  return [view.lensMiddle[0] + factor * dx, view.lensMiddle[1] + factor * dy];
}

/** The print's w1, w2 as seen at a pixel, including the lens. [px] */
export function seenRepeats(view: LatticeView, at: Point): Basis {
  const flat = flattened(view, at);
  const [dx, dy] = [flat[0] - view.lensMiddle[0], flat[1] - view.lensMiddle[1]];
  const k = view.lens / view.lensRadius ** 2;
  const factor = 1 + k * (dx * dx + dy * dy);
  const through = ([x, y]: Point): Point => {
    const along = 2 * k * (dx * x + dy * y);
    return [factor * x + along * dx, factor * y + along * dy];
  };
  const [a, b] = repeatsAt(view.homography, flat);
  return [through(a), through(b)];
}

export const latticePoint = (view: LatticeView, at: Point): Point =>
  applied(inverse(view.homography), flattened(view, at));

const length = (v: Point): number => Math.hypot(...v);
const angle = ([a, b]: Basis): number =>
  (Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) * 180) / Math.PI;

/** The found basis at the image's middle in terms of the print's, not rounded. */
const changeOf = (truth: CaseHead & PrintTruth, {homography}: PhotoAnswer): readonly number[] => {
  const middle: Point = [truth.width / 2, truth.height / 2];
  const found = repeatsAt(homography as unknown as Matrix3, middle);
  return within(seenRepeats(truth, middle), found);
};

/** The answer's w1, w2 as integer columns in the print's lattice coordinates, row by row. */
export function basisFound(
  truth: CaseHead & PrintTruth,
  answer: PhotoAnswer,
): readonly [number, number, number, number] {
  const [p = 0, q = 0, r = 0, s = 0] = changeOf(truth, answer).map(Math.round);
  return [p, q, r, s];
}

function judgePrint(
  truth: CaseHead & PrintTruth,
  answer: PhotoAnswer,
  print: PrintVectors | undefined,
): PrintVerdict {
  const middle: Point = [truth.width / 2, truth.height / 2];
  const seen = seenRepeats(truth, middle);
  const found = repeatsAt(answer.homography as unknown as Matrix3, middle);
  const whole = basisFound(truth, answer);
  const [p, q, r, s] = whole;
  const nearest = columns(seen, whole);
  const latticeError = Math.max(
    ...([0, 1] as const).map(
      (k) =>
        Math.hypot(found[k][0] - nearest[k][0], found[k][1] - nearest[k][1]) / length(found[k]),
    ),
  );
  const [c0 = 0, c1 = 0, c2 = 0, c3 = 0] = changeOf(truth, answer);
  const index = c0 * c3 - c1 * c2;
  const primitive = p * s - q * r === 1 && latticeError < 0.05;
  const lengths = answer.w1 && answer.w2 ? ([answer.w1, answer.w2] as const) : undefined;
  const shape = lengths ?? (print && ([print.w1, print.w2] as const));
  const real = columns([truth.w1, truth.w2], whole);
  const ratio = ([a, b]: Basis): number => length(a) / length(b);
  const groups = primitive
    ? agreement(
        {group: truth.group, w1: truth.w1, w2: truth.w2},
        {group: answer.group, basis: [p, q, r, s], origin: latticePoint(truth, answer.originPx)},
      )
    : undefined;
  const [measured, proportions] = primitive ? [lengths, shape] : [];
  return {
    primitive,
    index,
    latticeError,
    exactGroup: primitive && answer.group === truth.group && groups?.holds === true,
    falseClaim: groups ? !groups.holds : index < 0.9 || elementsOf(answer.group).length > 1,
    originError: groups?.originError ?? Infinity,
    aspectError: proportions && ratio(proportions) / ratio(real) - 1,
    angleError: proportions && angle(proportions) - angle(real),
    scaleError: measured && length(measured[0]) / length(real[0]) - 1,
    near: truth.near,
  };
}

/** Stripes have only one period, which must be that of the print, across the stripes. */
function judgeStripes(truth: CaseHead & PrintTruth, answer: PhotoAnswer): PrintVerdict {
  const middle: Point = [truth.width / 2, truth.height / 2];
  const [across, along] = seenRepeats(truth, middle);
  const period = (basis: Basis): number => {
    // the found vector that differs most from the stripes' direction
    const out = basis.map((v) => Math.abs(v[0] * along[1] - v[1] * along[0]) / length(along));
    return Math.max(...out);
  };
  const found = period(repeatsAt(answer.homography as unknown as Matrix3, middle));
  const real = period([across, along]);
  const latticeError = Math.abs(found / real - 1);
  const even = (group: GroupName): boolean =>
    elementsOf(group).some(({m}) => m.join() === '-1,0,0,-1');
  return {
    primitive: latticeError < 0.05 && answer.stripes,
    index: found / real,
    latticeError,
    exactGroup: answer.group === truth.group,
    falseClaim: found / real < 0.9 || (even(answer.group) && !even(truth.group)),
    originError: 0,
    aspectError: undefined,
    angleError: undefined,
    scaleError: undefined,
    near: truth.near,
  };
}

/**
 * @param answer  undefined if the program refused the image
 * @param printed  its print as written by `--out`, in proportion only if the answer has no lengths
 */
export function judge(
  truth: CaseTruth,
  answer: PhotoAnswer | undefined,
  printed?: PrintVectors,
): Verdict {
  const {name, level, kind} = truth;
  const head = {name, level, kind};
  if (!answer) return {...head, answered: 'refused', print: undefined};
  const answered = answer.confidence === 'uncertain' ? 'uncertain' : 'claimed';
  if (truth.group === null) return {...head, answered, print: undefined};
  const print = kind.endsWith('-stripe')
    ? judgeStripes(truth, answer)
    : judgePrint(truth, answer, printed);
  return {...head, answered, print};
}
