/**
 * Lines on the fabric as ribbons: seams by mismatch, and marks of the selection and the pointer's
 * target.
 */
import {BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, type ShaderMaterial} from 'three';

import type {DrapeMesh} from '../../model/result/draped-garment.js';
import {mismatchLine, type MismatchLine} from '../../scene/colours.js';
import type {PatternScene} from '../../scene/scene.js';
import {cross3, minus3, pointOf, unit3, type Vector} from './space.js';

/** A line along vertices of the mesh, and the style of each of its edges. */
export interface RibbonLine {
  readonly vertices: Uint32Array;
  readonly edges: readonly MismatchLine[];
}

/** Scale of dashes and gaps, which are defined for a flat pattern on a page. [cm per px] */
const dashScale = 0.09;

const origin: Vector = [0, 0, 0];

const sewnOf = (mesh: DrapeMesh, piece: number, vertices: Uint32Array): Uint32Array =>
  vertices.map((vertex) => mesh.pieces[piece]?.sewn[vertex] ?? 0);

/** Returns the line of each seam on the mesh. */
export const seamVertices = (mesh: DrapeMesh): readonly Uint32Array[] =>
  mesh.seams.map(({a}) => sewnOf(mesh, a.piece, a.vertices));

/** Returns the closed outline of a piece on the mesh. */
export function outlineVertices(mesh: DrapeMesh, piece: number): Uint32Array {
  const {outline = new Uint32Array()} = mesh.pieces[piece] ?? {};
  return sewnOf(mesh, piece, Uint32Array.of(...outline, ...outline.slice(0, 1)));
}

/**
 * Returns the seams that count and are not quiet, in the colours of the flat pattern. An edge of the mesh has the
 * colour at the same share of the seam's length.
 */
export function seamLines(mesh: DrapeMesh, {seams, scale}: PatternScene): readonly RibbonLine[] {
  return seamVertices(mesh).flatMap((vertices, number) => {
    const seam = seams[number];
    if (!seam?.counts || seam.isQuiet || vertices.length < 2) return [];
    const lines = seam.mismatch.map((mismatch) => mismatchLine(mismatch, scale));
    const count = vertices.length - 1;
    const edges = Array.from({length: count}, (_, k) => {
      const share = (k + 0.5) / count;
      return lines[Math.min(lines.length - 1, Math.floor(share * lines.length))];
    });
    return [{vertices, edges: edges.filter((line) => line !== undefined)}];
  });
}

/** Ribbons of one set of lines. Only their places change while a garment settles. */
export class Ribbons {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;
  #lines: readonly RibbonLine[] = [];
  /** Number of vertices. */
  #count = 0;

  constructor(material: ShaderMaterial) {
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.set([]);
  }

  set(lines: readonly RibbonLine[]): void {
    this.#lines = lines;
    const count = 4 * lines.reduce((sum, {edges}) => sum + edges.length, 0);
    const geometry = new BufferGeometry();
    const add = (name: string, size: number): Float32Array => {
      const attribute = new BufferAttribute(new Float32Array(size * count), size);
      if (['position', 'normal', 'across', 'along'].includes(name))
        attribute.setUsage(DynamicDrawUsage);
      geometry.setAttribute(name, attribute);
      return attribute.array as Float32Array;
    };
    for (const name of ['position', 'normal', 'across']) add(name, 3);
    add('along', 1);
    const [sides, widths, dashes, inks] = [
      add('side', 1),
      add('width', 1),
      add('dash', 2),
      add('ink', 3),
    ];
    const triangles: number[] = [];
    let vertex = 0;
    for (const {edges} of lines) {
      for (const {colour, width, dash} of edges) {
        const ink = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255);
        for (let k = 0; k < 4; k++) {
          sides[vertex + k] = k % 2 === 0 ? -1 : 1;
          widths[vertex + k] = width;
          // round caps are part of a dash: each extends its line by half its width
          if (dash)
            dashes.set(
              [dashScale * (dash[0] + width), dashScale * (dash[1] - width)],
              2 * (vertex + k),
            );
          inks.set(ink, 3 * (vertex + k));
        }
        triangles.push(vertex, vertex + 2, vertex + 1, vertex + 1, vertex + 2, vertex + 3);
        vertex += 4;
      }
    }
    geometry.setIndex(triangles);
    this.object.geometry.dispose();
    this.object.geometry = geometry;
    this.#count = count;
    this.isShown = true;
  }

  set isShown(isShown: boolean) {
    this.object.visible = isShown && this.#count > 0;
  }

  /**
   * @param positions x, y, z of the mesh's vertices [cm]
   * @param normals x, y, z of the same vertices
   */
  place(positions: ArrayLike<number>, normals: ArrayLike<number>): void {
    const {geometry} = this.object;
    const array = (name: string): Float32Array => {
      const attribute = geometry.getAttribute(name) as BufferAttribute;
      attribute.needsUpdate = true;
      return attribute.array as Float32Array;
    };
    if (this.#count === 0) return;
    const [places, ups, acrosses, runs] = [
      array('position'),
      array('normal'),
      array('across'),
      array('along'),
    ];
    let vertex = 0;
    for (const {vertices, edges} of this.#lines) {
      const points = Array.from(vertices, (one) => pointOf(positions, one));
      const normal = Array.from(vertices, (one) => pointOf(normals, one));
      const across = points.map((_, k) => {
        const from = points[Math.max(0, k - 1)] ?? origin;
        const to = points[Math.min(points.length - 1, k + 1)] ?? origin;
        return unit3(cross3(normal[k] ?? [0, 0, 1], minus3(to, from)));
      });
      let run = 0;
      for (let edge = 0; edge < edges.length; edge++) {
        const [from, to] = [points[edge] ?? origin, points[edge + 1] ?? origin];
        const length = Math.hypot(...minus3(to, from));
        for (let k = 0; k < 4; k++) {
          const end = edge + (k < 2 ? 0 : 1);
          places.set(points[end] ?? [0, 0, 0], 3 * (vertex + k));
          ups.set(normal[end] ?? [0, 0, 1], 3 * (vertex + k));
          acrosses.set(across[end] ?? [1, 0, 0], 3 * (vertex + k));
          runs[vertex + k] = run + (k < 2 ? 0 : length);
        }
        run += length;
        vertex += 4;
      }
    }
  }

  dispose(): void {
    this.object.geometry.dispose();
  }
}
