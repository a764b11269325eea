/** Preferences stay with the browser, not with a design. */
import {
  greatestAllowance,
  languages,
  preferencesFor,
  type ChosenAllowances,
  type Preferences,
  type Workbench,
} from '../../editor/index.js';
import {fieldOf} from '../../model/read.js';

const key = 'seamwise.preferences';

/** Every answer that a preference may have. */
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

/** What was stored, as far as it is understood; the rest as the browser says. */
export function storedPreferences(locale = navigator.language): Preferences {
  const usual = preferencesFor(locale);
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    const known = Object.entries(answers).flatMap(([name, ones]) => {
      const value = fieldOf(stored, name);
      return (ones as readonly unknown[]).includes(value) ? [[name, value] as const] : [];
    });
    const cloths = fieldOf(stored, 'cloths'); // each is read where it is used
    return {
      ...{...usual, ...Object.fromEntries(known)},
      allowances: allowancesIn(fieldOf(stored, 'allowances')),
      ...(isRecord(cloths) && {cloths}),
    };
  } catch {
    return usual; // nothing can be stored here, or something else was
  }
}

/** Stores the preferences of a workbench whenever they change. @returns what ends that */
export function keepPreferences(workbench: Workbench): () => void {
  return workbench.subscribe(['preferences'], () => {
    try {
      localStorage.setItem(key, JSON.stringify(workbench.preferences));
    } catch {
      // a browser that stores nothing still shows what was chosen
    }
  });
}
