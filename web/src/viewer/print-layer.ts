/** The fabric: each piece filled with its part of the print. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  LinearSRGBColorSpace,
  Mesh,
  ShaderMaterial,
  type Texture,
} from 'three';

import type {Alignment, Point} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {ontoSheet} from '../model/geometry/sheet-place.js';
import {apply} from '../model/geometry/plane-map.js';
import {between, nearestLike} from './morph.js';
import {imageCoordinates} from '../model/print/image-coordinates.js';
import type {ScenePiece} from '../scene/scene.js';

/** Unprinted fabric. */
const bareFabric = new Color().setRGB(0.925, 0.91, 0.87, LinearSRGBColorSpace);

/** Draws a texture's own pixel values: no light, no tone mapping, no colour conversion. */
export class PrintMaterial extends ShaderMaterial {
  declare uniforms: {tile: {value: Texture | null}; fabric: {value: Color}};

  constructor() {
    super({
      uniforms: {tile: {value: null}, fabric: {value: bareFabric}},
      vertexShader: `
      attribute float printed;
      varying vec2 at;
      varying float isPrinted;
      void main() {
        at = uv;
        isPrinted = printed;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
      fragmentShader: `
      uniform sampler2D tile;
      uniform vec3 fabric;
      varying vec2 at;
      varying float isPrinted;
      void main() {
        vec3 ink = texture2D(tile, at).rgb;
        gl_FragColor = vec4(isPrinted > 0.5 ? ink : fabric, 1.0);
      }`,
      depthTest: false,
      depthWrite: false,
    });
  }
}

/** Vertices in piece coordinates, and the pieces' places on the sheet and on the print. */
interface PiecePlaces {
  readonly points: Float64Array;
  readonly offsets: readonly Point[];
  readonly alignments: readonly Alignment[];
}

interface Way {
  readonly from: PiecePlaces;
  /** Alignments equivalent to those at the end. */
  readonly to: readonly Alignment[];
  /** Middles of the pieces, used as centres of rotation. */
  readonly middles: readonly Point[];
}

/**
 * One mesh of all pieces. Image coordinates are affine on a piece, so the hardware's mipmaps and
 * anisotropy are right.
 */
export class PrintLayer {
  readonly object: Mesh<BufferGeometry, PrintMaterial>;
  readonly #positions: BufferAttribute;
  readonly #coordinates: BufferAttribute;
  /** Number of vertices of each piece. */
  readonly #counts: readonly number[];
  readonly #turned: readonly boolean[];
  /** Final places of the pieces; `#shown` holds the current ones. */
  #own: PiecePlaces;
  #shown: PiecePlaces;
  #way: Way | undefined;
  #print: Print;

  constructor(pieces: readonly ScenePiece[], print: Print, material: PrintMaterial) {
    this.#print = print;
    this.#counts = pieces.map(({points}) => points.length);
    this.#turned = pieces.map(({isTurned = false}) => isTurned);
    const count = this.#counts.reduce((sum, one) => sum + one, 0);
    const printed = new Uint8Array(count);
    const indices: number[] = [];
    let first = 0;
    for (const {points, triangles, plain} of pieces) {
      printed.fill(plain ? 0 : 1, first, first + points.length);
      for (const [i, j, k] of triangles) indices.push(first + i, first + j, first + k);
      first += points.length;
    }
    const points = Float64Array.from(pieces.flatMap((piece) => piece.points.flat()));
    const offsets = pieces.map(({offset}) => offset);
    this.#own = {points, offsets, alignments: pieces.map(({alignment}) => alignment)};
    this.#shown = this.#own;
    this.#positions = new BufferAttribute(new Float32Array(3 * count), 3);
    this.#coordinates = new BufferAttribute(new Float32Array(2 * count), 2);
    this.#coordinates.setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.#positions);
    geometry.setAttribute('uv', this.#coordinates);
    geometry.setAttribute('printed', new BufferAttribute(printed, 1));
    geometry.setIndex(indices);
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.#place();
    this.#lay();
  }

  /** Current places of the pieces. */
  get places(): PiecePlaces {
    return this.#shown;
  }

  /** Returns whether `blend` has not reached the end since the last `comeFrom`. */
  get isOnItsWay(): boolean {
    return this.#way !== undefined;
  }

  /** Aligns the same pieces with the print. */
  align(pieces: readonly Pick<ScenePiece, 'alignment'>[], print: Print): void {
    this.#print = print;
    const alignments = pieces.map(({alignment}) => alignment);
    this.#own = {...this.#own, alignments};
    this.#shown = this.#way ? {...this.#shown, alignments} : this.#own;
    this.#lay();
  }

  /**
   * Sets the start of `blend`: places of the same pieces. On the print they take the shortest way
   * to an equivalent alignment.
   */
  comeFrom(from: PiecePlaces): void {
    let vertex = 0;
    const middles = this.#counts.map((count) =>
      middle(this.#own.points, vertex, (vertex += count)),
    );
    const to = this.#own.alignments.map((end, k) =>
      nearestLike(this.#print, from.alignments[k] ?? end, end, middles[k] ?? [0, 0]),
    );
    this.#way = {from, to, middles};
  }

  /**
   * Draws the pieces between the start and their own places; a share of 1 gives exactly their own
   * places.
   */
  blend(share: number): void {
    const [way, own] = [this.#way, this.#own];
    if (!way) return;
    if (share === 1) {
      this.#shown = own;
      this.#way = undefined;
    } else {
      const {from, to, middles} = way;
      const mixed = (a: number, b: number): number => b + (1 - share) * (a - b);
      this.#shown = {
        points: own.points.map((end, k) => mixed(from.points[k] ?? end, end)),
        offsets: own.offsets.map(([x, y], k): Point => {
          const [fromX, fromY] = from.offsets[k] ?? [x, y];
          return [mixed(fromX, x), mixed(fromY, y)];
        }),
        alignments: to.map((end, k) =>
          between(from.alignments[k] ?? end, end, share, middles[k] ?? [0, 0]),
        ),
      };
    }
    this.#place();
    this.#lay();
  }

  dispose(): void {
    this.object.geometry.dispose();
  }

  #place(): void {
    const {points, offsets} = this.#shown;
    let vertex = 0;
    for (const [piece, offset] of offsets.entries()) {
      const place = {offset, isTurned: this.#turned[piece] ?? false};
      for (const end = vertex + (this.#counts[piece] ?? 0); vertex < end; vertex++) {
        const own: Point = [points[2 * vertex] ?? 0, points[2 * vertex + 1] ?? 0];
        this.#positions.setXY(vertex, ...ontoSheet(place, own));
      }
    }
    this.#positions.needsUpdate = true;
  }

  #lay(): void {
    const {points, alignments} = this.#shown;
    let vertex = 0;
    for (const [piece, alignment] of alignments.entries()) {
      const near: Point = [points[2 * vertex] ?? 0, points[2 * vertex + 1] ?? 0];
      const map = imageCoordinates(this.#print, alignment, near);
      for (const end = vertex + (this.#counts[piece] ?? 0); vertex < end; vertex++) {
        const [u, v] = apply(map, [points[2 * vertex] ?? 0, points[2 * vertex + 1] ?? 0]);
        this.#coordinates.setXY(vertex, u, v);
      }
    }
    this.#coordinates.needsUpdate = true;
  }
}

/** Returns the mean of the vertices from `first` up to `end`. */
function middle(points: Float64Array, first: number, end: number): Point {
  let [x, y] = [0, 0];
  for (let k = first; k < end; k++) {
    x += points[2 * k] ?? 0;
    y += points[2 * k + 1] ?? 0;
  }
  const count = Math.max(1, end - first);
  return [x / count, y / count];
}
