/** What there is to take away beside project and result: a picture, and the pieces to cut. */
import {css, html, type TemplateResult} from 'lit';

import {controls, DeskElement, icon, lengthUnit, placeUnder} from '../element/index.js';
import {unseen} from './page-layout.js';
import {copyLink, saveCutting, savePicture} from './save.js';

/** What most sewing patterns have. [cm] */
const usualAllowance = 1;

export class SaveMenu extends DeskElement {
  static override properties = {...DeskElement.properties, allowance: {state: true}};
  declare allowance: number;

  static override styles = [
    controls,
    css`
      :host {
        display: inline-block;
      }
      [popover] {
        width: 18rem;
      }
      .rows {
        display: grid;
        gap: var(--sw-space-3);
      }
      .rows button {
        justify-content: start;
      }
      @container (width < 40rem) {
        .label {
          ${unseen}
        }
      }
    `,
  ];

  constructor() {
    super();
    this.allowance = usualAllowance;
  }

  protected override render(): TemplateResult {
    const {app} = this.texts;
    const {desk} = this;
    const {cm, name} = lengthUnit[desk.preferences.units];
    return html`
      <button class="outlined" popovertarget="save" ?disabled=${!desk.result}>
        ${icon.save} <span class="label">${app.saveMore}</span>
      </button>
      <div
        popover
        id="save"
        @beforetoggle=${({currentTarget}: Event) => {
          placeUnder(this.renderRoot.querySelector('button'), currentTarget as HTMLElement);
        }}
      >
        <div class="rows">
          <button class="outlined" @click=${() => void savePicture(desk)}>
            ${icon.save} ${app.savePicture}
          </button>
          <label>
            ${app.allowance(name)}
            <input
              type="number"
              min="0"
              max=${5 / cm}
              step=${0.1}
              .value=${String(Number((this.allowance / cm).toFixed(3)))}
              @change=${(event: Event) => {
                const value = (event.target as HTMLInputElement).valueAsNumber * cm;
                if (value >= 0 && value <= 5) this.allowance = value;
                else this.requestUpdate();
              }}
            />
          </label>
          <button class="outlined" @click=${() => void saveCutting(desk, this.allowance)}>
            ${icon.save} ${app.saveCutting}
          </button>
          <button class="outlined" @click=${() => void copyLink(desk)}>
            ${icon.link} ${app.copyLink}
          </button>
        </div>
      </div>
    `;
  }
}
