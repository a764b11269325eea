/**
 * A draped garment as binary glTF 2.0 for viewers, shops and other programs: metres, y up, front
 * towards +z. The texture coordinates include the place of the print, since many viewers ignore
 * texture transforms.
 */
import {SolverError} from '../../model/base/failure.js';
import type {Drape, DrapedPiece, Surface} from '../../model/result/draped-garment.js';
import type {Point} from '../../model/geometry/vectors.js';
import {imageCoordinates} from '../../model/print/image-coordinates.js';
import type {Print} from '../../model/print/repeating-print.js';
import type {SolveResult} from '../../model/result/result.js';
import {packageVersion} from '../../model/base/version.js';
import {apply} from '../../model/geometry/plane-map.js';

/** One cell of a print as an image that glTF can contain. */
export interface CellPicture {
  readonly bytes: Uint8Array;
  readonly type: 'image/png' | 'image/jpeg';
}

export interface GlbOptions {
  /**
   * Image of the print's cell. Without it the fabric is white and has the same texture coordinates.
   */
  readonly picture?: CellPicture;
  /** Names of the pieces of unprinted fabric. */
  readonly plain?: readonly string[];
  /**
   * Adds attributes per vertex: the number of its piece, `_PIECE`, and its point on the piece as
   * cut, `_SHAPE`. [cm]
   */
  readonly attributes?: boolean;
  /** Adds the form on which the garment hangs, as a separate node. */
  readonly form?: boolean;
  /** Name of the garment for the user. */
  readonly garment?: string;
  /** Hash of the result file. */
  readonly sha256?: string;
}

/**
 * Recognises the image of a cell by its first bytes; undefined unless PNG or JPEG, the only types
 * in glTF.
 */
export function cellPicture(bytes: Uint8Array): CellPicture | undefined {
  const begins = (...start: number[]): boolean => start.every((byte, k) => bytes[k] === byte);
  if (begins(0x89, 0x50, 0x4e, 0x47)) return {bytes, type: 'image/png'};
  return begins(0xff, 0xd8, 0xff) ? {bytes, type: 'image/jpeg'} : undefined;
}

/** WebGL constants by which glTF names the wrapping and filtering of a texture. */
const sampler = {wrapS: 10497, wrapT: 10497, magFilter: 9729, minFilter: 9987};

/** Linear base colours of fabric and form: red, green, blue, opacity. */
const white = [0.9, 0.9, 0.88, 1];
const linen = [0.62, 0.54, 0.43, 1];
const roughness = 0.85;

/**
 * Builds the file. Texture coordinates refer to the image of the cell, (0, 0) its upper left
 * corner, on the pieces as cut.
 * @throws {SolverError} `options` when the drape does not belong to this result
 */
export function glb(
  result: Pick<SolveResult, 'pieces'>,
  drape: Pick<Drape, 'mesh' | 'positions' | 'form'>,
  print: Print,
  options: GlbOptions = {},
): Uint8Array {
  const file = new GlbFile();
  const {picture, garment, sha256} = options;
  const isPlain = new Set(options.plain ?? []);
  const fabric = drapedPieces(result, drape, print);
  const groups = [
    {name: 'print', pieces: fabric.filter(({piece}) => !isPlain.has(piece.name))},
    {name: 'plain', pieces: fabric.filter(({piece}) => isPlain.has(piece.name))},
  ].filter(({pieces}) => pieces.length > 0);
  const primitives = groups.map(({pieces}, material) => ({
    ...primitiveOf(file, pieces, options.attributes ?? false),
    material,
  }));
  const materials: object[] = groups.map(({name}) => fabricMaterial(name, picture !== undefined));
  const nodes: object[] = [{name: 'garment', mesh: 0}];
  const meshes: object[] = [{name: 'garment', primitives}];
  if (options.form) {
    materials.push({name: 'linen', pbrMetallicRoughness: matt({baseColorFactor: linen})});
    nodes.push({name: 'form', mesh: 1});
    const form = formPrimitive(file, drape.form.surface);
    meshes.push({name: 'form', primitives: [{...form, material: materials.length - 1}]});
  }
  return file.bytes({
    asset: {version: '2.0', generator: `seamwise ${packageVersion}`},
    scene: 0,
    scenes: [{nodes: nodes.map((_, k) => k)}],
    ...{nodes, meshes, materials},
    ...(picture !== undefined &&
      groups[0]?.name === 'print' && {
        textures: [{sampler: 0, source: 0}],
        samplers: [sampler],
        images: [{bufferView: file.addBytes(picture.bytes), mimeType: picture.type}],
      }),
    extras: {
      format: 'seamwise-glb/1',
      ...(garment !== undefined && {garment}),
      print: {title: print.title, group: print.group, w1: print.w1, w2: print.w2, cell: print.cell},
      ...(sha256 !== undefined && {sha256}),
      units: 'm',
      pieces: drape.mesh.pieces.map(({name}) => name),
    },
  });
}

interface PlacedPiece {
  readonly piece: DrapedPiece;
  readonly index: number;
  /** Three, three and two numbers per vertex. [m], [1], [cells] */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly coordinates: Float32Array;
}

function drapedPieces(
  {pieces}: Pick<SolveResult, 'pieces'>,
  {mesh, positions}: Pick<Drape, 'mesh' | 'positions'>,
  print: Print,
): readonly PlacedPiece[] {
  const normals = normalsOf(
    positions,
    mesh.pieces.map(({triangles, sewn}) => triangles.map((vertex) => sewn[vertex] ?? 0)),
  );
  return mesh.pieces.map((piece, index) => {
    const known = pieces[index];
    if (known?.name !== piece.name) {
      throw new SolverError({
        code: 'options',
        message: `The result has no piece '${piece.name}' there; drape it again.`,
      });
    }
    const points = pointsOf(piece.shape);
    const onPicture = imageCoordinates(print, known.alignment, points[0] ?? [0, 0]);
    return {
      ...{piece, index},
      positions: metres(perVertex(positions, piece.sewn)),
      normals: Float32Array.from(perVertex(normals, piece.sewn)),
      coordinates: Float32Array.from(
        points.flatMap((point) => {
          const [u, v] = apply(onPicture, point);
          return [u, 1 - v];
        }),
      ),
    };
  });
}

const pointsOf = (numbers: Float64Array): readonly Point[] =>
  Array.from({length: numbers.length / 2}, (_, k) => [
    numbers[2 * k] ?? 0,
    numbers[2 * k + 1] ?? 0,
  ]);

const metres = (cm: ArrayLike<number>): Float32Array =>
  Float32Array.from(cm, (value) => value / 100);

/** Three numbers for each vertex of a piece, taken from those of the sewn mesh. */
const perVertex = (ofFabric: Float64Array, sewn: Uint32Array): Float64Array =>
  Float64Array.from({length: 3 * sewn.length}, (_, k) => {
    return ofFabric[3 * (sewn[Math.floor(k / 3)] ?? 0) + (k % 3)] ?? 0;
  });

/**
 * Normals of vertices: the mean of the adjacent triangles' normals, weighted by area. Upwards where
 * there is none.
 */
function normalsOf(positions: ArrayLike<number>, triangles: readonly Uint32Array[]): Float64Array {
  const sums = new Float64Array(positions.length);
  const coordinate = (vertex: number, c: number): number => positions[3 * vertex + c] ?? 0;
  for (const list of triangles) {
    for (let t = 0; t + 2 < list.length; t += 3) {
      const corners = [list[t] ?? 0, list[t + 1] ?? 0, list[t + 2] ?? 0] as const;
      const [a, b, c] = corners;
      const side = (to: number) =>
        [0, 1, 2].map((k) => coordinate(to, k) - coordinate(a, k)) as [number, number, number];
      const [u, v] = [side(b), side(c)];
      const normal = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
      ];
      for (const corner of corners) {
        normal.forEach((value, k) => (sums[3 * corner + k] = (sums[3 * corner + k] ?? 0) + value));
      }
    }
  }
  for (let at = 0; at < sums.length; at += 3) {
    const [x = 0, y = 0, z = 0] = sums.subarray(at, at + 3);
    const length = Math.sqrt(x * x + y * y + z * z); // equal in all engines, unlike Math.hypot
    sums.set(length > 0 ? [x / length, y / length, z / length] : [0, 1, 0], at);
  }
  return sums;
}

function joined(arrays: readonly Float32Array[]): Float32Array {
  const all = new Float32Array(arrays.reduce((length, array) => length + array.length, 0));
  let at = 0;
  for (const array of arrays) {
    all.set(array, at);
    at += array.length;
  }
  return all;
}

/**
 * Each piece has its own vertices, since pieces joined by a seam have different places on the
 * print.
 */
function primitiveOf(file: GlbFile, pieces: readonly PlacedPiece[], attributes: boolean): object {
  const indices: number[] = [];
  let before = 0;
  for (const {piece} of pieces) {
    for (const vertex of piece.triangles) indices.push(before + vertex);
    before += piece.sewn.length;
  }
  const all = (each: (placed: PlacedPiece) => Float32Array) => joined(pieces.map(each));
  return {
    attributes: {
      POSITION: file.addVectors(
        all(({positions}) => positions),
        'VEC3',
        true,
      ),
      NORMAL: file.addVectors(
        all(({normals}) => normals),
        'VEC3',
      ),
      TEXCOORD_0: file.addVectors(
        all(({coordinates}) => coordinates),
        'VEC2',
      ),
      ...(attributes && {
        _PIECE: file.addVectors(
          all(({piece, index}) => new Float32Array(piece.sewn.length).fill(index)),
          'SCALAR',
        ),
        _SHAPE: file.addVectors(
          all(({piece}) => Float32Array.from(piece.shape)),
          'VEC2',
        ),
      }),
    },
    indices: file.addIndices(Uint32Array.from(indices)),
  };
}

function formPrimitive(file: GlbFile, {vertices, triangles}: Surface): object {
  return {
    attributes: {
      POSITION: file.addVectors(metres(vertices), 'VEC3', true),
      NORMAL: file.addVectors(Float32Array.from(normalsOf(vertices, [triangles])), 'VEC3'),
    },
    indices: file.addIndices(triangles),
  };
}

const matt = (colour: object): object => ({
  ...colour,
  metallicFactor: 0,
  roughnessFactor: roughness,
});

const fabricMaterial = (name: string, hasPicture: boolean): object => ({
  name,
  pbrMetallicRoughness: matt(
    name === 'print' && hasPicture
      ? {baseColorTexture: {index: 0, texCoord: 0}}
      : {baseColorFactor: white},
  ),
  doubleSided: true,
});

// The container of a binary glTF 2.0 file:
// https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html

/**
 * The values "glTF", "JSON" and "BIN\0" as little-endian numbers: start of the file, and types of
 * its two chunks.
 */
const magic = 0x46546c67;
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;

const vertexTarget = 34962;
const indexTarget = 34963;
const float = 5126;
const unsignedInt = 5125;

const componentsOf = {SCALAR: 1, VEC2: 2, VEC3: 3} as const;
type VectorType = keyof typeof componentsOf;

const padded = (length: number): number => 4 * Math.ceil(length / 4);

/**
 * Collects the contents of a glTF file's only buffer. Numbers keep the byte order of this machine,
 * which has to be little-endian.
 */
class GlbFile {
  readonly #parts: Uint8Array[] = [];
  readonly #views: object[] = [];
  readonly #accessors: object[] = [];
  #length = 0;

  /** Adds a buffer view. @returns its number */
  addBytes(bytes: Uint8Array, target?: number): number {
    this.#parts.push(bytes);
    const view = {buffer: 0, byteOffset: this.#length, byteLength: bytes.length};
    this.#length += padded(bytes.length);
    return this.#views.push({...view, ...(target !== undefined && {target})}) - 1;
  }

  /**
   * Adds one vector per vertex.
   * @param withBounds adds the bounds that glTF requires for positions
   * @returns the number of the accessor
   */
  addVectors(values: Float32Array, type: VectorType, withBounds = false): number {
    const components = componentsOf[type];
    return this.#addAccessor(values, vertexTarget, {
      ...{componentType: float, count: values.length / components, type},
      ...(withBounds && boundsOf(values, components)),
    });
  }

  addIndices(values: Uint32Array): number {
    return this.#addAccessor(values, indexTarget, {
      ...{componentType: unsignedInt, count: values.length, type: 'SCALAR'},
    });
  }

  #addAccessor(values: Float32Array | Uint32Array, target: number, what: object): number {
    const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
    return this.#accessors.push({bufferView: this.addBytes(bytes, target), ...what}) - 1;
  }

  /** The whole file. @param document all members except buffers, buffer views and accessors */
  bytes(document: object): Uint8Array {
    const json = new TextEncoder().encode(
      JSON.stringify({
        ...document,
        accessors: this.#accessors,
        bufferViews: this.#views,
        buffers: [{byteLength: this.#length}],
      }),
    );
    const jsonLength = padded(json.length);
    const file = new Uint8Array(28 + jsonLength + this.#length);
    const head = [magic, 2, file.length, jsonLength, jsonChunk];
    const view = new DataView(file.buffer);
    head.forEach((word, k) => {
      view.setUint32(4 * k, word, true);
    });
    file.set(json, 20);
    file.fill(0x20, 20 + json.length, 20 + jsonLength);
    let at = 20 + jsonLength;
    view.setUint32(at, this.#length, true);
    view.setUint32(at + 4, binaryChunk, true);
    at += 8;
    for (const part of this.#parts) {
      file.set(part, at);
      at += padded(part.length);
    }
    return file;
  }
}

function boundsOf(values: Float32Array, components: number): {min: number[]; max: number[]} {
  const min = Array.from({length: components}, () => Infinity);
  const max = min.map(() => -Infinity);
  values.forEach((value, k) => {
    const c = k % components;
    min[c] = Math.min(min[c] ?? value, value);
    max[c] = Math.max(max[c] ?? value, value);
  });
  return {min, max};
}
