/**
 * All text over a drawing: names and letters of pieces, ranks and kinds of seams, and the words of
 * an overlay.
 */
import {Labels} from './labels.js';
import {OverlayChips} from './overlay-chips.js';
import type {Overlay} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import {SeamNotes} from './seam-notes.js';
import type {ScreenSize, SheetView} from '../scene/sheet-view.js';
import type {Appearance} from './strokes.js';

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
  update(scene: PatternScene, appearance: Appearance): void {
    this.#notes.update(scene, appearance);
  }

  showOverlay(
    scene: PatternScene | undefined,
    overlay: Overlay | undefined,
    look: Appearance,
  ): void {
    if (scene && overlay) this.#chips.show(scene, overlay, look);
    else this.#chips.clear();
    this.#notes.highlight(overlay?.highlight?.seam);
    // the badges' numbers could be mistaken for ranks
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

  /** Moves the words to a view; numbers belong to the scene to the right of `split`. [CSS px] */
  place(view: SheetView, size: ScreenSize, split: number): void {
    const taken = this.#labels.place(view, size);
    const left = {left: 0, top: 0, right: split, bottom: size.height};
    if (this.#hasSeams) this.#notes.place(view, size, [...taken, left]);
    this.#chips.place(view, size);
  }

  dispose(): void {
    for (const element of this.#elements) element.remove();
  }

  get #elements(): readonly HTMLElement[] {
    return [this.#labels, this.#notes, this.#chips].map(({element}) => element);
  }
}
