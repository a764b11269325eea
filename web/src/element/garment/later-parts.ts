/** Loads the code of modes, views and fabric layout on first use. */
import {loadDrape} from '../../editor/load-later-parts.js';
import type {GarmentMode, GarmentView} from './attributes.js';
import type {SolverError} from '../../model/base/failure.js';
import type {MarkerLayer, MarkerOwner} from './marker-layer.js';

/** Fabric layout of the answer. */
export class Marker {
  /** Undefined until the first layout. */
  layer: MarkerLayer | undefined;
  readonly #owner: MarkerOwner;
  readonly #lost: (error: unknown) => SolverError;
  #isAsked = false;

  /** @param lost converts a failed import to an error */
  constructor(owner: MarkerOwner, lost: (error: unknown) => SolverError) {
    this.#owner = owner;
    this.#lost = lost;
  }

  /** Starts the layout of the current answer, replacing the previous one. */
  follow(): void {
    const {element, session} = this.#owner;
    if (this.layer) this.layer.follow();
    else if (!this.#isAsked && element.clothWidth !== null && session.result) {
      // the next call of `layPlan` tries again
      this.load().catch((error: unknown) => {
        session.report(error as SolverError);
      });
    }
  }

  /** @throws {SolverError} if the code cannot be loaded */
  async load(): Promise<MarkerLayer> {
    this.#isAsked = true;
    const {MarkerLayer} = await import('./marker-layer.js').catch((error: unknown) => {
      throw this.#lost(error);
    });
    this.layer ??= new MarkerLayer(this.#owner);
    this.layer.follow();
    return this.layer;
  }
}

/** Modes and views of the element. */
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
      if (mode === 'place') (await import('./place-bar.js')).definePlacing();
      else (await import('../../editor/editor.js')).defineEditor();
      this.#loaded.add(mode);
      this.#changed();
    } catch (error) {
      this.#failed(error);
    }
  }
}
