/** The editing workbench: pattern and fabric on the left, the views in the middle, seams on the right. */
import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import {askedSymmetries} from '../model/design/design.js';
import {redoWords, undoWords} from '../workbench/history/step-change.js';
import type {KeyList} from '../commands/editor-command.js';
import type {ShortcutId} from '../commands/shortcuts.js';
import {WorkbenchElement} from './base/workbench-element.js';
import type {SeamLens} from './lens/lens.js';
import type {MarkerPane} from './marker/marker-pane.js';
import {loadDrape, loadLaterParts, loadMarker, loadPhoto} from './load-later-parts.js';
import {defineParts} from './parts.js';
import type {LensCursor} from '../workbench/tools/pattern-marks.js';
import type {PatternPane} from './pattern/pattern-pane.js';
import type {PhotoWanted} from '../print/openable-files.js';
import type {PrintPanel} from './print/print-panel.js';
import type {DrapePane} from './drape/drape-pane.js';
import type {CameraPreset} from '../viewer/drape/camera.js';
import {register} from './base/register.js';
import {
  sheetTabs,
  solvingButton,
  stepButtons,
  viewButtons,
  type Sheet,
} from './shell/head-buttons.js';
import type {KeyMap} from './shell/key-map.js';
import {controls} from './style/controls.js';
import type {Samples} from '../workbench/samples.js';
import {toFailure} from '../workbench/latest-solve.js';
import {sameTarget} from '../workbench/state.js';
import type {Target} from '../workbench/workbench.js';
import {editorKeys, isFree, type KeyCommands} from '../commands/pattern-keys.js';
import {editorLayout} from './editor-layout.js';
import type {PhotoKeeper} from '../photo/photo-keeper.js';

// Keeps an element at its greatest height so far, so that content below it does not move.

/** Time without a change after which the element releases the height it no longer needs. [ms] */
const settling = 2000;

class KeptHeight {
  readonly #part: HTMLElement;
  readonly #observer: ResizeObserver;
  #pause: ReturnType<typeof setTimeout> | undefined;
  #about: unknown;
  #width = 0;
  #highest = 0;

  /** @param part element to keep; heights with an open `details` are not counted */
  constructor(part: HTMLElement) {
    this.#part = part;
    this.#observer = new ResizeObserver(([entry]) => {
      const [size] = entry?.borderBoxSize ?? [];
      if (size) this.#measured(size.inlineSize, size.blockSize);
    });
    this.#observer.observe(part);
  }

  /** Subject of the element's text; a new subject resets the height. */
  set about(about: string) {
    if (about === this.#about) return;
    this.#about = about;
    this.#forget();
  }

  /** Restarts the pause after a change. @param isSettled true if the element has all its text */
  stir(isSettled: boolean): void {
    clearTimeout(this.#pause);
    if (!isSettled) return;
    this.#pause = setTimeout(() => {
      // nothing moves under the pointer
      if (this.#part.parentElement?.matches(':hover')) this.stir(true);
      else this.#forget();
    }, settling);
  }

  dispose(): void {
    clearTimeout(this.#pause);
    this.#observer.disconnect();
  }

  #measured(width: number, height: number): void {
    if (Math.abs(width - this.#width) > 1) {
      this.#width = width;
      this.#forget();
      return;
    }
    const isOpen = this.#part.shadowRoot?.querySelector('details[open]');
    if (isOpen || height <= this.#highest) return;
    this.#highest = height;
    this.#part.style.minHeight = `${height}px`;
  }

  #forget(): void {
    this.#highest = 0;
    this.#part.style.minHeight = '';
    // observing again causes a measurement, even of an unchanged height
    this.#observer.unobserve(this.#part);
    this.#observer.observe(this.#part);
  }
}

/** Views of the garment: drape, pattern pieces, both, or fabric layout. */
export const editorViews = ['garment', 'pattern', 'both', 'marker'] as const;
export type EditorView = (typeof editorViews)[number];

/** The first of these interactions loads the later parts, even before the first result. */
const interactions = ['pointerdown', 'wheel', 'keydown', 'focusin'] as const;

/**
 * Slots: `start` in the header for the page's name, `actions` and `goal` in the header for
 * commands, `garment` in the left panel for the choice of the garment, and `welcome` below the view.
 */
export class Editor extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    samples: {attribute: false},
    commands: {attribute: false},
    photos: {attribute: false},
    shows: {attribute: false},
    camera: {attribute: false},
    seams: {attribute: false},
    sheet: {attribute: false},
  };
  /** The prints that come with Seamwise. */
  declare samples: Samples | undefined;
  /** Functions of the page that have keyboard shortcuts. */
  declare commands: KeyCommands;
  /** Opens the storage of photos that became prints; undefined if the page stores nothing. */
  declare photos: (() => Promise<PhotoKeeper>) | undefined;
  declare shows: EditorView;
  /** Initial view of the drape. */
  declare camera: CameraPreset;
  /** The drape begins with coloured seams. */
  declare seams: boolean;
  /** The sheet that is open below the pattern in a narrow editor. */
  declare sheet: Sheet | undefined;

  static override styles = [controls, editorLayout];

  #selected: Target | undefined;
  #headline: KeptHeight | undefined;

  readonly #own = {
    undo: () => {
      if (!this.marker?.undo()) this.workbench.history.undo();
    },
    redo: () => {
      if (!this.marker?.redo()) this.workbench.history.redo();
    },
    keys: () => void this.#toggleKeys(),
    views: () => {
      const next = editorViews[editorViews.indexOf(this.shows) + 1];
      this.show(next ?? editorViews[0]);
    },
  } satisfies KeyCommands;

  constructor() {
    super();
    this.commands = {};
    this.shows = 'pattern';
    this.camera = 'front';
    this.seams = false;
    this.sheet = 'fabric';
    this.addEventListener('keydown', (event) => {
      this.press(event);
    });
    for (const type of interactions) {
      this.addEventListener(type, () => void loadLaterParts(), {once: true, passive: true});
    }
    this.addEventListener('sw-lens-wanted', () => void this.#toLens());
    this.addEventListener('sw-photo-wanted', (event) => void this.#toPhoto(event as PhotoWanted));
    this.addEventListener('sw-size-wanted', () => void this.#toSize());
    this.addEventListener('sw-sew-wanted', () => {
      this.pattern?.tools.beginSewing();
      this.show('pattern'); // who sews has to see the edges
      this.toPattern();
    });
    this.addEventListener('sw-grain-wanted', () => {
      const {pattern} = this;
      if (pattern?.tools.active !== 'grain') pattern?.tools.toggle('grain');
      pattern?.focus();
    });
  }

  /** Handles keys anywhere in the editor; a page can pass on key events from outside the editor. */
  press(event: KeyboardEvent): void {
    editorKeys(event, {...this.commands, ...this.#own});
    if (isFree(event)) this.pattern?.sewByKey(event);
  }

  get pattern(): PatternPane | null {
    return this.renderRoot.querySelector<PatternPane>('sw-pattern');
  }

  /** The drape; undefined while it is hidden or still loads. */
  get drape(): DrapePane | undefined {
    return this.renderRoot.querySelector<DrapePane>('sw-drape-pane:defined') ?? undefined;
  }

  /** The fabric layout; undefined while it is hidden or still loads. */
  get marker(): MarkerPane | undefined {
    return this.renderRoot.querySelector<MarkerPane>('sw-marker-pane:defined') ?? undefined;
  }

  /** Shows a view, and sends it as the detail of `sw-view`. */
  show(view: EditorView): void {
    if (view === this.shows) return;
    this.shows = view;
    if (view === 'marker') this.sheet = undefined; // it needs the room
    this.dispatchEvent(new CustomEvent('sw-view', {detail: view}));
  }

  /** Focuses the pattern, so that its keys work. */
  toPattern(): void {
    if (this.shows !== 'both') this.show('pattern');
    void this.updateComplete.then(() => {
      this.pattern?.focus();
    });
  }

  /** Shows or hides the list of keyboard shortcuts. */
  toggleKeys(): void {
    this.#own.keys();
  }

  async #toggleKeys(): Promise<void> {
    await loadLaterParts();
    const map = this.renderRoot.querySelector<KeyMap>('sw-key-map');
    await map?.updateComplete;
    map?.open();
  }

  /** Opens the photo dialog, which makes a print from a photo. */
  async #toPhoto({detail}: PhotoWanted): Promise<void> {
    try {
      const openPhoto = await loadPhoto();
      const keeper = await this.photos?.();
      await openPhoto(this.workbench, this.renderRoot, {
        ...(detail && {given: detail}),
        ...(keeper && {keeper}),
      });
    } catch (error) {
      this.workbench.notices.say({tone: 'error', text: toFailure(error).message});
    }
  }

  /** The lens is on the sheet `seams` in a narrow editor. */
  async #toLens(): Promise<void> {
    this.sheet = 'seams';
    await loadLaterParts();
    await this.updateComplete;
    this.renderRoot.querySelector<SeamLens>('sw-lens')?.focus();
  }

  /** The size fields are on the sheet `fabric` in a narrow editor. */
  async #toSize(): Promise<void> {
    this.sheet = 'fabric';
    await this.updateComplete;
    this.renderRoot.querySelector<PrintPanel>('sw-print-panel')?.toSize();
  }

  /** Opens the sheet with the lens in a narrow editor once the user selects a seam. */
  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.shows !== 'pattern') void this.#load();
    const {selected} = this.workbench.selection;
    if (sameTarget(selected, this.#selected)) return;
    this.#selected = selected;
    if (selected?.kind === 'seam') this.sheet = 'seams';
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#headline?.dispose();
    this.#headline = undefined;
  }

  protected override updated(): void {
    const {kind} = this.workbench.solving.state;
    if (kind !== 'opening' && kind !== 'solving') void loadLaterParts();
    const part = this.renderRoot.querySelector<HTMLElement>('sw-headline');
    if (!part || !this.isConnected) return;
    this.#headline ??= new KeptHeight(part);
    const {design} = this.workbench.history;
    const isSymmetric = design && askedSymmetries(design).length > 0;
    this.#headline.about = `${design?.garment.name} ${isSymmetric ? 'symmetric' : ''}`;
    this.#headline.stir(kind === 'done');
  }

  protected override render(): TemplateResult {
    const {workbench} = this;
    const {app} = this.texts;
    return html`<div class="workbench" data-sheet=${this.sheet ?? 'none'}>
      <header>
        <slot name="start"></slot>
        <span class="gap"></span>
        <span class="solving">
          <sw-progress .workbench=${workbench}></sw-progress>
          ${solvingButton(workbench, app)}
        </span>
        ${this.#steps()}
        <slot name="actions"></slot>
        <button
          class="icon keys"
          aria-label=${app.keys}
          title="${app.keys} (?)"
          @click=${this.#own.keys}
        >
          ?
        </button>
        <slot name="goal"></slot>
      </header>
      <div class="pattern" data-shows=${this.shows}>
        ${viewButtons(editorViews, this.shows, this.texts, (view) => {
          this.show(view);
        })}
        <sw-units-question .workbench=${workbench}></sw-units-question>
        <sw-grain-question .workbench=${workbench}></sw-grain-question>
        <sw-pattern .workbench=${workbench}
          >${this.#showsPattern ? this.#notice() : nothing}</sw-pattern
        >
        ${this.#beside()}
        <slot name="welcome"></slot>
      </div>
      <div class="side">
        <section class="setup" aria-label=${app.setup}>
          <slot name="garment"></slot>
          <sw-print-panel .workbench=${workbench} .samples=${this.samples}></sw-print-panel>
          <sw-symmetry-panel .workbench=${workbench}></sw-symmetry-panel>
          <sw-solve-panel .workbench=${workbench}></sw-solve-panel>
        </section>
        <section class="report" aria-label=${app.report}>
          <sw-headline .workbench=${workbench} .samples=${this.samples}></sw-headline>
          <sw-seam-table .workbench=${workbench}></sw-seam-table>
          <sw-piece-table .workbench=${workbench}></sw-piece-table>
          <sw-lens
            .workbench=${workbench}
            @sw-lens-cursor=${(event: CustomEvent<LensCursor | undefined>) => {
              if (this.pattern) this.pattern.cursor = event.detail;
            }}
          ></sw-lens>
        </section>
        ${sheetTabs(
          this.texts,
          this.sheet,
          (sheet) => {
            this.sheet = sheet;
          },
          this.commands.cut,
        )}
      </div>
      <sw-key-map
        .workbench=${workbench}
        .known=${this.#known}
        .more=${this.#keysOfView}
        .view=${this.shows}
        .tool=${this.#tool}
      ></sw-key-map>
    </div>`;
  }

  #steps(): TemplateResult {
    const {marker, workbench, texts} = this;
    const {undo, redo} = this.#own;
    return stepButtons(texts, {
      undo: {words: marker?.undoWords ?? undoWords(workbench, texts), run: undo},
      redo: {words: marker?.redoWords ?? redoWords(workbench, texts), run: redo},
    });
  }

  async #load(): Promise<void> {
    try {
      await (this.shows === 'marker' ? loadMarker : loadDrape)();
    } catch (error) {
      this.shows = 'pattern';
      this.workbench.notices.say({tone: 'error', text: toFailure(error).message});
    }
  }

  get #showsPattern(): boolean {
    return this.shows === 'pattern' || this.shows === 'both';
  }

  /** The view beside the pattern or in its place. */
  #beside(): TemplateResult | typeof nothing {
    const {workbench, shows} = this;
    if (shows === 'pattern') return nothing;
    const notice = this.#showsPattern ? nothing : this.#notice();
    return shows === 'marker'
      ? html`<sw-marker-pane .workbench=${workbench}>${notice}</sw-marker-pane>`
      : html`<sw-drape-pane
          camera=${this.camera}
          .seams=${this.seams}
          .workbench=${workbench}
          .beside=${true}
          >${notice}</sw-drape-pane
        >`;
  }

  #notice(): TemplateResult {
    return html`<sw-notice slot="notice" .workbench=${this.workbench}></sw-notice>`;
  }

  readonly #keysOfView = (): KeyList => (this.drape ?? this.marker)?.keys ?? [];

  readonly #tool = () => this.pattern?.tools.editing;

  /** Commands whose shortcuts work in this editor. */
  get #known(): readonly ShortcutId[] {
    return Object.keys({...this.commands, ...this.#own}) as ShortcutId[];
  }
}

/** Registers the editor as `sw-editor`, and all its parts. */
export function defineEditor(): void {
  defineParts();
  register('sw-editor', Editor);
}
