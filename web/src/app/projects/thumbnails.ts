/** Small pictures of projects, made while nothing else is to be done. */
import type {Design} from '../../model/design.js';
import type {Workbench} from '../../editor/index.js';
import type {Projects} from './projects.js';

/** Nothing may have changed for as long. [ms] */
const rest = 1500;
/** As wide as a card of the list on a sharp screen. [px] */
const width = 448;

/** Follows the workbench, and gives each project a picture of what it has become. */
export function illustrate(workbench: Workbench, projects: Projects): void {
  let pictured: Design | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const take = async (design: Design): Promise<void> => {
    if (workbench.design !== design || !workbench.view) return;
    pictured = design;
    // a lost graphics context gives no picture; the next change tries again
    const picture = await workbench.view.picture(width).catch(() => undefined);
    if (picture && workbench.design === design) await projects.illustrate(picture);
  };
  workbench.subscribe(['history', 'solving', 'sheet'], () => {
    const {design, state} = workbench;
    const isSettled = state.kind === 'done' || state.kind === 'stale';
    clearTimeout(timer);
    if (!design || design === pictured || !isSettled || workbench.isHeld) return;
    timer = setTimeout(() => {
      whenIdle(() => void take(design));
    }, rest);
  });
}

/** Some browsers do not say when they are idle. */
function whenIdle(act: () => void): void {
  if ('requestIdleCallback' in globalThis) requestIdleCallback(act, {timeout: 10_000});
  else setTimeout(act);
}
