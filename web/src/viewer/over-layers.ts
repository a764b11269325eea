/**
 * Temporary lines over a drawing: the change of shape, and what the user points at, selects or
 * marks.
 */
import {Scene} from 'three';

import {LineLayer, type LineMaterial} from './line-layer.js';
import {movementStrokes} from './movement.js';
import {overlayStrokes} from './overlay-strokes.js';
import type {Overlay} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import type {Appearance} from './strokes.js';

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
