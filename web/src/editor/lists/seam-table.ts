/** The seams that a sewist counts: visible ones first, the others folded. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {SeamState} from '../../model/result/result.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import type {Target} from '../../workbench/workbench.js';
import {reasonOf, wayOut} from '../../workbench/lists/group-actions.js';
import {foldedWords, groupRows, type GroupRow} from '../../workbench/lists/group-rows.js';
import {firstUpper} from '../../workbench/lists/names.js';
import {listStyle} from './list-style.js';
import {ListTable, type Column} from './list-table.js';
import type {SeamMenu} from './seam-menu.js';

/** Marks that differ by shape as well as by colour. */
const marks: Readonly<Record<SeamState, string>> = {
  ...{matches: '●', close: '◐', off: '○', cannot: '⊘', choice: '–'},
};

const wholeMillimetres = (cm: number): number => Math.round(10 * cm) / 10;

const stateWords = (
  state: SeamState,
  {after, end}: GroupRow,
  {lists: {states}}: Texts,
  format: Format,
): string => {
  if (state === 'close' && end) return states.nearly; // the rest of it matches
  return state === 'close' || state === 'off'
    ? states[state](format.fine(wholeMillimetres(after)))
    : states[state];
};

export class SeamTable extends ListTable<GroupRow> {
  static override styles = [
    controls,
    listStyle,
    css`
      thead {
        position: absolute;
        clip-path: inset(50%); /* the columns need no words for the eye */
      }
      .seam {
        display: grid;
        grid-template-columns: 1.25rem minmax(0, 1fr);
        align-items: baseline;
      }
      .mark {
        color: var(--sw-soft);
        font-size: var(--sw-text);
      }
      .matches {
        color: light-dark(#1f7d47, #6fc48f);
      }
      .close {
        color: light-dark(#8a6500, #d9b04c);
      }
      .off {
        color: var(--sw-bad);
      }
      .why {
        grid-column: 2;
        color: var(--sw-soft);
      }
      .why .link {
        font-size: inherit;
        line-height: inherit;
        text-align: start;
        white-space: normal;
      }
      .more {
        width: 1.75rem;
      }
      .more button {
        width: 1.75rem;
        min-height: 1.5rem;
        margin-block: -0.15rem;
        padding: 0;
        border: 0;
        color: var(--sw-soft);
      }
      @media (pointer: coarse), (width < 40rem) {
        .why .link {
          display: flex;
        }
        .more button {
          width: var(--sw-target);
          min-height: var(--sw-target);
        }
      }
    `,
  ];

  /** Number of the row whose menu is open. */
  #opened: number | undefined;

  constructor() {
    super({column: -1, descending: false}); // rows have their order
  }

  protected override get label(): string {
    return this.texts.lists.seams;
  }

  protected override get count(): number {
    return this.rows.reduce((sum, {count}) => sum + count, 0);
  }

  protected override get columns(): readonly Column<GroupRow>[] {
    const {lists} = this.texts;
    return [{title: lists.seam}, {title: lists.state, numeric: true}, {title: lists.menu}];
  }

  protected override get rows(): readonly GroupRow[] {
    return groupRows(this.workbench, this.texts);
  }

  protected override get folded() {
    const words = foldedWords(this.rows, this.texts);
    return words === undefined
      ? undefined
      : {from: this.rows.findIndex(({isVisible}) => !isVisible), words};
  }

  protected override get empty(): string | undefined {
    const {scenes} = this.workbench.sheet;
    return scenes?.now.seams.length === 0 ? this.texts.pattern.noSeams : undefined;
  }

  protected override targetOf(number: number): Target {
    return {kind: 'seam', seam: this.rows[number]?.worst ?? -1, side: 'a'};
  }

  protected override numberOf(target: Target): number | undefined {
    if (target.kind !== 'seam') return undefined;
    const number = this.rows.findIndex(({seams}) => seams.includes(target.seam));
    return number < 0 ? undefined : number;
  }

  protected override render(): TemplateResult {
    return html`${super.render()}
      <sw-seam-menu
        .workbench=${this.workbench}
        @close=${() => {
          if (this.#opened !== undefined) this.focusRow(this.#opened);
          this.#opened = undefined;
        }}
      ></sw-seam-menu>`;
  }

  protected override cells(row: GroupRow, tabIndex: number): TemplateResult {
    const {lists, keep} = this.texts;
    const {state} = row;
    const words = state && stateWords(state, row, this.texts, this.format);
    return html`
      <th scope="row" title=${row.between}>
        <span class="seam">
          <span class="mark ${state ?? ''}" aria-hidden="true">${state ? marks[state] : '·'}</span>
          <span>
            ${row.name}
            ${row.kept ? html`<span class="kept" title=${keep.kept}>${icon.lock}</span>` : nothing}
          </span>
          ${this.#why(row, tabIndex)}
        </span>
      </th>
      <td class="number">${words}</td>
      <td class="more">
        <button
          tabindex=${tabIndex}
          aria-haspopup="menu"
          aria-label=${lists.of(lists.menu, row.name)}
          title=${lists.of(lists.menu, row.name)}
          @click=${() => {
            this.#openMenu(row);
          }}
        >
          ${icon.more}
        </button>
      </td>
    `;
  }

  protected override press(number: number, key: string): boolean {
    const row = this.rows[number];
    if (key !== 'ContextMenu' || !row) return false;
    this.#openMenu(row);
    return true;
  }

  #why(row: GroupRow, tabIndex: number): TemplateResult | typeof nothing {
    const {texts, format} = this;
    const why = reasonOf(this.workbench, row, texts, format);
    if (why === undefined) return nothing;
    const way = row.end ? undefined : wayOut(this.workbench, row, texts, format);
    const button =
      way &&
      html` <button class="link" tabindex=${tabIndex} @click=${way.act}>${way.text}</button>`;
    return html`<span class="why">${firstUpper(why)}.${button}</span>`;
  }

  #openMenu(row: GroupRow): void {
    const number = this.rows.indexOf(row);
    const at = this.renderRoot.querySelector(`tr[data-number="${number}"] .more button`);
    if (!at) return;
    this.#opened = number;
    void this.renderRoot
      .querySelector<SeamMenu>('sw-seam-menu')
      ?.open(row, at.getBoundingClientRect());
  }
}
