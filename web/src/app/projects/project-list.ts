/** All projects of this browser with preview images: to open, rename, duplicate and delete. */
import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';

import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {icon} from '../../editor/style/icons.js';
import type {Design} from '../../model/design/design.js';
import {longestName} from '../../model/documents/project-name.js';
import {noProjects, noProjectsStyle} from './no-projects.js';
import {projectListStyle} from './project-list-style.js';
import type {ProjectEntry, Projects} from './projects.js';

export class ProjectList extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    projects: {attribute: false},
    blank: {attribute: false},
    entries: {state: true},
  };
  static override styles = [controls, projectListStyle, noProjectsStyle];
  declare projects: Projects;
  /** Returns the design shown after the last project is deleted. */
  declare blank: () => Promise<Design>;
  declare entries: readonly ProjectEntry[];
  /** Object URLs of preview images, by `keyOf`. */
  readonly #pictures = new Map<string, string>();
  /** Project that was just deleted or restored; it receives the focus once it is drawn. */
  #focusOn: string | undefined;
  #unsubscribe: (() => void) | undefined;

  constructor() {
    super();
    this.entries = [];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#closed();
  }

  async open(): Promise<void> {
    this.#unsubscribe ??= this.projects.subscribe(() => void this.#list());
    await this.#list();
    await this.updateComplete;
    const dialog = this.#dialog;
    if (dialog?.open === false) dialog.showModal();
  }

  protected override render(): TemplateResult {
    const {app, projects} = this.texts;
    return html`
      <dialog
        aria-labelledby="title"
        @close=${() => {
          this.#closed();
        }}
        @click=${(event: Event) => {
          // a click on the dialog element itself hits its backdrop
          if (event.target === event.currentTarget) this.#dialog?.close();
        }}
      >
        <header>
          <h2 id="title">${projects.title}</h2>
          <button
            class="icon"
            aria-label=${app.close}
            title=${app.close}
            @click=${() => {
              this.#dialog?.close();
            }}
          >
            ${icon.close}
          </button>
        </header>
        <div class="body">${this.#note()} ${this.#cards()}</div>
      </dialog>
    `;
  }

  protected override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    if (!changed.has('entries') || this.#focusOn === undefined) return;
    this.renderRoot.querySelector<HTMLElement>('[data-focus]')?.focus();
    this.#focusOn = undefined;
  }

  #note(): TemplateResult | typeof nothing {
    const {trouble} = this.projects;
    if (trouble) return html`<p class="note error">${this.texts.storage[trouble]}</p>`;
    const others = this.entries.some(({open}) => open !== 'here');
    return others
      ? nothing
      : html`<div class="empty">
          ${noProjects}
          <p class="note soft">${this.texts.projects.none}</p>
        </div>`;
  }

  #cards(): TemplateResult {
    return html`<ul role="list">
      ${repeat(
        this.entries,
        ({id, isDeleted}) => `${id} ${isDeleted}`,
        (entry) => (entry.isDeleted ? this.#deleted(entry) : this.#card(entry)),
      )}
    </ul>`;
  }

  #card(entry: ProjectEntry): TemplateResult {
    const {id, name, changed, thumbnail, open} = entry;
    const {projects} = this.texts;
    return html`<li class=${open ?? ''}>
      <button
        class="open"
        aria-label=${projects.open(name)}
        title=${projects.open(name)}
        aria-current=${open === 'here' ? 'true' : nothing}
        ?data-focus=${this.#focusOn === id}
        @click=${() => void this.#take(id)}
      >
        ${thumbnail ? html`<img src=${this.#urlOf(entry, thumbnail)} alt="" />` : icon.piece}
      </button>
      <input
        class="name"
        type="text"
        aria-label="${projects.name}: ${name}"
        maxlength=${longestName}
        autocomplete="off"
        spellcheck="false"
        .value=${name}
        @change=${(event: Event) => void this.#rename(id, event.target as HTMLInputElement)}
        @keydown=${(event: KeyboardEvent) => {
          this.#nameKey(event, name);
        }}
      />
      <div class="foot">
        <span class="soft">
          ${open ? projects[open] : html`<span>${this.format.moment(changed)}</span>`}
        </span>
        ${this.#action(projects.duplicate(name), icon.copy, () => void this.projects.duplicate(id))}
        ${
          open === 'elsewhere'
            ? nothing
            : this.#action(projects.delete(name), icon.bin, () => void this.#remove(id))
        }
      </div>
    </li>`;
  }

  #deleted({id, name}: ProjectEntry): TemplateResult {
    const {projects} = this.texts;
    return html`<li class="deleted">
      <span role="status">${projects.deleted(name)}</span>
      <button
        class="outlined"
        aria-label=${projects.restore(name)}
        ?data-focus=${this.#focusOn === id}
        @click=${() => {
          this.#focusOn = id;
          void this.projects.restore(id);
        }}
      >
        ${icon.undo} ${projects.undo}
      </button>
    </li>`;
  }

  #action(label: string, picture: TemplateResult, act: () => void): TemplateResult {
    return html`<button class="icon" aria-label=${label} title=${label} @click=${act}>
      ${picture}
    </button>`;
  }

  get #dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector('dialog');
  }

  #nameKey(event: KeyboardEvent, name: string): void {
    const input = event.target as HTMLInputElement;
    event.stopPropagation(); // outside of the dialog, letters are keyboard shortcuts
    if (event.key === 'Enter') input.blur();
    if (event.key !== 'Escape' || input.value === name) return;
    event.preventDefault(); // keeps the dialog open
    input.value = name;
  }

  async #list(): Promise<void> {
    this.entries = await this.projects.entries();
    await this.updateComplete;
    const shown = new Set(this.entries.map(keyOf));
    for (const [key, url] of this.#pictures) {
      if (shown.has(key)) continue;
      URL.revokeObjectURL(url);
      this.#pictures.delete(key);
    }
  }

  async #take(id: string): Promise<void> {
    if (await this.projects.open(id)) this.#dialog?.close();
    else this.workbench.notices.say({tone: 'error', text: this.texts.projects.gone});
  }

  /** Shows the name as it is stored; an update of the list does not replace a name being typed. */
  async #rename(id: string, input: HTMLInputElement): Promise<void> {
    await this.projects.rename(id, input.value);
    await this.#list();
    input.value = this.entries.find((entry) => entry.id === id)?.name ?? input.value;
  }

  async #remove(id: string): Promise<void> {
    this.#focusOn = id;
    await this.projects.remove(id, this.blank);
    await this.#list();
  }

  #urlOf(entry: ProjectEntry, picture: Blob): string {
    const key = keyOf(entry);
    const url = this.#pictures.get(key) ?? URL.createObjectURL(picture);
    this.#pictures.set(key, url);
    return url;
  }

  #closed(): void {
    this.#unsubscribe?.();
    this.#unsubscribe = undefined;
    for (const url of this.#pictures.values()) URL.revokeObjectURL(url);
    this.#pictures.clear();
    this.entries = [];
  }
}

/** Returns a key that changes with the preview image. */
const keyOf = ({id, changed, thumbnail}: ProjectEntry): string =>
  `${id} ${changed} ${thumbnail?.size ?? 0}`;
