/** The editing desk: what is decided on the left, the pattern in the middle, how well it fits on the right. */
import {html, type TemplateResult} from 'lit';

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
import {sameTarget} from '../workbench/state.js';
import {stepName} from '../workbench/step-name.js';
import type {Target} from '../workbench/workbench.js';
import {editorKeys, type EditorCommands} from './editor-keys.js';
import {editorLayout} from './editor-layout.js';
import {KeptHeight} from './kept-height.js';

type Sheet = 'print' | 'cutting' | 'fit' | 'lists';

/**
 * Whoever uses it puts controls of their own into its head: what is being edited into the slot `start`, what can
 * be done with it into `actions`. Where it is narrow, those of `order: -1` join the steps in its first row.
 */
export class Editor extends DeskElement {
  static override properties = {
    ...DeskElement.properties,
    samples: {attribute: false},
    sheet: {state: true},
  };
  /** The prints that come with Seamwise, to choose from. */
  declare samples: Samples | undefined;
  /** What is open below the pattern where there is no room beside it. */
  declare protected sheet: Sheet | undefined;

  static override styles = [controls, editorLayout];

  #selected: Target | undefined;
  #headline: KeptHeight | undefined;

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
    this.sheet = 'print';
    this.addEventListener('keydown', (event) => {
      this.press(event);
    });
    this.addEventListener('sw-lens-wanted', () =>
      this.renderRoot.querySelector<SeamLens>('sw-lens')?.focus(),
    );
    this.addEventListener('sw-grain-wanted', () => {
      const pattern = this.renderRoot.querySelector<PatternPane>('sw-pattern');
      if (pattern?.tools.active !== 'grain') pattern?.tools.toggle('grain');
      pattern?.focus();
    });
  }

  /** Keys that work wherever the focus is: in the editor by themselves, elsewhere when a page hands them on. */
  press(event: KeyboardEvent): void {
    editorKeys(event, this.#commands);
  }

  /** The keys of the pattern work. */
  toPattern(): void {
    this.renderRoot.querySelector<PatternPane>('sw-pattern')?.focus();
  }

  /** A seam that somebody picks in the pattern is to be seen from near. */
  protected override deskChanged(): void {
    super.deskChanged();
    const {selected} = this.desk;
    if (sameTarget(selected, this.#selected)) return;
    this.#selected = selected;
    if (selected?.kind === 'seam' && this.sheet !== 'lists') this.sheet = 'fit';
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#headline?.dispose();
    this.#headline = undefined;
  }

  protected override updated(): void {
    const part = this.renderRoot.querySelector<HTMLElement>('sw-headline');
    if (!part || !this.isConnected) return;
    this.#headline ??= new KeptHeight(part);
    const {garment, symmetries} = this.desk.design ?? {};
    this.#headline.about = `${garment?.name} ${symmetries?.length ? 'symmetric' : ''}`;
  }

  protected override render(): TemplateResult {
    const {desk} = this;
    const {app} = this.texts;
    return html`<div class="desk" data-sheet=${this.sheet ?? 'none'}>
      <header>
        <slot name="start"></slot>
        <span class="gap"></span>
        ${this.#steps()}
        <slot name="actions"></slot>
        <span class="solving">
          <sw-progress .desk=${desk}></sw-progress>
          ${this.#solving()}
        </span>
        <button
          class="icon keys"
          aria-label=${app.keys}
          title="${app.keys} (?)"
          @click=${this.#commands.keys}
        >
          ?
        </button>
      </header>
      <div class="pattern">
        <sw-units-question .desk=${desk}></sw-units-question>
        <sw-grain-question .desk=${desk}></sw-grain-question>
        <sw-pattern .desk=${desk}><sw-notice slot="notice" .desk=${desk}></sw-notice></sw-pattern>
      </div>
      <div class="side">
        <section class="setup" aria-label=${app.setup}>
          <sw-print-panel .desk=${desk} .samples=${this.samples}></sw-print-panel>
          <sw-symmetry-panel .desk=${desk}></sw-symmetry-panel>
          <sw-fit-panel .desk=${desk}></sw-fit-panel>
        </section>
        <section class="report" aria-label=${app.report}>
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
        ${this.#tabs()}
      </div>
      <sw-key-map .desk=${desk}></sw-key-map>
    </div>`;
  }

  /** What opens below the pattern, one sheet at a time; another press closes it. */
  #tabs(): TemplateResult {
    const {app, print, controls: cutting, headline, lists} = this.texts;
    const names: readonly (readonly [Sheet, string])[] = [
      ['print', print.title],
      ['cutting', cutting.fit],
      ['fit', headline.fit],
      ['lists', lists.pieces],
    ];
    return html`<nav class="tabs" aria-label=${app.panels}>
      ${names.map(
        ([name, label]) =>
          html`<button
            aria-expanded=${this.sheet === name}
            @click=${() => {
              this.sheet = this.sheet === name ? undefined : name;
            }}
          >
            ${label}
          </button>`,
      )}
    </nav>`;
  }

  #steps(): TemplateResult {
    const {desk} = this;
    const {app, steps} = this.texts;
    const {past = [], present, future = []} = desk.history ?? {};
    const [before, after] = [past.at(-1), future[0]];
    const name = (from: typeof before, to: typeof before): string =>
      from && to ? steps[stepName(from.design, to.design)] : '';
    return html`${this.#icon(
      app.undo,
      app.undoOf(name(before, present)),
      icon.undo,
      desk.canUndo,
      this.#commands.undo,
    )}
    ${this.#icon(
      app.redo,
      app.redoOf(name(present, after)),
      icon.redo,
      desk.canRedo,
      this.#commands.redo,
    )}`;
  }

  /** One button: it ends what is under way, or begins it where nobody else does. */
  #solving(): TemplateResult {
    const {desk} = this;
    const {app} = this.texts;
    const {kind} = desk.state;
    const isSolving = kind === 'solving';
    const asks = !desk.preferences.solveAsIGo || kind === 'stale' || kind === 'failed';
    const aligns = asks && !isSolving && desk.design !== undefined;
    return html`<button
      class=${aligns ? 'primary' : 'outlined'}
      ?hidden=${!aligns && !isSolving}
      @click=${({detail}: MouseEvent) => {
        if (detail > 1) return; // the second half of a double click
        if (isSolving) desk.cancel();
        else if (aligns) desk.align();
      }}
    >
      ${aligns ? app.align : app.cancel}
    </button>`;
  }

  #icon(
    label: string,
    title: string,
    picture: TemplateResult,
    enabled: boolean,
    act: () => void,
  ): TemplateResult {
    return html`<button
      class="icon"
      aria-label=${label}
      title=${enabled ? title : label}
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
