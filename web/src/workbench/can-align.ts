import type {Workbench} from './workbench.js';

/** Returns whether the user has to start the solver: it is not automatic, or stopped, or failed. */
export function canAlign({history: {design}, preferences, solving}: Workbench): boolean {
  const {kind} = solving.state;
  const waits = !preferences.chosen.solveAsIGo || kind === 'stale' || kind === 'failed';
  return waits && kind !== 'solving' && design !== undefined;
}
