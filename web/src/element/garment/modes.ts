/** Loads the code behind the modes and views on first use. */
import {loadDrape} from '../../editor/load-later-parts.js';
import type {GarmentMode, GarmentView} from './attributes.js';

export class Modes {
  readonly #loaded = new Set<GarmentMode>(['preview']);
  readonly #changed: () => void;
  readonly #failed: (error: unknown) => void;
  #asked: GarmentMode = 'preview';

  constructor(changed: () => void, failed: (error: unknown) => void) {
    this.#changed = changed;
    this.#failed = failed;
  }

  /** Returns the mode to show: the preview until a mode's code is loaded. */
  shown(mode: GarmentMode): GarmentMode {
    return this.#loaded.has(mode) ? mode : 'preview';
  }

  load(mode: GarmentMode, view: GarmentView): void {
    void this.#load(mode);
    if (view !== 'pattern') loadDrape().catch(this.#failed);
  }

  /** Loads once; a failed import is repeated only after another mode was selected. */
  async #load(mode: GarmentMode): Promise<void> {
    if (mode === this.#asked) return;
    this.#asked = mode;
    if (mode === 'preview' || this.#loaded.has(mode)) return;
    try {
      if (mode === 'place') (await import('./placing.js')).definePlacing();
      else (await import('../../editor/editor.js')).defineEditor();
      this.#loaded.add(mode);
      this.#changed();
    } catch (error) {
      this.#failed(error);
    }
  }
}
