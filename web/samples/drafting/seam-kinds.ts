/**
 * Default weight of each kind of seam, by a cutter's priorities. The middle of the body is the most
 * visible, then its sides; a seam under the arm or between the legs is rarely seen. A gathered seam
 * cannot match along its whole length, since its two sides differ in length.
 */
export const seamWeights = {
  centre: 2,
  front: 2, // a button front, a zip, a wrap: two sides next to each other in plain view
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
