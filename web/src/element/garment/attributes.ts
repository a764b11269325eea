/** Values of the element's attributes. Invalid values fall back to the default. */
import {optionLimits} from '../../model/base/core-tables.js';
import type {Units} from '../../model/base/length-text.js';
import {scaleLimits} from '../../model/print/print-scale.js';

export type GarmentView = 'pattern' | 'garment' | 'both';
export type GarmentCamera = 'front' | 'back' | 'left' | 'right' | 'three-quarter';
export type GarmentMode = 'preview' | 'place' | 'edit';
export type GarmentLoading = 'lazy' | 'eager';

/** Attributes in the order of the documentation. */
export const attributes = [
  ...['garment', 'size', 'print', 'colourway', 'print-sizes', 'symmetry', 'max-change-mm'],
  ...['view', 'dummy', 'fabric', 'camera', 'turntable', 'cloth-width', 'selvedge'],
  ...['mode', 'loading', 'units', 'locale', 'lang', 'alt', 'worker-url', 'wasm-url'],
  ...['name', 'required', 'disabled'],
] as const;

/**
 * Attributes by the spelling of their properties in lower case, as a server writes them into
 * markup. Frameworks that hydrate such markup do not set the property again.
 */
export const spellings: ReadonlyMap<string, string> = new Map(
  attributes
    .filter((name) => name.includes('-'))
    .map((name) => [name.replaceAll('-', ''), name] as const),
);

/** Attributes that change the request to the solver. */
export const asking: ReadonlySet<string> = new Set([
  ...['garment', 'size', 'print', 'colourway', 'symmetry', 'max-change-mm'],
  ...['worker-url', 'wasm-url'],
]);

const usualChange = 10;
const usualSelvedge = 1;
const greatestChange = 10 * optionLimits.maxChangeCm[1];

/** Returns one of the words, regardless of capitals; the first for any other. */
export const wordOf = <const T extends string>(
  written: string | null,
  words: readonly [T, ...T[]],
): T => words.find((word) => word === written?.trim().toLowerCase()) ?? words[0];

/** Greatest movement of an outline. [mm] */
export function changeOf(written: string | null): number {
  const value = written?.trim() ? Number(written) : usualChange;
  return value >= 0 && value <= greatestChange ? value : usualChange;
}

/** Fabric width; null for an invalid one. [cm] */
export function clothWidthOf(written: string | null): number | null {
  const width = Number(written);
  return width > 0 && width < Infinity ? width : null;
}

/** Sizes of the print, as multiples of its own; invalid ones are left out. */
export function printSizesOf(written: string | null): readonly number[] {
  const [least, most] = scaleLimits;
  return (written ?? '')
    .split(/[\s,]+/)
    .map(Number)
    .filter((size) => size >= least && size <= most);
}

/** Selvedge. [cm] */
export function selvedgeOf(written: string | null): number {
  const selvedge = written?.trim() ? Number(written) : usualSelvedge;
  return selvedge >= 0 && selvedge < Infinity ? selvedge : usualSelvedge;
}

export const unitsOf = (written: string | null): Units =>
  wordOf(written, ['cm', 'inch', 'in']) === 'cm' ? 'cm' : 'inch';

/** Returns the first valid locale. */
export function localeOf(...candidates: readonly (string | null | undefined)[]): string {
  return candidates.find((one) => isLocale(one)) ?? 'en';
}

function isLocale(written: string | null | undefined): written is string {
  if (!written) return false;
  try {
    return new Intl.Locale(written).language !== '';
  } catch {
    return false;
  }
}
