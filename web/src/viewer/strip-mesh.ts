/**
 * Mesh of the print on both sides of a straightened seam, side a above the line and side b below.
 */
import {BufferAttribute, BufferGeometry, Mesh} from 'three';

import {plus} from '../model/geometry/vectors.js';
import {apply} from '../model/print/wallpaper.js';
import {imageCoordinates} from '../model/print/image-coordinates.js';
import type {PrintMaterial} from './print-layer.js';
import type {PatternScene} from '../scene/scene.js';
import {ribbonDepth, type Ribbon, type StraightSeam} from './seam-ribbon.js';

/** Distance between rows. [cm] */
const rowStep = 0.3;
const rows = Math.ceil(ribbonDepth / rowStep);

export class StripMesh {
  readonly object: Mesh<BufferGeometry, PrintMaterial>;
  readonly #seam: StraightSeam;
  readonly #coordinates: BufferAttribute;

  constructor(seam: StraightSeam, material: PrintMaterial) {
    this.#seam = seam;
    const columns = seam.a.columns.length;
    const positions: number[] = [];
    const indices: number[] = [];
    for (const [ribbon, up] of [
      [seam.a, 1],
      [seam.b, -1],
    ] as const) {
      const first = positions.length / 3;
      ribbon.columns.forEach(({depth}, k) => {
        const way = (seam.length * k) / (columns - 1);
        const x = seam.runsLeft ? seam.length - way : way;
        for (const d of depths(depth)) positions.push(x, up * d, 0);
      });
      for (let k = 0; k + 1 < columns; k++) {
        for (let row = 0; row < rows; row++) {
          const corner = first + k * (rows + 1) + row;
          const next = corner + rows + 1;
          // the winding depends on side and direction
          const [one, other] = up > 0 !== seam.runsLeft ? [corner, next] : [next, corner];
          indices.push(one, other, other + 1, one, other + 1, one + 1);
        }
      }
    }
    this.#coordinates = new BufferAttribute(new Float32Array((positions.length / 3) * 2), 2);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    geometry.setAttribute('uv', this.#coordinates);
    geometry.setAttribute('printed', new BufferAttribute(new Uint8Array(positions.length / 3), 1));
    geometry.setIndex(indices);
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  /** Aligns the strip with the print as the pieces of the scene. */
  align(scene: PatternScene): void {
    const printed = this.object.geometry.getAttribute('printed');
    let vertex = 0;
    const lay = ({piece, columns}: Ribbon): void => {
      const {alignment, plain} = scene.pieces[piece] ?? {plain: true};
      if (!alignment) return;
      const map = imageCoordinates(scene.print, alignment, columns[0]?.at ?? [0, 0]);
      for (const {at, normal, depth} of columns) {
        for (const d of depths(depth)) {
          const [u, v] = apply(map, plus(at, normal, d));
          printed.setX(vertex, plain ? 0 : 1);
          this.#coordinates.setXY(vertex++, u, v);
        }
      }
    };
    lay(this.#seam.a);
    lay(this.#seam.b);
    this.#coordinates.needsUpdate = true;
    printed.needsUpdate = true;
  }

  dispose(): void {
    this.object.geometry.dispose();
  }
}

/** Returns the rows of a column, from the seam inwards; rows beyond its depth coincide. */
const depths = (depth: number): readonly number[] =>
  Array.from({length: rows + 1}, (_, row) => Math.min(row * rowStep, depth));
