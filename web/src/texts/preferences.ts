/** Display preferences of a person, which are not part of any design. */
import type {Units} from '../model/base/length-text.js';
import type {MismatchScale} from '../scene/colours.js';
import type {Messages} from './messages.js';

export const languages = ['en', 'de', 'fr', 'es', 'it'] as const;
export type Language = (typeof languages)[number];

/** Each language in its own words, for users who read no other. */
export const languageNames = {
  en: 'English',
  de: 'Deutsch',
  fr: 'Français',
  es: 'Español',
  it: 'Italiano',
} as const satisfies Readonly<Record<Language, string>>;

/** Allowances of edges without their own in the pattern. [cm] */
export interface ChosenAllowances {
  readonly allowanceCm: number;
  readonly hemCm: number;
}

export interface Preferences {
  readonly units: Units;
  readonly language: Language;
  readonly theme: 'system' | 'light' | 'dark';
  /** Solves after every change. */
  readonly solveAsIGo: boolean;
  /** The colour scale of the mismatch. */
  readonly scale: MismatchScale;
  /** Custom messages in place of the language's own. */
  readonly messages?: Messages | undefined;
  /** Allowances that differ from the usual ones of the units. */
  readonly allowances?: Partial<ChosenAllowances> | undefined;
  /** Fabric settings by the print's name; the newest comes last. */
  readonly cloths?: Readonly<Record<string, unknown>> | undefined;
}

/** Preferences from the browser's locale. */
export function preferencesFor(locale: string): Preferences {
  const {language} = new Intl.Locale(locale);
  return {
    units: 'cm',
    language: languages.find((one) => one === language) ?? 'en',
    theme: 'system',
    solveAsIGo: true,
    scale: 'absolute',
  };
}
