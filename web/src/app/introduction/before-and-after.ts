/** Introduction that is shown once: the garment as drafted, then its transition to the answer. */
import type {PatternPane} from '../../editor/pattern/pattern-pane.js';
import type {Workbench} from '../../workbench/workbench.js';

/** Durations of the draft and of the transition. [ms] */
const look = 1100;
const way = 700;

/** Any input shows the answer at once. */
const inputs = ['pointerdown', 'keydown', 'wheel', 'touchstart', 'dragenter', 'paste'] as const;

/** Starts with a garment's first drawing, which has been requested but is not there yet. */
export function showBeforeAndAfter(workbench: Workbench, pattern: PatternPane): void {
  if (document.hidden || matchMedia('(prefers-reduced-motion: reduce)').matches) return;
  const life = new AbortController();
  const {signal} = life;
  const {design} = workbench.history;
  let isDrawn = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const end = (ms: number): void => {
    life.abort();
    clearTimeout(timer);
    pattern.showAnswer(ms);
  };
  const follow = (): void => {
    const {state} = workbench.solving;
    const isOver =
      workbench.history.design !== design || state.kind === 'failed' || state.kind === 'stale';
    if (isOver) end(0);
    else if (isDrawn && state.kind === 'done')
      timer ??= setTimeout(() => {
        end(way);
      }, look);
  };
  for (const type of inputs) {
    const ended = (): void => {
      end(0);
    };
    addEventListener(type, ended, {signal, capture: true, passive: true});
  }
  pattern.addEventListener(
    'sw-drawn',
    () => {
      isDrawn = true;
      follow();
    },
    {signal},
  );
  signal.addEventListener('abort', workbench.subscribe(['history', 'solving'], follow));
  pattern.showDraft();
}
