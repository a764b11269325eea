/** Gallery of prints: one for each group, further prints, and their colours. */
import {css, html, nothing, type TemplateResult} from 'lit';
import {guard} from 'lit/directives/guard.js';

import {printOf, type Design, type DesignPrint} from '../../model/design/design.js';
import {carries} from '../../model/print/repeat.js';
import {PatientElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {inColours, samplePrint, type SamplePrint, type Samples} from '../../workbench/samples.js';
import {choiceOf, choices, meaningOf, sampleOf, type Choice} from '../../print/group-choice.js';
import {takePrint} from '../../workbench/print/take-print.js';
import {printCaption, printName} from '../../texts/sample-names.js';
import {swatch} from './swatch.js';

/** Styles of swatches to choose from. */
const swatches = css`
  :host {
    display: grid;
    gap: var(--sw-space-3);
  }
  .groups,
  .more {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 7rem));
    gap: var(--sw-space-2);
  }
  summary {
    min-height: var(--sw-target);
    align-content: center;
    cursor: pointer;
  }
  .filters {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-1);
  }
  .filters button {
    padding: 0 var(--sw-space-2);
    border-radius: var(--sw-target);
    font-size: var(--sw-text);
  }
  .colourways {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 7rem));
    gap: var(--sw-space-2);
  }
  :is(.groups, .more, .colourways) button {
    display: grid;
    grid-template-columns: minmax(0, 1fr); /* a long word gives way, not the picture above it */
    hyphens: auto;
    gap: 2px;
    min-height: 0;
    padding: 0;
    border: 0;
    background: none;
    align-content: start;
    line-height: 1.2;
    white-space: normal;
    font-size: var(--sw-text);
    color: var(--sw-soft);
  }
  :is(.groups, .more, .colourways) span {
    overflow: hidden;
    text-overflow: ellipsis; /* the button's title has the whole name */
  }
  svg {
    display: block;
    width: 100%;
    border-radius: 4px;
    box-shadow: inset 0 0 0 1px var(--sw-line);
  }
  .colourways svg {
    aspect-ratio: 3 / 2;
  }
  :is([aria-checked='true'], [aria-pressed='true']) svg {
    outline: 2px solid var(--sw-accent);
    outline-offset: 1px;
  }
  :is(.groups, .more, .colourways) :is([aria-checked='true'], [aria-pressed='true']) {
    color: var(--sw-accent);
    font-weight: 600;
  }
  button:focus-visible {
    outline-offset: 4px;
  }
`;

/** Columns of the gallery, as in its style; the arrow keys up and down move by a row. */
const columns = 3;

const steps: Readonly<Record<string, number>> = {
  ...{ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columns, ArrowDown: columns},
};

const standIns = new Set(choices.map(sampleOf));

/**
 * Returns a print in its first colours unless others are named, so that the gallery always looks
 * the same.
 */
const coloured = (print: SamplePrint, name?: string): string => {
  const {colourways} = print;
  const shown = colourways.find((one) => one.name === name) ?? colourways[0];
  return `prints/${shown?.raster ?? shown?.image ?? ''}`;
};

/** Filters of the gallery. */
const filters = ['botanical', 'geometric', 'tailored', 'mirrors'] as const;
type Filter = (typeof filters)[number];

const passes = ({family, group}: SamplePrint, filter: Filter | undefined): boolean =>
  filter === 'mirrors' ? carries(group, 'piece') : filter === undefined || family === filter;

export class PrintGallery extends PatientElement {
  static override properties = {
    ...PatientElement.properties,
    samples: {attribute: false},
    focused: {state: true},
    filter: {state: true},
  };
  declare samples: Samples | undefined;
  declare protected focused: Choice | undefined;

  /** Filter of the prints that come with Seamwise. */
  declare protected filter: Filter | undefined;

  static override styles = [controls, swatches];

  protected override render(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    const preferences = this.workbench.preferences.chosen;
    const {samples, focused, filter} = this;
    if (!design || !samples) return nothing;
    const {print} = design;
    // redrawn only for a new value of these, not with every step of a solve
    const seen = [print, preferences, samples, focused, filter];
    return html`${guard(
      seen,
      () => html`
        ${print.sample ? [this.#filters(), this.#groups(design, samples)] : this.#own(design, samples)}
        <p class="soft" role="status">${this.texts.print.meanings[meaningOf(print)]}</p>
        ${this.#more(design, samples)} ${this.#colourways(design, samples)}
      `,
    )}`;
  }

  #filters(): TemplateResult {
    const texts = this.texts.print;
    return html`<div class="filters" role="group" aria-label=${texts.filter}>
      ${filters.map(
        (filter) =>
          html`<button
            class="outlined"
            aria-pressed=${filter === this.filter}
            @click=${() => {
              this.filter = filter === this.filter ? undefined : filter;
            }}
          >
            ${texts.filters[filter]}
          </button>`,
      )}
    </div>`;
  }

  /** The user's own print, and its symmetry, which can be changed. */
  #own(design: Design, samples: Samples): TemplateResult {
    const {print} = design;
    const texts = this.texts.print;
    const choice = choiceOf(print);
    return html`<div class="more">
        <button aria-pressed="true">
          ${swatch('own', printOf(print), print.image)}
          <span>${print.title}</span>
        </button>
      </div>
      <details>
        <summary>${texts.group}: ${this.#kindOf(choice)}</summary>
        ${this.#groups(design, samples)}
      </details>`;
  }

  #kindOf(choice: Choice): string {
    const {stripes, kinds} = this.texts.print;
    return choice === 'stripes' ? stripes : kinds[choice];
  }

  /** The user's own print can have any of the groups. */
  #shown({print}: Design, {prints}: Samples): readonly Choice[] {
    if (!print.sample) return choices;
    return choices.filter((choice) =>
      prints.some((one) => one.name === sampleOf(choice) && passes(one, this.filter)),
    );
  }

  #groups(design: Design, samples: Samples): TemplateResult {
    const {print} = design;
    const texts = this.texts.print;
    const checked = choiceOf(print);
    const shown = this.#shown(design, samples);
    const first = [this.focused, checked].find((one) => one && shown.includes(one)) ?? shown[0];
    return html`<div
      class="groups"
      role="radiogroup"
      aria-label=${texts.group}
      @keydown=${(event: KeyboardEvent) => {
        this.#walk(event, shown, first);
      }}
      @focusout=${() => {
        this.focused = undefined;
      }}
    >
      ${shown.map((choice) => {
        const sample = samples.prints.find(({name}) => name === sampleOf(choice));
        if (!sample) return nothing;
        const label = print.sample ? this.#titleOf(sample) : this.#kindOf(choice);
        return html`<button
          id=${choice}
          role="radio"
          aria-label=${label}
          aria-checked=${choice === checked}
          title=${texts.meanings[choice]}
          tabindex=${choice === first ? 0 : -1}
          @focus=${() => {
            this.focused = choice;
          }}
          @click=${() => {
            this.#choose(choice);
          }}
        >
          ${swatch(`cloth-${choice}`, sample, coloured(sample))}
          <span>${print.sample ? printCaption(sample, this.texts) : label}</span>
        </button>`;
      })}
    </div>`;
  }

  #more(design: Design, {prints}: Samples): TemplateResult | typeof nothing {
    const texts = this.texts.print;
    const {print} = design;
    const others = prints.filter(({name}) => !standIns.has(name));
    const shown = print.sample ? others.filter((one) => passes(one, this.filter)) : prints;
    if (shown.length === 0) return nothing;
    return html`<h3>${print.sample ? texts.more : texts.ours}</h3>
      <div class="more" role="group" aria-label=${print.sample ? texts.more : texts.ours}>
        ${shown.map(
          (sample) =>
            html`<button
              aria-label=${this.#titleOf(sample)}
              aria-pressed=${sample.name === print.sample?.name}
              title=${texts.meanings[meaningOf(samplePrint(sample))]}
              @click=${() => {
                this.#take(sample);
              }}
            >
              ${swatch(`more-${sample.name}`, sample, coloured(sample))}
              <span>${printCaption(sample, this.texts)}</span>
            </button>`,
        )}
      </div>`;
  }

  #titleOf({name, title}: SamplePrint): string {
    return printName({title, sample: {name}}, this.texts);
  }

  #colourways({print}: Design, {prints}: Samples): TemplateResult | typeof nothing {
    const sample = prints.find(({name}) => name === print.sample?.name);
    if (!sample) return nothing;
    return html`<h3>${this.#titleOf(sample)}</h3>
      <div class="colourways" role="group" aria-label=${this.texts.print.colourways}>
        ${sample.colourways.map(
          ({name}) =>
            html`<button
              aria-pressed=${name === print.sample?.colourway}
              @click=${() => {
                this.workbench.history.change({print: inColours(print, sample, name)});
              }}
            >
              ${swatch(`colour-${name}`, sample, coloured(sample, name))}
              <span>${this.texts.samples.colourways[name] ?? name}</span>
            </button>`,
        )}
      </div>`;
  }

  #choose(choice: Choice): void {
    const {design} = this.workbench.history;
    if (!design) return;
    const sample = this.samples?.prints.find(({name}) => name === sampleOf(choice));
    if (!design.print.sample) void this.#regroup(design.print, choice);
    else if (sample) this.#take(sample);
  }

  async #regroup(print: DesignPrint, choice: Choice): Promise<void> {
    const {ownPrintAs} = await import('../../print/own-print.js');
    const regrouped = await ownPrintAs(this.workbench.solver, print, choice);
    if (this.workbench.history.design?.print === print) takePrint(this.workbench, regrouped);
  }

  #take(sample: SamplePrint): void {
    takePrint(this.workbench, samplePrint(sample));
  }

  #walk(event: KeyboardEvent, shown: readonly Choice[], from: Choice | undefined): void {
    const at = shown.findIndex((one) => one === from);
    const step = steps[event.key];
    const next = step === undefined ? undefined : shown[at + step];
    if (step === undefined) return;
    event.preventDefault();
    if (next === undefined) return;
    this.renderRoot.querySelector<HTMLElement>(`#${next}`)?.focus();
    this.#choose(next);
  }
}
