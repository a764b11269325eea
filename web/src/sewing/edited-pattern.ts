/** A garment's mesh right after an edit, until the new mesh is ready; its pieces are unchanged. */
import {edgeLength} from '../model/garment/edge-curve.js';
import type {EdgeOfPiece, GarmentDocument, GarmentSeam} from '../model/garment/garment-document.js';
import {edgeOf, type Edited} from '../model/garment/edits.js';
import {angleOf, distance, minus} from '../model/geometry/vectors.js';
import type {MeshedPattern, MeshedPiece, ResultSeam} from '../model/result/result.js';
import {edgeVertices} from '../scene/overlay.js';
import type {Run} from '../clicks/run.js';
import type {PatternScene} from '../scene/scene.js';
import type {SewTexts} from '../texts/sew-texts.js';
import type {Texts} from '../texts/texts.js';

// Names of edges: from the file, or by their place on the displayed piece.

/** Names of outward directions, counter-clockwise from the right. */
const places = [
  ...(['right', 'upperRight', 'top', 'upperLeft'] as const),
  ...(['left', 'lowerLeft', 'bottom', 'lowerRight'] as const),
];

export class EdgeNames {
  readonly #names = new Map<string, string>();
  readonly #pieces: readonly string[];
  readonly #list: Intl.ListFormat;
  readonly #sew: SewTexts;

  constructor(
    garment: GarmentDocument,
    scene: Pick<PatternScene, 'pieces'>,
    {lists}: Pick<Texts, 'lists'>,
    sew: SewTexts,
    language = 'en',
  ) {
    this.#sew = sew;
    this.#list = new Intl.ListFormat(language, {type: 'conjunction'});
    this.#pieces = garment.pieces.map(({name}, piece) => scene.pieces[piece]?.label ?? name);
    for (const [piece, {outline, name}] of garment.pieces.entries()) {
      const {label = name, isTurned = false} = scene.pieces[piece] ?? {};
      const own = outline.map((drafted) => {
        const way = minus(drafted.points.at(-1) ?? drafted.points[0], drafted.points[0]);
        // outward is a quarter turn clockwise of the direction along the edge
        const eighth =
          Math.round((angleOf(way) - Math.PI / 2) / (Math.PI / 4)) + (isTurned ? 4 : 0);
        return drafted.label ?? sew.places[places[(eighth + 16) % 8] ?? 'top'];
      });
      own.forEach((place, edge) => {
        const alike = own.flatMap((other, k) => (other === place ? [k] : []));
        const only = alike.length === 1 ? place : lists.numbered(place, alike.indexOf(edge) + 1);
        this.#names.set(`${piece} ${edge}`, sew.edge(only, label));
      });
    }
  }

  of({piece, edge}: EdgeOfPiece): string {
    return this.#names.get(`${piece} ${edge}`) ?? '';
  }

  /** Names the pieces of a run. */
  piecesOf(run: Run): string {
    const pieces = [...new Set(run.map(({piece}) => piece))];
    return this.#list.format(pieces.map((piece) => this.#pieces[piece] ?? ''));
  }

  ofRun(run: Run): string {
    const [first, second] = run;
    if (!first) return '';
    if (second && run.length === 2 && first.piece !== second.piece)
      return this.#sew.both(this.of(first), this.of(second));
    return run.length === 1 ? this.of(first) : this.#sew.run(run.length, this.of(first));
  }
}

/**
 * Returns the notch of an edge that is nearest to a position; both are shares of the edge's length.
 */
export function nearestNotch(
  {pieces}: GarmentDocument,
  at: EdgeOfPiece,
  share: number,
): number | undefined {
  const own = (pieces[at.piece]?.notches ?? []).filter(
    (notch) => notch.edge === at.edge && notch.at > 0.01 && notch.at < 0.99,
  );
  const [nearest] = own
    .map((notch) => notch.at)
    .sort((one, other) => Math.abs(one - share) - Math.abs(other - share));
  return nearest;
}

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
