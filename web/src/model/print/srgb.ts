/** Conversion between coded pixel values and linear light, both 0 to 1 (IEC 61966-2-1). */
export const linearOf = (coded: number): number =>
  coded <= 0.04045 ? coded / 12.92 : ((coded + 0.055) / 1.055) ** 2.4;

export const codedOf = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
