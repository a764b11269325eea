/** Limits of a valid drape. */
import type {DrapeVerdict, Spread} from './judge.js';

/** Upper limits: strains as shares, lengths in cm. */
export interface DrapeLimits {
  readonly depth: number;
  readonly tension: Spread;
  /** For 99 of 100 triangles that are not beside gathers, and for edges along seams. */
  readonly compression: number;
  readonly sewnLength: number;
  readonly asymmetry: number;
  /** Relative difference between the file's last energy and that of its positions. */
  readonly energyOff: number;
  readonly crossings: number;
}

const usual: DrapeLimits = {
  depth: 0.05,
  tension: {median: 0.005, p99: 0.03, max: 0.1},
  compression: 0.08,
  sewnLength: 0.02,
  asymmetry: 1e-6,
  energyOff: 0.01,
  crossings: 0,
};
const greatestGap = 1e-4;
/** Least share of the fabric that keeps 0.5 mm of distance from the form. */
const leastClear = 0.99;
const farthestWaist = 3;

const percent = (share: number): string => `${(100 * share).toFixed(2)} %`;

/** Exceeded limits of a drape, a message each. @param given  limits other than the usual ones */
export function broken(verdict: DrapeVerdict, given: Partial<DrapeLimits> = {}): string[] {
  const limits = {...usual, ...given};
  const list = [...verdict.faults, ...verdict.rises];
  const must = (holds: boolean, sentence: string) => {
    if (!holds) list.push(sentence);
  };
  const {gap, depth, clear, tension, asymmetry, energyOff, crossings, waist} = verdict;
  const [compression, sewn] = [verdict.flatCompression.p99, verdict.sewnLength.p99];
  const {median, p99, max} = limits.tension;
  must(gap <= greatestGap, `seams gape by ${gap} cm`);
  must(depth <= limits.depth, `the fabric is ${depth} cm deep in the form`);
  must(clear >= leastClear, `only ${percent(clear)} of it are 0.5 mm off the form`);
  must(tension.median <= median, `half of it is stretched by ${percent(tension.median)}`);
  must(tension.p99 <= p99, `a hundredth of it is stretched by ${percent(tension.p99)}`);
  must(tension.max <= max, `a triangle is stretched by ${percent(tension.max)}`);
  const isPressed = compression > limits.compression;
  must(!isPressed, `a hundredth of it is compressed by ${percent(compression)}`);
  must(sewn <= limits.sewnLength, `seams differ by ${percent(sewn)} from their lengths as cut`);
  must(asymmetry <= limits.asymmetry, `it is ${asymmetry} cm from its mirror image`);
  const isStated = Math.abs(energyOff) <= limits.energyOff;
  must(isStated, `its energy is ${percent(energyOff)} from what the file says`);
  must(crossings <= limits.crossings, `${crossings} edges cross triangles`);
  must(verdict.lowest > 0, `it reaches ${-verdict.lowest} cm below the floor`);
  const isWorn = Math.abs(waist ?? 0) <= farthestWaist;
  must(isWorn, `its waist lies ${waist} cm above that of the form`);
  return list;
}
