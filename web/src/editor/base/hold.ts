/** Drags, each of which is one step of the history. */
import type {Workbench} from '../../workbench/workbench.js';

/** From a press until that pointer is lifted, wherever it is by then. */
export function holdWhilePressed(workbench: Workbench, {pointerId}: PointerEvent): void {
  const letGo = workbench.hold();
  const done = new AbortController();
  for (const end of ['pointerup', 'pointercancel'] as const) {
    addEventListener(
      end,
      (event) => {
        if (event.pointerId !== pointerId) return;
        done.abort();
        letGo();
      },
      {signal: done.signal},
    );
  }
}
