/** How a person wants to be shown things; not part of any design. */
import type {Units} from '../model/units.js';
import type {MismatchScale} from '../scene/colours.js';
import type {Messages} from './messages.js';

export const languages = ['en', 'de', 'fr', 'es', 'it'] as const;
export type Language = (typeof languages)[number];

/** What pieces have around them to be sewn by, where a pattern gives its edges no allowance of their own. [cm] */
export interface ChosenAllowances {
  readonly allowanceCm: number;
  readonly hemCm: number;
}

export interface Preferences {
  readonly units: Units;
  readonly language: Language;
  readonly theme: 'system' | 'light' | 'dark';
  /** Solve after every change, without being asked. */
  readonly solveAsIGo: boolean;
  /** How mismatch is coloured. */
  readonly scale: MismatchScale;
  /** Words to be used in place of the language's own. */
  readonly messages?: Messages | undefined;
  /** Those that are not as they are usual in the units. */
  readonly allowances?: Partial<ChosenAllowances> | undefined;
  /** What was said of the cloth that a print is on, by the print's name; the newest comes last. */
  readonly cloths?: Readonly<Record<string, unknown>> | undefined;
}

/** What the browser says about its user. */
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
