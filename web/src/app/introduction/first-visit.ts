/** Recognises the first visit of a browser to the page. */
const key = 'seamwise.introduction';

/** Returns false without storage, since each visit would look like the first one. */
export function isFirstVisit(): boolean {
  try {
    return localStorage.getItem(key) === null;
  } catch {
    return false;
  }
}

export function endFirstVisit(): void {
  try {
    localStorage.setItem(key, '');
  } catch {
    // without storage, no visit is the first one
  }
}
