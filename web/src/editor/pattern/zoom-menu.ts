/** Zoom of the pattern in per cent of its true size, with other sizes to choose or to enter. */
import {css, html, type PropertyValues, type TemplateResult} from 'lit';

import type {PatternView} from '../../viewer/pattern-view.js';
import type {NumberField} from '../controls/number-field.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';

/** Scale at 100 %, as CSS defines it. [CSS px per cm] */
const trueScale = 96 / 2.54;
const presets = [0.5, 1, 2];
/** Limits of an entry; the view has its own limits. [%] */
const [least, most] = [1, 1000];

export class ZoomMenu extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, view: {attribute: false}};
  declare view: PatternView | undefined;
  #end: (() => void) | undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
      }
      .shown {
        min-width: 3.75rem;
        padding: 0 var(--sw-space-1);
      }
      @media (pointer: coarse) {
        .shown {
          min-width: var(--sw-target); /* in the place of the buttons beside it */
        }
      }
      [popover] {
        inset: auto;
        position: fixed;
        width: 11rem;
        padding: var(--sw-space-2);
      }
      .sizes {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: var(--sw-space-1);
        margin-bottom: var(--sw-space-2);
      }
    `,
  ];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#end?.();
    this.#end = undefined;
  }

  /** Opens the menu, with the focus in the field. */
  open(): void {
    this.#panel?.showPopover();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (!changed.has('view')) return;
    this.#end?.();
    this.#end = this.view?.onViewChange(() => {
      this.requestUpdate();
    });
  }

  protected override render(): TemplateResult {
    const {pattern} = this.texts;
    const shown = this.format.percent(this.#share);
    return html`<button
        class="shown"
        aria-label=${pattern.zoomed(shown)}
        title=${pattern.zoom}
        aria-haspopup="dialog"
        popovertarget="sizes"
      >
        ${shown}
      </button>
      <div
        popover
        id="sizes"
        role="dialog"
        aria-label=${pattern.zoom}
        @beforetoggle=${({newState}: ToggleEvent) => {
          if (newState === 'open') this.#place();
        }}
        @toggle=${({newState}: ToggleEvent) => {
          if (newState === 'open') this.#field?.focus();
        }}
      >
        <div class="sizes">
          ${this.#size(pattern.fit, () => this.view?.fit())}
          ${presets.map((share) =>
            this.#size(this.format.percent(share), () => {
              this.#zoomTo(share);
            }),
          )}
        </div>
        <sw-number-field
          .label=${pattern.zoomPercent}
          .value=${100 * this.#share}
          .least=${least}
          .most=${most}
          .step=${5}
          .digits=${0}
          .wrong=${pattern.zoomWrong(String(least), String(most))}
          @entered=${({detail}: CustomEvent<number>) => {
            this.#zoomTo(detail / 100);
          }}
          @keydown=${({key}: KeyboardEvent) => {
            if (key === 'Enter') this.#close();
          }}
        ></sw-number-field>
      </div>`;
  }

  /** Share of the true size. */
  get #share(): number {
    return (this.view?.scale ?? trueScale) / trueScale;
  }

  get #panel(): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>('[popover]');
  }

  get #field(): NumberField | null {
    return this.renderRoot.querySelector<NumberField>('sw-number-field');
  }

  #zoomTo(share: number): void {
    this.view?.zoomBy(share / this.#share);
  }

  #size(label: string, act: () => void): TemplateResult {
    return html`<button
      class="outlined"
      @click=${() => {
        act();
        this.#close();
      }}
    >
      ${label}
    </button>`;
  }

  /** A wrong entry keeps the menu open. */
  #close(): void {
    if (this.#field?.isWrong) return;
    this.#panel?.hidePopover();
    this.renderRoot.querySelector('button')?.focus();
  }

  /** Places the menu above its button, within the window. */
  #place(): void {
    const panel = this.#panel;
    const {right, top} = this.renderRoot.querySelector('button')?.getBoundingClientRect() ?? {};
    if (!panel || right === undefined || top === undefined) return;
    panel.style.right = `max(var(--sw-space-1), ${innerWidth - right}px)`;
    panel.style.bottom = `calc(${innerHeight - top}px + var(--sw-space-2))`;
  }
}
