/** The cloth of one mesh as the graphics card has it: places and normals that move, and where it lies on the print. */
import {BufferAttribute, BufferGeometry, DynamicDrawUsage} from 'three';

import type {DrapeMesh} from '../../model/drape.js';
import type {PatternScene} from '../../scene/scene.js';
import {clothOf, normalsOf, printPlaces, putToDrawn, type Cloth} from './cloth.js';

export class ClothLayer {
  readonly geometry = new BufferGeometry();
  readonly cloth: Cloth;
  /** Of the cloth's vertices, x, y, z after each other. [cm] */
  positions: Float32Array = new Float32Array();
  readonly normals: Float32Array<ArrayBuffer>;
  #scene: PatternScene | undefined;
  /** As drafted. */
  #before: PatternScene | undefined;

  constructor(mesh: DrapeMesh) {
    this.cloth = clothOf(mesh);
    const {pieces, shape, triangles} = this.cloth;
    const count = pieces.length;
    this.normals = new Float32Array(3 * mesh.size);
    for (const [name, size] of [
      ['position', 3],
      ['normal', 3],
      ['uv', 2],
      ['drafted', 2],
      ['printed', 1],
    ] as const) {
      const attribute = new BufferAttribute(new Float32Array(size * count), size);
      attribute.setUsage(DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
    }
    this.geometry.setAttribute('shape', new BufferAttribute(shape, 2));
    this.geometry.setAttribute('piece', new BufferAttribute(Float32Array.from(pieces), 1));
    this.geometry.setIndex(new BufferAttribute(triangles, 1));
  }

  /** Moves it there. */
  pose(positions: Float32Array): void {
    this.positions = positions;
    normalsOf(positions, this.cloth.welded, this.normals);
    putToDrawn(this.cloth, positions, this.#array('position'));
    putToDrawn(this.cloth, this.normals, this.#array('normal'));
  }

  /** Lays its pieces on the print as they lie in a scene of the same pieces; one of others changes nothing. */
  print(scene: PatternScene): void {
    if (scene === this.#scene || !this.isOf(scene)) return;
    const {pieces, print} = scene;
    const before = this.#scene;
    this.#scene = scene;
    if (before?.pieces !== pieces || before.print !== print) {
      const alignments = pieces.map(({alignment}) => alignment);
      printPlaces(this.cloth, alignments, print, this.#array('uv'));
    }
    const printed = this.#array('printed');
    this.cloth.pieces.forEach((piece, k) => (printed[k] = pieces[piece]?.plain ? 0 : 1));
  }

  /**
   * Lays its pieces on the print as drafted, too, to be compared. They hang where the cut ones do: drafted ones would
   * hang elsewhere by no more than outlines are moved, which is millimetres.
   */
  draft(before: PatternScene): void {
    if (before === this.#before || !this.isOf(before)) return;
    this.#before = before;
    const {pieces, print} = before;
    const alignments = pieces.map(({alignment}) => alignment);
    printPlaces(this.cloth, alignments, print, this.#array('drafted'), 'rest');
  }

  isOf({pieces}: PatternScene): boolean {
    const {mesh} = this.cloth;
    return (
      pieces.length === mesh.pieces.length &&
      mesh.pieces.every(({name}, k) => name === pieces[k]?.name)
    );
  }

  #array(name: string): Float32Array {
    const attribute = this.geometry.getAttribute(name) as BufferAttribute;
    attribute.needsUpdate = true;
    return attribute.array as Float32Array;
  }
}
