/** All that is drawn of one scene by the graphics card. */
import {Scene} from 'three';

import {LineLayer, type LineMaterial} from './line-layer.js';
import {PrintLayer, type PrintMaterial} from './print-layer.js';
import type {PatternScene} from './scene.js';
import {keptStrokes, markStrokes, outlineStrokes, seamStrokes, type Appearance} from './strokes.js';

/** Shared by all scenes of a view. */
export interface Materials {
  readonly cloth: PrintMaterial;
  readonly line: LineMaterial;
}

interface Layers {
  readonly print: PrintLayer;
  readonly outlines: LineLayer;
  readonly kept: LineLayer;
  readonly seams: LineLayer;
  readonly marks: LineLayer;
}

/** Whether two scenes differ in nothing but how the pieces lie on the print. */
const sameGeometry = (a: PatternScene, b: PatternScene): boolean =>
  a.symmetries === b.symmetries &&
  a.kept === b.kept &&
  a.seams.length === b.seams.length &&
  a.seams.every(({a: side}, k) => side === b.seams[k]?.a) &&
  a.pieces.length === b.pieces.length &&
  a.pieces.every(
    ({points, offset, plain}, k) =>
      points === b.pieces[k]?.points &&
      offset === b.pieces[k].offset &&
      plain === b.pieces[k].plain,
  );

export class SceneLayers {
  readonly object = new Scene();
  readonly #materials: Materials;
  #shown: PatternScene | undefined;
  #appearance: Appearance = 'light';
  #layers: Layers | undefined;

  constructor(materials: Materials) {
    this.#materials = materials;
  }

  get scene(): PatternScene | undefined {
    return this.#shown;
  }

  /** Cheap when only alignments differ from the scene before. @returns whether all was built anew */
  show(scene: PatternScene, appearance: Appearance): boolean {
    const before = this.#shown;
    const isKnown = before && this.#appearance === appearance && sameGeometry(before, scene);
    this.#shown = scene;
    this.#appearance = appearance;
    if (!isKnown) this.#build(scene, appearance);
    else if (before.seams !== scene.seams || before.scale !== scene.scale) {
      this.#layers?.seams.restyle(seamStrokes(scene, appearance));
    }
    if (!isKnown || before.pieces !== scene.pieces || before.print !== scene.print) {
      this.#layers?.print.align(scene.pieces, scene.print);
    }
    return !isKnown;
  }

  /** Whether there are lines over the cloth, and those of seams among them. */
  showLines(isShown: boolean, hasSeams: boolean): void {
    if (!this.#layers) return;
    const {outlines, seams, marks} = this.#layers;
    for (const {object} of [outlines, marks]) object.visible = isShown;
    seams.object.visible = isShown && hasSeams;
  }

  dispose(): void {
    this.object.clear();
    for (const layer of Object.values(this.#layers ?? {}) as Layers[keyof Layers][])
      layer.dispose();
    this.#layers = undefined;
  }

  #build(scene: PatternScene, appearance: Appearance): void {
    this.dispose();
    const {cloth, line} = this.#materials;
    const lines = (strokes: typeof markStrokes, order: number): LineLayer =>
      new LineLayer(strokes(scene, appearance), line, order);
    this.#layers = {
      print: new PrintLayer(scene.pieces, cloth),
      outlines: lines(outlineStrokes, 1),
      kept: lines(keptStrokes, 2),
      seams: lines(seamStrokes, 3),
      marks: lines(markStrokes, 4),
    };
    this.object.add(...Object.values(this.#layers).map(({object}: Layers[keyof Layers]) => object));
  }
}
