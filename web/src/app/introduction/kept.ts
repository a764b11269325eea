/** Hints that a new user has not seen yet, stored by the browser. */
const key = 'seamwise.introduction';

export const hints = ['print', 'compare', 'seam'] as const;
export type Hint = (typeof hints)[number];

/**
 * Returns undefined on a first visit. Without storage there are none: they would return each time.
 */
export function hintsLeft(): readonly Hint[] | undefined {
  try {
    const kept = localStorage.getItem(key);
    return kept === null ? undefined : hints.filter((hint) => kept.split(' ').includes(hint));
  } catch {
    return [];
  }
}

/** @returns true if the browser stores them */
export function keepHints(left: readonly Hint[]): boolean {
  try {
    localStorage.setItem(key, left.join(' '));
    return true;
  } catch {
    return false;
  }
}
