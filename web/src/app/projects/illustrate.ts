/** Preview images of projects, drawn in idle time. */
import type {Design} from '../../model/design/design.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {Projects} from './projects.js';

/** Least time without a change. [ms] */
const rest = 1500;
/** Width of a card in the list on a high-resolution screen. [px] */
const width = 448;

/** Observes the workbench and updates the current project's preview image. */
export function illustrate(workbench: Workbench, projects: Projects): void {
  let pictured: Design | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const take = async (design: Design): Promise<void> => {
    if (workbench.history.design !== design || !workbench.sheet.view) return;
    pictured = design;
    // a lost graphics context gives no picture; the next change tries again
    const picture = await workbench.sheet.view.picture(width).catch(() => undefined);
    if (picture && workbench.history.design === design) await projects.illustrate(picture);
  };
  workbench.subscribe(['history', 'solving', 'sheet'], () => {
    const {design} = workbench.history;
    const {state} = workbench.solving;
    const isSettled = state.kind === 'done' || state.kind === 'stale';
    clearTimeout(timer);
    if (!design || design === pictured || !isSettled || workbench.history.isHeld) return;
    timer = setTimeout(() => {
      whenIdle(() => void take(design));
    }, rest);
  });
}

/** Runs in idle time; some browsers do not report it. */
function whenIdle(act: () => void): void {
  if ('requestIdleCallback' in globalThis) requestIdleCallback(act, {timeout: 10_000});
  else setTimeout(act);
}
