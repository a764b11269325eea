/** Counts one unit of work that has a budget in a test run. */
export function count(kind: 'browser start' | 'page build' | 'page solve'): void;
