/** Changes the print, and removes the symmetries that the new one cannot keep. */
import {askedSymmetries, askingFor, type DesignPrint} from '../../model/design/design.js';
import {carries} from '../../model/print/repeat.js';
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../workbench.js';

/**
 * Takes a step to a print. Symmetries that its group lacks are removed in the same step, with a
 * notice that offers to undo it.
 */
export function takePrint(workbench: Workbench, print: DesignPrint): void {
  const {design} = workbench.history;
  if (!design) return;
  const asked = askedSymmetries(design);
  const lost = asked.filter(({kind}) => !carries(print.group, kind));
  if (lost.length === 0) {
    workbench.history.change({print}, 'print');
    return;
  }
  const kept = asked.filter((one) => !lost.includes(one));
  workbench.history.change({print, symmetry: askingFor(kept)});
  const {language, messages} = workbench.preferences.chosen;
  const texts = textsOf(language, messages);
  const name = texts.samples.prints[print.sample?.name ?? ''] ?? print.title;
  const kind = lost.some((one) => one.kind === 'pair') ? 'pair' : 'piece';
  workbench.notices.say({tone: 'info', text: texts.print.lost[kind](name), undo: true});
}
