/** Returns whether the main pointer is a finger. */
export const isTouched = (): boolean =>
  'matchMedia' in globalThis && matchMedia('(pointer: coarse)').matches;
