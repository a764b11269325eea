import type {Workbench} from './workbench.js';

/** Returns whether the user has to start the solver: it is not automatic, or stopped, or failed. */
export function canAlign({design, preferences, state: {kind}}: Workbench): boolean {
  const waits = !preferences.solveAsIGo || kind === 'stale' || kind === 'failed';
  return waits && kind !== 'solving' && design !== undefined;
}
