/** Counts one piece of work that a test run has a budget for. */
export function count(kind: 'browser start' | 'page build' | 'page solve'): void;
