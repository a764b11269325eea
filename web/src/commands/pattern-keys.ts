/** Keys of the pattern, while it has the focus. */
import type {PickIndex} from '../clicks/pick-index.js';
import type {Point} from '../model/geometry/vectors.js';
import {shortcutFor, shortcuts, type ShortcutIn} from './shortcuts.js';
import {groupRows} from '../workbench/lists/group-rows.js';
import {textsOf} from '../texts/texts.js';
import {patternCommands, type CommandedPattern} from './pattern-commands.js';
import {
  inwards,
  nextPiece,
  nextSeam,
  outwards,
  readingOrder,
  twin,
  type Direction,
  type Place,
} from '../clicks/walk.js';
import type {Target} from '../workbench/workbench.js';

// Keys that work anywhere in the editor.

/** Functions that shortcuts run; a page adds its own to the editor's. */
export type KeyCommands = Readonly<Partial<Record<ShortcutIn<'page' | 'editor'>, () => void>>>;

/** Runs the command of a key event, unless another listener has already handled the event. */
export function editorKeys(event: KeyboardEvent, commands: KeyCommands): void {
  const id = event.defaultPrevented ? undefined : shortcutFor(event, ['page', 'editor']);
  const command = id && commands[id];
  // undo in a field applies to the text of the field
  if (!command || (shortcuts[id].where === 'editor' && isTyping(event))) return;
  event.preventDefault();
  command();
}

/** Returns whether the pattern may use a key event: unhandled, outside fields and open dialogs. */
export const isFree = (event: KeyboardEvent): boolean =>
  !event.defaultPrevented &&
  !isTyping(event) &&
  !event.composedPath().some((one) => one instanceof HTMLDialogElement && one.open);

const isTyping = (event: KeyboardEvent): boolean => {
  const [target] = event.composedPath();
  if (target instanceof HTMLSelectElement) return true; // a letter key selects an option
  return target instanceof HTMLInputElement && ['text', 'number'].includes(target.type);
};

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
 * The pattern with the focus: index of the parts on its sheet, and its view of before and after.
 */
interface KeyedPattern extends CommandedPattern {
  readonly index: PickIndex | undefined;
  readonly beforeAfter: {isHeld: boolean};
}

export function patternKeys(pane: KeyedPattern, event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (!pane.tools.editing?.press(event, pane.index) && !handled(pane, key, event)) return;
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
    pane.beforeAfter.isHeld = true;
    return true;
  }
  const number = Number(key);
  if (!(number >= 1 && number <= 9)) return false;
  const texts = textsOf(
    workbench.preferences.chosen.language,
    workbench.preferences.chosen.messages,
  );
  const row = groupRows(workbench, texts)[number - 1];
  if (row) workbench.selection.select({kind: 'seam', seam: row.worst, side: 'a'});
  return true;
}

function walk({index, workbench}: KeyedPattern, key: string): boolean {
  const next = index && walked(index, workbench.selection.selected, key);
  if (next) workbench.selection.select(next);
  return next !== undefined;
}

/** Keyboard navigation in the pattern: from piece to piece, along seams, across to a twin. */
function placeOf({sheet}: PickIndex, target: Target): Place | undefined {
  if (target.kind === 'piece') return {level: 'piece', piece: target.piece};
  const piece = sheet.seams[target.seam]?.[target.side].piece;
  return piece === undefined
    ? undefined
    : {level: 'seam', piece, seam: target.seam, side: target.side};
}

const targetOf = (place: Place): Target =>
  place.level === 'piece'
    ? {kind: 'piece', piece: place.piece}
    : {kind: 'seam', seam: place.seam, side: place.side};

const directions: Readonly<Record<string, Direction>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
};

function led(index: PickIndex, place: Place, key: string): Place | undefined {
  const direction = directions[key];
  if (direction && place.level === 'piece')
    return {level: 'piece', piece: nextPiece(index, place.piece, direction)};
  if (direction && place.level === 'seam')
    return nextSeam(index, place, direction === 'right' || direction === 'down' ? 1 : -1);
  if (key === 'Enter' && place.level === 'piece') return inwards(index, place);
  if (key === 't' && place.level === 'seam') return twin(index, place);
  return undefined;
}

/** Returns the selection after a key; undefined if the key has no effect. */
function walked(index: PickIndex, selected: Target | undefined, key: string): Target | undefined {
  const place = selected && placeOf(index, selected);
  if (place) {
    const next = led(index, place, key);
    return next && targetOf(next);
  }
  const [first] = readingOrder(index);
  return directions[key] && first !== undefined ? {kind: 'piece', piece: first} : undefined;
}

/** Steps from a seam to its piece, and from a piece to no selection. */
function steppedOut(index: PickIndex, selected: Target): Target | undefined {
  const place = placeOf(index, selected);
  const out = place && outwards(place);
  return out && targetOf(out);
}
