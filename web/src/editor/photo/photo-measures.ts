/** How large the print on a photograph is: by a tape, by two points, or by a coin or card that lies on the cloth. */
import {html, nothing, type TemplateResult} from 'lit';

import {norm, type Point} from '../../model/geometry.js';
import {knownObjects, type KnownObject} from '../../model/photo.js';
import {lengthUnit} from '../controls/number-field.js';
import {controls} from '../style/controls.js';
import {panelStyle} from './panel-style.js';
import {PhotoElement} from './photo-element.js';
import type {TwoPoints} from './photo-stage.js';
import {cellOf, isMisfit, measuresOf, type PhotoStep} from '../print/photo-step.js';
import {saidFailure} from './said-failure.js';

type Vector = 'w1' | 'w2';

/** What is measured by. */
const ways = ['tape', 'points', 'object'] as const;
export type Measuring = (typeof ways)[number];

/** As often as a tape is held along, unless somebody says otherwise. */
const usualRepeats = 10;
/** [cm] */
const leastMeasured = 0.1;
const mostMeasured = 10_000;
/** Thickness and round edges leave no less. */
const leastError = 0.01;

const vectors: readonly Vector[] = ['w1', 'w2'];

/** Fires `measuring` with a `Measuring`, `object` with a `KnownObject`, and `look` when it is to be looked for. */
export class PhotoMeasures extends PhotoElement {
  static override properties = {
    ...PhotoElement.properties,
    way: {},
    points: {attribute: false},
    object: {},
    repeats: {state: true},
  };
  static override styles = [controls, panelStyle];
  declare way: Measuring;
  declare points: TwoPoints | undefined;
  /** That lies on the cloth. */
  declare object: KnownObject;
  /** Along which a tape is held. */
  declare protected repeats: Readonly<Record<Vector, number>>;

  constructor() {
    super();
    this.way = 'tape';
    this.object = 'eur1';
    this.repeats = {w1: usualRepeats, w2: usualRepeats};
  }

  protected override render(): TemplateResult | typeof nothing {
    const {words, format, way} = this;
    const {step} = this.session.read;
    if (!step) return nothing;
    const {w1, w2, isScaled} = cellOf(step);
    const {size, group} = measuresOf(step);
    const length = (vector: Point): string => format.length(norm(vector));
    const [width, height] = [format.length(size.width), format.length(size.height)];
    return html`<section aria-label=${words.size}>
      <h3>${words.size}</h3>
      <p role="status">${isScaled ? words.measures(width, height) : words.unknown}</p>
      ${
        isMisfit(step)
          ? html`<p class="error" role="alert">${words.misfit(length(w1), length(w2), group)}</p>`
          : nothing
      }
      <div class="row" role="radiogroup" aria-label=${words.measureBy}>
        <span class="soft">${words.measureBy}</span>
        ${ways.map(
          (one) =>
            html`<label class="inline">
              <input
                type="radio"
                name="way"
                .checked=${one === way}
                @change=${() => {
                  this.#fire('measuring', one);
                }}
              />
              ${words.measuring[one]}
            </label>`,
        )}
      </div>
      ${way === 'tape' ? vectors.map((vector) => this.#tape(vector, step)) : nothing}
      ${way === 'points' && this.points ? this.#ruler(this.points, step) : nothing}
      ${way === 'object' ? this.#object(step) : nothing}
    </section>`;
  }

  #fire(type: string, detail?: Measuring | KnownObject): void {
    this.dispatchEvent(new CustomEvent(type, {detail}));
  }

  #number(
    label: string,
    value: number,
    least: number,
    most: number,
    enter: (value: number) => void,
  ): TemplateResult {
    const {between} = this.texts.controls;
    return html`<sw-number-field
      .label=${label}
      .value=${value}
      .least=${least}
      .most=${most}
      .step=${0.1}
      .wrong=${between(this.format.number(least), this.format.number(most))}
      @entered=${({detail}: CustomEvent<number>) => {
        enter(detail);
      }}
    ></sw-number-field>`;
  }

  /** @param cm NaN where it was not measured */
  #length(label: (unit: string) => string, length: number, enter: (cm: number) => void) {
    const {name, cm} = lengthUnit[this.workbench.preferences.units];
    return this.#number(
      label(name),
      length / cm,
      leastMeasured / cm,
      mostMeasured / cm,
      (entered) => {
        enter(entered * cm);
      },
    );
  }

  #tape(vector: Vector, step: PhotoStep): TemplateResult {
    const {words, session} = this;
    const measured = step[`${vector}Measured`];
    const repeats = measured?.repeats ?? this.repeats[vector];
    return html`<div class="beside" role="group" aria-label=${words.repeatsAlong(vector)}>
      ${this.#number(words.repeatsAlong(vector), repeats, 0.5, 10_000, (count) => {
        this.repeats = {...this.repeats, [vector]: count};
        if (measured) session.measure(vector, {...measured, repeats: count});
      })}
      ${this.#length(words.measure, measured?.cm ?? NaN, (cm) => {
        session.measure(vector, {repeats, cm});
      })}
    </div>`;
  }

  #ruler([from, to]: TwoPoints, {between}: PhotoStep): TemplateResult {
    const {words, session} = this;
    return html`<p class="soft">${words.between}</p>
      ${this.#length(words.distance, between?.cm ?? NaN, (cm) => {
        session.measureBetween({from, to, cm});
      })}`;
  }

  #object({object}: PhotoStep): TemplateResult {
    const {words, format, session} = this;
    const {search} = session;
    const isLooking = search.kind === 'looking';
    return html`<label>
        ${words.object}
        <select
          @change=${(event: Event) => {
            const {value} = event.target as HTMLSelectElement;
            const chosen = knownObjects.find((one) => one === value);
            if (chosen) this.#fire('object', chosen);
          }}
        >
          ${knownObjects.map(
            (one) =>
              html`<option value=${one} .selected=${one === this.object}>
                ${words.objects[one]}
              </option>`,
          )}
        </select>
      </label>
      <p class="soft">${words.tap}</p>
      <div class="row">
        <button
          class="outlined"
          ?disabled=${isLooking}
          @click=${() => {
            this.#fire('look');
          }}
        >
          ${words.look}
        </button>
      </div>
      ${
        search.kind === 'failed'
          ? html`<p class="error" role="alert">${saidFailure(words, search.failure)}</p>`
          : html`<p role="status">
              ${
                isLooking
                  ? words.looking
                  : object
                    ? words.byObject(format.percent(Math.max(leastError, object.error)))
                    : nothing
              }
            </p>`
      }`;
  }
}
