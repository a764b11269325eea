/**
 * The container of a binary glTF 2.0 file:
 * https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
 */

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
export class GlbFile {
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
