/** List of the garments on the fabric: size, copies, share of the length, and more garments. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {garmentShares} from '../../marker/garment-shares.js';
import {mostAdded, mostCopies, type AddedGarment, type Design} from '../../model/design/design.js';
import type {GarmentShare} from '../../model/result/marker-plan.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {fresh, garmentsIn} from '../../workbench/marker/garment-sources.js';
import {
  addedFrom,
  addGarments,
  otherSize,
  removeGarment,
  setCopies,
  setGarment,
} from '../../workbench/marker/garment-steps.js';
import {garmentName, letterOf} from '../../workbench/marker/garment-words.js';
import {costOfLength} from '../../workbench/marker/marker-words.js';
import {projectsFor, type ProjectSource} from '../../workbench/marker/project-source.js';
import {loadSamples, sampleGarment, type Samples} from '../../workbench/samples.js';
import {spokenFailure} from '../../workbench/spoken-failure.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {colourClass, garmentColours} from './garment-colours.js';
import {MarkerElement} from './marker-element.js';

type Projects = Awaited<ReturnType<ProjectSource['list']>>;
type OnFabric = Pick<AddedGarment, 'garment' | 'copies'>;

export class MarkerGarments extends MarkerElement {
  static override properties = {
    ...MarkerElement.properties,
    samples: {state: true},
    projects: {state: true},
    said: {state: true},
  };
  declare protected samples: Samples | undefined;
  declare protected projects: Projects;
  /** Message of the last attempt to add a garment. */
  declare protected said: string;
  #hasAsked = false;

  static override styles = [
    controls,
    garmentColours,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-3);
      }
      ul {
        display: grid;
        gap: var(--sw-space-3);
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr) 4.5rem 4.5rem var(--sw-target);
        align-items: end;
        gap: var(--sw-space-1) var(--sw-space-2);
      }
      .swatch {
        display: grid;
        place-items: center;
        align-self: center;
        width: 1.5rem;
        height: 1.5rem;
        border-radius: var(--sw-radius);
        background: var(--garment);
        color: #ffffff;
        font-weight: 600;
      }
      .name {
        align-self: center;
        overflow-wrap: break-word;
        font-weight: 600;
      }
      .share {
        grid-column: 2 / -1;
        color: var(--sw-soft);
      }
      .copies {
        grid-column: 4;
      }
      .single {
        grid-template-columns: minmax(0, 1fr) 4.5rem;
      }
      .single .name,
      .single .copies {
        grid-column: auto;
      }
      .head {
        color: var(--sw-soft);
      }
      select {
        color: var(--sw-ink);
      }
    `,
  ];

  constructor() {
    super();
    this.projects = [];
    this.said = '';
  }

  protected override render(): TemplateResult | typeof nothing {
    const {words} = this;
    const {design} = this.workbench.history;
    if (!design) return nothing;
    const {copies = 1, added = []} = design;
    const all: readonly OnFabric[] = [{garment: design.garment, copies}, ...added];
    const {plan} = this.layouts;
    const isReady = plan?.unplaced.length === 0 && !this.layouts.isStale;
    const shares = isReady ? garmentShares(plan) : [];
    return html`<h3>${words.garments}</h3>
      <ul>
        ${all.map((one, k) =>
          this.#row(
            one,
            k,
            all.length,
            shares.find(({result}) => result === k),
          ),
        )}
      </ul>
      <label class="hidden" for="add">${words.addGarment}</label>
      ${added.length < mostAdded ? this.#adder(design) : nothing}
      <input
        class="hidden file"
        type="file"
        accept=".json,application/json"
        tabindex="-1"
        aria-hidden="true"
        @change=${this.#readFile}
      />
      ${this.said === '' ? nothing : html`<p class="error" role="alert">${this.said}</p>`}`;
  }

  #row(
    {garment, copies}: OnFabric,
    which: number,
    count: number,
    share: GarmentShare | undefined,
  ): TemplateResult {
    const {words, texts} = this;
    const name = garmentName(garment, texts, this.samples);
    const isSingle = count === 1;
    return html`<li class=${isSingle ? 'single' : ''} role="group" aria-label=${name}>
      ${
        isSingle
          ? nothing
          : html`<span class="swatch ${colourClass(which)}">${letterOf(which)}</span>`
      }
      <span class="name">${name}</span>
      ${which > 0 ? this.#sizes(garment, which, name) : nothing}
      <sw-number-field
        class="copies"
        .label=${words.copies}
        .value=${copies}
        .least=${1}
        .most=${mostCopies}
        .digits=${0}
        .wrong=${texts.controls.between('1', String(mostCopies))}
        .subject=${garment}
        @entered=${({detail}: CustomEvent<number>) => {
          setCopies(this.workbench, which, Math.round(detail));
        }}
      ></sw-number-field>
      ${
        which === 0
          ? nothing
          : html`<button
              class="icon"
              aria-label=${words.removeGarment(name)}
              title=${words.removeGarment(name)}
              @click=${() => {
                removeGarment(this.workbench, which);
              }}
            >
              ${icon.close}
            </button>`
      }
      ${share && !isSingle ? html`<span class="share">${this.#shareWords(share)}</span>` : nothing}
    </li>`;
  }

  #shareWords({lengthCm}: GarmentShare): string {
    const {words, format} = this;
    const {units} = this.workbench.preferences.chosen;
    const length = words.shareOf(format.length(lengthCm));
    const cost = costOfLength(lengthCm, this.layouts.choices, units, format);
    return cost === undefined ? length : `${length}, ${words.costOf(cost)}`;
  }

  #sizes({sample}: OnFabric['garment'], which: number, name: string): TemplateResult {
    const sizes = this.samples?.garments.find(({style}) => style === sample?.style)?.sizes ?? [];
    if (!sample) return html`<span></span>`;
    const shown = sizes.includes(sample.size) ? sizes : [sample.size];
    return html`<select
      aria-label=${this.words.sizeOf(name)}
      @pointerdown=${this.#ask}
      @focus=${this.#ask}
      @change=${(event: Event) => {
        const size = (event.target as HTMLSelectElement).value;
        void this.#try(async () => {
          setGarment(this.workbench, which, await sampleGarment(sample.style, size));
        });
      }}
    >
      ${shown.map(
        (size) =>
          html`<option value=${size} .selected=${size === sample.size}>
            ${size.toUpperCase()}
          </option>`,
      )}
    </select>`;
  }

  /** One list of all sources; choosing an entry adds it. */
  #adder({garment: {sample: own}}: Design): TemplateResult {
    const {words, texts, samples, projects} = this;
    const sizes = samples?.garments.find(({style}) => style === own?.style)?.sizes ?? [];
    const option = (value: string, label: string): TemplateResult =>
      html`<option value=${value}>${label}</option>`;
    return html`<select id="add" @pointerdown=${this.#ask} @focus=${this.#ask} @change=${this.#add}>
      <option value="" selected>${words.addGarment}</option>
      ${option('file:', words.fromFile)}
      ${
        own && sizes.length > 0
          ? html`<optgroup label=${words.otherSizes}>
              ${sizes.map((size) => option(`size:${size}`, garmentName({name: '', sample: {...own, size}}, texts, samples)))}
            </optgroup>`
          : nothing
      }
      ${
        projects.length > 0
          ? html`<optgroup label=${words.ofProjects}>
              ${projects.map(({id, name}) => option(`project:${id}`, name))}
            </optgroup>`
          : nothing
      }
      ${
        samples
          ? html`<optgroup label=${words.ofSamples}>
              ${samples.garments.map(({style, title}) =>
                option(`sample:${style}`, texts.samples.garments[style] ?? title),
              )}
            </optgroup>`
          : nothing
      }
    </select>`;
  }

  protected override firstUpdated(): void {
    this.#ask();
  }

  /** Lists samples and projects; projects may have changed since. */
  readonly #ask = (): void => {
    void projectsFor(this.workbench)
      ?.list()
      .then((projects) => {
        if (JSON.stringify(projects) !== JSON.stringify(this.projects)) this.projects = projects;
      });
    if (this.#hasAsked) return;
    this.#hasAsked = true;
    loadSamples().then(
      (samples) => {
        this.samples = samples;
      },
      () => {
        this.#hasAsked = false; // the next opening of the list asks again
      },
    );
  };

  readonly #add = ({target}: Event): void => {
    const list = target as HTMLSelectElement;
    const [kind = '', name = ''] = /^(\w+):(.*)$/.exec(list.value)?.slice(1) ?? [];
    list.value = '';
    if (kind === 'file') {
      this.renderRoot.querySelector<HTMLInputElement>('.file')?.click();
      return;
    }
    void this.#try(async () => {
      this.#take(await this.#chosen(kind, name));
    });
  };

  async #chosen(kind: string, name: string): Promise<readonly AddedGarment[]> {
    const {design} = this.workbench.history;
    const {sample} = design?.garment ?? {};
    if (kind === 'project') {
      const stored = await projectsFor(this.workbench)?.designOf(name);
      return stored ? addedFrom(stored) : [];
    }
    if (kind === 'size' && design && sample) {
      return [otherSize(design, await sampleGarment(sample.style, name))];
    }
    if (kind !== 'sample') return [];
    const sizes = this.samples?.garments.find(({style}) => style === name)?.sizes ?? [];
    const size = sizes.find((one) => one === (sample?.size ?? 'm')) ?? sizes[0] ?? 'm';
    return fresh(await sampleGarment(name, size));
  }

  #take(garments: readonly AddedGarment[]): void {
    const taken = addGarments(this.workbench, garments);
    if (taken < garments.length) this.said = this.words.tooManyGarments(mostAdded + 1);
  }

  readonly #readFile = ({target}: Event): void => {
    const input = target as HTMLInputElement;
    const [file] = input.files ?? [];
    if (!file) return;
    void this.#try(async () => {
      const garments = await garmentsIn(file, this.workbench);
      if (garments) this.#take(garments);
      else this.said = this.words.noGarment(file.name);
      input.value = '';
    });
  };

  /** Runs an attempt, and shows the reason if it fails. */
  async #try(attempt: () => Promise<void>): Promise<void> {
    this.said = '';
    try {
      await attempt();
    } catch (error) {
      this.said = spokenFailure(toFailure(error), this.workbench, this.texts);
    }
  }
}
