/** Preferences belong to the browser, not to a design. */
import {greatestAllowance} from '../../cutting/allowance-rule.js';
import {
  languages,
  preferencesFor,
  type ChosenAllowances,
  type Preferences,
} from '../../texts/preferences.js';
import type {Workbench} from '../../workbench/workbench.js';
import {fieldOf} from '../../model/base/read.js';

const key = 'seamwise.preferences';

/** Allowed values of each preference. */
const answers = {
  units: ['cm', 'inch'],
  language: languages,
  theme: ['system', 'light', 'dark'],
  solveAsIGo: [true, false],
  scale: ['absolute', 'paper'],
} as const satisfies {readonly [Name in keyof Preferences]: readonly Preferences[Name][]};

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function allowancesIn(stored: unknown): Partial<ChosenAllowances> {
  const names = ['allowanceCm', 'hemCm'] as const;
  return Object.fromEntries(
    names.flatMap((name) => {
      const value = fieldOf(stored, name);
      const isRight = typeof value === 'number' && value >= 0 && value <= greatestAllowance;
      return isRight ? [[name, value]] : [];
    }),
  );
}

/** Returns the stored preferences; unknown or missing ones have the browser's defaults. */
export function storedPreferences(locale = navigator.language): Preferences {
  const usual = preferencesFor(locale);
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    const known = Object.entries(answers).flatMap(([name, ones]) => {
      const value = fieldOf(stored, name);
      return (ones as readonly unknown[]).includes(value) ? [[name, value] as const] : [];
    });
    const cloths = fieldOf(stored, 'cloths'); // validated at each use
    return {
      ...{...usual, ...Object.fromEntries(known)},
      allowances: allowancesIn(fieldOf(stored, 'allowances')),
      ...(isRecord(cloths) && {cloths}),
    };
  } catch {
    return usual; // no storage here, or other content in it
  }
}

/** Stores the preferences of a workbench after each change. @returns a function that stops this */
export function keepPreferences(workbench: Workbench): () => void {
  return workbench.subscribe(['preferences'], () => {
    try {
      localStorage.setItem(key, JSON.stringify(workbench.preferences.chosen));
    } catch {
      // the page still uses the chosen preferences without storage
    }
  });
}
