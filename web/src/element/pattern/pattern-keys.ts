/** Keys of the pattern, while it has the focus. */
import type {Point} from '../../model/geometry.js';
import {seamRows, worstSeams} from '../lists/rows.js';
import {turnPiece} from '../lists/turn-piece.js';
import {textsOf} from '../texts/texts.js';
import type {PatternPane} from './pattern-pane.js';
import {steppedOut, walked} from './walking.js';

/** Of a print moved by an arrow key. [cm] */
const fineStep = 0.1;
const coarseStep = 1;

const ways: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function patternKeys(pane: PatternPane, event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (!handled(pane, key, event.shiftKey)) return;
  event.preventDefault();
  event.stopPropagation();
}

function handled(pane: PatternPane, key: string, shift: boolean): boolean {
  return (
    moved(pane, key, shift) ||
    chosen(pane, key) ||
    toolKey(pane, key) ||
    viewKey(pane, key) ||
    walk(pane, key)
  );
}

function moved({tools}: PatternPane, key: string, shift: boolean): boolean {
  const way = ways[key];
  const step = shift ? coarseStep : fineStep;
  if (way) return tools.nudge([way[0] * step, way[1] * step]);
  if (key === '[') return tools.nudge([0, 0], 1);
  if (key === ']') return tools.nudge([0, 0], -1);
  return false;
}

/** Enter and the space bar choose what is selected, or accept what has been chosen. */
function chosen({tools, index, desk}: PatternPane, key: string): boolean {
  const {chooser} = tools;
  if (key === 'Enter' && chooser.isReady) {
    chooser.send({type: 'commit'});
    return true;
  }
  const chooses =
    key === ' ' || (key === 'Enter' && (tools.active === 'pair' || desk.selected?.kind === 'seam'));
  const takes = chooser.tool !== undefined || tools.active === 'keep' || tools.active === 'grain';
  if (!index || !takes || !chooses) return false;
  tools.takeSelected(index);
  return true;
}

function toolKey(pane: PatternPane, key: string): boolean {
  const {tools, desk, index} = pane;
  switch (key) {
    case 's':
      tools.toggle('piece');
      return true;
    case 'x':
      tools.toggle('axis');
      return true;
    case 'p':
      tools.toggle('pair');
      return true;
    case 'm':
      tools.toggle('move');
      return true;
    case 'k':
      tools.toggle('keep');
      return true;
    case 'g':
      tools.toggle('grain');
      return true;
    case 'r': {
      const {selected} = desk;
      return selected?.kind === 'piece' && !tools.isFixed && turnPiece(desk, selected.piece);
    }
    case 'Escape': {
      if (tools.back() || !desk.selected) return true;
      desk.select(index && steppedOut(index, desk.selected));
      return true;
    }
    default:
      return false;
  }
}

function viewKey(pane: PatternPane, key: string): boolean {
  const {view, desk} = pane;
  switch (key) {
    case '+':
    case '=':
      view?.zoomBy(1.25);
      return true;
    case '-':
      view?.zoomBy(1 / 1.25);
      return true;
    case '0':
    case 'f':
      view?.fit();
      return true;
    case 'w':
      if (pane.tools.isFixed) return false;
      pane.split = 1;
      return true;
    case 'c':
      if (pane.tools.isFixed) return false;
      pane.toggleBare();
      return true;
    case 'l':
      pane.dispatchEvent(new CustomEvent('sw-lens-wanted', {bubbles: true, composed: true}));
      return true;
    default: {
      const number = Number(key);
      if (pane.tools.isFixed || !(number >= 1 && number <= 9)) return false;
      const texts = textsOf(desk.preferences.language, desk.preferences.messages);
      const row = worstSeams(seamRows(desk, texts), number)[number - 1];
      if (row) desk.select({kind: 'seam', seam: row.seam, side: 'a'});
      return true;
    }
  }
}

function walk({index, desk}: PatternPane, key: string): boolean {
  const next = index && walked(index, desk.selected, key);
  if (next) desk.select(next);
  return next !== undefined;
}
