/** The tools over the pattern, and the sentence that says what to do next. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {withAll} from '../workbench/symmetry-steps.js';
import {centred, frontOf, pin} from './print-mover.js';
import type {PatternTools} from './pattern-tools.js';

export class Toolbar extends DeskElement {
  static override properties = {...DeskElement.properties, tools: {attribute: false}};
  declare tools: PatternTools;

  static override styles = [
    controls,
    css`
      :host {
        position: relative;
        z-index: 1;
        display: flex;
      }
      .tools,
      .hint {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 2px;
        padding: 2px;
        border: 1px solid var(--sw-line);
        border-radius: calc(var(--sw-radius) + 2px);
        background: var(--sw-paper);
      }
      .hint {
        position: absolute; /* the pattern must not move under the next click */
        top: 100%;
        left: var(--sw-space-3);
        width: max-content;
        gap: var(--sw-space-3);
        max-width: min(34rem, calc(100% - 2 * var(--sw-space-3)));
        padding: var(--sw-space-2) var(--sw-space-3);
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {symmetry} = this.texts;
    const {tools} = this;
    return html`
      <div class="tools" role="toolbar" aria-label=${symmetry.tools}>
        ${this.#tool('piece', symmetry.piece, icon.piece)}
        ${this.#tool('pair', symmetry.pair, icon.pair)}
        ${this.#tool('move', symmetry.move, icon.move)} ${this.#acceptAll()}
      </div>
      ${tools.active ? this.#hint() : nothing}
    `;
  }

  #tool(name: 'piece' | 'pair' | 'move', label: string, picture: TemplateResult): TemplateResult {
    return html`<button
      aria-pressed=${this.tools.active === name}
      @click=${() => {
        this.tools.toggle(name);
      }}
    >
      ${picture} ${label}
    </button>`;
  }

  #acceptAll(): TemplateResult | typeof nothing {
    const {design, found} = this.desk;
    if (!design || found.length === 0) return nothing;
    const {symmetry} = this.texts;
    return html`<button
      title=${symmetry.foundCount(found.length)}
      @click=${() => {
        this.tools.acceptAll(withAll(design, found));
      }}
    >
      ${symmetry.acceptAll}
    </button>`;
  }

  #presets(): TemplateResult {
    const {symmetry} = this.texts;
    const preset = (what: 'motif' | 'line', label: string): TemplateResult =>
      html`<button
        class="outlined"
        @click=${() => {
          const piece = frontOf(this.desk);
          if (piece) pin(this.desk, piece, centred(piece, what));
        }}
      >
        ${label}
      </button>`;
    return html`${preset('motif', symmetry.centreMotif)} ${preset('line', symmetry.centreLine)}`;
  }

  #hint(): TemplateResult {
    const {symmetry} = this.texts;
    const {chooser} = this.tools;
    return html`<div class="hint">
      <span role="status" aria-label=${symmetry.hint}
        >${this.tools.words(this.texts, this.format)}</span
      >
      ${
        chooser.isReady
          ? html`<button
              class="primary"
              @click=${() => {
                chooser.send({type: 'commit'});
              }}
            >
              ${symmetry.accept}
            </button>`
          : nothing
      }
      ${this.tools.active === 'move' ? this.#presets() : nothing}
      <button
        @click=${() => {
          this.tools.back();
        }}
      >
        ${symmetry.back}
      </button>
    </div>`;
  }
}

customElements.define('sw-toolbar', Toolbar);
