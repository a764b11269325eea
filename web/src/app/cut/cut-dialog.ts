/**
 * Dialog for a cutting sheet: format, paper and allowances, with a preview of the pages before the
 * file is made.
 */
import {html, type TemplateResult} from 'lit';

import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {icon} from '../../editor/style/icons.js';
import type {NumberField} from '../../editor/controls/number-field.js';
import {wantSize} from '../../editor/print/size-wanted.js';
import type {SolveResult} from '../../model/result/result.js';
import {cutTexts, type CutTexts} from '../../texts/cut-texts.js';
import {keepChoices, storedChoices, type CutChoices} from './cut-choices.js';
import {cutFile, cutPlan, type CutPlan} from './cut-job.js';
import {cutSettings} from './cut-settings.js';
import {pageMap} from './page-map.js';
import {sheetDialog} from '../../editor/style/sheet-dialog.js';
import {cutStyle} from './cut-style.js';
import type {Workbench} from '../../workbench/workbench.js';

/** Receives a file and the ending of its name. */
type Saver = (ending: string, content: Blob) => void;

const types = {
  pdf: 'application/pdf',
  svg: 'image/svg+xml',
  dxf: 'application/dxf',
  plt: 'application/vnd.hp-hpgl',
} as const;

class CutDialog extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    choices: {state: true},
    plan: {state: true},
    making: {state: true},
    trouble: {state: true},
    isRenewed: {state: true},
  };
  static override styles = [controls, sheetDialog, cutStyle];
  /** Texts in the user's language. */
  declare words: CutTexts;
  declare save: Saver;
  declare protected choices: CutChoices;
  /** Undefined until there is one. */
  declare protected plan: CutPlan | undefined;
  declare protected making: 'plan' | 'file' | undefined;
  declare protected trouble: string | undefined;
  /** A new answer has arrived since the dialog was opened. */
  declare protected isRenewed: boolean;
  /** Answer of the current or pending plan. */
  #laid: SolveResult | undefined;
  #life = new AbortController();

  async open(): Promise<void> {
    this.choices = storedChoices(this.workbench);
    this.#laid = undefined;
    this.plan = undefined;
    this.isRenewed = false;
    this.trouble = undefined;
    await this.updateComplete;
    if (!this.#dialog?.open) this.#dialog?.showModal();
    this.#follow();
  }

  protected override updated(): void {
    if (this.#dialog?.open) this.#follow();
  }

  protected override render(): TemplateResult {
    const {words, texts} = this;
    return html`<dialog
      aria-labelledby="title"
      @close=${() => {
        this.#life.abort();
      }}
      @keydown=${(event: Event) => {
        event.stopPropagation(); // outside of the dialog, letters are keyboard shortcuts
      }}
    >
      <header>
        <h2 id="title">${words.title}</h2>
        <button
          class="icon"
          aria-label=${texts.app.close}
          title=${texts.app.close}
          @click=${this.#close}
        >
          ${icon.close}
        </button>
      </header>
      <div class="body">
        <div class="settings">
          ${cutSettings({
            ...{choices: this.choices, plan: this.plan, words, texts, format: this.format},
            units: this.workbench.preferences.chosen.units,
            choose: (change) => {
              this.#choose(change);
            },
          })}
        </div>
        ${this.#figure()}
      </div>
      ${this.#foot()}
    </dialog>`;
  }

  #figure(): TemplateResult {
    const {words, plan, making} = this;
    return html`<figure class=${making === 'plan' ? 'waiting' : ''}>
      ${plan ? pageMap(plan, this.choices.ink, plan.pages ? words.map : words.sheetMap) : html`<div></div>`}
      <figcaption role="status">${plan ? this.#caption(plan) : this.#why()}</figcaption>
    </figure>`;
  }

  /** Message in place of a missing plan. */
  #why(): TemplateResult | string {
    const {words} = this;
    if (this.#isUnscaled) return this.#refusal();
    if (this.#answer) return this.trouble === undefined ? words.planning : '';
    const {kind} = this.workbench.solving.state;
    return kind === 'failed' || kind === 'stale' ? words.unsolved : words.waiting;
  }

  /** Message that a print of unknown size cannot be cut. */
  #refusal(): TemplateResult {
    return html`<span class="error">${this.texts.print.unscaled}</span>
      <button
        class="outlined"
        autofocus
        @click=${() => {
          this.#close();
          wantSize(this);
        }}
      >
        ${this.words.toSize}
      </button>`;
  }

  get #isUnscaled(): boolean {
    return this.workbench.history.design?.print.unscaled === true;
  }

  #caption({pages, widthCm, heightCm}: CutPlan): TemplateResult {
    const {words} = this;
    const sheet = words.sheet(this.#extent(widthCm, heightCm));
    if (!pages) return html`<b>${sheet}</b>`;
    const {boxes, guides, widthCm: across, heightCm: up} = pages;
    const size = this.#extent(across, up);
    const soft = guides === 0 ? sheet : `${words.withGuide(guides)} · ${sheet}`;
    return html`<b>${words.pages(boxes.length + guides)}</b>, ${size}<br /><span class="soft"
        >${soft}</span
      >`;
  }

  #foot(): TemplateResult {
    const {words, making, trouble, choices} = this;
    const usual = choices.file === 'pdf' && !this.#isUnscaled ? words.atFullSize : '';
    const hint = this.isRenewed ? words.renewed : usual;
    return html`<footer>
      <p
        class=${trouble === undefined ? 'soft' : 'error'}
        role=${trouble === undefined ? 'status' : 'alert'}
      >
        ${trouble ?? (making === 'file' ? words.making : hint)}
      </p>
      <button class="outlined" @click=${this.#close}>${this.texts.app.cancel}</button>
      <button
        class="primary"
        autofocus
        ?disabled=${making === 'file' || !this.#cuttable}
        @click=${() => void this.#make()}
      >
        ${words.save(words.files[choices.file])}
      </button>
    </footer>`;
  }

  #extent(widthCm: number, heightCm: number): string {
    const {words, format} = this;
    return words.extent(format.length(widthCm), format.length(heightCm));
  }

  #choose(change: Partial<CutChoices>): void {
    this.choices = {...this.choices, ...change};
    if (this.#cuttable) void this.#lay();
  }

  get #dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector('dialog');
  }

  /** Answer that a file would be made from. */
  get #answer(): SolveResult | undefined {
    const {garment, result} = this.workbench.solving;
    return garment && result;
  }

  /** The answer, unless the print's size is unknown. */
  get #cuttable(): SolveResult | undefined {
    return this.#isUnscaled ? undefined : this.#answer;
  }

  /** Plans the current answer, and drops the plan of a previous one. */
  #follow(): void {
    const answer = this.#cuttable;
    if (answer === this.#laid) return;
    this.isRenewed ||= this.plan !== undefined;
    this.#laid = answer;
    this.plan = undefined;
    this.#life.abort();
    this.making = undefined;
    if (answer) void this.#lay();
  }

  readonly #lay = (): Promise<void> =>
    this.#doing('plan', async (signal) => {
      this.plan = await cutPlan(this.workbench, this.choices, signal);
    });

  /** Makes the file, unless a field contains an invalid length. */
  async #make(): Promise<void> {
    const fields = this.renderRoot.querySelectorAll<NumberField>('sw-number-field');
    const wrong = [...fields].find(({isWrong}) => isWrong);
    if (wrong) {
      wrong.focus();
      return;
    }
    const {choices} = this;
    await this.#doing('file', async (signal) => {
      const content = await cutFile(this.workbench, choices, signal);
      const {file} = choices;
      keepChoices(choices, this.workbench);
      this.save(file === 'svg' ? 'cut.svg' : file, new Blob([content], {type: types[file]}));
      this.#close();
    });
  }

  /** Runs a task; a new one cancels the one before. */
  async #doing(
    making: 'plan' | 'file',
    work: (signal: AbortSignal) => Promise<void>,
  ): Promise<void> {
    this.#life.abort();
    this.#life = new AbortController();
    const {signal} = this.#life;
    this.making = making;
    this.trouble = undefined;
    try {
      await work(signal);
    } catch (error) {
      if (!signal.aborted) this.trouble = this.words.failed((error as Error).message);
    } finally {
      if (this.#life.signal === signal) this.making = undefined;
    }
  }

  readonly #close = (): void => {
    this.#dialog?.close();
  };
}

/** Opens the dialog for a cutting sheet; loaded on first use. */
const tag = 'sw-cut-dialog';

/** @param save receives the file and the ending of its name */
export async function openCut(
  workbench: Workbench,
  root: HTMLElement | DocumentFragment,
  save: (ending: string, content: Blob) => void,
): Promise<void> {
  if (!customElements.get(tag)) customElements.define(tag, CutDialog);
  const words = await cutTexts(workbench.preferences.chosen.language);
  const dialog = root.querySelector<CutDialog>(tag) ?? new CutDialog();
  Object.assign(dialog, {workbench, words, save});
  if (!dialog.isConnected) root.append(dialog);
  await dialog.open();
}
