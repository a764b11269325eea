/** The two sides of a seam in question, face to face as they would be sewn. Lengths in cm, y down. */
import type {Suggestion} from '../clicks/seam-tool.js';
import type {Run} from '../clicks/run.js';
import {edgeLine} from '../model/garment/edge-curve.js';
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {edgeOf} from '../model/garment/edits.js';
import {boxOf} from '../model/geometry/polyline.js';
import {angleOf, distance, minus, plus, rotated, type Point} from '../model/geometry/vectors.js';

export interface SeamPicture {
  /** Outlines of the pieces, as data of an SVG path; those of the first side are above. */
  readonly pieces: readonly string[];
  /** The edges of both sides. */
  readonly edges: readonly string[];
  /** Lines between the ends that meet. */
  readonly ties: readonly string[];
  /** Left, top, width and height. */
  readonly box: readonly [number, number, number, number];
}

/** Share of the seam's length between its sides, and beside and behind them. */
const room = {between: 0.07, beside: 0.06, behind: 0.3};

const pathOf = (line: readonly Point[]): string =>
  line.map(([x, y], k) => `${k === 0 ? 'M' : 'L'}${x.toFixed(2)} ${y.toFixed(2)}`).join('');

interface Side {
  readonly outlines: readonly (readonly Point[])[];
  readonly edges: readonly (readonly Point[])[];
}

/** Returns a map that puts a line's chord on the x axis, from a start to the right. */
function laid(line: readonly Point[], start: number): (point: Point) => Point {
  const [from = [0, 0], to = from] = [line[0], line.at(-1)];
  const angle = -angleOf(minus(to, from));
  return (point) => plus(rotated(minus(point, from), angle), [start, 0]);
}

/** Lays the edges of a side end to end on the x axis, with their pieces above it (y up). */
function sideOf(garment: GarmentDocument, run: Run): Side & {readonly length: number} {
  let length = 0;
  const parts = run.flatMap((edge: EdgeOfPiece) => {
    const drafted = edgeOf(garment, edge);
    const outline = garment.pieces[edge.piece]?.outline ?? [];
    if (!drafted) return [];
    const line = edgeLine(drafted);
    const map = laid(line, length);
    length += distance(line[0] ?? [0, 0], line.at(-1) ?? [0, 0]);
    return [{edge: line.map(map), outline: outline.flatMap((one) => edgeLine(one).map(map))}];
  });
  return {
    length,
    edges: parts.map(({edge}) => edge),
    outlines: parts.map(({outline}) => outline),
  };
}

/** Draws the two sides of a seam. */
export function seamPicture(
  garment: GarmentDocument,
  {a, b, sameDirection}: Suggestion,
): SeamPicture {
  const [first, second] = [sideOf(garment, a), sideOf(garment, b)];
  const length = Math.max(first.length, second.length);
  const gap = (room.between * length) / 2;
  const bulge = (side: Side, by: 0 | 1): number => {
    const {low, high} = boxOf(side.edges.flat());
    return by === 0 ? Math.max(0, -low[1]) : Math.max(0, high[1]);
  };
  const [fromFirst, fromSecond] = [(length - first.length) / 2, (length - second.length) / 2];
  // the sides of a turned seam run the same way, so that the second one is mirrored
  const up = ([x, y]: Point): Point => [x + fromFirst, -y - gap - bulge(first, 0)];
  const down = ([x, y]: Point): Point => [
    fromSecond + (sameDirection ? x : second.length - x),
    y + gap + bulge(second, 0),
  ];
  const sides = [
    {...first, place: up},
    {...second, place: down},
  ];
  const ends = sides.map(({edges, place}) =>
    [edges[0]?.[0], edges.at(-1)?.at(-1)].flatMap((end) => (end ? [place(end)] : [])),
  );
  const [above = [], below = []] = [ends[0], sameDirection ? ends[1] : ends[1]?.toReversed()];
  const beside = room.beside * length;
  const top = -gap - bulge(first, 0) - bulge(first, 1) - room.behind * length;
  const foot = gap + bulge(second, 0) + bulge(second, 1) + room.behind * length;
  return {
    pieces: sides.flatMap(({outlines, place}) =>
      outlines.map((line) => `${pathOf(line.map(place))}Z`),
    ),
    edges: sides.flatMap(({edges, place}) => edges.map((line) => pathOf(line.map(place)))),
    ties: above.flatMap((end, k) => {
      const other = below[k];
      return other ? [pathOf([end, other])] : [];
    }),
    box: [-beside, top, length + 2 * beside, foot - top],
  };
}
