/** Close-up of one seam: both sides next to each other, as sewn. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {DesignGarment} from '../../model/design/design.js';
import {PatientElement} from '../base/workbench-element.js';
import {firstOff, groupRows, nextSeam} from '../../workbench/lists/group-rows.js';
import {remarkOn, seamRows, type SeamRow} from '../../workbench/lists/rows.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';

export class SeamLens extends PatientElement {
  /** `wide`: the user wants a tall strip; the editor shows one if it has room. */
  static override properties = {
    ...PatientElement.properties,
    wide: {type: Boolean, reflect: true},
  };
  declare wide: boolean;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
        padding: var(--sw-space-2) var(--sw-space-4);
        background: var(--sw-paper);
      }
      .lens {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: var(--sw-space-1);
        border-radius: var(--sw-radius);
      }
      .lens:focus-visible {
        outline-offset: 5px; /* in the margin, off words and picture */
      }
      header {
        display: flex;
        align-items: start;
        gap: var(--sw-space-1);
      }
      .name {
        flex: 1;
        min-width: 0;
      }
      @media (pointer: coarse) {
        header {
          flex-wrap: wrap; /* large buttons would leave no room for the name */
        }
        .name {
          flex: 1 0 100%;
        }
      }
      h3 {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      p {
        font-size: var(--sw-text);
      }
      .title,
      .name p {
        display: flex;
        align-items: center;
        gap: var(--sw-space-1);
      }
      header button {
        flex: none;
        width: var(--sw-target);
        padding: 0;
      }
      sw-lens-strip {
        height: 8rem;
      }
      sw-lens-strip:not(:defined) {
        display: block;
      }
      :host([wide]) sw-lens-strip {
        height: 14rem;
      }
    `,
  ];

  /** The pinned seam of this garment; it stays in the lens wherever the pointer is. */
  #pinned: {readonly seam: number; readonly garment: DesignGarment} | undefined;

  #wasAwake = false;

  constructor() {
    super();
    this.wide = false;
  }

  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector<HTMLElement>('.lens')?.focus(options);
  }

  protected override render(): TemplateResult {
    const {lens} = this.texts;
    const rows = seamRows(this.workbench, this.texts);
    const row = rows[this.#seam(rows) ?? -1];
    return html`<section
      class="lens"
      role="group"
      aria-label=${lens.label}
      aria-description=${lens.description}
      tabindex="0"
      @keydown=${this.#key}
    >
      ${row && this.#isAwake ? this.#showing(row) : html`<p class="soft">${lens.none}</p>`}
    </section>`;
  }

  #showing(row: SeamRow): TemplateResult {
    const {format} = this;
    const {lens, pattern} = this.texts;
    const remark = remarkOn(row, this.texts, format);
    return html`
      <header>
        <div class="name">
          <div class="title">
            <span class="letter">${row.letter}</span>
            <h3 title=${row.name}>${row.name}</h3>
          </div>
          <p class="soft">
            ${row.counts ? html`${icon[row.kind]} ${pattern[row.kind]}` : pattern.notCounted},
            ${format.length(row.length)}
          </p>
        </div>
        ${this.#button(lens.previous, icon.up, () => {
          this.#walk(-1);
        })}
        ${this.#button(lens.next, icon.down, () => {
          this.#walk(1);
        })}
        ${this.#toggle(lens.pin, icon.pin, this.#pinned !== undefined, () => {
          this.#pin(this.#pinned ? undefined : row.seam);
        })}
        ${this.#toggle(lens.widen, icon.widen, this.wide, () => {
          this.wide = !this.wide;
        })}
      </header>
      <sw-lens-strip .workbench=${this.workbench} .row=${row}></sw-lens-strip>
      <p class="soft">
        ${lens.mismatch(format.fine(row.before), format.fine(row.after))}${remark === undefined ? nothing : `; ${remark}`}
      </p>
    `;
  }

  /** True once the lens may draw: its drawing takes time, which the first solve needs. */
  get #isAwake(): boolean {
    return (this.#wasAwake ||=
      this.workbench.solving.state.kind !== 'solving' &&
      this.workbench.solving.state.kind !== 'empty');
  }

  /** Index of the displayed seam. */
  #seam(rows: readonly SeamRow[]): number | undefined {
    const {design} = this.workbench.history;
    const {pointed, selected} = this.workbench.selection;
    if (this.#pinned && this.#pinned.garment !== design?.garment) this.#pinned = undefined;
    const meant = [pointed, selected].find((target) => target?.kind === 'seam');
    if (this.#pinned) return this.#pinned.seam;
    if (meant?.kind === 'seam') return meant.seam;
    const groups = groupRows(this.workbench, this.texts);
    return (firstOff(groups) ?? groups[0])?.worst ?? rows[0]?.seam;
  }

  #pin(seam: number | undefined): void {
    const garment = this.workbench.history.design?.garment;
    this.#pinned = seam === undefined || !garment ? undefined : {seam, garment};
    this.requestUpdate();
  }

  #walk(step: 1 | -1): void {
    const rows = seamRows(this.workbench, this.texts);
    const seam = nextSeam(groupRows(this.workbench, this.texts), this.#seam(rows), step);
    if (seam === undefined) return;
    if (this.#pinned) this.#pin(seam);
    this.workbench.selection.select({kind: 'seam', seam, side: 'a'});
  }

  #key = (event: KeyboardEvent): void => {
    // the strip has its own arrow keys
    const onHandle = (event.target as Element).localName === 'sw-lens-strip';
    if (event.key === 'Escape' && this.#pinned) this.#pin(undefined);
    else if (event.key === 'ArrowDown' && !onHandle) this.#walk(1);
    else if (event.key === 'ArrowUp' && !onHandle) this.#walk(-1);
    else return;
    event.preventDefault();
  };

  #button(label: string, picture: TemplateResult, act: () => void): TemplateResult {
    return html`<button aria-label=${label} title=${label} @click=${act}>${picture}</button>`;
  }

  #toggle(
    label: string,
    picture: TemplateResult,
    pressed: boolean,
    act: () => void,
  ): TemplateResult {
    return html`<button aria-label=${label} title=${label} aria-pressed=${pressed} @click=${act}>
      ${picture}
    </button>`;
  }
}
