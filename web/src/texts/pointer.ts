/** Where a finger is what points. */
export const isTouched = (): boolean =>
  'matchMedia' in globalThis && matchMedia('(pointer: coarse)').matches;
