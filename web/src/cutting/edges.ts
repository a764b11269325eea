/** The outline of a solved piece, divided into its drafted edges. Lengths in cm. */
import type {DraftedEdge, GarmentPiece} from '../model/garment/garment-document.js';
import {distance, minus, turnBetween, type Point} from '../model/geometry/vectors.js';
import type {ResultPiece, ResultSeam} from '../model/result/result.js';
import {pick} from '../scene/marks.js';
import {smoothLine} from './smooth-line.js';

/** The seam of an edge. */
interface EdgeSeam {
  readonly number: number;
  readonly side: 'a' | 'b';
  /** Sewn from end to start. */
  readonly isReversed: boolean;
}

export interface OutlineEdge {
  /** Vertex indices of the piece from start to end. */
  readonly vertices: readonly number[];
  /** A smooth curve through the vertices of the shape. */
  readonly points: readonly Point[];
  readonly drafted?: DraftedEdge;
  readonly seam?: EdgeSeam;
}

/** Greatest distance between a drafted corner and its outline vertex. */
const sameCorner = 0.05;
/** Least turn of a corner in an outline without a matching draft. [rad] */
const cornerTurn = 0.4;

type Sides = readonly (EdgeSeam & {readonly vertices: readonly number[]})[];

/** Every sewn run of outline vertices, in the direction of the outline. */
const sidesOf = (
  seams: readonly ResultSeam[],
  piece: number,
  loops: readonly (readonly number[])[],
): Sides =>
  seams.flatMap((seam, number) =>
    (['a', 'b'] as const).flatMap((side) => {
      const {piece: on, vertices} = seam[side];
      const [first = -1, second = -1] = vertices;
      if (on !== piece) return [];
      const runsAlong = loops.some((loop) => {
        const at = loop.indexOf(first);
        return at >= 0 && loop[(at + 1) % loop.length] === second;
      });
      const forward = runsAlong ? vertices : [...vertices].reverse();
      return [{number, side, isReversed: !runsAlong, vertices: forward}];
    }),
  );

/** Loop indices where drafted edges begin; undefined if the draft does not fit the outline. */
function draftedStarts(
  {rest}: ResultPiece,
  loop: readonly number[],
  edges: readonly DraftedEdge[],
): readonly number[] | undefined {
  const points = pick(rest, loop);
  const starts = edges.map(({points: [start]}) => {
    const apart = points.map((p) => distance(p, start));
    const least = Math.min(...apart);
    return least < sameCorner ? apart.indexOf(least) : -1;
  });
  const steps = starts.map(
    (at, k) => ((starts[(k + 1) % starts.length] ?? at) - at + loop.length) % loop.length,
  );
  const isWhole =
    starts.length > 0 && !starts.includes(-1) && steps.reduce((a, b) => a + b, 0) === loop.length;
  return isWhole || (starts.length === 1 && starts[0] !== -1) ? starts : undefined;
}

/** Loop indices where seams begin or end, and where the outline turns sharply. */
function seenStarts({rest}: ResultPiece, loop: readonly number[], sides: Sides): readonly number[] {
  const points = pick(rest, loop);
  const ends = new Set(sides.flatMap(({vertices}) => [vertices[0], vertices.at(-1)]));
  const n = points.length;
  const starts = points.flatMap((p, k) => {
    const [before = p, after = p] = [points[(k + n - 1) % n], points[(k + 1) % n]];
    const turn = Math.abs(turnBetween(minus(p, before), minus(after, p)));
    return turn > cornerTurn || ends.has(loop[k]) ? [k] : [];
  });
  return starts.length > 0 ? starts : [0];
}

/** The edges of the outline, then of each hole. */
export function outlineEdges(
  piece: ResultPiece,
  number: number,
  seams: readonly ResultSeam[],
  drafted?: GarmentPiece,
): readonly (readonly OutlineEdge[])[] {
  const loops = [piece.outline, ...piece.holes];
  const sides = sidesOf(seams, number, loops);
  const draft = drafted && [drafted.outline, ...drafted.holes];
  return loops.map((loop, k) => {
    const known = draft?.[k];
    const byDraft = known && draftedStarts(piece, loop, known);
    const starts = byDraft ?? seenStarts(piece, loop, sides);
    return starts.map((start, e) => {
      const end = starts[(e + 1) % starts.length] ?? start;
      const steps = (end - start + loop.length) % loop.length || loop.length;
      const vertices = Array.from(
        {length: steps + 1},
        (_, n) => loop[(start + n) % loop.length] ?? 0,
      );
      const seam = sides.find(
        (side) => side.vertices[0] === vertices[0] && side.vertices[1] === vertices[1],
      );
      const edge = byDraft && known[e];
      return {
        ...{vertices, points: smoothLine(pick(piece.shape, vertices))},
        ...(edge && {drafted: edge}),
        ...(seam && {
          seam: {number: seam.number, side: seam.side, isReversed: seam.isReversed},
        }),
      };
    });
  });
}
