/** The seams of a garment with their mismatch and its weight. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import {mismatchLine, type MismatchScale} from '../../scene/colours.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import type {Target} from '../../workbench/workbench.js';
import {matches, matchOf, withMatch} from '../../workbench/lists/changed-options.js';
import {listStyle} from './list-style.js';
import {ListTable, type Column} from './list-table.js';
import {remarkOn, seamRows, type SeamRow} from '../../workbench/lists/rows.js';

/** A seam that does not count has no match to sort by, good or bad. */
const counted =
  (figure: 'before' | 'after') =>
  (row: SeamRow): number | undefined =>
    row.counts ? row[figure] : undefined;

export class SeamTable extends ListTable<SeamRow> {
  static override styles = [controls, listStyle];

  constructor() {
    super({column: 3, descending: true}); // worst first
  }

  protected override get label(): string {
    return this.texts.lists.seams;
  }

  protected override get columns(): readonly Column<SeamRow>[] {
    const {lists} = this.texts;
    return [
      {title: lists.seam, key: ({name}) => name},
      {title: lists.length, key: ({length}) => length, numeric: true},
      {title: lists.before, key: counted('before'), numeric: true},
      {title: lists.after, key: counted('after'), numeric: true},
      {title: lists.match},
    ];
  }

  protected override get rows(): readonly SeamRow[] {
    return seamRows(this.workbench, this.texts);
  }

  protected override get empty(): string | undefined {
    const {scenes} = this.workbench.sheet;
    return scenes?.now.seams.length === 0 ? this.texts.pattern.noSeams : undefined;
  }

  protected override targetOf(seam: number): Target {
    return {kind: 'seam', seam, side: 'a'};
  }

  protected override numberOf(target: Target): number | undefined {
    return target.kind === 'seam' ? target.seam : undefined;
  }

  protected override cells(row: SeamRow, tabIndex: number): TemplateResult {
    const {format} = this;
    const {lists, pattern} = this.texts;
    const {counts, kind, between} = row;
    const remark = remarkOn(row, this.texts, format);
    return html`
      <th scope="row" title=${between ?? nothing}>
        ${row.name} <span class="letter">${row.letter}</span>
        ${counts ? this.#kind(kind) : html`<span class="soft">(${pattern.notCounted})</span>`}
        ${remark === undefined ? nothing : html`<span class="soft">${remark}</span>`}
        ${
          row.keptOn.length === 0
            ? nothing
            : html`<span class="kept"
                >${icon.lock} ${this.texts.keep.keptOn(row.keptOn.join(', '))}</span
              >`
        }
      </th>
      <td class="number">${format.length(row.length)}</td>
      <td class="number soft">${format.fine(row.before)}</td>
      <td class="number" title=${lists.worst(format.fine(row.worst))}>
        ${format.fine(row.after)}
        ${counts ? bar(row, this.workbench.preferences.chosen.scale) : nothing}
      </td>
      <td>${this.#match(row, tabIndex)}</td>
    `;
  }

  #kind(kind: SeamRow['kind']): TemplateResult {
    const word = this.texts.pattern[kind];
    return html`<span class="kind" role="img" aria-label=${word} title=${word}
      >${icon[kind]}</span
    >`;
  }

  #match(row: SeamRow, tabIndex: number): TemplateResult {
    const {lists} = this.texts;
    const chosen = matchOf(row);
    return html`<select
      tabindex=${tabIndex}
      aria-label=${lists.of(lists.match, row.name)}
      ?disabled=${!row.canMatch}
      @change=${({target}: Event) => {
        const match = matches.find((one) => one === (target as HTMLSelectElement).value);
        const {design} = this.workbench.history;
        if (design && match) {
          this.workbench.history.change({options: withMatch(design.options, row, match)});
        }
      }}
    >
      ${
        chosen
          ? nothing
          : html`<option value="" .selected=${true}>
              ${lists.weight(this.format.number(row.weight, 2))}
            </option>`
      }
      ${matches.map(
        (match) =>
          html`<option value=${match} .selected=${match === chosen}>
            ${lists.matches[match]}
          </option>`,
      )}
    </select>`;
  }
}

/** Mismatch as length and colour of a bar; the number is next to it. */
const bar = ({after, severity}: SeamRow, scale: MismatchScale): TemplateResult =>
  html`<svg class="bar" viewBox="0 0 44 4" preserveAspectRatio="none" aria-hidden="true">
    ${svg`<rect width=${Math.max(2, 44 * severity).toFixed(1)} height="4" rx="2"
      fill=${mismatchLine(after, scale).colour} />`}
  </svg>`;
