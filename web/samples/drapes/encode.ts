/** Stores a drape in a small file, which `readStoredDrape` reads. */
import {deflateRawSync} from 'node:zlib';

import type {Surface} from '../../src/model/result/draped-garment.js';
import {
  bytesOfLists,
  edgesOf,
  join,
  NumberList,
  OpenEdges,
  steps,
  type Gate,
  type WalkNumbers,
} from '../../src/model/documents/mesh-walk.js';
import {
  listsOf,
  units,
  type StoredDrape,
  type StoredHeader,
} from '../../src/model/documents/stored-drape.js';

interface Walk {
  readonly numbers: WalkNumbers;
  /** Number of each vertex in the order of the walk. */
  readonly order: ReadonlyMap<number, number>;
}

/**
 * Walks over a mesh.
 * @param at coordinates of a vertex, whole numbers
 * @param size number of coordinates
 */
function walk(
  triangles: ArrayLike<number>,
  at: (vertex: number) => readonly number[],
  size: number,
): Walk {
  const [taken, known] = [new NumberList(), new NumberList()];
  const coordinates = Array.from({length: size}, () => new NumberList());
  const count = triangles.length / 3;
  /** Triangle and third corner of each directed edge. */
  const across = new Map<string, readonly [triangle: number, corner: number]>();
  for (let k = 0; k < count; k++) {
    const [a = 0, b = 0, c = 0] = [triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2]];
    for (const [from, to, corner] of edgesOf(a, b, c)) across.set(`${from} ${to}`, [k, corner]);
  }
  const order = new Map<number, number>();
  const originals: number[] = [];
  const fresh = (vertex: number, predicted: (k: number) => number): number => {
    order.set(vertex, originals.length);
    const place = at(vertex);
    coordinates.forEach(({numbers}, k) => numbers.push((place[k] ?? 0) - predicted(k)));
    return originals.push(vertex) - 1;
  };
  const value = (walked: number, k: number): number => at(originals[walked] ?? 0)[k] ?? 0;
  const done = new Set<number>();
  for (let seed = 0; seed < count; seed++) {
    if (done.has(seed)) continue;
    done.add(seed);
    const border = new OpenEdges();
    const gates: Gate[] = [];
    const a = fresh(triangles[3 * seed] ?? 0, () => 0);
    const b = fresh(triangles[3 * seed + 1] ?? 0, (k) => value(a, k));
    const c = fresh(triangles[3 * seed + 2] ?? 0, (k) => value(b, k));
    join(border, gates, edgesOf(a, b, c));
    for (const [from, to, corner] of gates) {
      if (!border.has(from, to)) continue;
      const [triangle, third] = across.get(`${originals[to]} ${originals[from]}`) ?? [];
      if (triangle === undefined || third === undefined || done.has(triangle)) {
        taken.numbers.push(steps.none);
        border.close(from, to);
        continue;
      }
      done.add(triangle);
      const old = order.get(third);
      let apex: number;
      if (old === undefined) {
        taken.numbers.push(steps.fresh);
        apex = fresh(third, (k) => value(from, k) + value(to, k) - value(corner, k));
      } else {
        apex = old;
        if (border.after(to) === old) taken.numbers.push(steps.after);
        else if (border.before(from) === old) taken.numbers.push(steps.before);
        else {
          taken.numbers.push(steps.known);
          known.numbers.push(old);
        }
      }
      join(border, gates, edgesOf(to, from, apex));
    }
  }
  return {numbers: {steps: taken, known, coordinates}, order};
}

/** Side of the cells whose vertices become one, in the stored surface of the form. [cm] */
const cell = 1.8;

/** Returns a surface with one vertex for each cell of a grid. */
function coarse({vertices, triangles}: Surface): Surface {
  const cells = new Map<string, {readonly vertex: number; count: number; sum: number[]}>();
  const cellOf = Array.from({length: vertices.length / 3}, (_, k) => {
    const place = [...vertices.subarray(3 * k, 3 * k + 3)];
    const name = place.map((one) => Math.floor(one / cell)).join(' ');
    const known = cells.get(name) ?? {vertex: cells.size, count: 0, sum: [0, 0, 0]};
    known.count++;
    known.sum = known.sum.map((one, j) => one + (place[j] ?? 0));
    cells.set(name, known);
    return known.vertex;
  });
  const kept = new Map<string, readonly number[]>();
  for (let k = 0; k < triangles.length; k += 3) {
    const corners = [0, 1, 2].map((j) => cellOf[triangles[k + j] ?? 0] ?? 0);
    const name = [...corners].sort((a, b) => a - b).join(' ');
    if (new Set(corners).size === 3) kept.set(name, corners);
  }
  const places = [...cells.values()].flatMap(({count, sum}) => sum.map((one) => one / count));
  return {
    vertices: Float32Array.from(places),
    triangles: Uint32Array.from([...kept.values()].flat()),
  };
}

const whole = (value: number | undefined, unit: number): number => Math.round((value ?? 0) / unit);

/** @throws {Error} if the sides of a seam have different numbers of vertices */
export function storedDrape({sample, symmetries, alignments, drape}: StoredDrape): Uint8Array {
  const {mesh, positions, form, fabric, check, notes} = drape;
  const walks = mesh.pieces.map(({triangles, shape, sewn}) =>
    walk(
      triangles,
      (vertex) => [
        ...[0, 1].map((k) => whole(shape[2 * vertex + k], units.plane)),
        ...[0, 1, 2].map((k) => whole(positions[3 * (sewn[vertex] ?? 0) + k], units.space)),
      ],
      5,
    ),
  );
  const {vertices, triangles} = coarse(form.surface);
  const surface = walk(
    triangles,
    (vertex) => [0, 1, 2].map((k) => whole(vertices[3 * vertex + k], units.form)),
    3,
  );
  const seams = new NumberList();
  for (const {a, b} of mesh.seams) {
    if (a.vertices.length !== b.vertices.length) throw new Error('A seam has two lengths.');
    for (const {piece, vertices: side} of [a, b]) {
      let before = 0;
      for (const vertex of side) {
        const walked = walks[piece]?.order.get(vertex) ?? 0;
        seams.numbers.push(walked - before);
        before = walked;
      }
    }
  }
  const header: StoredHeader = {
    ...{format: 'seamwise-stored-drape/1', sample, symmetries},
    ...{form: {body: form.body, parts: form.parts}, fabric, check, notes},
    pieces: mesh.pieces.map(({name, grainAngle, layer, part, triangles: own}, k) => ({
      ...{name, grainAngle, layer, part, triangles: own.length / 3},
      alignment: alignments[k] ?? {angle: 0, translation: [0, 0]},
    })),
    seams: mesh.seams.map(({a, b}) => [a.piece, b.piece, a.vertices.length]),
    surface: triangles.length / 3,
  };
  const text = new TextEncoder().encode(JSON.stringify(header));
  const pieces = walks.map(({numbers}) => numbers);
  const lists = bytesOfLists(listsOf({pieces, form: surface.numbers, seams}));
  const bytes = new Uint8Array(4 + text.length + lists.length);
  new DataView(bytes.buffer).setUint32(0, text.length, true);
  bytes.set(text, 4);
  bytes.set(lists, 4 + text.length);
  return deflateRawSync(bytes, {level: 9});
}
