/** Another scene of the same sheet, drawn to the left of a line. */
import type {OrthographicCamera} from 'three';

import {SceneLayers} from './scene-layers.js';
import type {PatternScene} from '../scene/scene.js';
import type {Screen} from './screen.js';
import type {Appearance} from './strokes.js';

/** @param split place of the line as a share of the width */
export interface Wipe {
  readonly before: PatternScene;
  readonly split: number;
}

export class WipeLayers {
  readonly #layers: SceneLayers;
  #wipe: Wipe | undefined;

  constructor(materials: ConstructorParameters<typeof SceneLayers>[0]) {
    this.#layers = new SceneLayers(materials);
  }

  /**
   * Sets the scene; cheap when only the split changes.
   * @returns whether the scene was laid out again
   */
  set(wipe: Wipe | undefined, appearance: Appearance): boolean {
    const {before} = this.#wipe ?? {};
    this.#wipe = wipe;
    return wipe !== undefined && wipe.before !== before && this.layAgain(appearance);
  }

  /** @returns true if there is a scene */
  layAgain(appearance: Appearance): boolean {
    if (!this.#wipe) return false;
    this.#layers.show(this.#wipe.before, appearance);
    return true;
  }

  showLines(...shown: Parameters<SceneLayers['showLines']>): void {
    this.#layers.showLines(...shown);
  }

  /** Returns the right end of the scene. [CSS px from the left] */
  splitOn(width: number): number {
    return Math.min(1, Math.max(0, this.#wipe?.split ?? 0)) * width;
  }

  /** Draws the scene, and restricts the screen to the right of the line afterwards. */
  draw(screen: Screen, camera: OrthographicCamera): void {
    const {width} = screen.size;
    if (this.#wipe) {
      screen.clip(0, this.splitOn(width));
      screen.renderer.render(this.#layers.object, camera);
    }
    screen.clip(this.splitOn(width), width);
  }

  dispose(): void {
    this.#layers.dispose();
  }
}
