/** Size of the print on a photo: by a tape, by two points, or by a coin or card on the fabric. */
import {html, nothing, type TemplateResult} from 'lit';

import {norm, type Point} from '../../model/geometry/vectors.js';
import {knownObjects, type KnownObject} from '../../model/print/photo-reading.js';
import {lengthUnit} from '../controls/number-field.js';
import {arrowNames} from '../../photo/arrow-names.js';
import {isCentred} from '../../model/print/wallpaper.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {panelStyle} from './photo-panel.js';
import {PhotoElement, progressNote, progressStyle} from './photo-element.js';
import type {PhotoSession} from '../../workbench/photo/photo-session.js';
import type {TwoPoints} from './photo-stage.js';
import {
  cellOf,
  conflictIn,
  groupIn,
  groupOf,
  isStriped,
  measuresOf,
  unmeasured,
  type PhotoStep,
} from '../../photo/photo-step.js';
import {saidFailure} from '../../texts/photo-texts.js';
import type {Vector} from './stage-marks.js';

/** Ways to measure. */
const ways = ['tape', 'points', 'object'] as const;
export type Measuring = (typeof ways)[number];

/** Default number of repeats along a tape. */
const usualRepeats = 10;
/** [cm] */
const leastMeasured = 0.1;
const mostMeasured = 10_000;
/** Least relative error, caused by thickness and round edges. */
const leastError = 0.01;

/**
 * Fires `measuring` with a `Measuring`, `object` with a `KnownObject`, and `look` to start the
 * search for the object. Fires `along` with the `Vector` whose fields have the focus, or without
 * detail.
 */
export class PhotoMeasures extends PhotoElement {
  static override properties = {
    ...PhotoElement.properties,
    way: {},
    points: {attribute: false},
    object: {},
    repeats: {state: true},
  };
  static override styles = [controls, panelStyle, progressStyle];
  declare way: Measuring;
  declare points: TwoPoints | undefined;
  /** Coin or card on the fabric. */
  declare object: KnownObject;
  /** Number of repeats along a tape. */
  declare protected repeats: Readonly<Record<Vector, number>>;
  /** Displayed progress of the search. */
  #note: Element | null = null;

  constructor() {
    super();
    this.way = 'tape';
    this.object = 'eur1';
    this.repeats = {w1: usualRepeats, w2: usualRepeats};
  }

  protected override render(): TemplateResult | typeof nothing {
    const {words, way} = this;
    const {step} = this.session.read;
    if (!step) return nothing;
    return html`<section aria-label=${words.size}>
      <h3>${words.size}</h3>
      <p role="status">${this.#said(step)}</p>
      ${this.#conflict(step)}
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
      ${way === 'tape' ? this.#tapes(step) : nothing}
      ${way === 'points' && this.points ? this.#ruler(this.points, step) : nothing}
      ${way === 'object' ? this.#object(step) : nothing}
    </section>`;
  }

  /** Text on the present size of the print. */
  #said(step: PhotoStep): string {
    const {words, format} = this;
    const {w1, w2, isScaled} = cellOf(step);
    if (!isScaled) return words.unknown;
    const length = (vector: Point): string => format.length(norm(vector));
    if (isStriped(step)) return words.oneMeasure(length(w1));
    const {width, height} = measuresOf(step).size;
    const size = words.measures(format.length(width), format.length(height));
    return isCentred(groupOf(step)) ? `${size} ${words.vectors(length(w1), length(w2))}` : size;
  }

  #conflict(step: PhotoStep): TemplateResult | typeof nothing {
    const conflict = conflictIn(step);
    if (!conflict) return nothing;
    const {words, format} = this;
    const [w1, w2] = [format.length(conflict.w1), format.length(conflict.w2)];
    const share = format.percent(conflict.share);
    return html`<p class="error" role="alert">
      ${
        conflict.isOfGroup
          ? words.sidesApart(w1, w2, share)
          : words.photoApart(w1, w2, share, format.length(conflict.expected))
      }
    </p>`;
  }

  #remove(measure: keyof typeof unmeasured, label: string): TemplateResult {
    const named = `${this.words.removeMeasure}: ${label}`;
    return html`<button
      class="icon"
      aria-label=${named}
      title=${named}
      @click=${() => {
        this.session.change({[measure]: undefined});
      }}
    >
      ${icon.close}
    </button>`;
  }

  #fire(type: string, detail?: Measuring | KnownObject | Vector): void {
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

  /** @param length NaN if not measured [cm] */
  #length(label: (unit: string) => string, length: number, enter: (cm: number) => void) {
    const {name, cm} = lengthUnit[this.workbench.preferences.chosen.units];
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

  /** One tape across stripes, else one in each direction. */
  #tapes(step: PhotoStep): TemplateResult | readonly TemplateResult[] {
    const {words} = this;
    if (isStriped(step)) return this.#tape('w1', words.repeatsAcross, step);
    const {w1, w2} = arrowNames(groupIn(step).map, step.reading, words.ways);
    return [
      this.#tape('w1', words.repeatsAlong(w1), step),
      this.#tape('w2', words.repeatsAlong(w2), step),
    ];
  }

  #tape(vector: Vector, label: string, step: PhotoStep): TemplateResult {
    const {words, session} = this;
    const measured = step[`${vector}Measured`];
    const repeats = measured?.repeats ?? this.repeats[vector];
    return html`<div
      class="beside"
      role="group"
      aria-label=${label}
      @focusin=${() => {
        this.#fire('along', vector);
      }}
      @focusout=${() => {
        this.#fire('along');
      }}
    >
      ${this.#number(label, repeats, 0.5, 10_000, (count) => {
        this.repeats = {...this.repeats, [vector]: count};
        if (measured) session.measure(vector, {...measured, repeats: count});
      })}
      ${this.#length(words.measure, measured?.cm ?? NaN, (cm) => {
        session.measure(vector, {repeats, cm});
      })}
      ${measured ? this.#remove(`${vector}Measured`, label) : nothing}
    </div>`;
  }

  #ruler([from, to]: TwoPoints, {between}: PhotoStep): TemplateResult {
    const {words, session} = this;
    return html`<p class="soft">${words.between}</p>
      <div class="beside">
        ${this.#length(words.distance, between?.cm ?? NaN, (cm) => {
          session.measureBetween({from, to, cm});
        })}
        ${between ? this.#remove('between', words.measuring.points) : nothing}
      </div>`;
  }

  #object({object}: PhotoStep): TemplateResult {
    const {words, session} = this;
    const {search} = session;
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
          class="outlined look"
          ?disabled=${search.kind === 'looking'}
          @click=${() => {
            this.#fire('look');
          }}
        >
          ${words.look}
        </button>
        ${object ? this.#remove('object', words.objects[object.object]) : nothing}
      </div>
      ${this.#searched(search, object)}`;
  }

  #searched(
    search: PhotoSession['search'],
    object: PhotoStep['object'],
  ): TemplateResult | typeof nothing {
    const {words, format} = this;
    switch (search.kind) {
      case 'looking':
        return progressNote(search, this.said, () => {
          this.session.cancelSearch();
          void this.#toLook();
        });
      case 'failed':
        return html`<p class="error" role="alert">${saidFailure(words, search.failure)}</p>`;
      case 'none':
        return html`<p role="status">
          ${object ? words.byObject(format.percent(Math.max(leastError, object.error))) : nothing}
        </p>`;
    }
  }

  /** Scrolls to the progress, which a narrow page shows below the visible part. */
  protected override updated(): void {
    const note = this.renderRoot.querySelector('.note');
    if (note && note !== this.#note) note.scrollIntoView({block: 'nearest'});
    this.#note = note;
  }

  /** Moves the focus here, since the focused button is gone. */
  async #toLook(): Promise<void> {
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>('.look')?.focus();
  }
}
