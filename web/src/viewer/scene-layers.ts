/** All parts of a scene that the graphics card draws. */
import {Scene} from 'three';

import {LineLayer, type LineMaterial} from './line-layer.js';
import {PrintLayer, type PrintMaterial} from './print-layer.js';
import type {Motion} from './morph.js';
import type {PatternScene} from '../scene/scene.js';
import {keptStrokes, markStrokes, outlineStrokes, seamStrokes, type Appearance} from './strokes.js';

/** Shared by all scenes of a view. */
interface Materials {
  readonly fabric: PrintMaterial;
  readonly line: LineMaterial;
}

interface Layers {
  readonly print: PrintLayer;
  readonly outlines: LineLayer;
  readonly kept: LineLayer;
  readonly seams: LineLayer;
  readonly marks: LineLayer;
}

type Places = {readonly [Layer in keyof Layers]: Layers[Layer]['places']};

const placesOf = ({print, outlines, kept, seams, marks}: Layers): Places => ({
  print: print.places,
  outlines: outlines.places,
  kept: kept.places,
  seams: seams.places,
  marks: marks.places,
});

/** Returns whether two scenes differ only in the alignments with the print. */
const sameGeometry = (a: PatternScene, b: PatternScene): boolean =>
  a.symmetries === b.symmetries &&
  a.kept === b.kept &&
  a.seams.length === b.seams.length &&
  a.seams.every(({a: side}, k) => side === b.seams[k]?.a) &&
  a.pieces.length === b.pieces.length &&
  a.pieces.every(
    ({points, offset, isTurned, plain}, k) =>
      points === b.pieces[k]?.points &&
      offset === b.pieces[k].offset &&
      isTurned === b.pieces[k].isTurned &&
      plain === b.pieces[k].plain,
  );

const sameNumbers = (a: readonly number[], b: readonly number[]): boolean =>
  a === b || (a.length === b.length && a.every((one, k) => one === b[k]));

/**
 * Returns whether the pieces of two sheets are the same, vertex by vertex, so that a motion between
 * them is possible.
 */
const sameVertices = (a: PatternScene, b: PatternScene): boolean =>
  sameNumbers(a.size, b.size) &&
  a.pieces.length === b.pieces.length &&
  a.pieces.every((piece, k) => {
    const other = b.pieces[k];
    return (
      piece.name === other?.name &&
      piece.points.length === other.points.length &&
      sameNumbers(piece.outline, other.outline) &&
      (piece.triangles === other.triangles ||
        piece.triangles.every((corners, n) => sameNumbers(corners, other.triangles[n] ?? [])))
    );
  });

/** Returns whether the print repeats in the same way, so that it may slide. */
const sameLattice = ({print: a}: PatternScene, {print: b}: PatternScene): boolean =>
  a.group === b.group && sameNumbers(a.w1, b.w1) && sameNumbers(a.w2, b.w2);

/** Courses of the lines of each kind; lines with different courses are not the same lines. */
const lineKinds: Readonly<
  Record<Exclude<keyof Layers, 'print'>, (scene: PatternScene) => unknown>
> = {
  outlines: () => '',
  kept: ({kept = []}) => kept,
  seams: ({seams}) => seams.map(({a, b}) => [a, b]),
  marks: ({pieces, symmetries}) => [
    pieces.map(({grain}) => grain !== undefined),
    symmetries.map((symmetry) => (symmetry.kind === 'piece' ? symmetry.piece : -1)),
  ],
};

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

  /**
   * Shows a scene; cheap when only alignments differ from the scene before.
   * @returns whether all was rebuilt, and whether `blend` can move from the previous drawing
   */
  show(
    scene: PatternScene,
    appearance: Appearance,
    motion: Motion = 'none',
  ): {readonly isNew: boolean; readonly moves: boolean} {
    const [before, drawn] = [this.#shown, this.#layers];
    const isKnown =
      before !== undefined && this.#appearance === appearance && sameGeometry(before, scene);
    const isMoved = motion === 'all' || !isKnown || drawn?.print.isOnItsWay;
    const moves = motion !== 'none' && isMoved && before && sameVertices(before, scene);
    const places = moves && drawn && placesOf(drawn);
    this.#shown = scene;
    this.#appearance = appearance;
    if (!isKnown) this.#build(scene, appearance);
    else if (before.seams !== scene.seams || before.scale !== scene.scale) {
      this.#layers?.seams.restyle(seamStrokes(scene, appearance));
    }
    if (!isKnown || before.pieces !== scene.pieces || before.print !== scene.print) {
      this.#layers?.print.align(scene.pieces, scene.print);
    }
    if (places) {
      const slides = motion === 'all' && sameLattice(before, scene);
      this.#comeFrom(
        places,
        slides,
        (along) => isKnown || JSON.stringify(along(before)) === JSON.stringify(along(scene)),
      );
    } else this.blend(1);
    return {isNew: !isKnown, moves: places !== undefined && places !== false};
  }

  /**
   * Draws a state between the previous drawing and the scene; a share of 1, also the initial state,
   * is exactly the scene.
   */
  blend(share: number): void {
    for (const layer of Object.values(this.#layers ?? {}) as Layers[keyof Layers][])
      layer.blend(share);
  }

  /** Shows or hides the lines over the fabric, and the seams among them. */
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
    const {fabric, line} = this.#materials;
    const lines = (strokes: typeof markStrokes, order: number): LineLayer =>
      new LineLayer(strokes(scene, appearance), line, order);
    this.#layers = {
      print: new PrintLayer(scene.pieces, scene.print, fabric),
      outlines: lines(outlineStrokes, 1),
      kept: lines(keptStrokes, 2),
      seams: lines(seamStrokes, 3),
      marks: lines(markStrokes, 4),
    };
    this.object.add(...Object.values(this.#layers).map(({object}: Layers[keyof Layers]) => object));
  }

  #comeFrom(
    {print, ...lines}: Places,
    slides: boolean,
    isSame: (along: (typeof lineKinds)[keyof typeof lineKinds]) => boolean,
  ): void {
    const layers = this.#layers;
    if (!layers) return;
    const {alignments} = layers.print.places;
    layers.print.comeFrom(slides ? print : {...print, alignments});
    for (const name of Object.keys(lineKinds) as (keyof typeof lineKinds)[]) {
      layers[name].comeFrom(isSame(lineKinds[name]) ? lines[name] : undefined);
    }
  }
}
