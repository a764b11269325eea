import type {Workbench} from '../../workbench/workbench.js';

/** Whether somebody has to ask for an answer: nothing solves by itself, or it was stopped, or has failed. */
export function canAlign({design, preferences, state: {kind}}: Workbench): boolean {
  const waits = !preferences.solveAsIGo || kind === 'stale' || kind === 'failed';
  return waits && kind !== 'solving' && design !== undefined;
}
