/** Turns a piece by 90 degrees on the fabric, for keys and buttons. */
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../workbench.js';
import {withQuarterTurn} from './changed-options.js';

/** @returns true if there is such a piece */
export function turnPiece(workbench: Workbench, piece: number): boolean {
  const {design, scenes} = workbench;
  const turned = scenes?.now.pieces[piece];
  if (!design || !turned) return false;
  workbench.change({options: withQuarterTurn(design.options, turned.name)});
  const {lists} = textsOf(workbench.preferences.language, workbench.preferences.messages);
  workbench.say({tone: 'info', text: lists.turned(turned.label), undo: true});
  return true;
}
