import {pickIndex, type PickIndex} from '../../clicks/pick-index.js';
import type {PatternScene} from '../../scene/scene.js';

/** Index for clicks; it stays valid while only the alignments change. */
export class SheetIndex {
  #for: Pick<PatternScene, 'pattern' | 'outline' | 'size'> | undefined;
  #index: PickIndex | undefined;

  of(scene: PatternScene): PickIndex {
    const {pattern, outline, size} = scene;
    const known = this.#for;
    if (
      this.#index &&
      known?.pattern === pattern &&
      known.outline === outline &&
      known.size === size
    )
      return this.#index;
    this.#for = {pattern, outline, size};
    return (this.#index = pickIndex(scene));
  }
}
