/** A shirt with sleeves of one piece each, without seams, in the format of pattern programs. */
import type {DraftedEdge, GarmentDocument} from '@/model/garment/garment-document.js';
import {leftOf, minus, plus, type Point} from '@/model/geometry/vectors.js';
import {documentOf, draftedSquare} from './documents.js';

/** Control points of an edge: shares of its chord along it, and to its left. */
type Bend = readonly [Point, Point];

interface Panel {
  readonly vertices: readonly Point[];
  readonly bends: Readonly<Record<number, Bend>>;
}

const bodice = (neck: number): Panel => ({
  vertices: [
    ...([
      [0, 0],
      [50, 0],
      [50, 40],
      [44, 62],
    ] as const),
    ...([
      [32, 66],
      [18, 66],
      [6, 62],
      [0, 40],
    ] as const),
  ],
  bends: {
    2: [
      [0.2, 0.3],
      [0.6, 0.25],
    ],
    4: [
      [0.25, neck],
      [0.75, neck],
    ],
    6: [
      [0.4, 0.25],
      [0.8, 0.3],
    ],
  },
});

/** Its cap, edge 2, is as long as both armholes: 51 cm. */
const sleeve: Panel = {
  vertices: [
    [6, 0],
    [30, 0],
    [36, 44],
    [0, 44],
  ],
  bends: {
    2: [
      [0.3, -0.6],
      [0.7, -0.6],
    ],
  },
};

/** The hem makes it fit one arm only. */
const lopsided: Panel = {
  ...sleeve,
  vertices: [
    [14, 0],
    [30, 3],
    [36, 44],
    [0, 40],
  ],
};

const mirrored = ({vertices, bends}: Panel): Panel => {
  const count = vertices.length;
  const flipped = vertices.map(([x, y]): Point => [36 - x, y]);
  return {
    // starts at the same corner in the opposite direction, so that only the order of the edges
    // changes
    vertices: [...flipped.slice(0, 2).reverse(), ...flipped.slice(2).reverse()],
    bends: Object.fromEntries(
      Object.entries(bends).map(([edge, [[x1, y1], [x2, y2]]]) => [
        (count + 4 - Number(edge)) % count,
        [
          [1 - x2, y2],
          [1 - x1, y1],
        ] as const,
      ]),
    ),
  };
};

const panelsOf = (isLopsided: boolean): readonly (readonly [string, Panel])[] => [
  ['front', bodice(0.35)],
  ['back', bodice(0.1)],
  ['sleeve', isLopsided ? lopsided : sleeve],
  ['sleeve 2', isLopsided ? mirrored(lopsided) : sleeve],
];

const edgesOf = ({vertices, bends}: Panel): readonly DraftedEdge[] =>
  vertices.map((from, k) => {
    const to = vertices[(k + 1) % vertices.length] ?? from;
    const way = minus(to, from);
    const controls = (bends[k] ?? []).map(([along, left]) =>
      plus(plus(from, way, along), leftOf(way), left),
    );
    return {points: [from, ...controls, to] as unknown as DraftedEdge['points']};
  });

/** @param isLopsided  sleeves are mirror images, but not symmetric in themselves */
export const shirtWithSleeves = ({isLopsided = false} = {}): GarmentDocument =>
  documentOf(
    panelsOf(isLopsided).map(([name, panel]) => draftedSquare(name, {outline: edgesOf(panel)})),
  );

/** The same shirt as a GarmentCode specification. */
export const shirtSpecification = (): object => ({
  pattern: {
    panels: Object.fromEntries(
      panelsOf(false).map(([name, {vertices, bends}]) => {
        const edges = vertices.map((_, k) => ({
          endpoints: [k, (k + 1) % vertices.length],
          ...(bends[k] && {curvature: {type: 'cubic', params: bends[k]}}),
        }));
        return [name, {vertices, edges}];
      }),
    ),
    stitches: [],
  },
  properties: {curvature_coords: 'relative', units_in_meter: 100},
});
