/** Instructions of the active tool, and buttons for it. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import type {PatternTools} from '../../workbench/tools/pattern-tools.js';
import {centred, middleToCentre} from '../../workbench/tools/centring.js';
import {pin, unpin} from '../../workbench/tools/print-mover.js';

export class ToolHint extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, tools: {attribute: false}};
  declare tools: PatternTools;

  static override styles = [
    controls,
    css`
      .hint {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: var(--sw-space-1) var(--sw-space-2);
      }
      .hint > span {
        flex: 1 1 16rem;
        line-height: 1.3;
      }
      .asks {
        font-size: var(--sw-text-large);
        font-weight: 600;
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {symmetry} = this.texts;
    const {chooser} = this.tools;
    return html`<div class="hint">
      <span
        role="status"
        class=${this.tools.sewing?.chooser.question ? 'asks' : ''}
        aria-label=${symmetry.hint}
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
      ${this.tools.active === 'move' ? html`${this.#presets()} ${this.#free()}` : nothing}
      ${this.tools.active === 'keep' ? html`<sw-keep-menu .workbench=${this.workbench}></sw-keep-menu>` : nothing}
      ${this.tools.isFixed ? nothing : this.#leaving()}
    </div>`;
  }

  /** Ends the sewing tool if no edge is chosen; goes one step back in all other cases. */
  #leaving(): TemplateResult {
    const {symmetry, sewing} = this.texts;
    const isIdle = this.tools.sewing?.chooser.state.run.length === 0;
    return html`<button
      class="outlined"
      @click=${() => {
        if (isIdle) this.tools.toggle('sew');
        else this.tools.back();
      }}
    >
      ${isIdle ? sewing.done : symmetry.back}
    </button>`;
  }

  /** Button for the selected piece, while it is pinned. */
  #free(): TemplateResult | typeof nothing {
    const {selected} = this.workbench.selection;
    const {scenes} = this.workbench.sheet;
    const {design} = this.workbench.history;
    const piece = selected?.kind === 'piece' ? scenes?.now.pieces[selected.piece] : undefined;
    if (!piece || !design?.options.pins?.[piece.name]) return nothing;
    return html`<button
      class="outlined"
      @click=${() => {
        unpin(this.workbench, piece);
      }}
    >
      ${this.texts.symmetry.freePiece(piece.label)}
    </button>`;
  }

  #presets(): TemplateResult {
    const {symmetry} = this.texts;
    const preset = (what: 'motif' | 'line', label: string): TemplateResult =>
      html`<button
        class="outlined"
        @click=${() => {
          const middle = middleToCentre(this.workbench);
          if (middle) pin(this.workbench, middle.piece, centred(middle, what));
        }}
      >
        ${label}
      </button>`;
    return html`${preset('motif', symmetry.centreMotif)} ${preset('line', symmetry.centreLine)}`;
  }
}
