/** GPU buffers of a drape's mesh: moving positions and normals, and coordinates on the print. */
import {BufferAttribute, BufferGeometry, DynamicDrawUsage} from 'three';

import type {DrapeMesh} from '../../model/result/draped-garment.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Alignment, Point} from '../../model/geometry/vectors.js';
import type {Print} from '../../model/print/repeating-print.js';
import {apply} from '../../model/geometry/plane-map.js';
import {imageCoordinates} from '../../model/print/image-coordinates.js';

export class FabricLayer {
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

// The mesh of a drape for drawing: split by piece, since each piece has its own place on the print.

/** Drawn vertices are those of the pieces, one piece after the other. */
interface Cloth {
  readonly mesh: DrapeMesh;
  /** Mesh vertex of each drawn vertex. */
  readonly sewn: Uint32Array;
  /** Piece of each drawn vertex. */
  readonly pieces: Uint16Array;
  /** Point x, y of each drawn vertex on the piece as cut. [cm] */
  readonly shape: Float32Array;
  /** Triples of drawn vertices, one piece after the other. */
  readonly triangles: Uint32Array;
  /** The same triples as vertices of the mesh. */
  readonly welded: Uint32Array;
  /** First drawn vertex of each piece, and the number of all. */
  readonly firsts: readonly number[];
}

export function clothOf(mesh: DrapeMesh): Cloth {
  const firsts = [0];
  for (const {sewn} of mesh.pieces) firsts.push((firsts.at(-1) ?? 0) + sewn.length);
  const count = firsts.at(-1) ?? 0;
  const corners = mesh.pieces.reduce((sum, {triangles}) => sum + triangles.length, 0);
  const sewn = new Uint32Array(count);
  const pieces = new Uint16Array(count);
  const shape = new Float32Array(2 * count);
  const triangles = new Uint32Array(corners);
  let corner = 0;
  for (const [number, piece] of mesh.pieces.entries()) {
    const first = firsts[number] ?? 0;
    sewn.set(piece.sewn, first);
    shape.set(piece.shape, 2 * first);
    pieces.fill(number, first, first + piece.sewn.length);
    for (const vertex of piece.triangles) triangles[corner++] = first + vertex;
  }
  const welded = triangles.map((vertex) => sewn[vertex] ?? 0);
  return {mesh, sewn, pieces, shape, triangles, welded, firsts};
}

/** Copies x, y, z of the mesh's vertices to the drawn ones. */
export function putToDrawn(
  {sewn}: Pick<Cloth, 'sewn'>,
  from: ArrayLike<number>,
  into: Float32Array,
): void {
  for (let k = 0; k < sewn.length; k++) {
    const at = 3 * (sewn[k] ?? 0);
    into[3 * k] = from[at] ?? 0;
    into[3 * k + 1] = from[at + 1] ?? 0;
    into[3 * k + 2] = from[at + 2] ?? 0;
  }
}

/**
 * Returns unit normals per vertex: the area-weighted sum over its triangles. Seams shade smoothly
 * if the vertices are the mesh's.
 */
export function normalsOf(
  positions: ArrayLike<number>,
  triangles: Uint32Array,
  into = new Float32Array(positions.length),
): Float32Array<ArrayBuffer> {
  into.fill(0);
  for (let k = 0; k < triangles.length; k += 3) {
    const [a, b, c] = [
      3 * (triangles[k] ?? 0),
      3 * (triangles[k + 1] ?? 0),
      3 * (triangles[k + 2] ?? 0),
    ];
    const [x, y, z] = [positions[a] ?? 0, positions[a + 1] ?? 0, positions[a + 2] ?? 0];
    const ux = (positions[b] ?? 0) - x;
    const uy = (positions[b + 1] ?? 0) - y;
    const uz = (positions[b + 2] ?? 0) - z;
    const vx = (positions[c] ?? 0) - x;
    const vy = (positions[c + 1] ?? 0) - y;
    const vz = (positions[c + 2] ?? 0) - z;
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const at of [a, b, c]) {
      into[at] = (into[at] ?? 0) + nx;
      into[at + 1] = (into[at + 1] ?? 0) + ny;
      into[at + 2] = (into[at + 2] ?? 0) + nz;
    }
  }
  for (let k = 0; k < into.length; k += 3) {
    const [x, y, z] = [into[k] ?? 0, into[k + 1] ?? 0, into[k + 2] ?? 0];
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    into[k] = x / length;
    into[k + 1] = y / length;
    into[k + 2] = z / length;
  }
  return into;
}

/**
 * Computes each drawn vertex's place on the print's image with one affine map per piece, as in the
 * flat pattern.
 * @param outline points of the pieces on the print: as drafted, or as cut
 */
export function printPlaces(
  {mesh, firsts}: Pick<Cloth, 'mesh' | 'firsts'>,
  alignments: readonly Alignment[],
  print: Print,
  into: Float32Array,
  outline: 'rest' | 'shape' = 'shape',
): void {
  for (const [number, piece] of mesh.pieces.entries()) {
    const alignment = alignments[number];
    if (!alignment) continue;
    const places = piece[outline];
    const at = (k: number): Point => [places[2 * k] ?? 0, places[2 * k + 1] ?? 0];
    const map = imageCoordinates(print, alignment, at(0));
    const first = firsts[number] ?? 0;
    for (let k = 0; 2 * k < places.length; k++) {
      const [u, v] = apply(map, at(k));
      into[2 * (first + k)] = u;
      into[2 * (first + k) + 1] = v;
    }
  }
}
