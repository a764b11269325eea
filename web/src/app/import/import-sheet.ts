/** Import dialog: the contents of another program's drawing, and choices before it is opened. */
import {html, nothing, type TemplateResult} from 'lit';

import type {PieceChoice} from '../../files/to-garment.js';
import {controls} from '../../editor/style/controls.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {icon} from '../../editor/style/icons.js';
import {unitsInMetre, type FileUnit} from '../../model/garment/garment-document.js';
import type {ImportTexts} from '../../texts/import-texts.js';
import {chosenAlso, largestOf} from './choices.js';
import {sheetDialog} from '../../editor/style/sheet-dialog.js';
import {importStyle} from './import-style.js';
import {allowanceChoice, pageChoice, pagePreview, type ShownPages} from './page-choice.js';
import {pieceChoice, ruler, type ShownChoices} from './piece-choice.js';
import {scaleChoice} from './scale-choice.js';
import {drawingAgain, drawingIn, garmentFrom, type ShownDrawing} from './reading.js';
import type {Drawing, DrawingOptions} from '../../model/garment/imported-drawing.js';
import type {Format} from '../../texts/format.js';

// Choice of a size, for a drawing with several.

/** @param isWaiting true while another size is being read */
function sizeChoice(
  {sizes, sampleSize, size = sampleSize}: Drawing,
  isWaiting: boolean,
  choose: (size: string) => void,
  words: ImportTexts,
): TemplateResult | typeof nothing {
  if (sizes.length < 2) return nothing;
  return html`<section>
    <label>
      ${words.size}
      <select
        ?disabled=${isWaiting}
        @change=${({target}: Event) => {
          choose((target as HTMLSelectElement).value);
        }}
      >
        ${sizes.map(
          (one) =>
            html`<option value=${one} ?selected=${one === size}>
              ${one === sampleSize ? words.sample(one) : one}
            </option>`,
        )}
      </select>
    </label>
  </section>`;
}

/** Choice of a drawing's unit, with the size of its largest piece in each. */
const units = (Object.keys(unitsInMetre) as FileUnit[]).sort(
  (a, b) => unitsInMetre[b] - unitsInMetre[a],
);

function unitChoice(
  shown: ShownDrawing,
  unit: FileUnit,
  choose: (unit: FileUnit) => void,
  words: ImportTexts,
  format: Format,
): TemplateResult {
  const {unit: guess} = shown.drawing;
  const isGuess = unit === guess.unit;
  const isDoubtful = isGuess && !guess.isSure;
  const how = words.unitIs[isGuess ? guess.because : 'chosen'](words.units[unit]);
  return html`<section class=${isDoubtful ? 'doubtful' : nothing}>
    <h3 id="unit">${words.unit}</h3>
    <p aria-live="polite">
      ${words.largest(format.length(largestOf(shown, unit)))}, ${how}
      ${isDoubtful ? words.doubtful : nothing}
    </p>
    <div class="units" role="group" aria-labelledby="unit">
      ${units.map(
        (one) =>
          html`<button
            class="outlined"
            data-unit=${one}
            aria-pressed=${one === unit}
            @click=${() => {
              choose(one);
            }}
          >
            <b>${words.units[one]}</b>
            <small>${format.length(largestOf(shown, one))}</small>
          </button>`,
      )}
    </div>
  </section>`;
}

export type FileUse = 'drawing' | 'print';

/**
 * Opens the chosen garment.
 * @throws {Error} a message of one sentence, which the open dialog shows
 */
type Opener = (text: string, signal: AbortSignal) => Promise<void>;

export class ImportSheet extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    file: {state: true},
    shown: {state: true},
    unit: {state: true},
    choices: {state: true},
    isOuterSewn: {state: true},
    options: {state: true},
    isBusy: {state: true},
    trouble: {state: true},
  };
  static override styles = [controls, sheetDialog, importStyle];
  /** Texts in the user's language. */
  declare words: ImportTexts;
  declare protected file: File | undefined;
  /** Undefined while the dialog offers the possible uses of the file. */
  declare protected shown: ShownDrawing | undefined;
  declare protected unit: FileUnit;
  declare protected choices: readonly PieceChoice[];
  declare protected isOuterSewn: boolean;
  /** Choices of how the file is read. */
  declare protected options: DrawingOptions;
  declare protected isBusy: boolean;
  declare protected trouble: string | undefined;
  #life = new AbortController();
  #opener: Opener | undefined;
  #use: ((use: FileUse | undefined) => void) | undefined;

  constructor() {
    super();
    this.choices = [];
    this.options = {};
    this.isOuterSewn = this.isBusy = false;
  }

  /** Offers to open an ambiguous SVG as a pattern or as a print. @returns undefined for neither */
  async askUse(file: File): Promise<FileUse | undefined> {
    this.#end();
    this.file = file;
    this.shown = undefined;
    await this.#show();
    return new Promise((resolve) => {
      this.#use = resolve;
    });
  }

  /** Shows the contents of a drawing; the user may close the dialog. */
  async offer(file: File, shown: ShownDrawing, opener: Opener): Promise<void> {
    this.#end();
    this.file = file;
    this.#opener = opener;
    this.shown = shown;
    ({unit: this.unit, pieces: this.choices} = shown.first);
    this.isOuterSewn = false;
    this.options = {};
    await this.#show();
  }

  protected override render(): TemplateResult {
    const {file, shown, words} = this;
    const {app} = this.texts;
    const name = file?.name ?? '';
    return html`<dialog
      class=${shown ? '' : 'question'}
      aria-labelledby="title"
      @close=${() => {
        this.#end();
      }}
      @keydown=${(event: Event) => {
        event.stopPropagation(); // outside of the dialog, letters are keyboard shortcuts
      }}
    >
      <header>
        <h2 id="title">${shown ? words.title(name) : words.which(name)}</h2>
        <button class="icon" aria-label=${app.close} title=${app.close} @click=${this.#close}>
          ${icon.close}
        </button>
      </header>
      ${file ? (shown ? this.#drawing(shown) : this.#uses()) : nothing}
    </dialog>`;
  }

  #uses(): TemplateResult {
    const {words} = this;
    const use = (use: FileUse, title: string, note: string): TemplateResult =>
      html`<button
        class="outlined"
        ?autofocus=${use === 'drawing'}
        @click=${() => {
          this.#use?.(use);
          this.#close();
        }}
      >
        <b>${title}</b><span class="soft">${note}</span>
      </button>`;
    return html`<div class="kinds">
      ${use('drawing', words.asPattern, words.asPatternNote)}
      ${use('print', words.asPrint, words.asPrintNote)}
    </div>`;
  }

  #drawing(shown: ShownDrawing): TemplateResult {
    const {words, format} = this;
    const {drawing} = shown;
    const choosing: ShownChoices = {
      ...{shown, unit: this.unit, choices: this.choices, words, format},
      units: this.workbench.preferences.chosen.units,
      choose: (piece, change) => {
        this.choices = this.choices.map((one, k) => (k === piece ? {...one, ...change} : one));
      },
    };
    const ofPages = this.#pagesOf(shown);
    return html`<div class="body">
        <div class="settings">
          ${sizeChoice(drawing, this.isBusy, this.#readSize, words)}
          ${
            ofPages
              ? [pageChoice(ofPages), allowanceChoice(ofPages)]
              : unitChoice(
                  shown,
                  this.unit,
                  (unit) => {
                    this.unit = unit;
                  },
                  words,
                  format,
                )
          }
          ${scaleChoice({
            ...{drawing, words, options: this.options, isBusy: this.isBusy, texts: this.texts},
            choose: this.#readScale,
          })}
          ${this.#lines(shown)} ${this.#notes(shown)}
        </div>
        <div class="pieces">
          ${ofPages ? pagePreview(ofPages) : nothing} ${pieceChoice(choosing)} ${ruler(choosing)}
        </div>
      </div>
      ${this.#foot()}`;
  }

  #pagesOf(shown: ShownDrawing): ShownPages | undefined {
    const {pages} = shown.drawing;
    if (!pages) return undefined;
    const {options, words, texts, format} = this;
    const {units} = this.workbench.preferences.chosen;
    const choose = (change: DrawingOptions): void => {
      const {places, ...others} = options;
      const isOrdered = change.pages !== undefined || change.grid !== undefined;
      this.#readAgain({...others, ...(places && !isOrdered && {places}), ...change});
    };
    return {shown, pages, options, units, words, texts, format, choose};
  }

  /** Needed only if a piece has both a cutting and a sewing line. */
  #lines({drawing}: ShownDrawing): TemplateResult | typeof nothing {
    if (!drawing.pieces.some(({cut}) => cut)) return nothing;
    const {words} = this;
    return html`<section>
      <h3>${words.lines}</h3>
      <label class="inline">
        <input
          type="checkbox"
          .checked=${!this.isOuterSewn}
          aria-describedby="lines"
          @change=${({target}: Event) => {
            this.isOuterSewn = !(target as HTMLInputElement).checked;
          }}
        />
        ${words.outerIsCut}
      </label>
      <p id="lines" class="soft">${words.outerIsCutNote}</p>
    </section>`;
  }

  #notes({drawing, first}: ShownDrawing): TemplateResult | typeof nothing {
    const {words} = this;
    const {program} = drawing;
    const notes = [...drawing.notes, ...first.notes];
    if (notes.length === 0 && program === undefined) return nothing;
    return html`<section>
      <h3>${words.notes}</h3>
      <ul class="notes">
        ${program === undefined ? nothing : html`<li>${words.program(program)}</li>`}
        ${notes.map((note) => html`<li>${note}</li>`)}
      </ul>
    </section>`;
  }

  #foot(): TemplateResult {
    const {words, choices, isBusy, trouble} = this;
    const taken = choices.filter(({take}) => take).length;
    return html`<footer>
      <p
        class=${trouble === undefined ? 'soft' : 'error'}
        role=${trouble === undefined ? 'status' : 'alert'}
      >
        ${trouble ?? words.taken(taken, choices.length)}
      </p>
      <button class="outlined" @click=${this.#close}>${this.texts.app.cancel}</button>
      <button
        class="primary"
        autofocus
        ?disabled=${isBusy || taken === 0}
        @click=${() => void this.#busy(this.#open)}
      >
        ${words.open}
      </button>
    </footer>`;
  }

  /** Reads the file, or puts the pages of a PDF together, with other options. */
  #readAgain(options: DrawingOptions): void {
    const isOtherDensity = options.pixelsPerInch !== this.options.pixelsPerInch;
    this.options = options;
    void this.#busy(async (signal) => {
      const {file, shown, choices} = this;
      if (!file || !shown) return;
      const read = shown.opened
        ? await drawingAgain(shown.opened, file.name, options, signal)
        : await drawingIn(file, signal, options);
      if (this.options !== options) return;
      this.choices = chosenAlso(read, shown, choices);
      if (isOtherDensity) this.unit = read.first.unit;
      this.shown = read;
    });
  }

  readonly #readSize = (size: string): void => {
    this.#readAgain({...this.options, size});
  };

  readonly #readScale = (change: DrawingOptions): void => {
    const {pixelsPerInch, ...others} = this.options;
    const isScale = change.scale !== undefined;
    const density = isScale && pixelsPerInch !== undefined ? {pixelsPerInch} : {};
    this.#readAgain({...others, ...density, ...change});
  };

  readonly #open = async (signal: AbortSignal): Promise<void> => {
    const {shown, unit, choices: pieces, isOuterSewn} = this;
    if (!shown) return;
    const {drawing} = shown;
    const choices = {unit, pieces};
    const text = await garmentFrom({drawing, choices, isOuterSewn}, signal);
    await this.#opener?.(text, signal);
    this.#close();
  };

  /** Runs a task; an error keeps all choices. */
  async #busy(work: (signal: AbortSignal) => Promise<void>): Promise<void> {
    const {signal} = this.#life;
    this.isBusy = true;
    this.trouble = undefined;
    try {
      await work(signal);
    } catch (error) {
      if (signal.aborted) return;
      this.trouble = (error as Error).message;
    } finally {
      if (!signal.aborted) this.isBusy = false;
    }
  }

  async #show(): Promise<void> {
    await this.updateComplete;
    const dialog = this.renderRoot.querySelector('dialog');
    if (dialog && !dialog.open) dialog.showModal();
  }

  readonly #close = (): void => {
    this.renderRoot.querySelector('dialog')?.close();
  };

  /** Cancels the work on the current file. */
  #end(): void {
    this.#life.abort();
    this.#life = new AbortController();
    this.#use?.(undefined);
    this.#use = this.#opener = this.file = this.shown = this.trouble = undefined;
    this.isBusy = false;
  }
}
