/** The sheet on display. */
import {Observable} from './observable.js';
import type {Scenes} from './scenes.js';
import type {SheetWindow} from './state.js';

export class ShownSheet extends Observable {
  /**
   * Window of the sheet, set by the code that draws it. Each step stores its view, and undo
   * restores it.
   */
  view: SheetWindow | undefined;
  #scenes: Scenes | undefined;

  /** Sheets of the pattern on display, for all other views of the same garment. */
  get scenes(): Scenes | undefined {
    return this.#scenes;
  }

  set scenes(scenes: Scenes | undefined) {
    if (scenes?.now === this.#scenes?.now && scenes?.before === this.#scenes?.before) return;
    this.#scenes = scenes;
    this.changed();
  }
}
