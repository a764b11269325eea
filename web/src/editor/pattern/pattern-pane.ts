/** The pattern: drawing, tools and overlay, and a list for screen readers. */
import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import {edgeOptions, emptyNote, noteStyle, stateNote, undrawableNote} from './state-note.js';
import {SheetIndex, type PickIndex} from '../../clicks/pick-index.js';
import type {Target as Picked} from '../../clicks/pick.js';
import {movementOf} from '../../viewer/movement.js';
import type {PatternView, PatternViewOptions} from '../../viewer/pattern-view.js';
import type {WorkbenchElement} from '../base/workbench-element.js';
import {pieceRows, seamRows, seamText, type PieceRow} from '../../workbench/lists/rows.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {lastOf} from '../../model/base/last-of.js';
import type {Target, Workbench} from '../../workbench/workbench.js';
import {BeforeAfter} from './before-after.js';
import {PatternDrawing} from './drawing.js';
import {overlayOf, type LensCursor} from '../../workbench/tools/pattern-marks.js';
import {patternKeys} from '../../commands/pattern-keys.js';
import {paneStyle} from './pane-style.js';
import {PatternTools, pointedAt} from '../../workbench/tools/pattern-tools.js';
import {Pointing} from './pointing.js';
import type {ZoomMenu} from './zoom-menu.js';
import {readingOrder, seamsRound} from '../../clicks/walk.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';

/** The pattern as a list for screen readers: every piece, followed by its seams. */
const optionId = (target: Target): string =>
  target.kind === 'piece' ? `piece-${target.piece}` : `seam-${target.seam}-${target.side}`;

function patternOptions(
  workbench: Workbench,
  index: PickIndex,
  texts: Texts,
  format: Format,
): TemplateResult {
  const pieces = pieceRows(workbench);
  const seams = seamRows(workbench, texts);
  const {pattern} = texts;
  const selected = workbench.selection.selected && optionId(workbench.selection.selected);
  const option = (target: Target, text: string): TemplateResult => {
    const id = optionId(target);
    return html`<div role="option" id=${id} aria-selected=${id === selected}>${text}</div>`;
  };
  return html`<div role="listbox" class="hidden" id="options" aria-label=${pattern.contents}>
    ${readingOrder(index).map((piece) => {
      const row = pieces[piece];
      if (!row) return undefined;
      return [
        option({kind: 'piece', piece}, pieceText(row, texts)),
        ...seamsRound(index, piece).map(({seam, side}) => {
          const words = seams[seam];
          return words && option({kind: 'seam', seam, side}, seamText(words, texts, format));
        }),
      ];
    })}
  </div>`;
}

/** "Front, 6 seams, pinned" */
function pieceText({label, seams, pinned, kept}: PieceRow, {pattern, lists, keep}: Texts): string {
  const states = [
    ...(pinned ? [lists.pinned] : []),
    ...(kept === 'none' ? [] : [kept === 'all' ? keep.kept : keep.some]),
  ];
  return [pattern.piece(label, pattern.seams(seams)), ...states].join(', ');
}

export class PatternPane extends PatternDrawing {
  static override properties = {
    ...PatternDrawing.properties,
    purpose: {reflect: true},
    sews: {type: Boolean, reflect: true},
  };
  static override styles = [...PatternDrawing.styles, controls, paneStyle, noteStyle];
  /** `place`: the user can only move the print. */
  declare purpose: 'edit' | 'place';
  /** Reflected for the layout, which changes for the tools that edit the garment. */
  declare sews: boolean;

  readonly beforeAfter = new BeforeAfter(() => {
    this.requestUpdate();
  });
  readonly #index = new SheetIndex();
  readonly #movementOf = lastOf(movementOf);
  #tools: PatternTools | undefined;
  #pointing: Pointing | undefined;
  #showsMovement = false;
  #isBare = false;
  /** Number of the last work that was checked for seams. */
  #welcomed: number | undefined;
  #cursor: LensCursor | undefined;

  constructor() {
    super();
    this.purpose = 'edit';
    this.sews = false;
  }

  get tools(): PatternTools {
    return (this.#tools ??= new PatternTools(
      this.workbench,
      () => {
        this.requestUpdate();
        for (const part of this.renderRoot.querySelectorAll<WorkbenchElement>(
          'sw-toolbar, sw-tool-hint',
        ))
          part.requestUpdate();
      },
      this.purpose,
    ));
  }

  /** Position of the lens cursor, displayed on both pieces. */
  set cursor(cursor: LensCursor | undefined) {
    this.#cursor = cursor;
    this.requestUpdate();
  }

  /** Shows the fabric alone, or all marks over it again. */
  toggleBare(): void {
    this.#isBare = !this.#isBare;
    this.requestUpdate();
  }

  /** Shows or hides the change of each outline. */
  toggleMovement(): void {
    this.#showsMovement = !this.#showsMovement;
    this.requestUpdate();
  }

  /** Opens the menu of zoom factors. */
  openZoom(): void {
    this.renderRoot.querySelector<ZoomMenu>('sw-zoom')?.open();
  }

  protected override hasSeams(): boolean {
    return this.purpose === 'edit';
  }

  protected override viewOptions(): PatternViewOptions {
    return {
      leavesWheel: this.purpose === 'place',
      onPress: (event, at) => this.#pointing?.press(event, at) ?? false,
    };
  }

  protected override opened(stage: HTMLElement, signal: AbortSignal): void {
    this.#pointing = new Pointing(this, stage, signal);
    stage.tabIndex = -1; // the whole pattern has the focus
  }

  /** Starts the sewing tool for a garment without seams. */
  #welcome(): void {
    const {beginnings} = this.workbench.history;
    const {garment} = this.workbench.solving;
    if (!garment || beginnings === this.#welcomed || this.purpose !== 'edit') return;
    this.#welcomed = beginnings;
    if (garment.seams.length > 0) return;
    void this.updateComplete.then(() => {
      this.dispatchEvent(new Event('sw-sew-wanted', {bubbles: true, composed: true}));
    });
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    this.#welcome();
    this.sews = this.tools.isEditing;
  }

  protected override drew(view: PatternView): void {
    const {workbench} = this;
    const {scenes} = workbench.sheet;
    if (!scenes) return;
    const split = this.beforeAfter.shown;
    view.setWipe(split === undefined ? undefined : {before: scenes.before, split});
    view.setBare(this.#isBare);
    view.setMovement(
      this.#showsMovement && workbench.solving.result
        ? this.#movementOf(workbench.solving.result.pieces)
        : undefined,
    );
    view.setOverlay(
      overlayOf(workbench, scenes.now, this.tools, this.#cursor, this.texts, this.format),
    );
  }

  /** Focuses the pattern, so that its keys work. */
  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector<HTMLElement>('.application')?.focus(options);
  }

  /**
   * Sends letters and digits to a tool for edges while a button has the focus; Enter and space still
   * press the button.
   */
  sewByKey(event: KeyboardEvent): void {
    if (this.tools.editing && /^[^ ]$/.test(event.key)) patternKeys(this, event);
  }

  get index(): PickIndex | undefined {
    const {scenes} = this.workbench.sheet;
    return scenes && this.#index.of(scenes.now);
  }

  protected override render(): TemplateResult {
    const {pattern} = this.texts;
    const {workbench, index} = this;
    const empty = workbench.solving.state.kind === 'empty';
    const places = this.purpose === 'place';
    return html`
      ${empty ? emptyNote(this.texts) : nothing}
      ${
        empty || places
          ? nothing
          : html`<sw-toolbar .workbench=${workbench} .tools=${this.tools}></sw-toolbar>`
      }
      <div
        class="application"
        role="application"
        aria-label=${pattern.label}
        aria-description=${pattern.description}
        aria-activedescendant=${this.#activeId ?? nothing}
        aria-owns="options"
        tabindex="0"
        @keydown=${(event: KeyboardEvent) => {
          patternKeys(this, event);
        }}
        @keyup=${(event: KeyboardEvent) => {
          if (event.key.toLowerCase() === 'w') this.beforeAfter.isHeld = false;
        }}
      >
        <div class="stage"></div>
      </div>
      ${index ? this.#options(index) : nothing} ${this.#note()}
      <slot name="notice"></slot>
      ${this.#menu()}
      ${
        this.beforeAfter.split === undefined
          ? nothing
          : html`<sw-wipe-handle
              .workbench=${workbench}
              .split=${this.beforeAfter.split}
              @input=${(event: CustomEvent<number>) => {
                this.beforeAfter.split = event.detail;
              }}
            ></sw-wipe-handle>`
      }
      <div class="foot" ?hidden=${empty}>
        ${
          this.tools.active
            ? html`<sw-tool-hint
                .workbench=${workbench}
                .tools=${this.tools}
                @click=${() => {
                  this.focus();
                }}
              ></sw-tool-hint>`
            : html`<div class="said">
                <sw-legend .workbench=${workbench}></sw-legend>
              </div>`
        }
        <div class="group view" role="group" aria-label=${pattern.view}>
          ${places || this.tools.editing ? nothing : this.#comparing()}
          ${this.#button(pattern.zoomOut, icon.minus, () => this.view?.zoomBy(1 / 1.4), 'zoom')}
          ${this.#button(pattern.fit, icon.fit, () => this.view?.fit(), places ? '' : 'zoom')}
          ${this.#button(pattern.zoomIn, icon.plus, () => this.view?.zoomBy(1.4), 'zoom')}
          ${places ? nothing : html`<sw-zoom .workbench=${workbench} .view=${this.view}></sw-zoom>`}
        </div>
        ${this.#bar()}
      </div>
    `;
  }

  /** Id of the part that keys act on. */
  get #activeId(): string | undefined {
    const {selected} = this.workbench.selection;
    const {sewing} = this.tools;
    return sewing ? sewing.activeId : selected && optionId(selected);
  }

  /** Pieces and seams as text, or edges while the sewing tool is active. */
  #options(index: PickIndex): TemplateResult {
    const {pattern} = this.texts;
    const {sewing} = this.tools;
    return sewing
      ? edgeOptions(sewing, pattern.contents)
      : patternOptions(this.workbench, index, this.texts, this.format);
  }

  /** Actions of the tool for seams, or of the one for folds. */
  #bar(): TemplateResult | typeof nothing {
    const {workbench} = this;
    const {sewing, folding} = this.tools;
    if (folding)
      return html`<sw-fold-bar
        class="bar"
        .workbench=${workbench}
        .tool=${folding}
        .state=${folding.chooser.state}
      ></sw-fold-bar>`;
    return sewing
      ? html`<sw-sew-bar
          class="bar"
          .workbench=${workbench}
          .chooser=${sewing.chooser}
          .state=${sewing.chooser.state}
        ></sw-sew-bar>`
      : nothing;
  }

  #comparing(): TemplateResult {
    const {pattern} = this.texts;
    return html`<sw-before
        .workbench=${this.workbench}
        .isOn=${this.beforeAfter.isHeld}
        @hold=${({detail}: CustomEvent<boolean>) => {
          this.beforeAfter.isHeld = detail;
        }}
      ></sw-before>
      ${this.#toggle(pattern.wipe, icon.wipe, this.beforeAfter.split !== undefined, () => {
        this.beforeAfter.toggle();
      })}
      ${this.#toggle(pattern.clothOnly, icon.cloth, this.#isBare, () => {
        this.toggleBare();
      })}
      ${this.#toggle(pattern.movement, icon.movement, this.#showsMovement, () => {
        this.toggleMovement();
      })}`;
  }

  #note(): TemplateResult | typeof nothing {
    if (this.undrawable !== undefined) return undrawableNote(this.undrawable);
    const {garment, state} = this.workbench.solving;
    if (this.tools.active === 'sew' && garment?.seams.length === 0 && state.kind === 'done')
      return nothing; // the tool shows instructions
    return stateNote(this.workbench, this.texts, () => {
      const {result} = this.workbench.solving;
      const {scenes} = this.workbench.sheet;
      if (!this.#showsMovement || !result) return undefined;
      const {factor, greatest} = this.#movementOf(result.pieces);
      const label = scenes?.now.pieces[greatest.piece]?.label ?? '';
      const {movementNote} = this.texts.pattern;
      return movementNote(String(factor), this.format.fine(greatest.cm), label);
    });
  }

  #menu(): TemplateResult | typeof nothing {
    const {workbench} = this;
    const pointing = this.#pointing;
    const ties = pointing?.ties;
    if (!pointing || !ties) return nothing;
    const rows = seamRows(workbench, this.texts);
    const choices = ties.targets.map((target) => ({
      text: tiedText(workbench, target, rows, this.texts.pattern.edge),
      choose: () => {
        pointing.take(target);
      },
      point: () => {
        workbench.selection.point(pointedAt(target));
      },
    }));
    return html`<sw-ties-menu
      .at=${ties.at}
      .choices=${choices}
      .label=${this.texts.pattern.which}
      @close=${() => {
        pointing.forgetTies();
      }}
    ></sw-ties-menu>`;
  }

  #button(label: string, picture: TemplateResult, act: () => void, kind = ''): TemplateResult {
    return html`<button class=${kind} aria-label=${label} title=${label} @click=${act}>
      ${picture}
    </button>`;
  }

  #toggle(label: string, picture: TemplateResult, on: boolean, act: () => void): TemplateResult {
    return html`<button aria-label=${label} title=${label} aria-pressed=${on} @click=${act}>
      ${picture}
    </button>`;
  }
}

/** "Side seam, left, on Front" */
function tiedText(
  {sheet: {scenes}}: Workbench,
  target: Picked,
  rows: ReturnType<typeof seamRows>,
  edge: string,
): string {
  const piece = scenes?.now.pieces[target.piece]?.label ?? '';
  return `${target.kind === 'seam' ? (rows[target.seam]?.name ?? '') : edge}, ${piece}`;
}
