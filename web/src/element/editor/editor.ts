/** The editing desk: what is decided on the left, the pattern in the middle, how well it fits on the right. */
import {html, nothing, type TemplateResult} from 'lit';

import {DeskElement} from '../desk-element.js';
import type {SeamLens} from '../lens/lens.js';
import {defineParts} from '../parts.js';
import type {LensCursor} from '../pattern/marks.js';
import type {PatternPane} from '../pattern/pattern-pane.js';
import {register} from '../register.js';
import type {KeyMap} from '../shell/key-map.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import type {Samples} from '../workbench/samples.js';
import {editorKeys, type EditorCommands} from './editor-keys.js';
import {editorLayout} from './editor-layout.js';

/**
 * Whoever uses it puts controls of their own into its head: what is being edited into the slot `start`, what can
 * be done with it into `actions`. Where it is narrow, those of `order: -1` join the steps in its first row.
 */
export class Editor extends DeskElement {
  static override properties = {...DeskElement.properties, samples: {attribute: false}};
  /** The prints that come with Seamwise, to choose from. */
  declare samples: Samples | undefined;

  static override styles = [controls, editorLayout];

  readonly #commands: EditorCommands = {
    undo: () => {
      this.desk.undo();
    },
    redo: () => {
      this.desk.redo();
    },
    keys: () => this.renderRoot.querySelector<KeyMap>('sw-key-map')?.open(),
  };

  constructor() {
    super();
    this.addEventListener('keydown', (event) => {
      this.press(event);
    });
    this.addEventListener('sw-lens-wanted', () =>
      this.renderRoot.querySelector<SeamLens>('sw-lens')?.focus(),
    );
  }

  /** Keys that work wherever the focus is: in the editor by themselves, elsewhere when a page hands them on. */
  press(event: KeyboardEvent): void {
    editorKeys(event, this.#commands);
  }

  protected override render(): TemplateResult {
    const {desk} = this;
    const {app} = this.texts;
    return html`<div class="desk">
      <header>
        <slot name="start"></slot>
        <span class="gap"></span>
        ${this.#icon(app.undo, icon.undo, desk.canUndo, this.#commands.undo)}
        ${this.#icon(app.redo, icon.redo, desk.canRedo, this.#commands.redo)}
        <slot name="actions"></slot>
        <span class="solving">
          <sw-progress .desk=${desk}></sw-progress>
          ${this.#solving()}
        </span>
      </header>
      <section class="setup" aria-label=${app.setup}>
        <sw-print-panel .desk=${desk} .samples=${this.samples}></sw-print-panel>
        <sw-symmetry-panel .desk=${desk}></sw-symmetry-panel>
        <sw-fit-panel .desk=${desk}></sw-fit-panel>
      </section>
      <div class="pattern">
        <sw-units-question .desk=${desk}></sw-units-question>
        <sw-pattern .desk=${desk}></sw-pattern>${this.#notice()}
      </div>
      <section class="report" aria-label=${app.report}>
        <sw-key-map .desk=${desk}></sw-key-map>
        <sw-headline .desk=${desk} .samples=${this.samples}></sw-headline>
        <sw-lens
          .desk=${desk}
          @sw-lens-cursor=${(event: CustomEvent<LensCursor | undefined>) => {
            const pattern = this.renderRoot.querySelector<PatternPane>('sw-pattern');
            if (pattern) pattern.cursor = event.detail;
          }}
        ></sw-lens>
        <sw-tables .desk=${desk}></sw-tables>
      </section>
    </div>`;
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
          ? html`<button class="link" @click=${this.#commands.undo}>${app.undo}</button>`
          : nothing
      }
      ${
        notice.action
          ? html`<button class="link" @click=${notice.action.act}>${notice.action.label}</button>`
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

/** Registers the editor as `sw-editor`, and all that it is made of. */
export function defineEditor(): void {
  defineParts();
  register('sw-editor', Editor);
}
