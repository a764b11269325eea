/** What a step is called in words: "turn Waistband", "matching of seams, Side seam". */
import type {Design} from '../../model/design.js';
import {seamRows} from '../lists/rows.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import type {Step} from '../../workbench/state.js';
import type {Workbench} from '../../workbench/workbench.js';
import {changeBetween, type Change} from './step.js';

/** More than these are not listed. */
const mostNamed = 2;

/** Undefined where there is no step. */
export function stepWords(
  desk: Workbench,
  texts: Texts,
  from: Step | undefined,
  to: Step | undefined,
): string | undefined {
  if (!from || !to) return undefined;
  const change = changeBetween(from.design, to.design);
  const named = namesIn(desk, texts, change, to.design);
  const whose = named.length > mostNamed ? '' : named.join(', ');
  const {turned, ...steps} = texts.steps;
  if (change.kind === 'turned') return turned(whose || texts.lists.pieces);
  return whose ? `${steps[change.kind]}, ${whose}` : steps[change.kind];
}

/** What undo would take back. */
export function undoWords(desk: Workbench, texts: Texts): string | undefined {
  const {past = [], present} = desk.history ?? {};
  return stepWords(desk, texts, past.at(-1), present);
}

/** What redo would do again. */
export function redoWords(desk: Workbench, texts: Texts): string | undefined {
  const {present, future = []} = desk.history ?? {};
  return stepWords(desk, texts, present, future[0]);
}

/** Takes the last step back and says which it was: for who presses where no step is named. */
export function undoAndSay(desk: Workbench): void {
  const texts = textsOf(desk.preferences.language, desk.preferences.messages);
  const undone = undoWords(desk, texts);
  desk.undo();
  if (undone !== undefined) desk.say({tone: 'info', text: texts.app.undone(undone)});
}

function namesIn(
  desk: Workbench,
  texts: Texts,
  {kind, pieces = [], seams = []}: Change,
  {print, garment, names}: Design,
): readonly string[] {
  const {size} = garment.sample ?? {};
  if (kind === 'size' && size !== undefined) return [size.toUpperCase()];
  if (kind === 'print') return [texts.samples.prints[print.sample?.name ?? ''] ?? print.title];
  const labels = new Map(desk.scenes?.now.pieces.map(({name, label}) => [name, label]));
  const rows = seams.length > 0 ? seamRows(desk, texts) : [];
  return [
    ...pieces.map((name) => names?.[name] ?? labels.get(name) ?? name),
    ...seams.flatMap((seam) => rows[seam]?.name ?? []),
  ];
}
