/** Search for a better result, as an action that the user can take at present. */
import {mostEffort} from '../improvement.js';
import type {Workbench} from '../workbench.js';

/** Returns the available action: begin a search, or stop a running one. */
export function improvementOffer({
  afterwards,
  history: {design},
  solving: {result, state},
}: Workbench): {readonly kind: 'begin' | 'stop'; readonly act: () => void} | undefined {
  if (!design || !result || state.kind !== 'done' || result.seams.length === 0) return undefined;
  const improving = afterwards.improving(design);
  if (improving?.isRunning) {
    const act = (): void => {
      afterwards.stopImproving();
    };
    return {kind: 'stop', act};
  }
  const isDone = 2 * (design.options.effort ?? 1) > mostEffort;
  if (improving || isDone || design.method !== 'best') return undefined;
  return {kind: 'begin', act: () => void afterwards.improve(design, result)};
}
