/** The sheet as somebody looks at it. */
import {Observable} from './observable.js';
import type {Scenes} from './scenes.js';
import type {SheetWindow} from './state.js';

export class ShownSheet extends Observable {
  /** Asked for the view when a step is taken, and told when one is to be restored; whoever draws it sets it. */
  view: SheetWindow | undefined;
  #scenes: Scenes | undefined;

  /** The sheets that the pattern shows, for everything beside it that speaks of the same. */
  get scenes(): Scenes | undefined {
    return this.#scenes;
  }

  set scenes(scenes: Scenes | undefined) {
    if (scenes?.now === this.#scenes?.now && scenes?.before === this.#scenes?.before) return;
    this.#scenes = scenes;
    this.changed();
  }
}
