import type {Measurements} from '../../src/model/result/draped-garment.js';

/** Measurements for drafting, in cm, of a standing body that faces +z with the floor at y = 0. */
export type Body = Measurements;

export const sizeNames = ['xs', 's', 'm', 'l', 'xl'] as const;
export type SizeName = (typeof sizeNames)[number];

/**
 * Women's girths of EN 13402-3 (Size designation of clothes, part 3), one row in the range of each
 * letter code: bust 74-82 is XS, 82-90 S, 90-98 M, 98-107 L, 107-119 XL.
 */
const girths: Readonly<Record<SizeName, Pick<Body, 'bust' | 'waist' | 'hip'>>> = {
  xs: {bust: 80, waist: 64, hip: 88},
  s: {bust: 88, waist: 72, hip: 96},
  m: {bust: 96, waist: 80, hip: 104},
  l: {bust: 104, waist: 88, hip: 112},
  xl: {bust: 116, waist: 101, hip: 122},
};

/**
 * Measurements that the standard leaves open: the average woman of the FreeSewing models
 * (freesewing.org, package "models", MIT) with a bust of 92.5, and the share of a change of girth
 * that each measurement follows there.
 */
const averageBust = 92.5;
const others = {
  neck: [34, 1],
  head: [56.5, 0.35],
  upperArm: [27, 1],
  wrist: [16.5, 0.5],
  thigh: [57, 0.45],
  knee: [38, 0.65],
  ankle: [24.5, 1],
  shoulderWidth: [41.5, 0.65],
  bustSpan: [16, 0.5],
  backLength: [39.5, 0.65],
  hipDepth: [25, 0.65],
  bodyRise: [27, 0.65],
  armLength: [59, 0.3],
  waistHeight: [105, 0.4],
  kneeDepth: [60, 0.65],
} as const satisfies Readonly<
  Record<Exclude<keyof Body, 'bust' | 'waist' | 'hip'>, readonly [average: number, share: number]>
>;

type Other = keyof typeof others;

/** The body measurements of a size. */
export function bodyOf(size: SizeName): Body {
  const more = girths[size].bust / averageBust - 1;
  const graded = ([average, share]: readonly [number, number]): number =>
    Number((average * (1 + share * more)).toFixed(1));
  const entries = Object.entries(others).map(([name, how]) => [name, graded(how)] as const);
  return {...girths[size], ...(Object.fromEntries(entries) as Record<Other, number>)};
}

/** The radius of a round body of this girth: the distance of a piece from the middle. */
export const radiusOf = (girth: number): number => girth / (2 * Math.PI);
