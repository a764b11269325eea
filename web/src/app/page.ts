/** The page: the editor with commands to open and save files. */
import {html, nothing, type TemplateResult} from 'lit';

import type {Design} from '../model/design/design.js';
import {controls} from '../editor/style/controls.js';
import {WorkbenchElement} from '../editor/base/workbench-element.js';
import {icon} from '../editor/style/icons.js';
import {keyOf} from '../commands/shortcuts.js';
import {printFiles} from '../print/openable-files.js';
import {tokens} from '../editor/style/tokens.js';
import type {Editor, EditorView} from '../editor/editor.js';
import type {GarmentChoice} from '../editor/shell/garment-choice.js';
import type {PatternPane} from '../editor/pattern/pattern-pane.js';
import type {PhotoKeeper} from '../photo/photo-keeper.js';
import type {Samples} from '../workbench/samples.js';
import type {DrapePane} from '../editor/drape/drape-pane.js';
import type {MarkerPane} from '../editor/marker/marker-pane.js';
import {chooseFile, takeFiles} from './files.js';
import {endFirstVisit, isFirstVisit} from './introduction/first-visit.js';
import {keepView, storedView} from './storage/shown-view.js';
import type {How} from './open-file.js';
import {pageLayout} from './style/page-layout.js';
import type {PageParts} from './palette/page-parts.js';
import {printPattern} from './print-pattern.js';
import type {ProjectsButton} from './projects/projects-button.js';
import type {Projects} from './projects/projects.js';
import {savePicture, saveProject, saveResult, type SaveMenu} from './save-menu.js';

/** Loads the store of photos; they stay in this browser. */
const keptPhotos = async (): Promise<PhotoKeeper> =>
  (await import('./storage/unfinished-photo.js')).photoStorage;

export class SeamwisePage extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    samples: {attribute: false},
    projects: {attribute: false},
    blank: {attribute: false},
    isFirst: {attribute: false},
    isHeld: {state: true},
  };
  static override styles = [tokens, controls, pageLayout];
  declare samples: Samples | undefined;
  declare projects: Projects;
  /** Returns the design for a page without a project. */
  declare blank: () => Promise<Design>;
  /** Shows the three ways to begin, until the first action. */
  declare isFirst: boolean;
  /** A file is being dragged over the page. */
  declare protected isHeld: boolean;
  #life: AbortController | undefined;
  /** The view at the start. */
  readonly #view = storedView();
  /** The open sheet of a phone at the start: none on a first visit, which shows the garment large. */
  readonly #sheet = isFirstVisit() ? undefined : 'fabric';

  get #editor(): Editor | null {
    return this.renderRoot.querySelector('sw-editor');
  }

  readonly #shownView = (): DrapePane | MarkerPane | undefined =>
    this.#editor?.drape ?? this.#editor?.marker;

  /** Commands with keyboard shortcuts outside the editor. */
  readonly #keyed = {
    commands: (): void => void this.#commands(),
    open: (): void => void this.#open(),
    save: (): void => {
      saveProject(this);
    },
    cut: (): void => void this.#cut(),
  };

  get pattern(): PatternPane | null {
    return this.#editor?.pattern ?? null;
  }

  constructor() {
    super();
    this.isFirst = false;
    this.isHeld = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#life = new AbortController();
    const {signal} = this.#life;
    const end = this.projects.subscribe(() => {
      this.requestUpdate();
    });
    signal.addEventListener('abort', end);
    takeFiles(
      {
        take: (file) => void this.#take(file),
        hold: (isHeld) => {
          this.isHeld = isHeld;
        },
      },
      signal,
    );
    printPattern(this.workbench, signal);
    addEventListener(
      'keydown',
      (event) => {
        this.#editor?.press(event);
      },
      {signal},
    );
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life?.abort();
  }

  protected override render(): TemplateResult {
    const {workbench, projects, samples} = this;
    const {app, commands} = this.texts;
    return html`<main>
      <button class="primary skip" @click=${() => this.#editor?.toPattern()}>
        ${app.toPattern}
      </button>
      <sw-editor
        .workbench=${workbench}
        .samples=${samples}
        .commands=${this.#keyed}
        .photos=${keptPhotos}
        .shows=${this.#view}
        .sheet=${this.#sheet}
        .camera=${'three-quarter'}
        .seams=${true}
        @sw-view=${({detail}: CustomEvent<EditorView>) => {
          keepView(detail);
          this.#endFirst();
        }}
      >
        <h1 slot="start">${app.name}</h1>
        <p slot="start" class="tagline">${app.tagline}</p>
        <section slot="garment" aria-labelledby="garment">
          <header>
            <h2 id="garment">${this.texts.pattern.views.pattern}</h2>
            <button class="outlined" @click=${this.#keyed.open}>
              ${icon.open} ${app.openGarment}
            </button>
          </header>
          <sw-garment-choice .workbench=${workbench} .samples=${samples}></sw-garment-choice>
        </section>
        <sw-projects-button
          slot="actions"
          .workbench=${workbench}
          .projects=${projects}
          .blank=${this.blank}
        ></sw-projects-button>
        <sw-save-menu
          slot="actions"
          .workbench=${workbench}
          .projects=${projects}
          .view=${this.#shownView}
        ></sw-save-menu>
        <button
          slot="actions"
          class="icon commands"
          aria-label=${commands.title}
          title="${commands.title} (${keyOf('commands', this.texts)})"
          aria-haspopup="dialog"
          @click=${this.#keyed.commands}
        >
          ${icon.search}
        </button>
        <sw-settings slot="actions" .workbench=${workbench}></sw-settings>
        <button
          slot="goal"
          class="primary"
          aria-haspopup="dialog"
          title="${app.cut} (${keyOf('cut', this.texts)})"
          ?disabled=${!workbench.history.design}
          @click=${this.#keyed.cut}
        >
          ${app.cut}
        </button>
        ${
          this.isFirst
            ? html`<sw-welcome
                slot="welcome"
                .workbench=${workbench}
                @pattern=${this.#keyed.open}
                @fabric=${() => void this.#openPrint()}
                @sample=${() => void this.#toSamples()}
                @done=${() => {
                  this.#endFirst();
                }}
              ></sw-welcome>`
            : nothing
        }
      </sw-editor>
      <p class="drop" ?hidden=${!this.isHeld}>${app.drop}</p>
    </main>`;
  }

  /** Applies the language, the theme and the project's name to the document. */
  protected override updated(): void {
    const {language, theme} = this.workbench.preferences.chosen;
    const root = document.documentElement;
    root.lang = language;
    const {name} = this.projects;
    document.title = name ? `${name} – ${this.texts.app.name}` : this.texts.app.name;
    if (theme === 'system') delete root.dataset.theme;
    else root.dataset.theme = theme;
  }

  #endFirst(): void {
    if (!this.isFirst) return;
    this.isFirst = false;
    endFirstVisit();
  }

  get #garments(): GarmentChoice | null {
    return this.renderRoot.querySelector('sw-garment-choice');
  }

  /** Opens the list of sample garments. */
  async #toSamples(): Promise<void> {
    const editor = this.#editor;
    if (!editor) return;
    editor.sheet = 'pattern';
    await editor.updateComplete;
    this.#garments?.open();
  }

  /** Opens the dialog for a cutting sheet. */
  async #cut(): Promise<void> {
    const menu = this.renderRoot.querySelector<SaveMenu>('sw-save-menu');
    if (!menu || !this.workbench.history.design) return;
    const {openCut} = await import('./cut/cut-dialog.js');
    await openCut(this.workbench, this.renderRoot, menu.saveOther);
  }

  async #open(): Promise<void> {
    const file = await chooseFile('.json,.pdf,.dxf,.svg,.obj,application/json,application/pdf');
    if (file) await this.#take(file, 'chosen as garment');
  }

  async #take(file: File, how?: How): Promise<void> {
    const {openFile} = await import('./open-file.js');
    const {workbench, projects, renderRoot: root} = this;
    await openFile({workbench, projects, root}, file, how);
  }

  async #openPrint(): Promise<void> {
    const file = await chooseFile(printFiles);
    if (file) await this.#take(file, 'chosen as print');
  }

  /** Opens the command palette; its code is loaded on first use. */
  async #commands(): Promise<void> {
    const {toggleCommands} = await import('./palette/index.js');
    await toggleCommands(this.workbench, this.renderRoot, () => this.#parts);
  }

  /** Undefined until the page is drawn. */
  get #parts(): PageParts | undefined {
    const {workbench, texts, format, samples, renderRoot: root} = this;
    const editor = this.#editor;
    const list = root.querySelector<ProjectsButton>('sw-projects-button');
    const garments = this.#garments;
    const menu = root.querySelector<SaveMenu>('sw-save-menu');
    if (!editor || !list || !garments || !menu) return undefined;
    return {
      ...{workbench, texts, format, samples, editor, garments},
      saves: {
        project: this.#keyed.save,
        result: () => {
          saveResult(this);
        },
        picture: () => void savePicture(this),
        cut: this.#keyed.cut,
        link: () => void menu.copyLink(),
        other: menu.saveOther,
      },
      openGarment: this.#keyed.open,
      openPrint: () => void this.#openPrint(),
      showProjects: () => void list.open(),
    };
  }
}
