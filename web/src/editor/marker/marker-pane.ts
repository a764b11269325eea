/** The fabric layout: pieces of the result on the fabric as a drawing and a list, with tools. */
import {html, nothing, type TemplateResult} from 'lit';

import {usedLength} from '../../marker/places.js';
import type {Point} from '../../model/geometry/vectors.js';
import {lastOf} from '../../model/base/last-of.js';
import {spokenFailure} from '../../workbench/spoken-failure.js';
import {commandFor, type Command, type KeyList} from '../../commands/editor-command.js';
import {wantSize} from '../print/size-wanted.js';
import {controls} from '../style/controls.js';
import {markerBar, markerZoom} from './marker-bar.js';
import {markerCommands, markerKeys} from '../../commands/marker-commands.js';
import {emptyStyle, markerEmpty} from './marker-empty.js';
import {FlawActions} from './flaw-actions.js';
import {ways} from '../../workbench/marker/marker-moves.js';
import {markerFiles} from '../../workbench/marker/marker-files.js';
import {MarkerPointing, type PointedFabric} from './marker-pointing.js';
import {markerSheet, sheetStyle} from './marker-sheet.js';
import type {Dragged} from '../../workbench/marker/piece-drag.js';
import {markerStatus, spokenStatus} from './marker-status.js';
import {markerStyle} from './marker-style.js';
import {
  conflicts,
  conflictWords,
  lyingWords,
  roundedLength,
} from '../../workbench/marker/marker-words.js';
import {layStepWords} from '../../workbench/marker/lay-step.js';
import {margin, offSheet, type SheetFrame} from '../../marker/sheet-frame.js';

// Scrolls a part of the fabric into view.

/** Distance from the part to the edges of the view. [CSS px] */
const apart = 8;

/**
 * Returns the distance by which `low` to `high` misses a view `from` to `to`; 0 for a part that
 * fills the view.
 */
export function missed(low: number, high: number, from: number, to: number): number {
  const [before, after] = [low - from, high - to];
  if (before * after <= 0) return 0; // inside, or beyond both edges
  return Math.abs(before) < Math.abs(after) ? before : after;
}

/** Scrolls no further than needed. */
function scrollTo(view: Element, shown: Element): void {
  const [{left, right, top, bottom}, seen] = [view, shown].map((one) =>
    one.getBoundingClientRect(),
  ) as [DOMRect, DOMRect];
  view.scrollBy({
    left: missed(seen.left - apart, seen.right + apart, left, right),
    top: missed(seen.top - apart, seen.bottom + apart, top, bottom),
    behavior: 'instant',
  });
}

/**
 * Returns the middle of the visible fabric in a view that scrolls.
 * @param sheet drawing of the fabric
 */
function middleInSight(view: Element, sheet: SVGSVGElement, widthCm: number): Point | undefined {
  const matrix = sheet.getScreenCTM();
  if (!matrix) return undefined;
  const [seen, all] = [view, sheet].map((one) => one.getBoundingClientRect()) as [DOMRect, DOMRect];
  const x = (Math.max(seen.left, all.left) + Math.min(seen.right, all.right)) / 2;
  const y = (Math.max(seen.top, all.top) + Math.min(seen.bottom, all.bottom)) / 2;
  const [across, along] = offSheet(new DOMPoint(x, y).matrixTransform(matrix.inverse()));
  return [Math.min(widthCm, Math.max(0, across)), Math.max(0, along)];
}

const zooms = {least: 1, most: 12} as const;
/** Length of fabric displayed beyond the used length. [cm] */
const beyond = 14;
/** Least used length in the drawing. [cm] */
const leastLength = 50;
/** Least scale of long fabric, as a share of the scale at which the width fills the view. */
const leastShare = 0.6;
export class MarkerPane extends FlawActions {
  static override styles = [controls, markerStyle, sheetStyle, emptyStyle];
  readonly #conflictsOf = lastOf(conflicts);
  readonly #pointing = new MarkerPointing(this);
  #observer: ResizeObserver | undefined;
  #end: (() => void) | undefined;
  /** Size of the drawing's container. [CSS px] */
  #room: Point = [0, 0];
  #zoom = 1;
  #isAtStart = false;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#observer = new ResizeObserver(([entry]) => {
      const {width = 0, height = 0} = entry?.contentRect ?? {};
      this.#room = [width, height];
      this.requestUpdate();
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#observer?.disconnect();
    this.#end?.();
    this.#end = undefined;
    this.#pointing.cancel();
  }

  /** Commands, with the keys that work while the pane has the focus. */
  get commands(): readonly Command[] {
    return markerCommands(this, this.texts, this.words);
  }

  /** All keys of the pane. */
  get keys(): KeyList {
    return markerKeys(this, this.texts, this.words);
  }

  /** Files to save at present; none while a piece has a conflict. */
  get files(): ReturnType<typeof markerFiles> {
    const {words, workbench} = this;
    const {plan, print} = this.layouts;
    const isGood = plan?.placements.length && print && this.isReady && this.#conflicts.size === 0;
    const {garments} = this.layouts;
    return isGood ? markerFiles(plan, {words, workbench, print, garments}) : [];
  }

  /** Name of the step that undo reverts here. */
  get undoWords(): string | undefined {
    const {past = [], present} = this.layouts.history ?? {};
    return layStepWords(past.at(-1), present, this.words);
  }

  get redoWords(): string | undefined {
    const {future = [], present} = this.layouts.history ?? {};
    return layStepWords(present, future[0], this.words);
  }

  /** @returns true if there was a step to undo */
  undo(): boolean {
    this.#pointing.cancel();
    this.say(''); // the message may no longer be true
    return this.layouts.undo();
  }

  redo(): boolean {
    this.say('');
    return this.layouts.redo();
  }

  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector<HTMLElement>('.application')?.focus(options);
  }

  zoomBy(factor: number): void {
    this.#zoom = Math.min(zooms.most, Math.max(zooms.least, this.#zoom * factor));
    this.requestUpdate();
  }

  fit(): void {
    this.#zoom = 1;
    this.#isAtStart = false;
    this.requestUpdate();
  }

  toggleFlawTool(): void {
    if (this.canMark) this.#pointing.toggleFlawTool();
  }

  protected override get middle(): Point | undefined {
    const {renderRoot, layouts} = this;
    const [view, sheet] = [
      renderRoot.querySelector('.application'),
      renderRoot.querySelector<SVGSVGElement>('.sheet'),
    ];
    return view && sheet && layouts.bolt
      ? middleInSight(view, sheet, layouts.bolt.widthCm)
      : undefined;
  }

  get isMarking(): boolean {
    return this.#pointing.isMarking;
  }

  /** The displayed state, for pointer events. */
  get shown(): PointedFabric['shown'] {
    const {pieces, bolt} = this.layouts;
    return {pieces, bolt, frame: bolt && this.#frame(bolt.widthCm, usedLength(pieces))};
  }

  /** Starts packing once the pane is visible, and scrolls to the cut edge first. */
  protected override updated(): void {
    if (this.isConnected) this.#end ??= this.layouts.show();
    const application = this.renderRoot.querySelector('.application');
    if (application) this.#observer?.observe(application);
    if (!application || !this.renderRoot.querySelector('.sheet')) return;
    if (!this.#isAtStart) application.scrollTop = application.scrollHeight;
    this.#isAtStart = true;
    const piece = this.renderRoot.querySelector('.piece.selected .line');
    if (this.toBeSeen && piece) scrollTo(application, piece);
    if (this.toBeSeen === 'on page') application.scrollIntoView({block: 'nearest'});
    this.toBeSeen = undefined;
  }

  protected override render(): TemplateResult {
    const {layouts, words} = this;
    const {state} = layouts;
    return html`<div class="pane" data-state=${state.kind}>
      ${markerBar(this, words)}
      <div
        class="application"
        role="application"
        aria-label=${words.label}
        aria-description=${words.description}
        tabindex="0"
        @keydown=${this.#press}
      >
        <div
          class="stage ${layouts.isStale ? 'stale' : ''} ${this.isMarking ? 'marking' : ''}"
          @pointerdown=${this.#pointing.press}
          @pointermove=${this.#pointing.move}
          @pointerup=${this.#pointing.release}
          @pointercancel=${this.#pointing.cancel}
          @pointerleave=${this.#pointing.leave}
          @dblclick=${this.#pointing.closeFlaw}
        >
          ${this.#sheet()}
        </div>
      </div>
      <slot name="notice"></slot>
      <div class="foot">
        <div class="said">${markerStatus(this.#status)}</div>
        ${markerZoom(this, this.texts)}
      </div>
      <progress
        aria-hidden="true"
        max="1"
        ?hidden=${state.kind !== 'laying'}
        .value=${state.kind === 'laying' ? state.fraction : 0}
      ></progress>
      <sw-marker-panel
        .workbench=${this.workbench}
        .selected=${this.selected}
        .conflicts=${this.#conflicts}
        .actions=${this}
        .chosenFlaw=${this.chosenFlaw}
        @sw-piece-chosen=${({detail}: CustomEvent<number>) => {
          this.choose(detail);
          this.toBeSeen = 'on fabric';
        }}
        @keydown=${this.#pressInList}
      ></sw-marker-panel>
      <p class="hidden" role="status">${spokenStatus(this.#status)}</p>
    </div>`;
  }

  get #conflicts(): ReadonlyMap<number, string> {
    const {pieces, bolt, isMoved} = this.layouts;
    // packed pieces have no conflicts
    return bolt && isMoved ? this.#conflictsOf(pieces, bolt, this.labelOf, this.words) : new Map();
  }

  /** The largest scale that fits into the view, times the user's zoom. */
  #frame(widthCm: number, usedCm: number): SheetFrame {
    const [width, height] = this.#room;
    const lengthCm = Math.max(usedCm, leastLength) + beyond;
    const across = (width - margin.left - margin.right) / widthCm;
    const along = (height - margin.top - margin.bottom) / lengthCm;
    const scale = Math.max(Math.min(across, along), leastShare * across, 1);
    return {widthCm, lengthCm, scale: scale * this.#zoom};
  }

  #sheet(): TemplateResult | typeof nothing {
    const {layouts, words} = this;
    const {bolt, pieces, step, print} = layouts;
    if (!bolt || !step || !print) return markerEmpty(words.empty);
    if (this.#room[0] === 0) return nothing;
    const usedCm = usedLength(pieces);
    const {units} = this.workbench.preferences.chosen;
    const frame = this.#pointing.frame ?? this.#frame(bolt.widthCm, usedCm);
    return markerSheet({
      ...{frame, bolt, image: print.image, usedCm, pieces, words, units},
      isOfSeveral: layouts.garments.length > 1,
      usedWords: roundedLength(usedCm, units, this.format),
      label: this.labelOf,
      pins: step.pins,
      selected: this.selected,
      pointed: this.numberOf(this.workbench.selection.pointed),
      bad: new Set(this.#conflicts.keys()),
      dragged: this.#pointing.dragged,
      chosenFlaw: this.chosenFlaw,
      draft: this.#pointing.draft,
    });
  }

  #inWay({piece, inWay}: Dragged): string | undefined {
    return conflictWords(piece, inWay, this.layouts.pieces, this.labelOf, this.words);
  }

  /** Place of the selected piece in words; during a drag, the place that it would take. */
  get #placeOfSelected(): string | undefined {
    const {bolt} = this.layouts;
    const {dragged} = this.#pointing;
    const piece = dragged ? {...dragged.piece, place: dragged.place} : this.selectedPiece;
    if (!piece || !bolt) return undefined;
    const place = lyingWords(piece, bolt, this.words, this.format);
    const pinned = this.chosen?.isPinned ? `, ${this.words.pinned}` : '';
    const went = dragged || this.went === '' ? '' : ` (${this.went})`;
    return `${this.labelOf(piece)}: ${place}${pinned}${went}`;
  }

  get #status(): Parameters<typeof markerStatus>[0] {
    const {layouts, words, format} = this;
    const {state} = layouts;
    const {dragged} = this.#pointing;
    const conflicts = this.#conflicts;
    const own = this.selected === undefined ? undefined : conflicts.get(this.selected);
    const why =
      state.kind === 'failed' ? spokenFailure(state.failure, this.workbench, this.texts) : '';
    return {
      ...{layouts, words, format, why, said: this.said, told: this.told},
      unaligned:
        this.workbench.solving.state.kind === 'failed' ? this.texts.progress.failed : undefined,
      isMarking: this.isMarking,
      isDragging: dragged !== undefined,
      toSize: this.#toSize,
      ...{conflict: dragged ? this.#inWay(dragged) : (own ?? [...conflicts.values()][0])},
      place: this.#placeOfSelected,
    };
  }

  readonly #toSize = (): void => {
    wantSize(this);
  };

  /** Keys also work in the list of pieces, except the keys that press its buttons. */
  readonly #pressInList = (event: KeyboardEvent): void => {
    const [target] = event.composedPath();
    const isField = target instanceof HTMLInputElement || target instanceof HTMLSelectElement;
    if (!isField && !['Enter', ' '].includes(event.key)) this.#press(event);
  };

  readonly #press = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey) return;
    if (!this.#handled(event)) return;
    event.preventDefault();
    event.stopPropagation();
  };

  #handled(event: KeyboardEvent): boolean {
    const {key, altKey, shiftKey} = event;
    if (this.pressForFlaw(event)) return true;
    const way = ways[key];
    if (way) return this.nudge(way, altKey);
    if (key === 'Escape') return this.#pointing.cancel() || this.letGo();
    if (key === 'Enter' && this.isMarking) {
      this.#pointing.closeFlaw();
      return true;
    }
    if (altKey) {
      if (key.toUpperCase() !== 'R') return false;
      this.turn(true);
      return true;
    }
    const command = commandFor(
      this.commands,
      shiftKey && /^[nx]$/i.test(key) ? `Shift ${key.toUpperCase()}` : key,
    );
    command?.run();
    return command !== undefined;
  }
}
