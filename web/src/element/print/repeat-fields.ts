/** How large the repeat is on the cloth, and how it lies there. */
import {css, html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import type {DesignPrint} from '../../model/design.js';
import {
  coupledSize,
  fittingGroup,
  isCoupled,
  type FittingGroup,
  type RepeatSize,
} from '../../model/repeat.js';
import {latticeType} from '../../model/wallpaper.js';
import {lengthUnit} from '../controls/number-field.js';
import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';
import {missing} from './choices.js';
import {withGroup} from './own-print.js';

const leastCm = 0.2;
const mostCm = 200;

export class RepeatFields extends DeskElement {
  static override properties = {...DeskElement.properties, measured: {state: true}};
  /** A cell that somebody measured on cloth and that the print's group does not allow. */
  declare protected measured: {readonly of: DesignPrint; readonly size: RepeatSize} | undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: var(--sw-space-3) var(--sw-space-2);
      }
      .offer,
      .question {
        grid-column: 1 / -1;
      }
      .offer {
        display: grid;
        gap: var(--sw-space-2);
        padding: var(--sw-space-3);
        border-radius: var(--sw-radius);
        background: var(--sw-tint);
      }
      .offer div {
        display: flex;
        gap: var(--sw-space-2);
      }
      .question p {
        margin-left: calc(1rem + var(--sw-space-2));
      }
    `,
  ];

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.measured && this.measured.of !== this.desk.design?.print) this.measured = undefined;
  }

  protected override render(): TemplateResult | typeof nothing {
    const print = this.desk.design?.print;
    if (!print) return nothing;
    const {size, turnDeg, group, oneWay} = print;
    const texts = this.texts.print;
    return html`
      ${this.#length(texts.width, size.width, (width) => {
        this.#resize(print, {...size, width});
      })}
      ${this.#length(texts.height, this.measured?.size.height ?? size.height, (height) => {
        const measured = {...size, height};
        if (isCoupled(group)) this.measured = {of: print, size: measured};
        else this.#resize(print, measured);
      })}
      ${this.#offer(print)}
      ${
        latticeType(group) === 'oblique'
          ? this.#degrees(texts.angle, size.angleDeg, 20, 160, (angleDeg) => {
              this.#resize(print, {...size, angleDeg});
            })
          : nothing
      }
      ${this.#degrees(texts.turn, turnDeg, -180, 180, (degrees) => {
        this.desk.change({print: {...print, turnDeg: degrees}}, 'print size');
      })}
      <div class="question">
        <label class="inline">
          <input
            type="checkbox"
            aria-describedby="upside-down"
            .checked=${oneWay}
            @change=${(event: Event) => {
              const {checked} = event.target as HTMLInputElement;
              this.desk.change({print: {...print, oneWay: checked}});
            }}
          />
          ${texts.oneWay}
        </label>
        <p id="upside-down" class="soft">${texts.oneWayNote}</p>
      </div>
    `;
  }

  #length(
    label: (unit: string) => string,
    value: number,
    enter: (cm: number) => void,
  ): TemplateResult {
    const {name, cm} = lengthUnit[this.desk.preferences.units];
    const {format} = this;
    return html`<sw-number-field
      .label=${label(name)}
      .value=${value / cm}
      .subject=${this.desk.design?.print.image}
      .least=${leastCm / cm}
      .most=${mostCm / cm}
      .step=${0.1}
      .wrong=${this.texts.controls.between(format.length(leastCm), format.length(mostCm))}
      @entered=${({detail}: CustomEvent<number>) => {
        enter(detail * cm);
      }}
    ></sw-number-field>`;
  }

  #degrees(
    label: string,
    value: number,
    least: number,
    most: number,
    enter: (degrees: number) => void,
  ): TemplateResult {
    return html`<sw-number-field
      .label=${label}
      .value=${value}
      .subject=${this.desk.design?.print.image}
      .least=${least}
      .most=${most}
      .wrong=${this.texts.controls.between(`${least}°`, `${most}°`)}
      @entered=${({detail}: CustomEvent<number>) => {
        enter(detail);
      }}
    ></sw-number-field>`;
  }

  /** What still fits a cell that was measured. */
  #offer(print: DesignPrint): TemplateResult | typeof nothing {
    const fitting = this.measured && fittingGroup(print.group, this.measured.size);
    // another cell of the picture than the measured one would have to be drawn anew
    const drawn = latticeType(print.group) === 'square' || print.cell === 'rectangular';
    if (!fitting || !drawn) return nothing;
    const texts = this.texts.print;
    const lacks = missing(fitting.group, this.desk.design?.symmetries ?? []);
    return html`<div class="offer" role="status">
      <p>${texts.notQuite(print.group, fitting.group)}</p>
      ${lacks ? html`<p>${texts.lacks[lacks](fitting.group)}</p>` : nothing}
      <div>
        <button
          class="outlined"
          ?disabled=${lacks !== undefined}
          @click=${() => this.#take(print, fitting)}
        >
          ${texts.take(fitting.group)}
        </button>
        <button
          @click=${() => {
            this.measured = undefined;
          }}
        >
          ${texts.keep(print.group)}
        </button>
      </div>
    </div>`;
  }

  #resize(print: DesignPrint, size: RepeatSize): void {
    this.desk.change({print: {...print, size: coupledSize(print.group, size)}}, 'print size');
  }

  async #take(print: DesignPrint, fitting: FittingGroup): Promise<void> {
    const smaller = await withGroup(print, fitting);
    if (this.desk.design?.print === print) this.desk.change({print: smaller});
  }
}
