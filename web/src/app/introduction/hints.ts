/**
 * Three short hints for a new user, one at a time. Sends `given` with a dismissed or followed hint
 * as its detail; it never appears again.
 */
import {css, html, nothing, type TemplateResult} from 'lit';

import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {icon} from '../../editor/style/icons.js';
import type {Editor} from '../../editor/editor.js';

/** Hints that a new user has not seen yet, stored by the browser. */
const key = 'seamwise.introduction';

export const hints = ['print', 'compare', 'seam'] as const;
export type Hint = (typeof hints)[number];

/**
 * Returns undefined on a first visit. Without storage there are none: they would return each time.
 */
export function hintsLeft(): readonly Hint[] | undefined {
  try {
    const kept = localStorage.getItem(key);
    return kept === null ? undefined : hints.filter((hint) => kept.split(' ').includes(hint));
  } catch {
    return [];
  }
}

/** @returns true if the browser stores them */
export function keepHints(left: readonly Hint[]): boolean {
  try {
    localStorage.setItem(key, left.join(' '));
    return true;
  } catch {
    return false;
  }
}

export class Hints extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    editor: {attribute: false},
    left: {attribute: false},
  };
  /** Returns null before the editor is drawn. */
  declare editor: () => Editor | null;
  /** Hints that are still to be shown. */
  declare left: readonly Hint[];

  static override styles = [
    controls,
    css`
      :host {
        position: absolute;
        inset: 0;
        display: flex;
        align-items: center;
        background: var(--sw-ground);
      }
      :host([hidden]) {
        display: none;
      }
      .hint {
        display: flex;
        flex: 1;
        align-items: center;
        gap: var(--sw-space-1);
        max-width: 36rem;
        min-height: min(3rem, 100%);
        max-height: 100%;
        padding-left: var(--sw-space-3);
        border: 1px solid var(--sw-line);
        border-radius: var(--sw-radius);
        background: var(--sw-tint);
        line-height: 1.25;
      }
      p {
        flex: 1;
      }
      svg {
        vertical-align: -0.2em;
      }
      button {
        flex: none;
        width: var(--sw-target);
        padding: 0;
      }
      @container (width < 40rem) {
        .hint {
          padding-left: var(--sw-space-2);
          font-size: var(--sw-text-small);
        }
      }
    `,
  ];

  /** The first answer has arrived. */
  #isReady = false;
  #print: string | undefined;
  readonly #look = (): void => {
    // runs after all listeners, once the press or key has taken effect
    setTimeout(() => {
      if (this.editor()?.pattern?.split !== undefined) this.#done('compare');
    });
  };

  override connectedCallback(): void {
    super.connectedCallback();
    for (const type of ['click', 'keydown']) addEventListener(type, this.#look, true);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const type of ['click', 'keydown']) removeEventListener(type, this.#look, true);
  }

  /** Drops the hints that the user has already followed. */
  protected override updated(): void {
    const {design} = this.workbench.history;
    const {selected} = this.workbench.selection;
    const print = design && `${design.print.title} ${design.print.image}`;
    if (this.#print !== undefined && print !== this.#print) this.#done('print');
    this.#print = print;
    if (selected?.kind === 'seam') this.#done('seam');
  }

  protected override render(): TemplateResult | typeof nothing {
    const [hint] = this.left;
    this.#isReady ||= this.workbench.solving.state.kind === 'done';
    this.hidden = hint === undefined || !this.#isReady;
    if (hint === undefined) return nothing;
    const {app, introduction} = this.texts;
    const words = {
      print: introduction.print,
      compare: html`${icon.before} ${introduction.compare}`,
      seam: introduction.seam,
    };
    const number = hints.indexOf(hint) + 1;
    return html`<div
      class="hint"
      role="note"
      aria-label=${introduction.label(number, hints.length)}
    >
      <p>${words[hint]}</p>
      <button
        aria-label=${app.dismiss}
        title=${app.dismiss}
        @click=${() => {
          this.#done(hint);
          if (this.left.length === 1) this.editor()?.toPattern(); // the focused button disappears
        }}
      >
        ${icon.close}
      </button>
    </div>`;
  }

  #done(hint: Hint): void {
    if (this.left.includes(hint)) this.dispatchEvent(new CustomEvent('given', {detail: hint}));
  }
}
