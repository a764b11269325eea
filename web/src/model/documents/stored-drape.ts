/**
 * A drape in a small file, which a page displays before the solver is loaded: a header in JSON and
 * lists of numbers, deflated. `npm run draft` writes it.
 */
import type {Symmetry} from '../garment/symmetries.js';
import type {Alignment} from '../geometry/vectors.js';
import type {Drape, DrapedPiece, DrapedSeamSide, Form} from '../result/draped-garment.js';
import {listsIn, NumberList, walkedMesh, type WalkNumbers} from './mesh-walk.js';

/** Units of the stored coordinates: of pieces, of the garment in space, and of the form. [cm] */
export const units = {plane: 0.03, space: 0.03, form: 0.05} as const;

export interface StoredHeader extends Pick<Drape, 'fabric' | 'check' | 'notes'> {
  readonly format: 'seamwise-stored-drape/1';
  readonly sample: {readonly style: string; readonly size: string; readonly print: string};
  readonly symmetries: readonly Symmetry[];
  readonly form: Omit<Form, 'surface'>;
  readonly pieces: readonly (Pick<DrapedPiece, 'name' | 'grainAngle' | 'layer' | 'part'> & {
    readonly alignment: Alignment;
    readonly triangles: number;
  })[];
  /** For each seam, the pieces of its sides and the number of vertices of a side. */
  readonly seams: readonly (readonly [a: number, b: number, count: number])[];
  /** Number of triangles of the form's surface. */
  readonly surface: number;
}

export interface StoredDrape extends Pick<StoredHeader, 'sample' | 'symmetries'> {
  /** Alignment of each piece with the print. */
  readonly alignments: readonly Alignment[];
  readonly drape: Drape;
}

/** The lists of a file: a walk over each piece, over the form, and the vertices of seams. */
interface StoredNumbers {
  readonly pieces: readonly WalkNumbers[];
  readonly form: WalkNumbers;
  readonly seams: NumberList;
}

/** Coordinates of a piece's vertex: x, y on the piece, and x, y, z in space. */
const [pieceSize, formSize] = [5, 3];

/** Lists in the order of the file. */
export const listsOf = ({pieces, form, seams}: StoredNumbers): readonly NumberList[] => [
  ...[...pieces, form].flatMap(({steps, known, coordinates}) => [steps, known, ...coordinates]),
  seams,
];

function numbersIn(lists: readonly NumberList[], count: number): StoredNumbers {
  let at = 0;
  const next = (): NumberList => lists[at++] ?? new NumberList();
  const walk = (size: number): WalkNumbers => ({
    steps: next(),
    known: next(),
    coordinates: Array.from({length: size}, next),
  });
  return {
    pieces: Array.from({length: count}, () => walk(pieceSize)),
    form: walk(formSize),
    seams: next(),
  };
}

/** Reads a stored drape. @throws {TypeError} if the file is damaged */
export async function readStoredDrape(file: Blob): Promise<StoredDrape> {
  const inflated = file.stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(inflated).arrayBuffer());
  const size = new DataView(bytes.buffer).getUint32(0, true);
  const text = new TextDecoder().decode(bytes.subarray(4, 4 + size));
  const header = JSON.parse(text) as StoredHeader;
  const {sample, symmetries, pieces} = header;
  const numbers = numbersIn(listsIn(bytes.subarray(4 + size)), pieces.length);
  const alignments = pieces.map(({alignment}) => alignment);
  return {sample, symmetries, alignments, drape: drapeOf(header, numbers)};
}

function drapeOf(header: StoredHeader, numbers: StoredNumbers): Drape {
  const walks = header.pieces.map(({triangles}, k) =>
    walkedMesh(triangles, numbers.pieces[k] ?? numbers.form),
  );
  const sides = seamSides(header, numbers.seams);
  const {sewn, size} = sewnVertices(
    walks.map(({vertices}) => vertices.length),
    sides,
  );
  const positions = new Float64Array(3 * size);
  const pieces = header.pieces.map((piece, k): DrapedPiece => {
    const {triangles, vertices} = walks[k] ?? {triangles: new Uint32Array(), vertices: []};
    const own = sewn[k] ?? new Uint32Array();
    vertices.forEach(([, , ...place], vertex) => {
      positions.set(
        place.map((one) => one * units.space),
        3 * (own[vertex] ?? 0),
      );
    });
    const shape = Float64Array.from(
      vertices.flatMap(([x = 0, y = 0]) => [x, y]),
      scaled,
    );
    return {
      ...{name: piece.name, grainAngle: piece.grainAngle, layer: piece.layer, part: piece.part},
      // the drafted piece is needed for the comparison only, and differs by millimetres
      ...{rest: shape, shape, triangles, sewn: own},
      ...{outline: outlineOf(triangles), resultVertices: new Uint32Array()},
    };
  });
  const surface = walkedMesh(header.surface, numbers.form);
  const vertices = Float32Array.from(surface.vertices.flat(), (one) => one * units.form);
  return {
    mesh: {pieces, seams: sides, mirrors: [], size},
    positions,
    form: {...header.form, surface: {vertices, triangles: surface.triangles}},
    stages: [],
    ...{fabric: header.fabric, check: header.check, notes: header.notes},
  };
}

const scaled = (one: number): number => one * units.plane;

type Sides = readonly {readonly a: DrapedSeamSide; readonly b: DrapedSeamSide}[];

function seamSides({seams}: StoredHeader, numbers: NumberList): Sides {
  const side = (piece: number, count: number): DrapedSeamSide => {
    let vertex = 0;
    const vertices = Uint32Array.from({length: count}, () => (vertex += numbers.next()));
    return {piece, vertices};
  };
  return seams.map(([a, b, count]) => ({a: side(a, count), b: side(b, count)}));
}

/**
 * Numbers the vertices of pieces anew, so that vertices that a seam joins have the same number.
 * @param counts number of vertices of each piece
 */
function sewnVertices(
  counts: readonly number[],
  seams: Sides,
): {readonly sewn: readonly Uint32Array[]; readonly size: number} {
  const firsts = counts.map((_, k) => counts.slice(0, k).reduce((sum, one) => sum + one, 0));
  const total = counts.reduce((sum, one) => sum + one, 0);
  const parents = Array.from({length: total}, (_, k) => k);
  const root = (vertex: number): number => {
    let at = vertex;
    while (parents[at] !== at) at = parents[at] ?? at;
    return at;
  };
  for (const {a, b} of seams) {
    a.vertices.forEach((vertex, k) => {
      const one = root((firsts[a.piece] ?? 0) + vertex);
      const other = root((firsts[b.piece] ?? 0) + (b.vertices[k] ?? 0));
      parents[Math.max(one, other)] = Math.min(one, other);
    });
  }
  const numbers = new Map<number, number>();
  const sewn = counts.map((count, piece) =>
    Uint32Array.from({length: count}, (_, k) => {
      const at = root((firsts[piece] ?? 0) + k);
      if (!numbers.has(at)) numbers.set(at, numbers.size);
      return numbers.get(at) ?? 0;
    }),
  );
  return {sewn, size: numbers.size};
}

/** Vertices of the outline, counter-clockwise, from the edges that have one triangle. */
function outlineOf(triangles: Uint32Array): Uint32Array {
  const next = new Map<number, number>();
  const inner = new Set<string>();
  const edges: [number, number][] = [];
  for (let k = 0; k < triangles.length; k += 3) {
    for (let j = 0; j < 3; j++) {
      const [from = 0, to = 0] = [triangles[k + j], triangles[k + ((j + 1) % 3)]];
      edges.push([from, to]);
      inner.add(`${from} ${to}`);
    }
  }
  for (const [from, to] of edges) if (!inner.has(`${to} ${from}`)) next.set(from, to);
  const [start = 0] = next.keys();
  const outline = [start];
  for (let at = next.get(start); at !== undefined && at !== start; at = next.get(at))
    outline.push(at);
  return Uint32Array.from(outline);
}
