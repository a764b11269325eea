/** GPU buffers of a drape's mesh: moving positions and normals, and coordinates on the print. */
import {BufferAttribute, BufferGeometry, DynamicDrawUsage} from 'three';

import type {DrapeMesh} from '../../model/result/draped-garment.js';
import type {PatternScene} from '../../scene/scene.js';
import {clothOf, normalsOf, printPlaces, putToDrawn, type Cloth} from './cloth.js';

export class ClothLayer {
  readonly geometry = new BufferGeometry();
  readonly cloth: Cloth;
  /** Positions of the mesh's vertices as x, y, z triples. [cm] */
  positions: Float32Array = new Float32Array();
  readonly normals: Float32Array<ArrayBuffer>;
  #scene: PatternScene | undefined;
  /** The drafted scene. */
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

  /** Moves the mesh. */
  pose(positions: Float32Array): void {
    this.positions = positions;
    normalsOf(positions, this.cloth.welded, this.normals);
    putToDrawn(this.cloth, positions, this.#array('position'));
    putToDrawn(this.cloth, this.normals, this.#array('normal'));
  }

  /**
   * Aligns the pieces with the print as in a scene of the same pieces; ignores a scene of others.
   */
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
   * Computes print coordinates of the drafted pieces, too, for comparison. They use the positions
   * of the cut pieces: drafted ones would hang elsewhere by no more than outlines are moved, which
   * is millimetres.
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
