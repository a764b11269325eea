/** The pieces of a garment, and what is decided about each. */
import {html, nothing, type TemplateResult} from 'lit';
import {live} from 'lit/directives/live.js';

import type {GrainLock} from '../../model/options.js';
import {togglePart} from '../pattern/keeping.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import type {Target} from '../workbench/workbench.js';
import {withGrain, withoutPin, withPrinted} from './choices.js';
import {listStyle} from './list-style.js';
import {ListTable, type Column} from './list-table.js';
import {pieceRows, type PieceRow} from './rows.js';

const grains = ['all', 'on', 'bias', 'free'] as const satisfies readonly (GrainLock | 'all')[];

export class PieceTable extends ListTable<PieceRow> {
  static override styles = [controls, listStyle];

  constructor() {
    super({column: 0, descending: false});
  }

  protected override get label(): string {
    return this.texts.lists.pieces;
  }

  protected override get columns(): readonly Column<PieceRow>[] {
    const {lists} = this.texts;
    return [
      {title: lists.piece, key: ({label}) => label},
      {title: lists.moved, key: ({moved}) => moved, numeric: true},
      {title: lists.offGrain, key: ({offGrain}) => offGrain, numeric: true},
      {title: lists.grain},
      {title: lists.printed},
      {title: this.texts.keep.column},
    ];
  }

  protected override get rows(): readonly PieceRow[] {
    return pieceRows(this.desk);
  }

  protected override get empty(): undefined {
    return undefined;
  }

  protected override targetOf(piece: number): Target {
    return {kind: 'piece', piece};
  }

  protected override numberOf(target: Target): number | undefined {
    return target.kind === 'piece' ? target.piece : undefined;
  }

  protected override cells(row: PieceRow, tabIndex: number): TemplateResult {
    const {texts, format} = this;
    const {lists, pattern} = texts;
    const {moved, offGrain, width, height} = row;
    const size = lists.size(format.length(Math.round(width)), format.length(Math.round(height)));
    return html`
      <th scope="row">
        ${row.label}
        <span class="line"><span>${size},</span> <span>${pattern.seams(row.seams)}</span></span>
        ${row.pinned ? this.#pin(row, tabIndex) : nothing}
      </th>
      <td class="number">
        ${moved === undefined ? html`<span aria-label=${lists.unknown}>–</span>` : format.fine(moved)}
      </td>
      <td class="number">${format.number(offGrain)}°</td>
      <td>${this.#grain(row, tabIndex)}</td>
      <td class="middle">
        <input
          type="checkbox"
          tabindex=${tabIndex}
          aria-label=${lists.of(lists.printed, row.label)}
          .checked=${row.printed}
          @change=${({target}: Event) => {
            this.#decide((options) =>
              withPrinted(options, row.name, (target as HTMLInputElement).checked),
            );
          }}
        />
      </td>
      <td class="middle">${this.#keep(row, tabIndex)}</td>
    `;
  }

  #grain(row: PieceRow, tabIndex: number): TemplateResult {
    const {lists, controls: words} = this.texts;
    return html`<select
      tabindex=${tabIndex}
      aria-label=${lists.of(lists.grain, row.label)}
      @change=${({target}: Event) => {
        const grain = grains.find((one) => one === (target as HTMLSelectElement).value) ?? 'all';
        this.#decide((options) => withGrain(options, row.name, grain));
      }}
    >
      ${grains.map(
        (grain) =>
          html`<option value=${grain} .selected=${grain === row.grain}>
            ${grain === 'all' ? lists.asAll : words.grains[grain]}
          </option>`,
      )}
    </select>`;
  }

  #keep(row: PieceRow, tabIndex: number): TemplateResult {
    const {lists, keep} = this.texts;
    return html`<input
      type="checkbox"
      tabindex=${tabIndex}
      aria-label=${lists.of(keep.kept, row.label)}
      title=${row.kept === 'some' ? keep.some : keep.kept}
      .checked=${live(row.kept === 'all')}
      .indeterminate=${live(row.kept === 'some')}
      @change=${() => {
        togglePart(this.desk, {piece: row.piece});
      }}
    />`;
  }

  #pin(row: PieceRow, tabIndex: number): TemplateResult {
    const {lists} = this.texts;
    return html`<span class="line"
      >${icon.pin} ${lists.pinned}
      <button
        class="link"
        tabindex=${tabIndex}
        aria-label=${lists.of(lists.free, row.label)}
        @click=${() => {
          this.#decide((options) => withoutPin(options, row.name));
        }}
      >
        ${lists.free}
      </button></span
    >`;
  }

  #decide(change: (options: Parameters<typeof withoutPin>[0]) => ReturnType<typeof withoutPin>) {
    const {design} = this.desk;
    if (design) this.desk.change({options: change(design.options)});
  }
}
