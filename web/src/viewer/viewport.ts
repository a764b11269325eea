/** The visible part of a sheet: the half of a view that needs no drawing. */
import type {Point} from '../model/geometry/vectors.js';
import {
  fitted,
  panned,
  toScreen,
  toSheet,
  zoomed,
  type ScreenSize,
  type SheetView,
} from '../scene/sheet-view.js';
import {Labels} from './labels.js';
import {OverlayChips} from './overlay-chips.js';
import type {Overlay} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import {SeamNotes} from './seam-notes.js';
import type {Appearance} from './strokes.js';

/**
 * All text over a drawing: names and letters of pieces, kinds of seams, and the words of
 * an overlay.
 */
export class Words {
  readonly #labels: Labels;
  readonly #notes = new SeamNotes();
  readonly #chips = new OverlayChips();
  #hasSeams = true;

  constructor(host: HTMLElement, appearance: Appearance) {
    this.#labels = new Labels(appearance);
    host.append(...this.#elements);
  }

  /** Shows the words of a new scene. */
  show(scene: PatternScene, appearance: Appearance): void {
    this.#labels.show(scene, appearance);
    this.#notes.show(scene, appearance);
  }

  /** Updates the words after alignments change along the same seams. */
  update(scene: PatternScene): void {
    this.#notes.update(scene);
  }

  showOverlay(
    scene: PatternScene | undefined,
    overlay: Overlay | undefined,
    look: Appearance,
  ): void {
    if (scene && overlay) this.#chips.show(scene, overlay, look);
    else this.#chips.clear();
    this.#notes.highlight(overlay?.highlight?.seam);
    this.#labels.highlight(overlay);
    // the badges stand in their place
    this.#notes.element.style.visibility = overlay?.badges ? 'hidden' : '';
  }

  /** Shows or hides all words, and those of seams among them. */
  setShown(isShown: boolean, hasSeams: boolean): void {
    this.#hasSeams = hasSeams;
    for (const element of this.#elements) {
      const isSeen = isShown && (hasSeams || element !== this.#notes.element);
      element.style.display = isSeen ? '' : 'none';
    }
  }

  /** Moves the words to a view. */
  place(view: SheetView, size: ScreenSize): void {
    this.#labels.place(view, size);
    if (this.#hasSeams) this.#notes.place(view, size);
    this.#chips.place(view, size);
  }

  dispose(): void {
    for (const element of this.#elements) element.remove();
  }

  get #elements(): readonly HTMLElement[] {
    return [this.#labels, this.#notes, this.#chips].map(({element}) => element);
  }
}

export abstract class Viewport {
  readonly #listeners = new Set<() => void>();
  #view: SheetView = {centre: [0, 0], scale: 1};
  /** The view has not moved since it was fitted, so it is fitted again when the room changes. */
  #isFitted = true;

  /** Undefined without a sheet; the view does not move then. */
  protected abstract get sheetSize(): Point | undefined;

  protected abstract get room(): ScreenSize;

  /** [CSS px per cm] */
  get scale(): number {
    return this.#view.scale;
  }

  /** Visible part of the sheet, to restore it later. */
  get state(): SheetView {
    return this.#view;
  }

  set state(view: SheetView) {
    this.#zoom(view, 1, this.#middle);
  }

  /** Shows the whole sheet. */
  fit(): void {
    if (!this.sheetSize) return;
    this.#move(fitted(this.sheetSize, this.room));
    this.#isFitted = true;
  }

  /** Zooms about a point of the screen, by default its middle. */
  zoomBy(factor: number, at: Point = this.#middle): void {
    this.#zoom(this.#view, factor, at);
  }

  /** Moves the sheet by (dx, dy). [CSS px] */
  panBy(dx: number, dy: number): void {
    if (this.sheetSize) this.#move(panned(this.#view, this.sheetSize, dx, dy));
  }

  /** Converts a point of the sheet [cm] to the host, from its upper left [CSS px]. */
  screenOf(point: Point): Point {
    return toScreen(this.#view, this.room, point);
  }

  /** Converts a point of the host, from its upper left [CSS px], to the sheet [cm]. */
  sheetPointAt(x: number, y: number): Point {
    return toSheet(this.#view, this.room, [x, y]);
  }

  /**
   * Calls `listener` after each zoom, move or change of size.
   * @returns a function that stops this
   */
  onViewChange(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  protected resized(): void {
    if (this.#isFitted) this.fit();
    else this.#move(this.#view);
  }

  get #middle(): Point {
    return [this.room.width / 2, this.room.height / 2];
  }

  #zoom(view: SheetView, factor: number, at: Point): void {
    if (this.sheetSize) this.#move(zoomed(view, this.room, this.sheetSize, factor, at));
  }

  #move(view: SheetView): void {
    this.#view = view;
    this.#isFitted = false;
    for (const listener of this.#listeners) listener();
  }
}
