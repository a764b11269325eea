/** Menu of a line in the list of seams: how much the seam counts, and whether its outline stays. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {decide, toggleOutline} from '../../workbench/lists/group-actions.js';
import type {GroupRow} from '../../workbench/lists/group-rows.js';

const importances = ['first', 'well', 'hardly', 'none'] as const;

export class SeamMenu extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, row: {state: true}};
  declare protected row: GroupRow | undefined;

  static override styles = [
    controls,
    css`
      [popover] {
        position: fixed;
        margin: 0;
        padding: var(--sw-space-1);
        border: 1px solid var(--sw-line);
        border-radius: var(--sw-radius);
        background: var(--sw-raised);
        color: var(--sw-ink);
        box-shadow: 0 4px 16px rgb(0 0 0 / 0.14);
      }
      [popover]:popover-open {
        display: grid;
      }
      p {
        max-width: 16rem;
        padding: var(--sw-space-1) var(--sw-space-2);
        color: var(--sw-soft);
        font-size: var(--sw-text);
      }
      button {
        justify-content: start;
        border: 0;
      }
      button::before {
        content: '' / '';
        width: 1em;
      }
      [aria-checked='true']::before {
        content: '✓' / '';
      }
    `,
  ];

  /** @param at the button that opened the menu */
  async open(row: GroupRow, at: DOMRect): Promise<void> {
    this.row = row;
    await this.updateComplete;
    const menu = this.renderRoot.querySelector<HTMLElement>('[popover]');
    if (!menu || menu.matches(':popover-open')) return;
    menu.showPopover();
    const {width, height} = menu.getBoundingClientRect();
    const below = at.bottom + height < innerHeight ? at.bottom : at.top - height;
    menu.style.inset = `${Math.max(4, below)}px auto auto ${Math.max(4, at.right - width)}px`;
    menu.querySelector('button')?.focus();
  }

  protected override render(): TemplateResult | typeof nothing {
    const {row} = this;
    if (!row) return nothing;
    const {lists} = this.texts;
    return html`<div
      popover
      role="menu"
      aria-label=${lists.of(lists.menu, row.name)}
      @keydown=${this.#key}
      @toggle=${({newState}: ToggleEvent) => {
        if (newState === 'closed') this.dispatchEvent(new Event('close'));
      }}
    >
      <p>${row.isVisible ? lists.visible.well : lists.visible.some}</p>
      ${importances.map((one) =>
        this.#item(lists.importance[one], row.importance === one, !row.canMatch, () => {
          decide(this.workbench, row, row.importance === one ? 'usual' : one);
        }),
      )}
      ${this.#item(lists.keep, row.kept, false, () => {
        toggleOutline(this.workbench, row);
      })}
    </div>`;
  }

  #item(text: string, isChecked: boolean, isOff: boolean, act: () => void): TemplateResult {
    return html`<button
      role="menuitemcheckbox"
      aria-checked=${isChecked}
      ?disabled=${isOff}
      @click=${() => {
        this.renderRoot.querySelector<HTMLElement>('[popover]')?.hidePopover();
        act();
      }}
    >
      ${text}
    </button>`;
  }

  readonly #key = (event: KeyboardEvent): void => {
    event.stopPropagation(); // letters are no shortcuts here
    const items = [...this.renderRoot.querySelectorAll<HTMLElement>('button:enabled')];
    const at = items.findIndex((item) => item === this.shadowRoot?.activeElement);
    const to = {ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1}[event.key];
    if (to === undefined) return;
    event.preventDefault();
    items.at(to % items.length)?.focus();
  };
}
