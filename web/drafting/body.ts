/** The measurements a garment is drafted from, in cm, of a standing body that faces +z with the floor at y = 0. */
export interface Body {
  /** Girths, taken with the tape level. */
  readonly bust: number;
  readonly waist: number;
  readonly hip: number;
  readonly neck: number;
  readonly upperArm: number;
  /** Between the two shoulder points, across the back. */
  readonly shoulderWidth: number;
  /** From the nape down to the waist. */
  readonly backLength: number;
  /** From the waist down to the fullest part of the hip. */
  readonly hipDepth: number;
  /** From the floor up to the waist. */
  readonly waistHeight: number;
}

/** The body the shipped garments are drafted for. */
export const sampleBody: Body = {
  bust: 92,
  waist: 74,
  hip: 98,
  neck: 36,
  upperArm: 29,
  shoulderWidth: 39,
  backLength: 41,
  hipDepth: 20,
  waistHeight: 104,
};

/** The radius of a body as round as this girth: how far from the middle a piece has to hang. */
export const radiusOf = (girth: number): number => girth / (2 * Math.PI);
