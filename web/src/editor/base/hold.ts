/** Records a drag as one step of the history. */
import type {Workbench} from '../../workbench/workbench.js';

/** Holds the history from a press until the same pointer is lifted, anywhere in the window. */
export function holdWhilePressed(workbench: Workbench, {pointerId}: PointerEvent): void {
  const letGo = workbench.history.hold();
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
