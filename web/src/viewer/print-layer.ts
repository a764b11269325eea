/** The cloth: every piece filled with the print as the piece lies on it. */
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

import type {Print} from '../model/print.js';
import {apply} from '../model/wallpaper.js';
import {imageCoordinates} from './print-coordinates.js';
import type {ScenePiece} from './scene.js';

/** Unprinted cloth. */
const bareCloth = new Color().setRGB(0.925, 0.91, 0.87, LinearSRGBColorSpace);

/** Draws a texture's own pixel values: no light, no tone mapping, no conversion of colours. */
export class PrintMaterial extends ShaderMaterial {
  declare uniforms: {tile: {value: Texture | null}; cloth: {value: Color}};

  constructor() {
    super({
      uniforms: {tile: {value: null}, cloth: {value: bareCloth}},
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
      uniform vec3 cloth;
      varying vec2 at;
      varying float isPrinted;
      void main() {
        vec3 ink = texture2D(tile, at).rgb;
        gl_FragColor = vec4(isPrinted > 0.5 ? ink : cloth, 1.0);
      }`,
      depthTest: false,
      depthWrite: false,
    });
  }
}

/** One mesh of all pieces. Image coordinates are affine on a piece, so the hardware's mipmaps and anisotropy are right. */
export class PrintLayer {
  readonly object: Mesh<BufferGeometry, PrintMaterial>;
  readonly #coordinates: BufferAttribute;

  constructor(pieces: readonly ScenePiece[], material: PrintMaterial) {
    const count = pieces.reduce((sum, {points}) => sum + points.length, 0);
    const positions = new Float32Array(3 * count);
    const printed = new Uint8Array(count);
    const indices: number[] = [];
    let first = 0;
    for (const {points, triangles, offset, plain} of pieces) {
      printed.fill(plain ? 0 : 1, first, first + points.length);
      points.forEach(([x, y], k) => {
        positions.set([x + offset[0], y + offset[1], 0], 3 * (first + k));
      });
      for (const [i, j, k] of triangles) indices.push(first + i, first + j, first + k);
      first += points.length;
    }
    this.#coordinates = new BufferAttribute(new Float32Array(2 * count), 2);
    this.#coordinates.setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('uv', this.#coordinates);
    geometry.setAttribute('printed', new BufferAttribute(printed, 1));
    geometry.setIndex(indices);
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  /** Lays the pieces, the same as before, on the print by their alignments. */
  align(pieces: readonly ScenePiece[], print: Print): void {
    let vertex = 0;
    for (const {points, alignment} of pieces) {
      const map = imageCoordinates(print, alignment, points[0] ?? [0, 0]);
      for (const point of points) {
        const [u, v] = apply(map, point);
        this.#coordinates.setXY(vertex++, u, v);
      }
    }
    this.#coordinates.needsUpdate = true;
  }

  dispose(): void {
    this.object.geometry.dispose();
  }
}
