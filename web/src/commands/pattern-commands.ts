/** Commands of the pattern, by key or by name. */
import type {ShortcutIn} from './shortcuts.js';
import {turnPiece} from '../workbench/lists/changed-options.js';
import type {PatternView} from '../viewer/pattern-view.js';
import type {Workbench} from '../workbench/workbench.js';
import type {PatternTools, Tool} from '../workbench/tools/pattern-tools.js';

/** State and functions that keys and commands of the pattern use. */
export interface CommandedPattern extends EventTarget {
  readonly workbench: Workbench;
  readonly tools: PatternTools;
  readonly view: PatternView | undefined;
  toggleBare(): void;
  openZoom(): void;
}

/** Zoom step of a key. */
const zoom = 1.25;

const tool =
  (name: Tool) =>
  ({tools}: CommandedPattern): boolean => {
    tools.toggle(name);
    return true;
  };

/** @returns true if the command has an effect at present */
type Act = (pane: CommandedPattern) => boolean;

export const patternCommands: Readonly<Record<ShortcutIn<'pattern'>, Act>> = {
  sew: tool('sew'),
  fold: tool('fold'),
  piece: tool('piece'),
  axis: tool('axis'),
  pair: tool('pair'),
  move: tool('move'),
  keep: tool('keep'),
  grain: tool('grain'),
  turn: ({tools, workbench}) =>
    workbench.selection.selected?.kind === 'piece' &&
    !tools.isFixed &&
    turnPiece(workbench, workbench.selection.selected.piece),
  lens: (pane) => {
    pane.dispatchEvent(new CustomEvent('sw-lens-wanted', {bubbles: true, composed: true}));
    return true;
  },
  clothOnly: (pane) => {
    if (pane.tools.isFixed) return false;
    pane.toggleBare();
    return true;
  },
  fit: ({view}) => {
    view?.fit();
    return true;
  },
  zoomIn: ({view}) => {
    view?.zoomBy(zoom);
    return true;
  },
  zoomOut: ({view}) => {
    view?.zoomBy(1 / zoom);
    return true;
  },
  zoom: (pane) => {
    if (pane.tools.isFixed) return false;
    pane.openZoom();
    return true;
  },
};
