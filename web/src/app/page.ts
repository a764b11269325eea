/** The page: what is decided on the left, the pattern in the middle, how well it fits on the right. */
import {html, nothing, type TemplateResult} from 'lit';

import {
  controls,
  DeskElement,
  icon,
  tokens,
  type KeyMap,
  type LensCursor,
  type PatternPane,
  type Samples,
  type SeamLens,
} from '../element/index.js';
import {chooseFile, takeFiles} from './files.js';
import type {Keeper} from './keeper.js';
import {openFile} from './open-file.js';
import {pageLayout} from './page-layout.js';
import {pageKeys} from './page-keys.js';
import {saveProject, saveResult} from './save.js';

export class SeamwisePage extends DeskElement {
  static override properties = {
    ...DeskElement.properties,
    samples: {attribute: false},
    keeper: {attribute: false},
  };
  static override styles = [tokens, controls, pageLayout];
  declare samples: Samples | undefined;
  declare keeper: Keeper;
  #life: AbortController | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#life = new AbortController();
    const {signal} = this.#life;
    takeFiles((file) => void openFile(this.desk, file), signal);
    pageKeys(
      {
        undo: () => {
          this.desk.undo();
        },
        redo: () => {
          this.desk.redo();
        },
        save: () => {
          saveProject(this.desk);
        },
        open: () => void this.#open(),
        keys: () => this.renderRoot.querySelector<KeyMap>('sw-key-map')?.open(),
      },
      signal,
    );
    this.addEventListener(
      'sw-lens-wanted',
      () => this.renderRoot.querySelector<SeamLens>('sw-lens')?.focus(),
      {signal},
    );
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life?.abort();
  }

  protected override render(): TemplateResult {
    const {desk, samples} = this;
    const {app} = this.texts;
    return html`
      <header>
        <h1>${app.name}</h1>
        <sw-recent-menu .desk=${desk} .keeper=${this.keeper}></sw-recent-menu>
        <sw-garment-choice .desk=${desk} .samples=${samples}></sw-garment-choice>
        <button class="outlined" title=${app.openGarment} @click=${() => this.#open()}>
          ${icon.open} <span class="label">${app.openGarment}</span>
        </button>
        <span class="gap"></span>
        ${this.#icon(app.undo, icon.undo, desk.canUndo, () => {
          desk.undo();
        })}
        ${this.#icon(app.redo, icon.redo, desk.canRedo, () => {
          desk.redo();
        })}
        <button
          class="outlined"
          title=${app.saveProject}
          ?disabled=${!desk.design}
          @click=${() => {
            saveProject(desk);
          }}
        >
          ${icon.project} <span class="label">${app.saveProject}</span>
        </button>
        <button
          class="outlined"
          title=${app.saveResult}
          ?disabled=${!desk.result}
          @click=${() => {
            saveResult(desk);
          }}
        >
          ${icon.result} <span class="label">${app.saveResult}</span>
        </button>
        <sw-save-menu .desk=${desk}></sw-save-menu>
        <sw-settings .desk=${desk}></sw-settings>
        <span class="solving">
          <sw-progress .desk=${desk}></sw-progress>
          ${this.#solving()}
        </span>
      </header>
      <aside class="setup" aria-label=${app.setup}>
        <sw-print-panel .desk=${desk} .samples=${samples}></sw-print-panel>
        <sw-symmetry-panel .desk=${desk}></sw-symmetry-panel>
        <sw-fit-panel .desk=${desk}></sw-fit-panel>
      </aside>
      <main>
        <sw-units-question .desk=${desk}></sw-units-question>
        <sw-pattern .desk=${desk}></sw-pattern>${this.#notice()}
      </main>
      <aside class="report" aria-label=${app.report}>
        <sw-key-map .desk=${desk}></sw-key-map>
        <sw-headline .desk=${desk}></sw-headline>
        <sw-lens
          .desk=${desk}
          @sw-lens-cursor=${(event: CustomEvent<LensCursor | undefined>) => {
            if (this.#pattern) this.#pattern.cursor = event.detail;
          }}
        ></sw-lens>
        <sw-tables .desk=${desk}></sw-tables>
      </aside>
    `;
  }

  get #pattern(): PatternPane | null {
    return this.renderRoot.querySelector('sw-pattern');
  }

  async #open(): Promise<void> {
    const file = await chooseFile('.json,application/json');
    if (file) await openFile(this.desk, file, 'chosen as garment');
  }

  #solving(): TemplateResult {
    const {desk} = this;
    const {app} = this.texts;
    const solving = desk.state.kind === 'solving';
    return html`<button
        class="primary"
        ?disabled=${!desk.design || solving}
        @click=${() => {
          desk.align();
        }}
      >
        ${app.align}
      </button>
      <button
        class="outlined"
        ?disabled=${!solving}
        @click=${() => {
          desk.cancel();
        }}
      >
        ${app.cancel}
      </button>`;
  }

  #notice(): TemplateResult | typeof nothing {
    const {desk} = this;
    const {notice} = desk;
    if (!notice) return nothing;
    const {app} = this.texts;
    return html`<div
      class="notice ${notice.tone}"
      role=${notice.tone === 'error' ? 'alert' : 'status'}
    >
      <span>${notice.text}</span>
      ${
        notice.undo
          ? html`<button
              class="link"
              @click=${() => {
                desk.undo();
              }}
            >
              ${app.undo}
            </button>`
          : nothing
      }
      ${this.#icon(app.dismiss, icon.close, true, () => {
        desk.say(undefined);
      })}
    </div>`;
  }

  #icon(label: string, picture: TemplateResult, enabled: boolean, act: () => void): TemplateResult {
    return html`<button
      class="icon"
      aria-label=${label}
      title=${label}
      ?disabled=${!enabled}
      @click=${act}
    >
      ${picture}
    </button>`;
  }
}
