/** Beside the photograph: what was found, and all that can be decided about it. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import {norm, type Point} from '../../model/geometry.js';
import {rebased} from '../../model/photo-map.js';
import type {PhotoGroup, RepeatsMeasured} from '../../model/photo.js';
import {lengthUnit} from '../controls/number-field.js';
import {controls} from '../style/controls.js';
import {PhotoElement} from './photo-element.js';
import {panelStyle} from './panel-style.js';
import type {Overlays, TwoPoints} from './photo-stage.js';
import {
  cellOf,
  groupIn,
  groupOf,
  isMisfit,
  isOneWay,
  measuresOf,
  type PhotoStep,
} from '../print/photo-step.js';

type Vector = 'w1' | 'w2';

/** As often as a tape is held along, unless somebody says otherwise. */
const usualRepeats = 10;
/** [cm] */
const leastMeasured = 0.1;
const mostMeasured = 10_000;
/** Shares at which the bars of the groups are full: twice what is "has not". */
const fullBar = {rho: 0.12, worst: 0.8};

/** Another basis of the lattice, or of a coarser or finer one. */
const bases = {
  w1: (factor: number) =>
    [
      [factor, 0],
      [0, 1],
    ] as const,
  w2: (factor: number) =>
    [
      [1, 0],
      [0, factor],
    ] as const,
  /** The middle of the cell is like its corner. */
  halfDrop: [
    [0.5, -0.5],
    [0.5, 0.5],
  ] as const,
};

const lengths: readonly Vector[] = ['w1', 'w2'];

/** Fires `overlays` with `Overlays`, `ruler` with whether two points are to be measured. */
export class PhotoPanel extends PhotoElement {
  static override properties = {
    ...PhotoElement.properties,
    overlays: {attribute: false},
    points: {attribute: false},
    repeats: {state: true},
  };
  static override styles = [controls, panelStyle];
  declare overlays: Overlays;
  declare points: TwoPoints | undefined;
  /** Along which a tape is held. */
  declare protected repeats: Readonly<Record<Vector, number>>;

  constructor() {
    super();
    this.repeats = {w1: usualRepeats, w2: usualRepeats};
  }

  protected override render(): TemplateResult | typeof nothing {
    const {step} = this.session.read;
    if (!step) return nothing;
    return html`${this.#found(step)}
      <sw-photo-swatch .workbench=${this.workbench} .session=${this.session}></sw-photo-swatch>
      ${this.#looks(step)} ${this.#size(step)} ${this.#groups(step)} ${this.#lattice(step)}
      ${this.#cloth(step)}`;
  }

  #found({reading}: PhotoStep): TemplateResult {
    const {words, session} = this;
    const {confidence, others, notes, group} = reading;
    return html`<section aria-label=${words.title}>
      ${
        confidence === 'uncertain'
          ? html`<p class="error" role="alert">${words.confidences.uncertain}</p>`
          : html`<p role="status">
              <b>${words.found(group)}</b>
              ${confidence === 'likely' ? words.confidences.likely : nothing}
            </p>`
      }
      ${notes.map((note) => html`<p class="soft">${words.notes[note]}</p>`)}
      ${
        others.length === 0
          ? nothing
          : html`<p>${words.others}</p>
              <div class="row">
                ${others
                  .slice(0, 3)
                  .map(
                    (map, k) =>
                      html`<button class="outlined" @click=${() => void session.align(map, true)}>
                        ${words.other(k + 2)}
                      </button>`,
                  )}
              </div>`
      }
    </section>`;
  }

  #looks(step: PhotoStep): TemplateResult {
    const {words, overlays, session} = this;
    const names = ['cells', 'axes', 'differing'] as const;
    return html`<section aria-label=${words.show}>
      <h3>${words.show}</h3>
      <div class="row">
        ${names.map(
          (name) =>
            html`<label class="inline">
              <input
                type="checkbox"
                .checked=${overlays[name]}
                @change=${() => {
                  const detail = {...overlays, [name]: !overlays[name]};
                  this.dispatchEvent(new CustomEvent<Overlays>('overlays', {detail}));
                }}
              />
              ${words.overlays[name]}
            </label>`,
        )}
      </div>
      <label>
        ${words.flatten}
        <input
          type="range"
          min="0"
          max="1"
          step="0.05"
          .value=${String(step.flatten)}
          @change=${(event: Event) => {
            session.change({flatten: Number((event.target as HTMLInputElement).value)});
          }}
        />
      </label>
      <label class="inline">
        <input
          type="checkbox"
          .checked=${step.isExact}
          ?disabled=${groupOf(step) === 'p1'}
          @change=${() => {
            session.change({isExact: !step.isExact});
          }}
        />
        ${words.exact}
      </label>
    </section>`;
  }

  #size(step: PhotoStep): TemplateResult {
    const {words, format} = this;
    const {w1, w2, isScaled} = cellOf(step);
    const {size, group} = measuresOf(step);
    const length = (vector: Point): string => format.length(norm(vector));
    return html`<section aria-label=${words.size}>
      <h3>${words.size}</h3>
      <p role="status">
        ${isScaled ? words.measures(format.length(size.width), format.length(size.height)) : words.unknown}
      </p>
      ${
        isMisfit(step)
          ? html`<p class="error" role="alert">${words.misfit(length(w1), length(w2), group)}</p>`
          : nothing
      }
      ${lengths.map((vector) => this.#tape(vector, step[`${vector}Measured`]))} ${this.#ruler(step)}
    </section>`;
  }

  #number(
    label: string,
    value: number,
    least: number,
    most: number,
    enter: (value: number) => void,
  ) {
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

  #tape(vector: Vector, measured: RepeatsMeasured | undefined): TemplateResult {
    const {words, session} = this;
    const {name, cm} = lengthUnit[this.workbench.preferences.units];
    const repeats = measured?.repeats ?? this.repeats[vector];
    return html`<div class="beside" role="group" aria-label=${words.repeatsAlong(vector)}>
      ${this.#number(words.repeatsAlong(vector), repeats, 0.5, 10_000, (count) => {
        this.repeats = {...this.repeats, [vector]: count};
        if (measured) session.measure(vector, {...measured, repeats: count});
      })}
      ${this.#number(
        words.measure(name),
        measured ? measured.cm / cm : NaN,
        leastMeasured / cm,
        mostMeasured / cm,
        (length) => {
          session.measure(vector, {repeats, cm: length * cm});
        },
      )}
    </div>`;
  }

  #ruler({between}: PhotoStep): TemplateResult {
    const {words, session, points} = this;
    const {name, cm} = lengthUnit[this.workbench.preferences.units];
    return html`<label class="inline">
        <input
          type="checkbox"
          .checked=${points !== undefined}
          @change=${() => {
            this.dispatchEvent(new CustomEvent<boolean>('ruler', {detail: points === undefined}));
          }}
        />
        ${words.between}
      </label>
      ${
        points
          ? this.#number(
              words.distance(name),
              between ? between.cm / cm : NaN,
              leastMeasured / cm,
              mostMeasured / cm,
              (length) => {
                const [from, to] = points;
                session.change({
                  ...{w1Measured: undefined, w2Measured: undefined},
                  between: {from, to, cm: length * cm},
                });
              },
            )
          : nothing
      }`;
  }

  #groups(step: PhotoStep): TemplateResult {
    const {words} = this;
    return html`<section aria-label=${words.group}>
      <h3 id="groups">${words.group}</h3>
      <div class="groups" role="radiogroup" aria-labelledby="groups">
        ${step.reading.groups.map((group) => this.#group(step, group))}
      </div>
      <p class="soft">${this.texts.print.meanings[groupOf(step)]}</p>
    </section>`;
  }

  #group(step: PhotoStep, {name, rho, worst, verdict}: PhotoGroup): TemplateResult {
    const {words, session} = this;
    const share = verdict === 'cannot' ? 0 : Math.max(rho / fullBar.rho, worst / fullBar.worst);
    const isFound = name === step.reading.group;
    return html`<label class="group">
      <input
        type="radio"
        name="group"
        .checked=${name === groupOf(step)}
        ?disabled=${verdict === 'cannot'}
        aria-label="${name}, ${words.verdicts[verdict]}${isFound ? `, ${words.foundOne}` : ''}"
        @change=${() => {
          session.change({chosen: isFound ? undefined : name});
        }}
      />
      <span>${name}</span>
      ${svg`<svg viewBox="0 0 100 8" preserveAspectRatio="none" aria-hidden="true" data-verdict=${verdict}>
        <rect class="track" width="100" height="8"></rect>
        <rect width=${Math.min(100, Math.max(0, 100 * share)).toFixed(0)} height="8"></rect>
      </svg>`}
      <span class="soft"
        >${words.verdicts[verdict]}${isFound ? html` · <b>${words.foundOne}</b>` : nothing}</span
      >
    </label>`;
  }

  #lattice(step: PhotoStep): TemplateResult {
    const {words, session} = this;
    const {map} = groupIn(step);
    const change = (label: string, basis: readonly [readonly number[], readonly number[]]) =>
      html`<button
        class="outlined"
        @click=${() => void session.align(rebased(map, basis as unknown as [Point, Point]))}
      >
        ${label}
      </button>`;
    return html`<section aria-label=${words.lattice}>
      <h3>${words.lattice}</h3>
      <p class="soft">${words.how}</p>
      <div class="row">
        ${lengths.map((vector) => [
          change(words.twice(vector), bases[vector](2)),
          change(words.half(vector), bases[vector](0.5)),
        ])}
        ${change(words.halfDrop, bases.halfDrop)}
      </div>
    </section>`;
  }

  #cloth(step: PhotoStep): TemplateResult {
    const {words, session, texts, format} = this;
    return html`<section aria-label=${words.cloth}>
      <h3>${words.cloth}</h3>
      <p>${words.warp(`${format.number(measuresOf(step).turnDeg)}°`)}</p>
      <div class="row">
        <button
          class="outlined"
          @click=${() => {
            session.change({quarterTurns: (step.quarterTurns + 1) % 4});
          }}
        >
          ${words.turn}
        </button>
      </div>
      <label class="inline">
        <input
          type="checkbox"
          .checked=${isOneWay(step)}
          @change=${() => {
            session.change({oneWay: !isOneWay(step)});
          }}
        />
        ${texts.print.oneWay}
      </label>
    </section>`;
  }
}
