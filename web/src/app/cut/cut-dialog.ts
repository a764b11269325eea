/**
 * Dialog for a cutting sheet: format, paper and allowances, with a preview of the pages before the
 * file is made.
 */
import {html, nothing, svg, type TemplateResult} from 'lit';

import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {icon} from '../../editor/style/icons.js';
import {lengthUnit, type NumberField} from '../../editor/controls/number-field.js';
import {wantSize} from '../../editor/print/size-wanted.js';
import type {SolveResult} from '../../model/result/result.js';
import {cutTexts, type CutTexts} from '../../texts/cut-texts.js';
import {cutFileKinds, keepChoices, papers, storedChoices, type CutChoices} from './cut-choices.js';
import {cutFile, cutPlan, type CutPlan} from './cut-job.js';
import {sheetDialog} from '../../editor/style/sheet-dialog.js';
import {cutStyle} from './cut-style.js';
import {greatestAllowance} from '../../cutting/allowance-rule.js';
import {dxfStyles, dxfUnits, type DxfStyle, type DxfUnit} from '../../files/dxf/dxf-format.js';
import type {Units} from '../../model/base/length-text.js';
import {paperOf} from '../../paper/papers.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {Point} from '../../model/geometry/vectors.js';

/** Controls for the settings of a cutting sheet. */
interface Shown {
  readonly choices: CutChoices;
  /** Undefined until there is one. */
  readonly plan: CutPlan | undefined;
  readonly words: CutTexts;
  readonly texts: Texts;
  readonly format: Format;
  readonly units: Units;
  readonly choose: (change: Partial<CutChoices>) => void;
}

function filePart({choices, words, choose}: Shown): TemplateResult {
  return html`<div class="file">
    <h3 id="file">${words.file}</h3>
    <div class="files" role="group" aria-labelledby="file" aria-describedby="for">
      ${cutFileKinds.map(
        (file) =>
          html`<button
            class="outlined"
            aria-pressed=${file === choices.file}
            @click=${() => {
              choose({file});
            }}
          >
            ${words.files[file]}
          </button>`,
      )}
    </div>
    <p id="for" class="soft">${words.fileNotes[choices.file]}</p>
  </div>`;
}

/** Dialect and unit of a DXF file. */
function dxfPart({choices: {dxfStyle, dxfUnit}, words, choose}: Shown): TemplateResult {
  return html`<label>
      ${words.dxfStyle}
      <select
        @change=${({target}: Event) => {
          choose({dxfStyle: (target as HTMLSelectElement).value as DxfStyle});
        }}
      >
        ${dxfStyles.map(
          (style) =>
            html`<option value=${style} ?selected=${style === dxfStyle}>
              ${words.dxfStyles[style]}
            </option>`,
        )}
      </select>
    </label>
    <label>
      ${words.dxfUnit}
      <select
        @change=${({target}: Event) => {
          choose({dxfUnit: (target as HTMLSelectElement).value as DxfUnit});
        }}
      >
        ${dxfUnits.map(
          (unit) =>
            html`<option value=${unit} ?selected=${unit === dxfUnit}>
              ${words.dxfUnits[unit]}
            </option>`,
        )}
      </select>
    </label>`;
}

function paperPart(shown: Shown): TemplateResult {
  const {choices, words, choose} = shown;
  return html`<label>
    ${words.paper}
    <select
      @change=${({target}: Event) => {
        choose({paper: (target as HTMLSelectElement).value});
      }}
    >
      ${papers.map(
        (paper) =>
          html`<option value=${paper} ?selected=${paper === choices.paper}>
            ${called(paper, shown)}
          </option>`,
      )}
    </select>
  </label>`;
}

/** Returns the paper's name with its size, if it has one. */
function called(paper: string, {words, format}: Shown): string {
  if (paper === 'projector') return words.projector;
  const {name = '', widthCm = 0, heightCm} = paperOf(paper) ?? {};
  if (heightCm === undefined) return words.roll;
  return words.each(name, words.extent(format.length(widthCm), format.length(heightCm)));
}

function lengthPart(
  name: 'allowanceCm' | 'hemCm',
  label: (unit: string) => string,
  {choices, format, texts, units, choose}: Shown,
): TemplateResult {
  const {cm, name: unit} = lengthUnit[units];
  return html`<sw-number-field
    .label=${label(unit)}
    .value=${choices[name] / cm}
    .least=${0}
    .most=${greatestAllowance / cm}
    .step=${0.1}
    .fractions=${units === 'inch'}
    .digits=${3}
    .wrong=${texts.controls.between(format.length(0), format.length(greatestAllowance))}
    @entered=${({detail}: CustomEvent<number>) => {
      choose({[name]: detail * cm});
    }}
  ></sw-number-field>`;
}

/** Note that pieces with their own allowances ignore the fields. */
function ownPart({plan, words}: Shown): TemplateResult | typeof nothing {
  const {ownAllowances = 'none'} = plan ?? {};
  if (ownAllowances === 'none') return nothing;
  return html`<p class="soft" role="status">${words.ownAllowances[ownAllowances]}</p>`;
}

/** Checkbox for the print; cutters and plotters accept lines only. */
function inkPart({choices, words, choose}: Shown): TemplateResult | typeof nothing {
  if (choices.file === 'dxf' || choices.file === 'plt') return nothing;
  return html`<label class="inline">
    <input
      type="checkbox"
      .checked=${choices.ink === 'full'}
      @change=${({target}: Event) => {
        choose({ink: (target as HTMLInputElement).checked ? 'full' : 'outline'});
      }}
    />
    ${words.print}
  </label>`;
}

const cutSettings = (shown: Shown): TemplateResult =>
  html`${filePart(shown)} ${shown.choices.file === 'pdf' ? paperPart(shown) : nothing}
    ${shown.choices.file === 'dxf' ? dxfPart(shown) : nothing}
    <div class="lengths">
      ${lengthPart('allowanceCm', shown.words.allowance, shown)}
      ${lengthPart('hemCm', shown.words.hem, shown)} ${ownPart(shown)}
    </div>
    ${inkPart(shown)}`;

/** Preview of the layout of pages and pieces, before a file is made. */
const short = (value: number): string => String(Number(value.toFixed(1)));
const line = (points: readonly Point[]): string =>
  `M${points.map(([x, y]) => `${short(x)} ${short(-y)}`).join('L')}Z`;

/** Margin around all pages. [share of the longer side] */
const rim = 0.01;

function pageMap({widthCm, heightCm, outlines, pages}: CutPlan, label: string) {
  const boxes = pages?.boxes ?? [{low: [0, 0] as const, high: [widthCm, heightCm] as const}];
  const left = Math.min(...boxes.map(({low}) => low[0]));
  const right = Math.max(...boxes.map(({high}) => high[0]));
  const low = Math.min(...boxes.map((box) => box.low[1]));
  const high = Math.max(...boxes.map((box) => box.high[1]));
  const margin = rim * Math.max(right - left, high - low);
  const view = [left - margin, -high - margin, right - left + 2 * margin, high - low + 2 * margin];
  return html`<svg class="map" viewBox=${view.map(short).join(' ')} role="img" aria-label=${label}>
    ${boxes.map(
      (box) =>
        svg`<rect class="page" x=${short(box.low[0])} y=${short(-box.high[1])}
          width=${short(box.high[0] - box.low[0])} height=${short(box.high[1] - box.low[1])}></rect>`,
    )}
    <path class="pieces" d=${outlines.map(line).join('')}></path>
    ${boxes.length < 2 ? nothing : (pages?.boxes ?? []).map(nameOn)}
  </svg>`;
}

/** Page name in the upper left corner, at the same place as on paper. */
function nameOn({name, low, high}: NonNullable<CutPlan['pages']>['boxes'][number]): TemplateResult {
  const size = 0.22 * Math.min(high[0] - low[0], high[1] - low[1]);
  return svg`<text x=${short(low[0] + size / 2)} y=${short(-high[1] + 1.2 * size)}
    font-size=${short(size)}>${name}</text>`;
}

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
      ${plan ? pageMap(plan, plan.pages ? words.map : words.sheetMap) : html`<div></div>`}
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
    const {boxes, widthCm: across, heightCm: up} = pages;
    const size = this.#extent(across, up);
    return html`<b>${words.pages(boxes.length)}</b>, ${size}<br /><span class="soft"
        >${sheet}</span
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
