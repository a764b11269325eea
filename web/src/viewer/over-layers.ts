/**
 * Temporary lines over a drawing: the change of shape, and what the user points at, selects or
 * marks.
 */
import {Scene, type OrthographicCamera} from 'three';

import {LineLayer, type LineMaterial} from './line-layer.js';
import {movementStrokes} from './movement.js';
import {overlayStrokes} from './overlay-strokes.js';
import type {Overlay} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import type {Appearance} from './strokes.js';
import {SceneLayers} from './scene-layers.js';
import type {Screen} from './screen.js';

// Another scene of the same sheet, drawn to the left of a line.

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

export class OverLayers {
  readonly object = new Scene();
  readonly #line: LineMaterial;
  readonly #layers = new Map<'movement' | 'overlay', LineLayer>();

  constructor(line: LineMaterial) {
    this.#line = line;
  }

  /** Shows arrows that are `factor` times as long as the movement; none without a factor. */
  showMovement(
    scene: PatternScene | undefined,
    factor: number | undefined,
    appearance: Appearance,
  ): void {
    const isShown = scene && factor !== undefined;
    this.#replace('movement', isShown ? movementStrokes(scene, factor, appearance) : [], 0);
  }

  showOverlay(
    scene: PatternScene | undefined,
    overlay: Overlay | undefined,
    appearance: Appearance,
  ): void {
    const isShown = scene && overlay;
    this.#replace('overlay', isShown ? overlayStrokes(scene, overlay, appearance) : [], 1);
  }

  dispose(): void {
    this.object.clear();
    for (const layer of this.#layers.values()) layer.dispose();
  }

  #replace(
    name: 'movement' | 'overlay',
    strokes: ReturnType<typeof overlayStrokes>,
    order: number,
  ): void {
    const before = this.#layers.get(name);
    if (before) this.object.remove(before.object);
    before?.dispose();
    this.#layers.delete(name);
    if (strokes.length === 0) return;
    const next = new LineLayer(strokes, this.#line, order);
    this.#layers.set(name, next);
    this.object.add(next.object);
  }
}
