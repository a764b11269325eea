/** Changes the print, and removes the symmetries that the new one cannot keep. */
import {
  askedSymmetries,
  askingFor,
  type Decisions,
  type DesignPrint,
} from '../../model/design/design.js';
import type {Symmetry} from '../../model/garment/symmetries.js';
import type {GroupName} from '../../model/print/repeating-print.js';
import {carries} from '../../model/print/repeat.js';
import {textsOf} from '../../texts/texts.js';
import {printName} from '../../texts/sample-names.js';
import type {Workbench} from '../workbench.js';

/** Returns the requested symmetries that prints of a group cannot have. */
export const lostSymmetries = (
  group: GroupName,
  decisions: Pick<Decisions, 'symmetry'>,
): readonly Symmetry[] => askedSymmetries(decisions).filter(({kind}) => !carries(group, kind));

/**
 * Takes a step to a print. Symmetries that its group lacks are removed in the same step, with a
 * notice that offers to undo it.
 */
export function takePrint(workbench: Workbench, print: DesignPrint): void {
  const {design} = workbench.history;
  if (!design) return;
  const lost = lostSymmetries(print.group, design);
  if (lost.length === 0) {
    workbench.history.change({print}, 'print');
    return;
  }
  const kept = askedSymmetries(design).filter((one) => !lost.includes(one));
  workbench.history.change({print, symmetry: askingFor(kept)});
  const {language, messages} = workbench.preferences.chosen;
  const texts = textsOf(language, messages);
  const name = printName(print, texts);
  const kind = lost.some((one) => one.kind === 'pair') ? 'pair' : 'piece';
  workbench.notices.say({tone: 'info', text: texts.print.lost[kind](name), undo: true});
}
