/** The drape with its tools: drawing, settings, and text for screen readers. */
import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import {fabricOf, usualFabric} from '../../model/design/design.js';
import {fabricNames, type FabricName} from '../../model/result/draped-garment.js';
import {passingFailures, type Failure} from '../../model/base/failure.js';
import {presetNames, type CameraPreset} from '../../viewer/drape/camera.js';
import type {DrapeView} from '../../viewer/drape/drape-view.js';
import {drapeTexts, type DrapeTexts} from '../../texts/drape-texts.js';
import {tightnessOf} from '../../workbench/drape/spoken-tightness.js';
import {spokenDrapeNotes} from '../../workbench/drape/spoken-drape-notes.js';
import {spokenFailure} from '../../workbench/spoken-failure.js';
import {commandFor, keysOf, type KeyList, type Command} from '../../commands/editor-command.js';
import {sameTarget} from '../../workbench/state.js';
import type {Target} from '../../workbench/workbench.js';
import {headlineOf} from '../../workbench/lists/verdict.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {drapeCommands} from '../../commands/drape-commands.js';
import {BeforeAfter} from '../pattern/before-after.js';
import {DrapeDrawing, drapeStyle} from './drape-drawing.js';

/** Zoom step of a button; a key zooms less. */
const zoomFactor = 1.4;

export class DrapePane extends DrapeDrawing {
  static override properties = {
    ...DrapeDrawing.properties,
    purpose: {},
    seams: {attribute: false},
  };
  static override styles = [...DrapeDrawing.styles, controls, drapeStyle];
  /** `show`: for display only, in a page that scrolls. */
  declare purpose: 'show' | 'edit';
  /** Seams are coloured by mismatch. */
  declare seams: boolean;
  readonly beforeAfter = new BeforeAfter(() => {
    this.requestUpdate();
  });
  /** The preset nearest to the camera; a change of it is announced. */
  #preset: CameraPreset = 'front';
  /** Last selected target, here or elsewhere. */
  #selected: Target | undefined;

  constructor() {
    super();
    this.purpose = 'edit';
    this.seams = false;
  }

  toggleSeams(): void {
    this.seams = !this.seams;
  }

  /** Shows or hides the form under the garment. */
  toggleForm(): void {
    this.form = this.form === 'hidden' ? 'shown' : 'hidden';
  }

  /** Keys of the commands. */
  get keys(): KeyList {
    return keysOf(this.commands);
  }

  /** Commands, with the keys that work while the pane has the focus. */
  get commands(): readonly Command[] {
    return drapeCommands(this, this.purpose === 'edit', this.texts, this.#words);
  }

  /** Focuses the drape, so that its keys work. */
  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector<HTMLElement>('.application')?.focus(options);
  }

  protected override hasSeams(): boolean {
    return this.seams;
  }

  protected override viewOptions(): ConstructorParameters<typeof DrapeView>[1] {
    const onMoved = (): void => {
      this.#preset = this.view?.camera.preset ?? this.#preset;
      this.requestUpdate();
    };
    if (this.purpose === 'show') return {leavesWheel: true, onMoved};
    return {
      onMoved,
      onPoint: (target) => {
        this.workbench.selection.point(target);
      },
      onPick: (target) => {
        this.#selected = target;
        this.workbench.selection.select(target);
      },
    };
  }

  protected override opened(stage?: HTMLElement): void {
    super.opened();
    if (stage) stage.tabIndex = -1; // the whole drape has the focus
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const {selected} = this.workbench.selection;
    if (!this.view || sameTarget(selected, this.#selected)) return;
    // without a garment yet, the camera turns when there is one
    if (!selected || this.view.face(selected)) this.#selected = selected;
  }

  protected override drew(view: DrapeView): void {
    super.drew(view);
    view.setSeams(this.seams);
    const {selected, pointed} = this.workbench.selection;
    const {scenes} = this.workbench.sheet;
    const split = this.beforeAfter.shown;
    view.setWipe(split === undefined || !scenes ? undefined : {before: scenes.before, split});
    view.setMarked(this.purpose === 'edit' ? {selected, pointed} : {});
  }

  protected override render(): TemplateResult {
    const words = this.#words;
    const {state} = this.drapes.read;
    const edits = this.purpose === 'edit';
    return html`
      <div
        class="application"
        role="application"
        aria-label=${words.label}
        aria-description=${words.description}
        tabindex="0"
        @keydown=${this.#press}
        @keyup=${({key}: KeyboardEvent) => {
          if (key.toLowerCase() === 'w') this.beforeAfter.isHeld = false;
        }}
      >
        <div class="stage"></div>
      </div>
      ${this.beforeAfter.split !== undefined ? this.#wiping(this.beforeAfter.split) : nothing}
      ${edits ? this.#bar(words) : nothing}
      <slot name="notice"></slot>
      <div class="foot">
        <div class="said">${this.#told(words)}</div>
        ${this.#looking(words, edits)}
      </div>
      <progress
        aria-hidden="true"
        max="1"
        ?hidden=${state.kind !== 'draping'}
        .value=${state.kind === 'draping' ? state.progress.fraction : 0}
      ></progress>
      <p class="hidden" role="status">${this.#spoken(words)}</p>
    `;
  }

  get #words(): DrapeTexts {
    const {language, messages} = this.workbench.preferences.chosen;
    return drapeTexts(language, messages);
  }

  #bar(words: DrapeTexts): TemplateResult {
    const {design} = this.workbench.history;
    const fabric = design ? fabricOf(design) : usualFabric;
    return html`<div class="bar">
      <div class="group">
        <select
          aria-label=${words.fabric}
          title=${words.fabric}
          .value=${fabric}
          @change=${({target}: Event) => {
            this.workbench.history.change({
              fabric: (target as HTMLSelectElement).value as FabricName,
            });
          }}
        >
          ${fabricNames.map(
            (name) =>
              html`<option value=${name} ?selected=${name === fabric}>
                ${words.fabrics[name]}
              </option>`,
          )}
        </select>
        ${this.#toggle(words.form, this.form !== 'hidden', () => {
          this.toggleForm();
        })}
        ${this.#toggle(words.seams, this.seams, () => {
          this.toggleSeams();
        })}
      </div>
    </div>`;
  }

  #wiping(split: number): TemplateResult {
    return html`<div class="wipe">
      <sw-wipe-handle
        .workbench=${this.workbench}
        .split=${split}
        @input=${({detail}: CustomEvent<number>) => {
          this.beforeAfter.split = detail;
        }}
      ></sw-wipe-handle>
    </div>`;
  }

  /** Controls of the camera: view, zoom and turntable. */
  #looking(words: DrapeTexts, edits: boolean): TemplateResult {
    const {pattern} = this.texts;
    const isTurning = this.view?.camera.isTurning ?? false;
    const preset = this.view?.camera.preset ?? this.#preset;
    return html`<div class="group" role="group" aria-label=${pattern.view}>
      ${
        edits
          ? html`<sw-before
                .workbench=${this.workbench}
                .isOn=${this.beforeAfter.isHeld}
                @hold=${({detail}: CustomEvent<boolean>) => {
                  this.beforeAfter.isHeld = detail;
                }}
              ></sw-before>
              <button
                class="icon"
                aria-label=${pattern.wipe}
                title=${pattern.wipe}
                aria-pressed=${this.beforeAfter.split !== undefined}
                @click=${() => {
                  this.beforeAfter.toggle();
                }}
              >
                ${icon.wipe}</button
              ><select
                aria-label=${words.look}
                title=${words.look}
                .value=${preset}
                @change=${({target}: Event) => {
                  this.view?.camera.look((target as HTMLSelectElement).value as CameraPreset);
                }}
              >
                ${presetNames.map(
                  (name) =>
                    html`<option value=${name} ?selected=${name === preset}>
                      ${words.looks[name]}
                    </option>`,
                )}
              </select>`
          : nothing
      }
      <button
        class="icon turntable"
        aria-label=${words.turntable}
        title=${words.turntable}
        aria-pressed=${isTurning}
        @click=${() => {
          this.view?.camera.setTurntable(!isTurning);
        }}
      >
        ${icon.turntable}
      </button>
      ${this.#icon(pattern.zoomOut, icon.minus, 'zoom', () => this.view?.camera.zoomBy(1 / zoomFactor))}
      ${this.#icon(pattern.fit, icon.fit, '', () => this.view?.camera.look())}
      ${this.#icon(pattern.zoomIn, icon.plus, 'zoom', () => this.view?.camera.zoomBy(zoomFactor))}
    </div>`;
  }

  /** Progress, failure or notes. */
  #told(words: DrapeTexts): TemplateResult | typeof nothing {
    if (this.undrawable !== undefined) return html`<p class="told">${this.undrawable}</p>`;
    const {drapes} = this;
    const {state, drape} = drapes;
    const again = html`<button
      class="outlined"
      @click=${() => {
        drapes.again();
      }}
    >
      ${words.again}
    </button>`;
    switch (state.kind) {
      case 'waiting':
        return drape || !this.workbench.history.design
          ? nothing
          : html`<p class="told">${words.waiting}</p>`;
      case 'draping':
        return html`<p class="told">
          <span class="numbers"
            >${words.draping(this.format.percent(state.progress.fraction))}</span
          >
          <button
            @click=${() => {
              drapes.cancel();
            }}
          >
            ${words.stop}
          </button>
        </p>`;
      case 'cancelled':
        return html`<p class="told">${words.stopped} ${again}</p>`;
      case 'failed': {
        const {failure} = state;
        if (failure.reason === 'drapeTooSmall') return this.#tooSmall(failure, words);
        const why = spokenFailure(failure, this.workbench, this.texts);
        const isPassing = passingFailures.has(failure.code);
        return html`<p class="told bad" role="alert">${why} ${isPassing ? again : nothing}</p>`;
      }
      case 'done': {
        const notes = drape ? spokenDrapeNotes(drape, words, this.format) : [];
        if (this.seams && notes.length === 0)
          return html`<sw-legend .workbench=${this.workbench}></sw-legend>`;
        return notes.length > 0
          ? html`<p class="told">${notes.join(' ')}</p>`
          : html`<span class="truth">${words.truth}</span>`;
      }
    }
  }

  get #fabric(): FabricName {
    const {design} = this.workbench.history;
    return design ? fabricOf(design) : usualFabric;
  }

  /** A garment that is too tight may drape on another form or in another fabric. */
  #tooSmall(failure: Failure, words: DrapeTexts): TemplateResult {
    const tightness = tightnessOf(failure, words, this.format);
    const fits = tightness?.fits;
    const strained = this.#fabric === usualFabric ? undefined : words.fabrics[this.#fabric];
    const why =
      tightness?.sentence ??
      (strained === undefined
        ? spokenFailure(failure, this.workbench, this.texts)
        : words.strained(strained));
    if (fits === undefined && strained === undefined)
      return html`<p class="told bad" role="alert">${why}</p>`;
    return html`<p class="told" role="status">
      ${why}
      ${
        fits === undefined
          ? nothing
          : html`<button
              class="outlined"
              @click=${() => {
                this.drapes.drapeOn(fits);
              }}
            >
              ${words.drapeOn(fits)}
            </button>`
      }
      ${
        strained === undefined
          ? nothing
          : html`<button
              class="outlined"
              @click=${() => {
                this.workbench.history.change({fabric: usualFabric});
              }}
            >
              ${words.drapeIn(words.fabrics[usualFabric])}
            </button>`
      }
    </p>`;
  }

  /** "Front view. 9 of 11 visible seams match." */
  #spoken(words: DrapeTexts): string {
    const {state, drape} = this.drapes;
    if (!drape && state.kind === 'waiting') return words.waiting;
    if (state.kind === 'draping')
      return words.draping(this.format.percent(Math.floor(state.progress.fraction * 4) / 4));
    const view = words.seen[this.view?.camera.preset ?? this.#preset];
    const {selected} = this.workbench.selection;
    const {scenes} = this.workbench.sheet;
    const piece =
      selected?.kind === 'piece' ? scenes?.now.pieces[selected.piece]?.label : undefined;
    const seen = piece === undefined ? view : `${piece}. ${view}`;
    const {result, seamGroups: groups} = this.workbench.solving;
    if (!drape || !result) return seen;
    const weights = this.workbench.history.design?.options.weights;
    return `${seen} ${headlineOf({groups, weights}, this.texts)}.`;
  }

  readonly #press = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const command = commandFor(this.commands, event.key);
    if (command) command.run();
    else if (event.key.toLowerCase() === 'w' && this.purpose === 'edit')
      this.beforeAfter.isHeld = true;
    else if (event.key === 'Escape' && this.workbench.selection.selected)
      this.workbench.selection.select(undefined);
    else if (!this.view?.camera.key(event.key, event.shiftKey)) return;
    event.preventDefault();
    event.stopPropagation();
  };

  #toggle(label: string, on: boolean, act: () => void): TemplateResult {
    return html`<button aria-pressed=${on} @click=${act}>${label}</button>`;
  }

  #icon(label: string, picture: TemplateResult, kind: string, act: () => void): TemplateResult {
    return html`<button class="icon ${kind}" aria-label=${label} title=${label} @click=${act}>
      ${picture}
    </button>`;
  }
}
