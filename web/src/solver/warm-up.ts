/**
 * Small problems that take a solver through all its stages. An engine compiles code at its first
 * call, and optimises it later if it is called often. It uses its own threads for that, which
 * compete with the worker on a device with few processors, just while the user waits for the first
 * result.
 */
import type {Problem} from '../model/design/solve-problem.js';

type Point = readonly [x: number, y: number];
/** Control points of an edge's cubic, relative to the edge. */
type Bend = readonly [Point, Point];

const print = {group: 'pmm', w1: [2, 0], w2: [0, 2.5]} as const;

const square = (left: number) => ({
  translation: [left, 0, 0],
  rotation: [0, 0, 0],
  vertices: [
    [0, 0],
    [6, 0],
    [6, 6],
    [0, 6],
  ],
  edges: [
    {endpoints: [0, 1]},
    {endpoints: [1, 2], curvature: [0.5, 0.15]},
    {endpoints: [2, 3]},
    {endpoints: [3, 0]},
  ],
});

/**
 * Two pieces. One side of their seam is curved and the other is not, so that they have to be
 * reshaped.
 */
const squares: Problem = {
  garment: garmentOf({one: square(-8), other: square(2)}, [
    ['one', 1, 'other', 3],
    ['one', 0, 'other', 2],
  ]),
  print,
};

const side: Bend = [
  [0.459915556665, -0.006231918112],
  [0.651006423521, 0.026095899088],
];
const armhole: Bend = [
  [0.319915556665, 0.156231918112],
  [0.751006423521, 0.126095899088],
];
const neckline: Bend = [
  [0.234567890123, -0.351234567891],
  [0.765432109877, -0.351234567891],
];

/** The same curve in the opposite direction. */
const backwards = ([[x1, y1], [x2, y2]]: Bend): Bend => [
  [1 - x2, y2],
  [1 - x1, y1],
];

/** The front or the back of a bodice, symmetric in itself. */
function bodice(width: number, height: number, isBack: boolean) {
  const right: Point[] = [
    [28 * width, -19],
    [27.5 * width, 17.9],
    [21.85 * width, 37.058319],
    [8.66 * width, 41.6],
  ];
  const bends = [side, armhole, null, neckline, null, backwards(armhole), backwards(side), null];
  return {
    translation: [0, height, isBack ? -20 : 20],
    rotation: [0, isBack ? 180 : 0, 0],
    vertices: [...right, ...right.toReversed().map(([x, y]) => [-x, y])],
    edges: bends.map((bend, k) => ({
      endpoints: [k, (k + 1) % bends.length],
      ...(bend && {curvature: {type: 'cubic', params: bend}}),
    })),
  };
}

/**
 * Two bodices. They have as many curves and mirrors to detect as any garment, but match as drafted,
 * so that hardly any search is needed.
 */
const bodices = (width: number): Problem => ({
  garment: garmentOf(
    {
      front: bodice(width, 0, false),
      back: bodice(width, 0, true),
      other: bodice(1.1 * width, 100, false),
      'other back': bodice(1.1 * width, 100, true),
    },
    [
      ['front', 'back'],
      ['other', 'other back'],
    ].flatMap(([a, b]) => [0, 2, 4, 6].map((edge) => [a, edge, b, 6 - edge])),
  ),
  print,
});

function garmentOf(panels: object, seams: unknown[][]): string {
  const stitches = seams.map(([a, edge, b, other]) => [
    {panel: a, edge},
    {panel: b, edge: other},
  ]);
  return JSON.stringify({
    pattern: {panels, stitches},
    properties: {units_in_meter: 100, curvature_coords: 'relative'},
  });
}

/** Problems to solve in this order while no other request is pending. No two have equal meshes. */
export const warmUpProblems: readonly Problem[] = [squares, bodices(1), bodices(1.03)];
