/**
 * Lines with a width in pixels at any zoom: one rectangle per edge, with the distance from the edge
 * per pixel.
 */
import {
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  BufferAttribute,
  Mesh,
  ShaderMaterial,
  Vector2,
} from 'three';

import {distance, type Point} from '../model/geometry/vectors.js';

export interface LineStyle {
  /** Red, green and blue as shown on the screen, from 0 to 255. */
  readonly colour: readonly [number, number, number];
  /** [CSS px] */
  readonly width: number;
  /** Lengths of dash and gap, before round caps. [CSS px] */
  readonly dash?: readonly [number, number];
}

/** A polyline on the sheet with one style per edge, or one for all. */
export interface Stroke {
  readonly points: readonly Point[];
  readonly closed?: boolean;
  /** Offset of the line at each point at any zoom, in widths of the line. Default: none. */
  readonly shifts?: readonly Point[];
  readonly styles: LineStyle | readonly LineStyle[];
}

/** Shared by all layers of a view; its uniforms are set for every frame. */
export class LineMaterial extends ShaderMaterial {
  declare uniforms: {
    /** Size of the drawing buffer. [device px] */
    buffer: {value: Vector2};
    /** [device px per cm] */
    scale: {value: number};
    /** [device px per CSS px] */
    ratio: {value: number};
    /** Factor of all widths; lines are thinner on small pieces. */
    weight: {value: number};
  };

  constructor() {
    super({
      uniforms: {
        buffer: {value: new Vector2()},
        scale: {value: 1},
        ratio: {value: 1},
        weight: {value: 1},
      },
      vertexShader: `
      attribute vec4 ends;
      attribute vec4 shifts;
      attribute vec2 along;
      attribute vec3 ink;
      attribute vec3 stroke;
      uniform vec2 buffer;
      uniform float scale;
      uniform float ratio;
      uniform float weight;
      varying vec3 colour;
      varying vec2 at;      // along and across the edge, from its start [device px]
      varying vec2 extent;  // length of the edge, half the width of the line [device px]
      varying vec3 dashes;  // way to the edge's start, half a dash, period [device px]
      void main() {
        float width = stroke.x * weight * ratio;
        vec2 way = (ends.zw - ends.xy) * scale + (shifts.zw - shifts.xy) * width;
        float length = length(way);
        vec2 forward = length > 0.0 ? way / length : vec2(1.0, 0.0);
        float halfWidth = 0.5 * width;
        float reach = halfWidth + 1.0;
        at = vec2(mix(-reach, length + reach, position.x), position.y * reach);
        extent = vec2(length, halfWidth);
        dashes = vec3(along.x * scale, 0.5 * stroke.y * ratio, (stroke.y + stroke.z) * ratio);
        colour = ink;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(ends.xy, 0.0, 1.0);
        vec2 across = vec2(-forward.y, forward.x);
        gl_Position.xy += 2.0 * (shifts.xy * width + forward * at.x + across * at.y) / buffer;
      }`,
      fragmentShader: `
      varying vec3 colour;
      varying vec2 at;
      varying vec2 extent;
      varying vec3 dashes;
      void main() {
        float onEdge = clamp(at.x, 0.0, extent.x);
        float beyond = abs(at.x - onEdge);
        if (dashes.z > dashes.y * 2.0) {
          float s = dashes.x + onEdge - dashes.y;
          float offCentre = abs(s - dashes.z * floor(s / dashes.z + 0.5));
          beyond = max(beyond, offCentre - dashes.y);
        }
        float distance = length(vec2(max(beyond, 0.0), at.y));
        float cover = clamp(extent.y + 0.5 - distance, 0.0, 1.0);
        if (cover == 0.0) discard;
        gl_FragColor = vec4(colour * cover, cover);
      }`,
      transparent: true,
      premultipliedAlpha: true,
      depthTest: false,
      depthWrite: false,
    });
  }
}

const styleOf = ({styles}: Stroke, edge: number): LineStyle =>
  'width' in styles ? styles : (styles[edge] ?? {colour: [0, 0, 0], width: 0});

const edgeCount = ({points, closed}: Stroke): number =>
  closed ? points.length : Math.max(points.length - 1, 0);

/** Ends of all edges of a layer, and their shifts. */
interface LinePlaces {
  readonly ends: Float32Array;
  readonly shifts: Float32Array;
}

/** Strokes in their drawing order. */
export class LineLayer {
  readonly object: Mesh<InstancedBufferGeometry, LineMaterial>;
  readonly #ends: InstancedBufferAttribute;
  readonly #shifts: InstancedBufferAttribute;
  /** The strokes' final places, once they have been drawn elsewhere. */
  #own: LinePlaces | undefined;
  #from: LinePlaces | undefined;
  readonly #ink: InstancedBufferAttribute;
  readonly #stroke: InstancedBufferAttribute;

  constructor(strokes: readonly Stroke[], material: LineMaterial, order: number) {
    const count = strokes.reduce((sum, stroke) => sum + edgeCount(stroke), 0);
    const ends = new Float32Array(4 * count);
    const along = new Float32Array(2 * count);
    const shifts = new Float32Array(4 * count);
    let edge = 0;
    for (const stroke of strokes) {
      let way = 0;
      for (let k = 0; k < edgeCount(stroke); k++, edge++) {
        const from = stroke.points[k] ?? [0, 0];
        const to = stroke.points[(k + 1) % stroke.points.length] ?? from;
        const start = way;
        way += distance(from, to);
        ends.set([...from, ...to], 4 * edge);
        along.set([start, way], 2 * edge);
        const [first, last] = [stroke.shifts?.[k], stroke.shifts?.[(k + 1) % stroke.points.length]];
        if (first && last) shifts.set([...first, ...last], 4 * edge);
      }
    }
    this.#ink = new InstancedBufferAttribute(new Uint8Array(3 * count), 3, true);
    this.#stroke = new InstancedBufferAttribute(new Float32Array(3 * count), 3);
    const geometry = new InstancedBufferGeometry();
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.#ends = new InstancedBufferAttribute(ends, 4);
    this.#shifts = new InstancedBufferAttribute(shifts, 4);
    geometry.setAttribute('ends', this.#ends);
    geometry.setAttribute('along', new InstancedBufferAttribute(along, 2));
    geometry.setAttribute('shifts', this.#shifts);
    geometry.setAttribute('ink', this.#ink.setUsage(DynamicDrawUsage));
    geometry.setAttribute('stroke', this.#stroke.setUsage(DynamicDrawUsage));
    geometry.instanceCount = count;
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.restyle(strokes);
  }

  /** Changes the styles of the same strokes. */
  restyle(strokes: readonly Stroke[]): void {
    let edge = 0;
    for (const stroke of strokes) {
      for (let k = 0; k < edgeCount(stroke); k++, edge++) {
        const {colour, width, dash = [0, 0]} = styleOf(stroke, k);
        this.#ink.array.set(colour, 3 * edge);
        this.#stroke.setXYZ(edge, width, dash[0], dash[1]);
      }
    }
    this.#ink.needsUpdate = true;
    this.#stroke.needsUpdate = true;
  }

  /** Current places of the lines. */
  get places(): LinePlaces {
    const [ends, shifts] = [this.#ends, this.#shifts].map(({array}) => Float32Array.from(array));
    return {ends: ends ?? new Float32Array(), shifts: shifts ?? new Float32Array()};
  }

  /** Sets the start of `blend`: places of the same number of edges, or none. */
  comeFrom(from: LinePlaces | undefined): void {
    this.#from = from;
  }

  /**
   * Draws the lines between the start and their own places; a share of 1 gives exactly their own
   * places.
   */
  blend(share: number): void {
    const from = this.#from;
    if (from?.ends.length !== this.#ends.array.length) return;
    this.#own ??= this.places;
    blend(this.#ends, from.ends, this.#own.ends, share);
    blend(this.#shifts, from.shifts, this.#own.shifts, share);
    if (share === 1) this.#from = undefined;
  }

  dispose(): void {
    this.object.geometry.dispose();
  }
}

/** Mixes two arrays; a share of 1 gives exactly `to`. */
function blend(
  attribute: InstancedBufferAttribute,
  from: Float32Array,
  to: Float32Array,
  share: number,
): void {
  const {array} = attribute;
  for (let k = 0; k < to.length; k++) {
    const [start = 0, end = 0] = [from[k], to[k]];
    array[k] = end + (1 - share) * (start - end);
  }
  attribute.needsUpdate = true;
}
