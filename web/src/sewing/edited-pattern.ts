/** A garment's mesh right after an edit, until the new mesh is ready; its pieces are unchanged. */
import {edgeLength} from '../model/garment/edge-curve.js';
import type {EdgeOfPiece, GarmentDocument, GarmentSeam} from '../model/garment/garment-document.js';
import {edgeOf, type Edited} from '../model/garment/edits.js';
import {distance} from '../model/geometry/vectors.js';
import type {MeshedPattern, MeshedPiece, ResultSeam} from '../model/result/result.js';
import {edgeVertices} from '../scene/edge-line.js';

/**
 * Returns the edge numbers along an outline; the length along a former edge decides between its
 * parts.
 */
function edgesAfter(
  {rest, outline, edges}: MeshedPiece,
  piece: number,
  {document, edgesOf}: Edited,
): readonly number[] {
  const lengthAt = (k: number): number => {
    const [from, to] = [rest[outline[k] ?? -1], rest[outline[(k + 1) % outline.length] ?? -1]];
    return from && to ? distance(from, to) : 0;
  };
  const partsOf = new Map(
    [...new Set(edges)].map((edge) => {
      const parts = edgesOf({piece, edge});
      const lengths = parts.map((part) => {
        const drafted = edgeOf(document, part);
        return drafted ? edgeLength(drafted) : 0;
      });
      return [edge, {parts, lengths}] as const;
    }),
  );
  const next = [...edges];
  for (const [edge, {parts, lengths}] of partsOf) {
    const start = edges.findIndex(
      (one, k) => one === edge && edges[(k + edges.length - 1) % edges.length] !== edge,
    );
    let along = 0;
    for (let k = Math.max(start, 0), n = 0; n < edges.length && edges[k] === edge; n++) {
      const middle = along + lengthAt(k) / 2;
      along += lengthAt(k);
      let [part, end] = [0, lengths[0] ?? 0];
      while (part < parts.length - 1 && middle > end) end += lengths[++part] ?? 0;
      next[k] = parts[part]?.edge ?? edge;
      k = (k + 1) % edges.length;
    }
  }
  return next;
}

/** Returns `count` of the vertices at equal steps, so that both sides have the same number. */
const thinned = (vertices: readonly number[], count: number): readonly number[] =>
  Array.from(
    {length: count},
    (_, k) => vertices[Math.round((k * (vertices.length - 1)) / Math.max(count - 1, 1))] ?? 0,
  );

function seamAfter(
  pieces: readonly MeshedPiece[],
  {a, b, sameDirection, weight, matched}: GarmentSeam,
): ResultSeam {
  const along = ({piece, edge}: EdgeOfPiece): readonly number[] => {
    const meshed = pieces[piece];
    return meshed ? edgeVertices(meshed, edge) : [];
  };
  const [first, other] = [along(a), along(b)];
  const second = sameDirection ? other : [...other].reverse();
  const count = Math.min(first.length, second.length);
  return {
    a: {piece: a.piece, vertices: thinned(first, count)},
    b: {piece: b.piece, vertices: thinned(second, count)},
    ...{weight, matched, lengthRatio: 1, kind: 'continuous', mismatch: []},
  };
}

export function editedPattern(pattern: MeshedPattern, edited: Edited): MeshedPattern {
  const pieces = pattern.pieces.map((piece, number) => ({
    ...piece,
    edges: edgesAfter(piece, number, edited),
  }));
  const document: GarmentDocument = edited.document;
  return {...pattern, pieces, seams: document.seams.map((seam) => seamAfter(pieces, seam))};
}
