/** Panel beside the photo: the findings, and all settings. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import type {Point} from '../../model/geometry/vectors.js';
import {rebased} from '../../model/print/photo-map.js';
import type {GroupName} from '../../model/print/repeating-print.js';
import {controls} from '../style/controls.js';
import {arrowNames} from '../../photo/arrow-names.js';
import {meaningOf} from '../../print/group-choice.js';
import type {BrokenPlaces} from '../../photo/breaks-on-photo.js';
import {PhotoElement} from './photo-element.js';
import {
  groupIn,
  groupOf,
  isDoubtful,
  isOneWay,
  isStriped,
  measuresOf,
  type PhotoStep,
} from '../../photo/photo-step.js';
import {overlayNames, type Overlays} from './stage-marks.js';
import type {PhotoGroup} from '../../model/print/photo-reading.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';

// All groups, each with the deviation of the photographed print from it.

/** Deviations of a full bar: twice those of the verdict "has not". */
const fullBar = {rho: 0.12, worst: 0.8};

interface GroupChoice {
  readonly words: PhotoTexts;
  readonly kinds: Readonly<Record<GroupName, string>>;
  readonly choose: (name: GroupName) => void;
}

function photoGroups(step: PhotoStep, choice: GroupChoice): TemplateResult {
  const {words, kinds} = choice;
  return html`<details>
    <summary>${words.group}: ${kinds[groupOf(step)]}</summary>
    <div class="groups" role="radiogroup" aria-label=${words.group}>
      ${step.reading.groups.map((group) => row(step, group, choice))}
    </div>
  </details>`;
}

function row(
  step: PhotoStep,
  {name, rho, worst, verdict}: PhotoGroup,
  {words, kinds, choose}: GroupChoice,
): TemplateResult {
  const share = verdict === 'cannot' ? 0 : Math.max(rho / fullBar.rho, worst / fullBar.worst);
  const isFound = name === step.reading.group;
  return html`<label class="group">
    <input
      type="radio"
      name="group"
      .checked=${name === groupOf(step)}
      ?disabled=${verdict === 'cannot'}
      aria-label="${kinds[name]}, ${words.verdicts[verdict]}${isFound ? `, ${words.foundOne}` : ''}"
      @change=${() => {
        choose(name);
      }}
    />
    <span>${kinds[name]}</span>
    ${svg`<svg viewBox="0 0 100 8" preserveAspectRatio="none" aria-hidden="true" data-verdict=${verdict}>
      <rect class="track" width="100" height="8"></rect>
      <rect width=${Math.min(100, Math.max(0, 100 * share)).toFixed(0)} height="8"></rect>
    </svg>`}
    <span class="soft"
      >${name}:
      ${words.verdicts[verdict]}${isFound ? html` · <b>${words.foundOne}</b>` : nothing}</span
    >
  </label>`;
}

export const panelStyle = css`
  :host {
    display: grid;
    align-content: start;
    gap: var(--sw-space-4);
  }
  section {
    display: grid;
    gap: var(--sw-space-2);
  }
  summary {
    min-height: var(--sw-target);
    align-content: center;
    cursor: pointer;
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-2);
  }
  .row > .soft {
    flex-basis: 100%;
  }
  .row label {
    margin-right: var(--sw-space-2);
  }
  .beside {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr)) var(--sw-target);
    align-items: end;
    gap: var(--sw-space-2);
  }
  input[type='range'] {
    width: 100%;
    min-height: var(--sw-target);
    margin: 0;
    accent-color: var(--sw-accent);
  }
  .groups {
    display: grid;
  }
  .group {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) 3rem 6.5rem;
    align-items: center;
    gap: var(--sw-space-2);
    min-height: 1.75rem;
    color: inherit;
  }
  .group svg {
    width: 100%;
    height: 0.4rem;
    fill: #2e7d4f;
  }
  .group svg[data-verdict='almost'] {
    fill: #b7791f;
  }
  .group svg[data-verdict='has not'] {
    fill: #c22318;
  }
  .group .track {
    fill: color-mix(in srgb, var(--sw-ink) 10%, transparent);
  }
`;

/** Other bases of the lattice, or bases of a coarser or finer one. */
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
  /** The middle of the cell is a lattice point, like its corner. */
  halfDrop: [
    [0.5, -0.5],
    [0.5, 0.5],
  ] as const,
};

/**
 * Fires `overlays` with `Overlays`, `whiten` to start or end the choice of a white spot, and
 * `broken`.
 */
export class PhotoPanel extends PhotoElement {
  static override properties = {
    ...PhotoElement.properties,
    overlays: {attribute: false},
    isWhitening: {type: Boolean},
  };
  static override styles = [controls, panelStyle];
  declare overlays: Overlays;
  /** True while the user chooses a white spot. */
  declare isWhitening: boolean;

  constructor() {
    super();
    this.isWhitening = false;
  }

  protected override render(): TemplateResult | typeof nothing {
    const {session, words, texts} = this;
    const {step} = session.read;
    if (!step) return nothing;
    const groups = {
      ...{words, kinds: texts.print.kinds},
      choose: (name: GroupName): void => {
        session.change({chosen: name === step.reading.group ? undefined : name});
      },
    };
    return html`${this.#found(step)}
      <sw-photo-swatch
        .workbench=${this.workbench}
        .session=${session}
        @broken=${({detail}: CustomEvent<BrokenPlaces | null>) => {
          this.dispatchEvent(new CustomEvent('broken', {detail}));
        }}
      ></sw-photo-swatch>
      <slot></slot> ${photoGroups(step, groups)} ${this.#looks(step)} ${this.#lattice(step)}
      ${this.#object(step)}`;
  }

  #found(step: PhotoStep): TemplateResult {
    const {words, session, texts} = this;
    const {w1Measured, w2Measured, reading} = step;
    const {confidence, others} = reading;
    const {kinds, stripes, meanings} = texts.print;
    const isFully = w1Measured !== undefined && w2Measured !== undefined;
    const hasProportions = isFully || isStriped(step);
    const notes = reading.notes.filter((note) => !hasProportions || note !== 'focalLength');
    return html`<section aria-label=${words.title}>
      ${
        isDoubtful(step)
          ? html`<p class="error" role="alert">${words.confidences.uncertain}</p>`
          : html`<p role="status">
              <b>${words.found(isStriped(step) ? stripes : kinds[groupOf(step)])}</b>
              ${confidence === 'likely' ? words.confidences.likely : nothing}
            </p>`
      }
      <p class="soft">${meanings[meaningOf(measuresOf(step))]}</p>
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
    return html`<section aria-label=${words.show}>
      <h3>${words.show}</h3>
      <div class="row">
        ${overlayNames.map(
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
      ${this.#white(step)}
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

  #white({gains}: PhotoStep): TemplateResult {
    const {words, session, isWhitening} = this;
    return html`<div class="row">
        <button
          class="outlined"
          aria-pressed=${isWhitening ? 'true' : 'false'}
          @click=${() => {
            this.dispatchEvent(new CustomEvent('whiten'));
          }}
        >
          ${words.white}
        </button>
        ${
          gains
            ? html`<button
                class="outlined"
                @click=${() => {
                  session.change({gains: undefined});
                }}
              >
                ${words.asTaken}
              </button>`
            : nothing
        }
      </div>
      ${isWhitening ? html`<p role="status">${words.tapWhite}</p>` : nothing}`;
  }

  #lattice(step: PhotoStep): TemplateResult | typeof nothing {
    const {words, session} = this;
    const {map} = groupIn(step);
    if (isStriped(step)) return nothing;
    const names = arrowNames(map, step.reading, words.ways);
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
        ${(['w1', 'w2'] as const).map((vector) => [
          change(words.twice(names[vector]), bases[vector](2)),
          change(words.half(names[vector]), bases[vector](0.5)),
        ])}
        ${change(words.halfDrop, bases.halfDrop)}
      </div>
    </section>`;
  }

  #object(step: PhotoStep): TemplateResult {
    const {words, session, texts, format} = this;
    return html`<section aria-label=${words.objectOnFabric}>
      <h3>${words.objectOnFabric}</h3>
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
