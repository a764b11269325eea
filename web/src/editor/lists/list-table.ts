/** A table of parts of the pattern: sorted by columns, used by keys, selected like the drawing. */
import {html, nothing, type TemplateResult} from 'lit';
import {guard} from 'lit/directives/guard.js';
import {repeat} from 'lit/directives/repeat.js';

import {PatientElement} from '../base/workbench-element.js';
import type {Target} from '../../workbench/workbench.js';
import {inOrder, type Order, type SortKey} from '../../workbench/lists/row-order.js';

export interface Column<Row> {
  readonly title: string;
  /** A column without a key cannot be sorted. */
  readonly key?: SortKey<Row>;
  /** Numbers are aligned right, and sort in descending order first. */
  readonly numeric?: boolean;
}

export abstract class ListTable<Row> extends PatientElement {
  #order: Order;
  /** Numbers of the rows in the displayed order. */
  #sorted: readonly number[] = [];
  /** Input that `#sorted` was computed from. */
  #sortedFrom: readonly unknown[] = [];
  /** Number of the row in the tab order. */
  #stop = 0;
  #isUnfolded = false;
  /**
   * Last selected target, to notice a new selection; and the last target selected in this table.
   */
  #selected: Target | undefined;
  #chosen: Target | undefined;

  /** Number of the row with an open text field. */
  protected edited: number | undefined;

  protected constructor(order: Order) {
    super();
    this.#order = order;
  }

  protected abstract get label(): string;
  /** Number in the caption. */
  protected get count(): number {
    return this.rows.length;
  }
  /** Rows from this number on are folded away under these words. */
  protected get folded(): {readonly from: number; readonly words: string} | undefined {
    return undefined;
  }
  protected abstract get columns(): readonly Column<Row>[];
  /** Row n is piece or seam n. */
  protected abstract get rows(): readonly Row[];
  protected abstract targetOf(number: number): Target;
  /** Returns the row number of a target; undefined if another table contains it. */
  protected abstract numberOf(target: Target): number | undefined;
  /** @param tabIndex for the controls in the row */
  protected abstract cells(row: Row, tabIndex: number): TemplateResult;
  /** Text in place of an empty table. */
  protected abstract get empty(): string | undefined;

  protected override render(): TemplateResult {
    const {columns, rows, label, folded} = this;
    const {selected, pointed} = this.workbench.selection;
    const [selectedRow, pointedRow] = [selected, pointed].map((one) => one && this.numberOf(one));
    this.#sort(rows, columns);
    if (this.#stop >= rows.length) this.#stop = this.#sorted[0] ?? 0;
    const {empty} = this;
    const shown = folded && !this.#isUnfolded ? folded.from : rows.length;
    return html`
      <table aria-label=${label}>
        <caption>
          ${label}
          <span class="soft">${this.count || ''}</span>
        </caption>
        <thead>
          <tr>
            ${columns.map((column, k) => this.#header(column, k))}
          </tr>
        </thead>
        <tbody
          @click=${this.#click}
          @keydown=${this.#key}
          @pointerover=${this.#point}
          @pointerleave=${this.#leave}
          @focusin=${this.#point}
          @focusout=${this.#leave}
        >
          ${repeat(
            this.#sorted,
            (number) => number,
            (number) => {
              const row = rows[number];
              const isSelected = number === selectedRow;
              const tabIndex = number === this.#stop ? 0 : -1;
              const state = isSelected ? 'selected' : number === pointedRow ? 'pointed' : '';
              const isEdited = number === this.edited;
              const isHidden = number >= shown;
              const fold = number === folded?.from ? folded.words : undefined;
              const {texts, format} = this;
              const shows = [row, state, tabIndex, isEdited, isHidden, fold, texts, format];
              return guard(shows, () =>
                row === undefined
                  ? nothing
                  : html`${fold === undefined ? nothing : this.#fold(fold, columns.length)}
                      <tr
                        data-number=${number}
                        class=${state}
                        tabindex=${tabIndex}
                        aria-selected=${isSelected}
                        ?hidden=${isHidden}
                      >
                        ${this.cells(row, tabIndex)}
                      </tr>`,
              );
            },
          )}
        </tbody>
      </table>
      ${empty === undefined ? nothing : html`<p class="soft">${empty}</p>`}
    `;
  }

  /** The line that folds the rows after it. */
  #fold(words: string, columns: number): TemplateResult {
    return html`<tr class="fold">
      <td colspan=${columns}>
        <button
          class="link"
          aria-expanded=${this.#isUnfolded}
          @click=${() => {
            this.#unfold(!this.#isUnfolded);
          }}
        >
          ${words}
        </button>
      </td>
    </tr>`;
  }

  #unfold(isUnfolded: boolean): void {
    this.#isUnfolded = isUnfolded;
    this.requestUpdate();
  }

  #header({title, key, numeric = false}: Column<Row>, column: number): TemplateResult {
    const cell = numeric ? 'number' : '';
    if (!key) return html`<th scope="col" class=${cell}>${title}</th>`;
    const {column: by, descending} = this.#order;
    const direction = descending ? 'descending' : 'ascending';
    return html`<th scope="col" class=${cell} aria-sort=${by === column ? direction : nothing}>
      <button
        @click=${() => {
          this.#order = {column, descending: by === column ? !descending : numeric};
          this.#sortedFrom = [];
          this.requestUpdate();
        }}
      >
        ${title}
      </button>
    </th>`;
  }

  /** Rows keep their order during a solve, since their values change many times a second. */
  #sort(rows: readonly Row[], columns: readonly Column<Row>[]): void {
    const {column, descending} = this.#order;
    const {language} = this.workbench.preferences.chosen;
    const from = [rows, language];
    const runs =
      this.workbench.solving.state.kind === 'solving' && this.#sorted.length === rows.length;
    const isSame = from.every((one, k) => one === this.#sortedFrom[k]);
    if (this.#sortedFrom.length > 0 && (runs || isSame)) return;
    this.#sortedFrom = from;
    const numbers = new Map(rows.map((row, number) => [row, number]));
    const key = columns[column]?.key ?? (() => undefined);
    this.#sorted = inOrder(rows, key, descending, language).map((row) => numbers.get(row) ?? 0);
  }

  /** A row that changes its place keeps the focus. */
  protected override update(...given: Parameters<PatientElement['update']>): void {
    const root = this.shadowRoot;
    const held = root?.activeElement;
    super.update(...given);
    if (held instanceof HTMLElement && held.isConnected && root?.activeElement !== held) {
      held.focus({preventScroll: true});
    }
  }

  protected override updated(): void {
    const {selected} = this.workbench.selection;
    if (selected === this.#selected) return;
    this.#selected = selected;
    const number = selected && this.numberOf(selected);
    if (number === undefined || selected === this.#chosen) return;
    this.#setStop(number);
    if (number >= (this.folded?.from ?? Infinity)) this.#unfold(true);
    const row = this.renderRoot.querySelector<HTMLElement>(`tr[data-number="${number}"]`);
    if (row) reveal(row, this);
  }

  /** Focuses the controls of a row again. */
  protected focusRow(number: number): void {
    this.#setStop(number);
    this.renderRoot.querySelector<HTMLElement>(`tr[data-number="${number}"]`)?.focus();
  }

  #setStop(number: number): void {
    if (number === this.#stop) return;
    this.#stop = number;
    this.requestUpdate();
  }

  #click = (event: MouseEvent): void => {
    const number = rowNumber(event);
    if (number !== undefined && !isInControl(event)) this.#choose(number);
  };

  #key = (event: KeyboardEvent): void => {
    const {target, key} = event;
    const row = target instanceof Element ? target.closest('tr') : null;
    if (!row || (target !== row && !row.matches('.fold'))) return;
    const number = rowNumber(event);
    const rows = [...(row.parentElement?.querySelectorAll<HTMLElement>('tr:not([hidden])') ?? [])];
    const at = rows.indexOf(row);
    const to = {
      ArrowDown: rows[at + 1],
      ArrowUp: rows[at - 1],
      Home: rows[0],
      End: rows.at(-1),
    }[key];
    if (to) (to.querySelector<HTMLElement>('[aria-expanded]') ?? to).focus();
    else if (key === 'Escape') this.workbench.selection.select(undefined);
    else if (number !== undefined && (key === 'Enter' || key === ' ')) this.#choose(number);
    else if (event.ctrlKey || event.metaKey || event.altKey) return;
    else if (number === undefined || !this.press?.(number, key)) return;
    event.preventDefault();
  };

  /** Handles a key on a row that the table does not use. @returns true if the key has an effect */
  protected press?(number: number, key: string): boolean;

  #point = (event: Event): void => {
    const number = rowNumber(event);
    if (number === undefined) return;
    if (event.type === 'focusin') this.#setStop(number);
    this.workbench.selection.point(this.targetOf(number));
  };

  #leave = (): void => {
    this.workbench.selection.point(undefined);
  };

  #choose(number: number): void {
    this.#setStop(number);
    this.workbench.selection.select(this.targetOf(number));
    this.#chosen = this.workbench.selection.selected;
  }
}

function rowNumber({target}: Event): number | undefined {
  const row = target instanceof Element ? target.closest('tr') : null;
  return row?.dataset.number === undefined ? undefined : Number(row.dataset.number);
}

const isInControl = ({target}: Event): boolean =>
  target instanceof Element && target.closest('button, select, input') !== null;

/** Share of the column's height that the lens may cover at its foot. */
const lensShare = 0.35;

/** Scrolls only the column of the table, so that the drawing stays visible. */
function reveal(row: HTMLElement, table: HTMLElement): void {
  const column = scroller(table);
  if (!column) return;
  const [at, shown] = [row.getBoundingClientRect(), column.getBoundingClientRect()];
  const to = shown.bottom - lensShare * shown.height;
  if (at.top < shown.top || at.bottom > to) {
    column.scrollTop += (at.top + at.bottom - shown.top - to) / 2;
  }
}

function scroller(element: Element): Element | undefined {
  const root = element.getRootNode();
  const parent = element.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
  if (!parent || parent === document.body) return undefined;
  const scrolls = ['auto', 'scroll'].includes(getComputedStyle(parent).overflowY);
  return scrolls && parent.scrollHeight > parent.clientHeight ? parent : scroller(parent);
}
