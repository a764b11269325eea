/** The tools over the pattern. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {toolGroup, wordlessTools} from '../style/tool-group.js';
import type {PatternTools} from '../../workbench/tools/pattern-tools.js';

export class Toolbar extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, tools: {attribute: false}};
  declare tools: PatternTools;

  static override styles = [
    controls,
    toolGroup,
    css`
      :host {
        display: flex;
        container-type: inline-size;
      }
      /* words fit without icons, and on a phone icons without words */
      @container (34rem <= width < 54rem) {
        .tool svg {
          display: none;
        }
      }
      @container (34rem <= width < 42rem) {
        .group button {
          padding: 0 5px; /* one row beside both panels of a small screen */
        }
      }
      @container (width < 34rem) {
        .group .all {
          flex: 0 1 auto;
          line-height: 1.2;
          text-align: start;
          white-space: normal;
        }
        .group {
          flex-wrap: nowrap;
        }
        ${wordlessTools}
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {symmetry} = this.texts;
    return html`
      <div
        class="group"
        role="toolbar"
        aria-label=${symmetry.tools}
        @keydown=${(event: KeyboardEvent) => {
          if (event.key !== 'Escape' || !this.tools.back()) return;
          event.preventDefault();
          event.stopPropagation();
        }}
      >
        ${this.tools.canSew ? this.#tool('sew', this.texts.sewing.tool, icon.sew) : nothing}
        ${this.tools.canSew ? this.#tool('fold', this.texts.folding.tool, icon.fold) : nothing}
        ${this.#tool('piece', symmetry.piece, icon.piece)}
        ${this.#tool('pair', symmetry.pair, icon.pair)}
        ${this.#tool('move', symmetry.move, icon.move)}
        ${this.#tool('keep', this.texts.keep.tool, icon.lock)} ${this.#acceptAll()}
      </div>
    `;
  }

  #tool(
    name: 'sew' | 'fold' | 'piece' | 'pair' | 'move' | 'keep',
    label: string,
    picture: TemplateResult,
  ): TemplateResult {
    return html`<button
      class="tool"
      title=${label}
      aria-pressed=${this.tools.active === name}
      @click=${() => {
        this.tools.toggle(name);
      }}
    >
      ${picture} <span>${label}</span>
    </button>`;
  }

  #acceptAll(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    const {found} = this.workbench.solving;
    if (!design || found.length === 0) return nothing;
    const {symmetry} = this.texts;
    return html`<button
      class="all"
      title=${symmetry.foundCount(found.length)}
      @click=${() => {
        this.tools.acceptAll();
      }}
    >
      ${symmetry.acceptAll}
    </button>`;
  }
}
