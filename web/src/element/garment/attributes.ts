/** What the element's attributes mean. Whatever is written in them, they mean something. */
import {optionLimits} from '../../model/core-tables.js';
import type {Units} from '../../model/units.js';

export type GarmentView = 'pattern' | 'garment' | 'both';
export type GarmentCamera = 'front' | 'back' | 'left' | 'right' | 'three-quarter';
export type GarmentMode = 'preview' | 'place' | 'edit';
export type GarmentLoading = 'lazy' | 'eager';

/** In the order of the documentation. */
export const attributes = [
  ...['garment', 'size', 'print', 'colourway', 'symmetry', 'max-change-mm'],
  ...['view', 'dummy', 'fabric', 'camera', 'turntable', 'cloth-width', 'selvedge'],
  ...['mode', 'loading', 'units', 'locale', 'lang', 'alt', 'worker-url', 'wasm-url'],
  ...['name', 'required', 'disabled'],
] as const;

/**
 * As a server writes a property into markup, which has no capitals: the attribute that is meant. Frameworks that
 * take such markup over do not set the property again.
 */
export const spellings: ReadonlyMap<string, string> = new Map(
  attributes
    .filter((name) => name.includes('-'))
    .map((name) => [name.replaceAll('-', ''), name] as const),
);

/** A change of one of these is another question to the solver. */
export const asking: ReadonlySet<string> = new Set([
  ...['garment', 'size', 'print', 'colourway', 'symmetry', 'max-change-mm'],
  ...['worker-url', 'wasm-url'],
]);

const usualChange = 10;
const usualSelvedge = 1;
const greatestChange = 10 * optionLimits.maxChangeCm[1];

/** One of the words, however it is capitalised; the first if it is another. */
export const wordOf = <const T extends string>(
  written: string | null,
  words: readonly [T, ...T[]],
): T => words.find((word) => word === written?.trim().toLowerCase()) ?? words[0];

/** [mm] */
export function changeOf(written: string | null): number {
  const value = written?.trim() ? Number(written) : usualChange;
  return value >= 0 && value <= greatestChange ? value : usualChange;
}

/** Nothing for what is no width. [cm] */
export function clothWidthOf(written: string | null): number | null {
  const width = Number(written);
  return width > 0 && width < Infinity ? width : null;
}

/** [cm] */
export function selvedgeOf(written: string | null): number {
  const selvedge = written?.trim() ? Number(written) : usualSelvedge;
  return selvedge >= 0 && selvedge < Infinity ? selvedge : usualSelvedge;
}

export const unitsOf = (written: string | null): Units =>
  wordOf(written, ['cm', 'inch', 'in']) === 'cm' ? 'cm' : 'inch';

/** The first that names a language. */
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
