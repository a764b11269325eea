/** Reads a binary glTF file by its specification, independently of the writer. */

interface GltfPrimitive {
  readonly attributes: Readonly<Record<string, number>>;
  readonly indices: number;
  readonly material: number;
}

interface Gltf {
  readonly scenes: readonly {readonly nodes: readonly number[]}[];
  readonly nodes: readonly {readonly name: string; readonly mesh: number}[];
  readonly meshes: readonly {readonly primitives: readonly GltfPrimitive[]}[];
  readonly materials: readonly {
    readonly name: string;
    readonly pbrMetallicRoughness: {readonly baseColorTexture?: object};
  }[];
  readonly accessors: readonly {
    readonly bufferView: number;
    readonly componentType: number;
    readonly count: number;
    readonly type: 'SCALAR' | 'VEC2' | 'VEC3';
  }[];
  readonly bufferViews: readonly {readonly byteOffset: number; readonly byteLength: number}[];
  readonly images?: readonly {readonly bufferView: number; readonly mimeType: string}[];
  readonly samplers?: readonly object[];
  readonly extensionsUsed?: readonly string[];
  readonly extras: Readonly<Record<string, unknown>>;
}

interface Glb {
  readonly json: Gltf;
  /** Values of an accessor: one list per vertex, or one number per index. */
  readonly vectors: (accessor: number) => readonly (readonly number[])[];
  readonly bytesOf: (bufferView: number) => Uint8Array;
}

export function readGlb(file: Uint8Array): Glb {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const jsonLength = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + jsonLength))) as Gltf;
  const binary = 28 + jsonLength;
  const viewOf = (number: number) => {
    const found = json.bufferViews[number];
    if (!found) throw new Error(`there is no buffer view ${number}`);
    return found;
  };
  return {
    json,
    bytesOf: (number) => {
      const {byteOffset, byteLength} = viewOf(number);
      return file.subarray(binary + byteOffset, binary + byteOffset + byteLength);
    },
    vectors: (number) => {
      const accessor = json.accessors[number];
      if (!accessor) throw new Error(`there is no accessor ${number}`);
      const width = {SCALAR: 1, VEC2: 2, VEC3: 3}[accessor.type];
      const start = binary + viewOf(accessor.bufferView).byteOffset;
      return Array.from({length: accessor.count}, (_, k) =>
        Array.from({length: width}, (_, c) => {
          const at = start + 4 * (width * k + c);
          return accessor.componentType === 5126
            ? view.getFloat32(at, true)
            : view.getUint32(at, true);
        }),
      );
    },
  };
}
