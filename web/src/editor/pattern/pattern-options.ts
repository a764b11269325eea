/** The pattern as a list for screen readers: every piece, followed by its seams. */
import {html, type TemplateResult} from 'lit';

import type {PickIndex} from '../../clicks/pick-index.js';
import {readingOrder, seamsRound} from '../../clicks/walk.js';
import {pieceRows, seamRows, seamText, type PieceRow} from '../../workbench/lists/rows.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import type {Target, Workbench} from '../../workbench/workbench.js';

export const optionId = (target: Target): string =>
  target.kind === 'piece' ? `piece-${target.piece}` : `seam-${target.seam}-${target.side}`;

export function patternOptions(
  workbench: Workbench,
  index: PickIndex,
  texts: Texts,
  format: Format,
): TemplateResult {
  const pieces = pieceRows(workbench);
  const seams = seamRows(workbench, texts);
  const {pattern} = texts;
  const selected = workbench.selection.selected && optionId(workbench.selection.selected);
  const option = (target: Target, text: string): TemplateResult => {
    const id = optionId(target);
    return html`<div role="option" id=${id} aria-selected=${id === selected}>${text}</div>`;
  };
  return html`<div role="listbox" class="hidden" id="options" aria-label=${pattern.contents}>
    ${readingOrder(index).map((piece) => {
      const row = pieces[piece];
      if (!row) return undefined;
      return [
        option({kind: 'piece', piece}, pieceText(row, texts)),
        ...seamsRound(index, piece).map(({seam, side}) => {
          const words = seams[seam];
          return words && option({kind: 'seam', seam, side}, seamText(words, texts, format));
        }),
      ];
    })}
  </div>`;
}

/** "Front, 6 seams, pinned" */
function pieceText({label, seams, pinned, kept}: PieceRow, {pattern, lists, keep}: Texts): string {
  const states = [
    ...(pinned ? [lists.pinned] : []),
    ...(kept === 'none' ? [] : [kept === 'all' ? keep.kept : keep.some]),
  ];
  return [pattern.piece(label, pattern.seams(seams)), ...states].join(', ');
}
