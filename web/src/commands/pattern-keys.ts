/** Keys of the pattern, while it has the focus. */
import type {PickIndex} from '../clicks/pick-index.js';
import type {Point} from '../model/geometry/vectors.js';
import {shortcutFor} from './shortcuts.js';
import {seamRows, worstSeams} from '../workbench/lists/rows.js';
import {textsOf} from '../texts/texts.js';
import {patternCommands, type CommandedPattern} from './pattern-commands.js';
import {steppedOut, walked} from './walking.js';

/** Steps of a print moved by an arrow key, without and with Shift. [cm] */
const fineStep = 0.1;
const coarseStep = 1;

const ways: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/**
 * The pattern with the focus: index of the parts on its sheet, and share of the width that shows
 * the draft.
 */
interface KeyedPattern extends CommandedPattern {
  readonly index: PickIndex | undefined;
  split: number | undefined;
}

export function patternKeys(pane: KeyedPattern, event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (!pane.tools.sewing?.press(event) && !handled(pane, key, event)) return;
  event.preventDefault();
  event.stopPropagation();
}

function handled(pane: KeyedPattern, key: string, event: KeyboardEvent): boolean {
  return (
    moved(pane, key, event.shiftKey) || chosen(pane, key) || asked(pane, event) || walk(pane, key)
  );
}

function moved({tools}: KeyedPattern, key: string, shift: boolean): boolean {
  const way = ways[key];
  const step = shift ? coarseStep : fineStep;
  if (way) return tools.nudge([way[0] * step, way[1] * step]);
  if (key === '[') return tools.nudge([0, 0], 1);
  if (key === ']') return tools.nudge([0, 0], -1);
  return false;
}

/** Enter and the space bar choose the selected part, or accept a complete choice. */
function chosen({tools, index, workbench}: KeyedPattern, key: string): boolean {
  const {chooser} = tools;
  if (key === 'Enter' && chooser.isReady) {
    chooser.send({type: 'commit'});
    return true;
  }
  const chooses =
    key === ' ' ||
    (key === 'Enter' && (tools.active === 'pair' || workbench.selection.selected?.kind === 'seam'));
  const takes = chooser.tool !== undefined || tools.active === 'keep' || tools.active === 'grain';
  if (!index || !takes || !chooses) return false;
  tools.takeSelected(index);
  return true;
}

/** Runs a command by its key, or an action that only a key has. */
function asked(pane: KeyedPattern, event: KeyboardEvent): boolean {
  const command = shortcutFor(event, ['pattern']);
  return command ? patternCommands[command](pane) : heldOrStepped(pane, event.key);
}

function heldOrStepped(pane: KeyedPattern, key: string): boolean {
  const {tools, workbench, index} = pane;
  if (key === 'Escape') {
    if (!tools.back() && workbench.selection.selected)
      workbench.selection.select(index && steppedOut(index, workbench.selection.selected));
    return true;
  }
  if (tools.isFixed) return false;
  if (key.toLowerCase() === 'w') {
    pane.split = 1;
    return true;
  }
  const number = Number(key);
  if (!(number >= 1 && number <= 9)) return false;
  const texts = textsOf(
    workbench.preferences.chosen.language,
    workbench.preferences.chosen.messages,
  );
  const row = worstSeams(seamRows(workbench, texts), number)[number - 1];
  if (row) workbench.selection.select({kind: 'seam', seam: row.seam, side: 'a'});
  return true;
}

function walk({index, workbench}: KeyedPattern, key: string): boolean {
  const next = index && walked(index, workbench.selection.selected, key);
  if (next) workbench.selection.select(next);
  return next !== undefined;
}
