/**
 * How much each kind of seam counts by default, as a cutter ranks them: the eye runs down the middle of the
 * body first, then along the sides; a seam under the arm or between the legs is rarely seen. A gathered seam
 * cannot match all along, since its two sides differ in length.
 */
export const seamWeights = {
  centre: 2,
  front: 2, // a button front, a zip, a wrap: the two sides lie side by side before the eye
  princess: 1,
  side: 1,
  panel: 1, // gores, yokes, patches
  armhole: 0.75,
  waist: 0.75,
  pocket: 0.75,
  collar: 0.5,
  shoulder: 0.5,
  cuff: 0.5,
  dart: 0.5,
  underarm: 0.25,
  inseam: 0.25,
  facing: 0.25,
  gathered: 0.1,
} as const;

export type SeamKind = keyof typeof seamWeights;
