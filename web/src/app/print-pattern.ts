/** Prints the page: the whole pattern on white, without the controls. */
import type {Workbench} from '../workbench/workbench.js';

/**
 * Adds the pattern's sheet for each print of the page, until `signal` fires; page.css hides the
 * rest meanwhile.
 */
export function printPattern(workbench: Workbench, signal: AbortSignal): void {
  let sheet: HTMLCanvasElement | undefined;
  const clear = (): void => {
    sheet?.remove();
    sheet = undefined;
  };
  addEventListener(
    'beforeprint',
    () => {
      clear();
      // synchronous: the browser does not wait
      sheet = workbench.sheet.view?.onPaper();
      if (!sheet) return;
      sheet.className = 'on-paper';
      document.body.append(sheet);
    },
    {signal},
  );
  addEventListener('afterprint', clear, {signal});
  signal.addEventListener('abort', clear);
}
