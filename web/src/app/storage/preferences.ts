/** Preferences stay with the browser, not with a design. */
import {languages, preferencesFor, type Preferences, type Workbench} from '../../editor/index.js';

const key = 'seamwise.preferences';

/** Every answer that a preference may have. */
const answers: {readonly [Name in keyof Preferences]: readonly Preferences[Name][]} = {
  units: ['cm', 'inch'],
  language: languages,
  theme: ['system', 'light', 'dark'],
  solveAsIGo: [true, false],
  scale: ['absolute', 'paper'],
};

/** What was stored, as far as it is understood; the rest as the browser says. */
export function storedPreferences(locale = navigator.language): Preferences {
  const usual = preferencesFor(locale);
  try {
    const stored = JSON.parse(localStorage.getItem(key) ?? '{}') as Record<string, unknown>;
    const known = Object.entries(answers).filter(([name, ones]) =>
      (ones as readonly unknown[]).includes(stored[name]),
    );
    return {...usual, ...Object.fromEntries(known.map(([name]) => [name, stored[name]]))};
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
