/** Which hints somebody who is new here has still to be given; kept by the browser. */
const key = 'seamwise.introduction';

export const hints = ['print', 'compare', 'seam'] as const;
export type Hint = (typeof hints)[number];

/** Nothing where nobody has been here yet. Where nothing can be kept, none: they would come back each time. */
export function hintsLeft(): readonly Hint[] | undefined {
  try {
    const kept = localStorage.getItem(key);
    return kept === null ? undefined : hints.filter((hint) => kept.split(' ').includes(hint));
  } catch {
    return [];
  }
}

/** @returns whether the browser keeps it */
export function keepHints(left: readonly Hint[]): boolean {
  try {
    localStorage.setItem(key, left.join(' '));
    return true;
  } catch {
    return false;
  }
}
