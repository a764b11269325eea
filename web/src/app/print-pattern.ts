/** The page on paper: the whole pattern on white, without what it is worked on with. */
import type {Workbench} from '../editor/index.js';

/** Lays the pattern out whenever the page is printed, until `signal` fires; page.css hides the rest then. */
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
      // at once: the browser does not wait for anything
      sheet = workbench.view?.onPaper();
      if (!sheet) return;
      sheet.className = 'on-paper';
      document.body.append(sheet);
    },
    {signal},
  );
  addEventListener('afterprint', clear, {signal});
  signal.addEventListener('abort', clear);
}
