/** GPU buffers of a drape's mesh: moving positions and normals, and coordinates on the print. */
import {BufferAttribute, BufferGeometry, DynamicDrawUsage} from 'three';

import type {DrapeMesh} from '../../model/result/draped-garment.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Alignment, Point} from '../../model/geometry/vectors.js';
import type {Print} from '../../model/print/repeating-print.js';
import {apply} from '../../model/geometry/plane-map.js';
import {imageCoordinates} from '../../model/print/image-coordinates.js';
import {hemPlaces, hollows, openEdges, type OpenEdge} from './relief.js';

/** Attributes of a drawn vertex that change, and their numbers of components. */
const moving = {position: 3, normal: 3, uv: 2, drafted: 2, printed: 1, hollow: 1} as const;
/** Those that a mesh keeps. */
const lasting = {shape: 2, piece: 1, hem: 2} as const;
const attributes = {...moving, ...lasting};
type Attribute = keyof typeof attributes;

export class FabricLayer {
  readonly geometry = new BufferGeometry();
  /** The fabric's thickness along its open edges. */
  readonly hems: BufferGeometry;
  readonly cloth: Cloth;
  /** Positions of the mesh's vertices as x, y, z triples. [cm] */
  positions: Float32Array = new Float32Array();
  readonly normals: Float32Array<ArrayBuffer>;
  readonly #hollows: Float32Array;
  /** Drawn vertex of each vertex of the hems. */
  readonly #hemmed: Uint32Array;
  #scene: PatternScene | undefined;
  /** The drafted scene. */
  #before: PatternScene | undefined;

  constructor(mesh: DrapeMesh) {
    this.cloth = clothOf(mesh);
    const {pieces, shape, triangles, firsts} = this.cloth;
    this.normals = new Float32Array(3 * mesh.size);
    this.#hollows = new Float32Array(mesh.size);
    addAttributes(this.geometry, pieces.length);
    this.geometry.setIndex(new BufferAttribute(triangles, 1));
    const open = openEdges(mesh);
    this.hems = hemsOf(open);
    this.#hemmed = Uint32Array.from(
      open.flatMap(({piece, from, to}) =>
        [from, from, to, to].map((k) => k + (firsts[piece] ?? 0)),
      ),
    );
    this.#fill('shape', (array) => {
      array.set(shape);
    });
    this.#fill('piece', (array) => {
      array.set(pieces);
    });
    this.#fill('hem', (array) => {
      for (const [number, piece] of mesh.pieces.entries()) {
        const own = open.filter((edge) => edge.piece === number);
        array.set(hemPlaces(piece, own), 2 * (firsts[number] ?? 0));
      }
    });
  }

  /** Moves the mesh. */
  pose(positions: Float32Array): void {
    this.positions = positions;
    const {cloth, normals} = this;
    normalsOf(positions, cloth.welded, normals);
    hollows(positions, normals, cloth.welded, this.#hollows);
    this.#fill('position', (array) => {
      putToDrawn(cloth, positions, array);
    });
    this.#fill('normal', (array) => {
      putToDrawn(cloth, normals, array);
    });
    this.#fill('hollow', (array) => {
      for (let k = 0; k < array.length; k++) array[k] = this.#hollows[cloth.sewn[k] ?? 0] ?? 0;
    });
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
      this.#fill('uv', (array) => {
        printPlaces(this.cloth, alignments, print, array);
      });
    }
    this.#fill('printed', (array) => {
      this.cloth.pieces.forEach((piece, k) => (array[k] = pieces[piece]?.plain ? 0 : 1));
    });
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
    this.#fill('drafted', (array) => {
      printPlaces(this.cloth, alignments, print, array, 'rest');
    });
  }

  isOf({pieces}: PatternScene): boolean {
    const {mesh} = this.cloth;
    return (
      pieces.length === mesh.pieces.length &&
      mesh.pieces.every(({name}, k) => name === pieces[k]?.name)
    );
  }

  dispose(): void {
    this.geometry.dispose();
    this.hems.dispose();
  }

  /** Changes an attribute of the fabric, and with it that of the hems. */
  #fill(name: Attribute, change: (array: Float32Array) => void): void {
    const from = arrayOf(this.geometry, name);
    change(from);
    const into = arrayOf(this.hems, name);
    const size = attributes[name];
    this.#hemmed.forEach((vertex, k) => {
      for (let c = 0; c < size; c++) into[size * k + c] = from[size * vertex + c] ?? 0;
    });
  }
}

function addAttributes(geometry: BufferGeometry, count: number): void {
  for (const [name, size] of Object.entries(attributes)) {
    const attribute = new BufferAttribute(new Float32Array(size * count), size);
    if (name in moving) attribute.setUsage(DynamicDrawUsage);
    geometry.setAttribute(name, attribute);
  }
}

function arrayOf(geometry: BufferGeometry, name: Attribute): Float32Array {
  const attribute = geometry.getAttribute(name) as BufferAttribute;
  attribute.needsUpdate = true;
  return attribute.array as Float32Array;
}

/** Returns a strip along each open edge, as high as the fabric is thick. */
function hemsOf(open: readonly OpenEdge[]): BufferGeometry {
  const geometry = new BufferGeometry();
  addAttributes(geometry, 4 * open.length);
  const sides = Float32Array.from({length: 4 * open.length}, (_, k) => (k % 2 === 0 ? -1 : 1));
  geometry.setAttribute('side', new BufferAttribute(sides, 1));
  geometry.setIndex(open.flatMap((_, k) => [0, 2, 1, 1, 2, 3].map((corner) => 4 * k + corner)));
  return geometry;
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
