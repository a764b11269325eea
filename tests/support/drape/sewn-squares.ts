/** A garment of two squares sewn at one edge, and its drape: flat, upright, in front of a form. */
import type {
  Drape,
  DrapedPiece,
  Form,
  Measurements,
  Surface,
} from '@/model/result/draped-garment.js';
import type {Point} from '@/model/geometry/vectors.js';
import type {ResultPiece, SolveResult} from '@/model/result/result.js';
import {at} from '../plane.js';
import {plainMetrics, plainPrint} from '../garments/two-squares.js';

/** Cells along an edge of a square, 1 cm each. */
const cells = 4;
const side = cells + 1;
/** Position of the squares: at the height of a waist, clear of the form. [cm] */
const height = 100;
const ahead = 8;

const vertexAt = (i: number, j: number): number => j * side + i;

const outline = [
  ...Array.from({length: cells}, (_, k) => vertexAt(k, 0)),
  ...Array.from({length: cells}, (_, k) => vertexAt(cells, k)),
  ...Array.from({length: cells}, (_, k) => vertexAt(cells - k, cells)),
  ...Array.from({length: cells}, (_, k) => vertexAt(0, cells - k)),
];

const grid: readonly Point[] = Array.from({length: side * side}, (_, k) => [
  k % side,
  Math.floor(k / side),
]);

/** Triangles whose diagonals lean to the right, or to the left on a twin. */
const triangles = (isTwin: boolean): readonly (readonly [number, number, number])[] =>
  Array.from({length: cells * cells}, (_, k) => {
    const [i, j] = [k % cells, Math.floor(k / cells)];
    const [a, b] = [vertexAt(i, j), vertexAt(i + 1, j)];
    const [c, d] = [vertexAt(i + 1, j + 1), vertexAt(i, j + 1)];
    const halves = [
      [
        [a, b, c],
        [a, c, d],
      ],
      [
        [a, b, d],
        [b, c, d],
      ],
    ] as const;
    return halves[isTwin ? 1 : 0];
  }).flat();

const pieceOf = (name: string, isTwin: boolean): ResultPiece => ({
  ...{name, rest: grid, shape: grid, triangles: triangles(isTwin), outline, holes: []},
  ...{alignment: {angle: 0, translation: [0, 0]}, mirroredFromInput: false},
});

/** The upper ends first. */
const leftEdge = Array.from({length: side}, (_, k) => vertexAt(0, cells - k));
const rightEdge = Array.from({length: side}, (_, k) => vertexAt(cells, cells - k));

/**
 * A possible answer of a solve: the right edge of `right` is sewn to the left one of `left`, its
 * mirror image.
 */
export const squaresResult: SolveResult = {
  format: 'seamwise-result/1',
  units: 'cm',
  print: plainPrint,
  pieces: [pieceOf('right', false), pieceOf('left', true)],
  seams: [
    {
      a: {piece: 0, vertices: rightEdge},
      b: {piece: 1, vertices: leftEdge},
      ...{weight: 1, matched: true, lengthRatio: 1, kind: 'continuous'},
      mismatch: Array.from({length: cells}, () => 0),
    },
  ],
  symmetries: [],
  search: [],
  metrics: plainMetrics,
  notes: [],
};

const body: Measurements = {
  ...{bust: 96, waist: 80, hip: 104, neck: 35.3, head: 57.2, upperArm: 28, wrist: 16.8},
  ...{thigh: 58, knee: 38.9, ankle: 25.4, shoulderWidth: 42.5, bustSpan: 16.3, backLength: 40.5},
  ...{hipDepth: 25.6, bodyRise: 27.7, kneeDepth: 61.5, armLength: 59.7, waistHeight: 102},
};

/** A box around the axis x = z = 0, from y = 80 to 120. [cm] */
function boxOf(half: number): Surface {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [
    k & 1 ? half : -half,
    k & 2 ? 120 : 80,
    k & 4 ? half : -half,
  ]);
  const faces = [
    ...[0, 2, 3, 0, 3, 1],
    ...[4, 5, 7, 4, 7, 6],
    ...[0, 4, 6, 0, 6, 2],
    ...[1, 3, 7, 1, 7, 5],
    ...[0, 1, 5, 0, 5, 4],
    ...[2, 6, 7, 2, 7, 3],
  ];
  return {vertices: Float32Array.from(corners), triangles: Uint32Array.from(faces)};
}

const form: Form = {
  body,
  parts: [
    {
      ...{name: 'torso', origin: [0, 0, 0], up: [0, 1, 0]},
      sections: [
        {level: 80, width: 5, depth: 5, middle: 0, square: 1},
        {level: 120, width: 5, depth: 5, middle: 0, square: 1},
      ],
    },
  ],
  surface: boxOf(5),
};

const draped = (piece: number): DrapedPiece => {
  const {name, rest, shape, triangles: corners} = at(squaresResult.pieces, piece);
  // vertices along the seam belong to the first piece; all others get separate numbers
  const sewn = grid.map(([i, j], vertex) => {
    if (piece === 0) return vertex;
    return i === 0 ? vertexAt(cells, j) : side * side + j * cells + i - 1;
  });
  return {
    ...{name, rest: Float64Array.from(rest.flat()), shape: Float64Array.from(shape.flat())},
    triangles: Uint32Array.from(corners.flat()),
    sewn: Uint32Array.from(sewn),
    outline: Uint32Array.from(outline),
    resultVertices: Uint32Array.from(outline),
    ...{grainAngle: Math.PI / 2, layer: 0, part: 'torso'},
  };
};

/**
 * The drape of `squaresResult`, which is its own mirror image. The energies are approximately those
 * of its weight.
 */
export function squaresDrape(): Drape {
  const pieces = [draped(0), draped(1)];
  const size = 2 * side * side - side;
  const positions = new Float64Array(3 * size);
  pieces.forEach(({sewn}, piece) => {
    grid.forEach(([i, j], vertex) => {
      const x = i - (piece === 0 ? cells : 0);
      positions.set([x, height + j, ahead], 3 * (sewn[vertex] ?? 0));
    });
  });
  const image = Uint32Array.from(grid, ([i, j]) => vertexAt(cells - i, j));
  const weight = 0.12 * 9.81 * 32e-4 * 1.02; // J: density, area and height of the middle, in SI
  return {
    mesh: {
      pieces,
      seams: [
        {
          a: {piece: 0, vertices: Uint32Array.from(rightEdge)},
          b: {piece: 1, vertices: Uint32Array.from(leftEdge)},
        },
      ],
      mirrors: [{pieces: [0, 1], image}],
      size,
    },
    ...{positions, form},
    fabric: {
      ...{name: 'poplin', density: 0.12, warp: 2000, weft: 1800, coupling: 450, shear: 60},
      ...{stiffFrom: 0.03, stiffening: 4, bendingWarp: 9e-6, bendingWeft: 7e-6},
      ...{friction: 0.4, offset: 0.0015},
    },
    stages: [
      {name: 'sew', vertices: size, steps: 2, work: 1, energy: [0.5, 0.1, 0.02]},
      {name: 'settle', vertices: size, steps: 1, work: 1, energy: [0.01, weight]},
    ],
    check: {
      ...{gap: 0, depth: 0, crossings: 0, moved: 0},
      tension: {median: 0, p99: 0, max: 0},
      compression: {median: 0, p99: 0, max: 0},
    },
    notes: [],
  };
}
