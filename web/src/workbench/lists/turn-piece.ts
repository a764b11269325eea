/** Turns a piece by 90 degrees on the fabric, for keys and buttons. */
import type {Workbench} from '../workbench.js';
import {withQuarterTurn} from './changed-options.js';

/** @returns true if there is such a piece */
export function turnPiece(workbench: Workbench, piece: number): boolean {
  const {design} = workbench.history;
  const {scenes} = workbench.sheet;
  const turned = scenes?.now.pieces[piece];
  if (!design || !turned) return false;
  workbench.history.change({options: withQuarterTurn(design.options, turned.name)});
  const {lists} = workbench.preferences.texts;
  workbench.notices.say({tone: 'info', text: lists.turned(turned.label), undo: true});
  return true;
}
