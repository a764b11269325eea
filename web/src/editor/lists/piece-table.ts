/** The pieces of a garment with their settings. */
import {html, nothing, type TemplateResult} from 'lit';
import {live} from 'lit/directives/live.js';

import {grainDeg, grainInUse, type GrainLock} from '../../model/garment/grain.js';
import {mirrorsOf} from '../../workbench/mirrors.js';
import {withImage} from '../../workbench/tools/grain-proposals.js';
import {togglePart} from '../../workbench/tools/keeping.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import type {Target} from '../../workbench/workbench.js';
import {
  turnPiece,
  withGrain,
  withGrainLines,
  withName,
  withoutPin,
  withPrinted,
} from '../../workbench/lists/changed-options.js';
import {listStyle} from './list-style.js';
import {ListTable, type Column} from './list-table.js';
import {pieceRows, type PieceRow} from '../../workbench/lists/rows.js';

// A name edited in place: Enter and leaving the field keep the entry, Escape discards it.

/** Greatest length of a name that fits on a piece. [characters] */
const greatestLength = 80;

interface NameField {
  readonly name: string;
  /** Accessible name of the field. */
  readonly label: string;
  /** @returns true if the name is valid */
  readonly keep: (name: string) => boolean;
  /** Runs after the entry was kept or discarded; `byKey` if the field still has the focus. */
  readonly close: (byKey: boolean) => void;
}

function nameField({name, label, keep, close}: NameField): TemplateResult {
  let isOpen = true;
  const end = (byKey: boolean): void => {
    isOpen = false;
    close(byKey);
  };
  const press = (event: KeyboardEvent): void => {
    event.stopPropagation(); // letters are no shortcuts here
    const field = event.target as HTMLInputElement;
    if (event.key === 'Enter') event.preventDefault(); // or it presses what has the focus next
    if (event.key === 'Escape') end(true);
    else if (event.key === 'Enter' && keep(field.value.trim())) end(true);
  };
  return html`<input
    class="name"
    type="text"
    aria-label=${label}
    maxlength=${greatestLength}
    .value=${name}
    @keydown=${press}
    @blur=${({target}: Event) => {
      if (!isOpen) return;
      keep((target as HTMLInputElement).value.trim());
      end(false);
    }}
  />`;
}

const grains = ['all', 'on', 'across', 'bias', 'free'] as const satisfies readonly (
  GrainLock | 'all'
)[];

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
    return pieceRows(this.workbench);
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
        ${this.#name(row, tabIndex)}
        <span class="line measured"
          ><span>${size},</span> <span>${pattern.seams(row.seams)}</span></span
        >
        ${row.pinned ? this.#pin(row, tabIndex) : nothing}
      </th>
      <td class="number">
        ${moved === undefined ? html`<span aria-label=${lists.unknown}>–</span>` : format.fine(moved)}
      </td>
      <td class="number">${format.number(offGrain)}°</td>
      <td class="grain">
        <div>${this.#grain(row, tabIndex)}${this.#turn(row, tabIndex)}</div>
        ${this.#grainLine(row, tabIndex)}
      </td>
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

  protected override press(piece: number, key: string): boolean {
    if (key === 'F2') this.#edit(piece);
    else if (key === 'r') return turnPiece(this.workbench, piece);
    else return false;
    return true;
  }

  #edit(piece: number | undefined): void {
    this.edited = piece;
    this.requestUpdate();
    if (piece === undefined) return;
    // waits until the table has returned the focus to the row
    void this.updateComplete.then(() => {
      this.renderRoot.querySelector<HTMLInputElement>('input.name')?.select();
    });
  }

  #name(row: PieceRow, tabIndex: number): TemplateResult {
    const {lists} = this.texts;
    const {piece, label} = row;
    if (piece === this.edited)
      return nameField({
        name: label,
        label: lists.of(lists.name, label),
        keep: (name) => this.#rename(row, name),
        close: (byKey) => {
          this.#edit(undefined);
          if (byKey)
            this.renderRoot.querySelector<HTMLElement>(`tr[data-number="${piece}"]`)?.focus();
        },
      });
    const edit = (): void => {
      this.#edit(piece);
    };
    return html`<span class="named" @dblclick=${edit}
      >${label}
      <button
        class="icon"
        tabindex=${tabIndex}
        aria-label=${lists.of(lists.rename, label)}
        title="${lists.rename} (F2)"
        @click=${edit}
      >
        ${icon.pencil}
      </button></span
    >`;
  }

  #rename({piece, name, label}: PieceRow, chosen: string): boolean {
    const {design} = this.workbench.history;
    if (!design || chosen === label) return true;
    if (this.rows.some((other) => other.piece !== piece && other.label === chosen)) {
      this.workbench.notices.say({tone: 'error', text: this.texts.lists.nameTaken(chosen)});
      return false;
    }
    this.workbench.history.change({names: withName(design.names, name, chosen)});
    return true;
  }

  #turn({piece, label}: PieceRow, tabIndex: number): TemplateResult {
    const {lists} = this.texts;
    return html`<button
      class="turn"
      tabindex=${tabIndex}
      aria-label=${lists.of(lists.quarterTurn, label)}
      title="${lists.quarterTurn} (R)"
      @click=${() => turnPiece(this.workbench, piece)}
    >
      ${icon.quarterTurn}
    </button>`;
  }

  #grain(row: PieceRow, tabIndex: number): TemplateResult {
    const {lists, controls: words, grain: grainWords} = this.texts;
    return html`<select
      tabindex=${tabIndex}
      aria-label=${lists.of(lists.grain, row.label)}
      @change=${({target}: Event) => {
        const {value} = target as HTMLSelectElement;
        const grain = grains.find((one) => one === value);
        if (grain) this.#decide((options) => withGrain(options, row.name, grain));
        else this.#wantGrainLine(row, target as HTMLSelectElement);
      }}
    >
      ${grains.map(
        (grain) =>
          html`<option value=${grain} .selected=${grain === row.grain}>
            ${grain === 'all' ? lists.asAll : words.grains[grain]}
          </option>`,
      )}
      <option value="line">${grainWords.line}</option>
    </select>`;
  }

  /** Choice of a grain line where the maker draws several. */
  #grainLine({name, label}: PieceRow, tabIndex: number): TemplateResult | typeof nothing {
    const {lists, grain: words} = this.texts;
    const {drafted, grainDeg: chosenDeg} = this.workbench.sheet.scenes?.marks.get(name) ?? {};
    const {grains = []} = drafted ?? {};
    if (!drafted || grains.length < 2) return nothing;
    const present = grainInUse(drafted, chosenDeg);
    return html`<select
      class="choice"
      tabindex=${tabIndex}
      aria-label=${lists.of(words.choice, label)}
      @change=${({target}: Event) => {
        const chosen = grains[Number((target as HTMLSelectElement).value)];
        if (!chosen) return;
        const lines = withImage(name, grainDeg(chosen), mirrorsOf(this.workbench.solving));
        this.#decide((options) => withGrainLines(options, lines));
      }}
    >
      ${
        present === undefined
          ? html`<option value="" selected>${words.other(Math.round(chosenDeg ?? 90))}</option>`
          : nothing
      }
      ${grains.map(
        (one, k) =>
          html`<option value=${k} .selected=${one === present}>
            ${one.name ?? words.other(Math.round(grainDeg(one)))}
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
        togglePart(this.workbench, {piece: row.piece});
      }}
    />`;
  }

  /** The user sets the grain line by clicks on the pattern. */
  #wantGrainLine({piece, grain}: PieceRow, select: HTMLSelectElement): void {
    select.value = grain;
    this.workbench.selection.select(this.targetOf(piece));
    this.dispatchEvent(new CustomEvent('sw-grain-wanted', {bubbles: true, composed: true}));
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
    const {design} = this.workbench.history;
    if (design) this.workbench.history.change({options: change(design.options)});
  }
}
