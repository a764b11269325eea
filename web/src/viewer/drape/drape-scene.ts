/** The contents of a drape's view: settling fabric, dummy and floor, seams and marks. */
import {BufferGeometry, type WebGLRenderer} from 'three';

import type {DrapeMesh, FabricName, Form} from '../../model/result/draped-garment.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Raster} from '../stage.js';
import {inks, type Appearance} from '../strokes.js';
import type {Wipe} from '../over-layers.js';
import type {Orbit} from './camera.js';
import {FabricLayer} from './cloth-layer.js';
import type {DrapeTarget} from './drape-picker.js';
import {bodyOf, standOf, type Solid, type Stand} from './dummy.js';
import {fabricLooks} from './fabric-look.js';
import type {Fineness} from './fineness.js';
import {outlineVertices, Ribbons, seamLines, seamVertices, type RibbonLine} from './ribbons.js';
import {boxAround, boxDistance, type Box3} from './space.js';
import {Studio} from './studio.js';

/** Greatest change of the box that keeps the garment's place in the picture. [cm] */
const calm = 8;
const shadowStrength: Readonly<Record<Appearance, number>> = {light: 1, dark: 2};
/** Line widths of the selection, and of the pointer's target. [px] */
const markWidths = {selected: 5, pointed: 4};

/** Selection and target of the pointer. */
export interface Marked {
  readonly selected?: DrapeTarget | undefined;
  readonly pointed?: DrapeTarget | undefined;
}

export class DrapeScene {
  readonly studio = new Studio();
  readonly #seams = new Ribbons(this.studio.ribbonMaterial);
  /** Seams as drafted. */
  readonly #drafted = new Ribbons(this.studio.ribbonMaterial);
  readonly #marks = new Ribbons(this.studio.ribbonMaterial);
  #appearance: Appearance;
  #scene: PatternScene | undefined;
  #layer: FabricLayer | undefined;
  /** Layer shown once its first positions arrive. */
  #next: FabricLayer | undefined;
  /** Positions that are not drawn yet. */
  #pose: Float32Array | undefined;
  #form: Form | undefined;
  #dummy: Solid | undefined;
  #stand: Stand | undefined;
  #hasSeams = false;
  #hasForm = true;
  #wipe: Wipe | undefined;
  #marked: Marked = {};
  #box: Box3 | undefined;

  constructor(appearance: Appearance) {
    this.#appearance = appearance;
    this.studio.scene.add(this.#seams.object, this.#drafted.object, this.#marks.object);
  }

  /** Bounding box of everything. [cm] */
  get box(): Box3 | undefined {
    return this.#box;
  }

  get layer(): FabricLayer | undefined {
    return this.#layer;
  }

  /** The form's surface, while it is visible. */
  get body(): Form['surface'] | undefined {
    return this.#hasForm ? this.#form?.surface : undefined;
  }

  /** Returns whether a garment is there. */
  get isWorn(): boolean {
    return this.#layer !== undefined || this.#pose !== undefined;
  }

  /** Aligns the fabric with the print as in a scene. */
  show(scene: PatternScene): void {
    const before = this.#scene;
    this.#scene = scene;
    this.#layer?.print(scene);
    if (before?.seams !== scene.seams) this.#laySeams();
  }

  /** Shows the pieces as drafted, on the print without pattern matching, to the left of a line. */
  setWipe(wipe: Wipe | undefined): void {
    const before = this.#wipe?.before;
    this.#wipe = wipe;
    if (wipe?.before === before) return;
    if (wipe) this.#layer?.draft(wipe.before);
    this.#laySeams();
  }

  setAppearance(appearance: Appearance): void {
    this.#appearance = appearance;
    this.#layFloor();
    this.#layMarks();
  }

  setSeams(hasSeams: boolean): void {
    if (hasSeams === this.#hasSeams) return;
    this.#hasSeams = hasSeams;
    this.#laySeams();
  }

  setForm(isShown: boolean): void {
    this.#hasForm = isShown;
    this.studio.hasDummy = isShown;
  }

  set fabric(fabric: FabricName) {
    this.studio.look = fabricLooks[fabric];
  }

  setMarked(marked: Marked): void {
    const {selected, pointed} = this.#marked;
    if (marked.selected === selected && marked.pointed === pointed) return;
    this.#marked = marked;
    this.#layMarks();
  }

  /** The form under the garment. */
  set form(form: Form) {
    if (form === this.#form) return;
    this.#form = form;
    this.#dummy = bodyOf(form.surface);
    this.#stand = undefined; // its height depends on the garment
  }

  /** Sets the mesh of the next poses; the current one stays visible until then. */
  set mesh(mesh: DrapeMesh) {
    if (mesh === (this.#next ?? this.#layer)?.cloth.mesh) return;
    this.#next = new FabricLayer(mesh);
  }

  /**
   * Sets the mesh's positions, x, y, z per vertex [cm]; nothing is computed before the next
   * drawing.
   */
  set pose(positions: Float32Array) {
    this.#pose = positions;
  }

  /** Removes the garment. */
  clear(): void {
    this.#layer = undefined;
    this.#next = undefined;
    this.#pose = undefined;
    this.#form = undefined;
    this.#stand = undefined;
    this.#box = undefined;
    this.studio.setCloth(new BufferGeometry(), new BufferGeometry());
    this.#laySeams();
    this.#marks.set([]);
  }

  /** Applies the latest positions. @returns whether the box of the scene has changed */
  settle(): boolean {
    const pose = this.#pose;
    if (!pose) return false;
    this.#pose = undefined;
    const isNew = this.#next !== undefined;
    this.#layer = this.#next ?? this.#layer;
    this.#next = undefined;
    const layer = this.#layer;
    // belongs to a mesh that is not shown any more
    if (layer?.normals.length !== pose.length) return false;
    layer.pose(pose);
    if (isNew) {
      this.studio.setCloth(layer.geometry, layer.hems);
      if (this.#scene) layer.print(this.#scene);
      if (this.#wipe) layer.draft(this.#wipe.before);
      this.#laySeams();
      this.#layMarks();
    }
    for (const ribbons of [this.#seams, this.#drafted, this.#marks])
      ribbons.place(layer.positions, layer.normals);
    return (isNew || !this.#stand) && this.#setUp(pose);
  }

  /** @param hasWipe draws the compared scene as well */
  draw(
    renderer: WebGLRenderer,
    raster: Raster,
    fineness: Fineness,
    orbit: Orbit,
    hasWipe: boolean,
  ): void {
    if (!this.#box) return;
    const split = hasWipe ? Math.min(1, Math.max(0, this.#wipe?.split ?? 0)) : 0;
    const parts = [
      {from: 0, to: split, isDrafted: true},
      {from: split, to: 1, isDrafted: false},
    ].filter(({from, to}) => from < to);
    this.studio.draw(renderer, raster, fineness, orbit, this.#box, parts, ({isDrafted}) => {
      this.#drafted.isShown = isDrafted;
      this.#seams.isShown = !isDrafted;
    });
  }

  dispose(): void {
    this.#next?.dispose();
    this.#seams.dispose();
    this.#drafted.dispose();
    this.#marks.dispose();
    this.studio.dispose();
  }

  /** Places dummy and floor under the hanging garment. @returns whether the box has changed */
  #setUp(pose: Float32Array): boolean {
    let box = boxAround(pose);
    if (this.#form && box) {
      const {surface} = this.#form;
      if (!this.#stand) {
        this.#stand = standOf(this.#form, box.low[1]);
        if (this.#dummy) this.studio.setDummy(this.#dummy, this.#stand.parts);
      }
      box = boxAround(this.#stand.parts.positions, boxAround(surface.vertices, box));
    }
    // a settling garment keeps its place in the picture
    const isOther = !this.#box || !box || boxDistance(this.#box, box) > calm;
    if (isOther) this.#box = box;
    this.#layFloor();
    return isOther;
  }

  #layFloor(): void {
    if (!this.#stand || !this.#box) return;
    const {floor, middle} = this.#stand;
    this.studio.setFloor(floor, middle, this.#box, shadowStrength[this.#appearance]);
  }

  #laySeams(): void {
    const [layer, scene] = [this.#layer, this.#scene];
    const lay = (ribbons: Ribbons, shown: PatternScene | undefined): void => {
      const isShown = this.#hasSeams && layer && shown && layer.isOf(shown);
      ribbons.set(isShown ? seamLines(layer.cloth.mesh, shown) : []);
      if (layer) ribbons.place(layer.positions, layer.normals);
    };
    lay(this.#seams, scene);
    lay(this.#drafted, this.#wipe?.before);
  }

  #layMarks(): void {
    const {selected, pointed} = this.#marked;
    const {accent} = inks[this.#appearance];
    const piece = (target: DrapeTarget | undefined): number | undefined =>
      target?.kind === 'piece' ? target.piece : undefined;
    this.studio.mark(piece(selected), piece(pointed), accent);
    const layer = this.#layer;
    if (!layer) return;
    const colour = `#${accent.map((one) => one.toString(16).padStart(2, '0')).join('')}`;
    const line = (target: DrapeTarget | undefined, width: number): readonly RibbonLine[] => {
      const vertices = target && verticesOf(layer.cloth.mesh, target);
      if (!vertices || vertices.length < 2) return [];
      return [{vertices, edges: Array.from(vertices.slice(1), () => ({colour, width}))}];
    };
    this.#marks.set([
      ...line(selected, markWidths.selected),
      ...line(pointed?.kind === 'seam' ? pointed : undefined, markWidths.pointed),
    ]);
    this.#marks.place(layer.positions, layer.normals);
  }
}

const verticesOf = (mesh: DrapeMesh, target: DrapeTarget): Uint32Array | undefined =>
  target.kind === 'seam' ? seamVertices(mesh)[target.seam] : outlineVertices(mesh, target.piece);
