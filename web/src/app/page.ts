/** The page: the editor, with files to open and to take away. */
import {html, type TemplateResult} from 'lit';

import type {Design} from '../model/design.js';
import {controls, DeskElement, icon, tokens, type Editor, type Samples} from '../element/index.js';
import {chooseFile, takeFiles} from './files.js';
import {openFile} from './open-file.js';
import {pageLayout} from './page-layout.js';
import {pageKeys} from './page-keys.js';
import {printPattern} from './print-pattern.js';
import type {Projects} from './projects/projects.js';
import {saveProject} from './save.js';

export class SeamwisePage extends DeskElement {
  static override properties = {
    ...DeskElement.properties,
    samples: {attribute: false},
    projects: {attribute: false},
    blank: {attribute: false},
    isHeld: {state: true},
  };
  static override styles = [tokens, controls, pageLayout];
  declare samples: Samples | undefined;
  declare projects: Projects;
  /** What is shown when there is no project. */
  declare blank: () => Promise<Design>;
  /** A file is held over the page. */
  declare protected isHeld: boolean;
  #life: AbortController | undefined;

  get #editor(): Editor | null {
    return this.renderRoot.querySelector('sw-editor');
  }

  constructor() {
    super();
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
        take: (file) => void openFile(this.desk, this.projects, file),
        hold: (isHeld) => {
          this.isHeld = isHeld;
        },
      },
      signal,
    );
    printPattern(this.desk, signal);
    pageKeys(
      {
        save: () => {
          saveProject(this);
        },
        open: () => void this.#open(),
        other: (event) => this.#editor?.press(event),
      },
      signal,
    );
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life?.abort();
  }

  protected override render(): TemplateResult {
    const {desk, projects, samples} = this;
    const {app} = this.texts;
    return html`<main>
      <button class="primary skip" @click=${() => this.#editor?.toPattern()}>
        ${app.toPattern}
      </button>
      <sw-editor .desk=${desk} .samples=${samples}>
        <h1 slot="start">${app.name}</h1>
        <sw-project-list
          slot="start"
          .desk=${desk}
          .projects=${projects}
          .blank=${this.blank}
        ></sw-project-list>
        <sw-garment-choice slot="start" .desk=${desk} .samples=${samples}></sw-garment-choice>
        <button
          slot="start"
          class="outlined"
          title=${app.openGarment}
          @click=${() => void this.#open()}
        >
          ${icon.open} <span class="label">${app.openGarment}</span>
        </button>
        <sw-save-menu slot="actions" .desk=${desk} .projects=${projects}></sw-save-menu>
        <sw-settings slot="actions" .desk=${desk}></sw-settings>
      </sw-editor>
      <p class="drop" ?hidden=${!this.isHeld}>${app.drop}</p>
    </main>`;
  }

  /** The document itself speaks the language, wears the colours and has the name that were chosen. */
  protected override updated(): void {
    const {language, theme} = this.desk.preferences;
    const root = document.documentElement;
    root.lang = language;
    const {name} = this.projects;
    document.title = name ? `${name} – ${this.texts.app.name}` : this.texts.app.name;
    if (theme === 'system') delete root.dataset.theme;
    else root.dataset.theme = theme;
  }

  async #open(): Promise<void> {
    const file = await chooseFile('.json,application/json');
    if (file) await openFile(this.desk, this.projects, file, 'chosen as garment');
  }
}
