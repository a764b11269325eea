/** Names of history steps: "turn Waistband", "matching of seams, Side seam". */
import type {Design} from '../../model/design/design.js';
import {seamRows} from '../lists/rows.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import type {Step} from '../state.js';
import type {Workbench} from '../workbench.js';
import {changeBetween, type Change} from './step-change.js';

/** A step of more pieces or seams lists none. */
const mostNamed = 2;

/** Returns undefined if there is no step. */
function stepWords(
  workbench: Workbench,
  texts: Texts,
  from: Step | undefined,
  to: Step | undefined,
): string | undefined {
  if (!from || !to) return undefined;
  const change = changeBetween(from.design, to.design);
  const named = namesIn(workbench, texts, change, to.design);
  const whose = named.length > mostNamed ? '' : named.join(', ');
  const {turned, ...steps} = texts.steps;
  if (change.kind === 'turned') return turned(whose || texts.lists.pieces);
  return whose ? `${steps[change.kind]}, ${whose}` : steps[change.kind];
}

/** Returns the name of the step that undo reverts. */
export function undoWords(workbench: Workbench, texts: Texts): string | undefined {
  const {past = [], present} = workbench.history.steps ?? {};
  return stepWords(workbench, texts, past.at(-1), present);
}

/** Returns the name of the step that redo repeats. */
export function redoWords(workbench: Workbench, texts: Texts): string | undefined {
  const {present, future = []} = workbench.history.steps ?? {};
  return stepWords(workbench, texts, present, future[0]);
}

/** Undoes the last step and shows its name in a notice, for callers that display no name. */
export function undoAndSay(workbench: Workbench): void {
  const texts = textsOf(
    workbench.preferences.chosen.language,
    workbench.preferences.chosen.messages,
  );
  const undone = undoWords(workbench, texts);
  workbench.history.undo();
  if (undone !== undefined) workbench.notices.say({tone: 'info', text: texts.app.undone(undone)});
}

function namesIn(
  workbench: Workbench,
  texts: Texts,
  {kind, pieces = [], seams = []}: Change,
  {print, garment, names}: Design,
): readonly string[] {
  const {size} = garment.sample ?? {};
  if (kind === 'size' && size !== undefined) return [size.toUpperCase()];
  if (kind === 'print') return [texts.samples.prints[print.sample?.name ?? ''] ?? print.title];
  const labels = new Map(workbench.sheet.scenes?.now.pieces.map(({name, label}) => [name, label]));
  const rows = seams.length > 0 ? seamRows(workbench, texts) : [];
  return [
    ...pieces.map((name) => names?.[name] ?? labels.get(name) ?? name),
    ...seams.flatMap((seam) => rows[seam]?.name ?? []),
  ];
}
