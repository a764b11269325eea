import {describe, expect, it} from 'vitest';

import {allowancesOf} from '@/cutting/allowances.js';
import {cutLine} from '@/cutting/cut-line.js';
import {allowedLoops, garmentEdges} from '@/cutting/garment-edges.js';
import {garmentNotches} from '@/cutting/notches.js';
import {matchTicks, stripeWays} from '@/cutting/ticks.js';
import type {PanelMarks} from '@/model/garment/panel-marks.js';
import type {Allowance, DraftedEdge, GarmentPiece} from '@/model/garment/garment-document.js';
import {distance, onPrint, type Point} from '@/model/geometry/vectors.js';
import {distanceTo, isInside} from '@/model/geometry/polyline.js';
import type {ResultPiece, ResultSeam} from '@/model/result/result.js';
import {printDistance} from '@/model/print/wallpaper.js';
import {plainPrint, squarePiece} from '../../support/garments/two-squares.js';

/**
 * A piece with corners at these points, whose first edge is its hem, and vertices at least every 5
 * cm.
 */
function pieceOf(
  name: string,
  corners: readonly Point[],
  more: {readonly allowances?: readonly (Allowance | undefined)[]} & Partial<ResultPiece> = {},
): {readonly piece: ResultPiece; readonly marks: PanelMarks; readonly edges: number[][]} {
  const points: Point[] = [];
  const edges = corners.map((from, k) => {
    const to = corners[(k + 1) % corners.length] ?? from;
    const steps = Math.ceil(distance(from, to) / 5);
    const first = points.length;
    for (let n = 0; n < steps; n++)
      points.push([
        from[0] + ((to[0] - from[0]) * n) / steps,
        from[1] + ((to[1] - from[1]) * n) / steps,
      ]);
    return Array.from({length: steps + 1}, (_, n) => first + n);
  });
  const closed = edges.map((edge) => edge.map((v) => (v === points.length ? 0 : v)));
  const {allowances = [], ...piece} = more;
  const outline = corners.map((from, k): DraftedEdge => ({
    points: [from, corners[(k + 1) % corners.length] ?? from],
    ...(allowances[k] && {allowance: allowances[k]}),
  }));
  const drafted: GarmentPiece = {
    ...{name, mirroredFromInput: false, outline, holes: [], internalLines: []},
  };
  return {
    piece: squarePiece(name, {
      ...{rest: points, shape: points, triangles: [], outline: points.map((_, k) => k)},
      ...piece,
    }),
    marks: {label: name, drafted},
    edges: closed,
  };
}

type Made = ReturnType<typeof pieceOf>;

const seamOf = (a: readonly [number, number[]], b: readonly [number, number[]]): ResultSeam => ({
  a: {piece: a[0], vertices: a[1]},
  b: {piece: b[0], vertices: b[1]},
  ...{weight: 1, matched: true, lengthRatio: 1, kind: 'continuous', mismatch: []},
});

function cut(made: readonly Made[], seams: readonly ResultSeam[], hemCm = 3) {
  const pieces = made.map(({piece}) => piece);
  const marks = made.map((one) => one.marks);
  const garment = garmentEdges(
    {pieces, seams},
    (name) => marks.find(({drafted}) => drafted?.name === name)?.drafted,
  );
  const allowances = allowancesOf(garment, pieces, marks, {allowanceCm: 1, hemCm});
  return {
    ...{garment, allowances, marks, pieces},
    lines: pieces.map((_, k) => cutLine(allowedLoops(garment, k), allowances)[0] ?? []),
  };
}

/** Distance from a point to the cut line in a direction. */
const reach = (line: readonly Point[], [x, y]: Point, [dx, dy]: Point): number => {
  for (let s = 0; s < 20; s += 0.001) if (!isInside(line, [x + s * dx, y + s * dy])) return s;
  return Infinity;
};

const rectangle: readonly Point[] = [
  [0, 0],
  [20, 0],
  [20, 30],
  [0, 30],
];

describe('allowances', () => {
  it('are each edge’s own, and deeper at the hem that lies lowest', () => {
    const made = pieceOf('front', rectangle, {allowances: [undefined, {width: 2}, {width: 0}]});
    const {lines} = cut([made], []);
    const [line = []] = lines;
    expect(reach(line, [10, 0], [0, -1])).toBeCloseTo(3, 2);
    expect(reach(line, [20, 15], [1, 0])).toBeCloseTo(2, 2);
    expect(distanceTo(line, [10, 30])).toBeLessThan(1e-4);
    expect(reach(line, [0, 15], [-1, 0])).toBeCloseTo(1, 2);
  });

  it('follow a drawn cut line, by the median of its distance', () => {
    const made = pieceOf('front', rectangle);
    const cutLineDrawn: readonly Point[] = [
      [-1.5, -4],
      [21.5, -4],
      [21.5, 30.7],
      [-1.5, 30.7],
    ];
    const drafted = made.marks.drafted && {...made.marks.drafted, cutLine: cutLineDrawn};
    const {lines} = cut([{...made, marks: {label: 'front', ...(drafted && {drafted})}}], []);
    expect(reach(lines[0] ?? [], [10, 0], [0, -1])).toBeCloseTo(4, 2);
    expect(reach(lines[0] ?? [], [20, 15], [1, 0])).toBeCloseTo(1.5, 2);
    expect(reach(lines[0] ?? [], [10, 30], [0, 1])).toBeCloseTo(0.7, 2);
  });

  it('are no deeper where a hem turns too much to be turned up', () => {
    const made = pieceOf('front', rectangle);
    const bent = made.piece.rest.map(([x, y]): Point => [x, y === 0 ? (x * (x - 20)) / 20 : y]);
    expect([...cut([made], []).allowances.hems]).toEqual(['0.0.0']);
    const {allowances} = cut([{...made, piece: {...made.piece, shape: bent}}], []);
    expect([...allowances.hems]).toEqual([]);
  });

  it('fold onto the piece at the corners of a slanted hem', () => {
    // wider at the hem: sides at 60 degrees to it
    const side = 30 / Math.tan(Math.PI / 3);
    const flared: readonly Point[] = [
      [0, 0],
      [60, 0],
      [60 - side, 30],
      [side, 30],
    ];
    const [line = []] = cut([pieceOf('front', flared)], []).lines;
    const below = line.filter(([, y]) => y < -1e-6);
    expect(Math.min(...below.map(([, y]) => y))).toBeCloseTo(-3, 4);
    for (const [x, y] of below) {
      const folded: Point = [x, -y];
      expect(isInside(line, folded) || distanceTo(line, folded) < 1e-3).toBe(true);
    }
    // calculated by hand: the side's cut line meets the hem line 1 / sin 60 beyond the corner, and
    // returns by 3 / tan 60
    const corner = Math.min(...below.filter(([, y]) => y < -2.9).map(([x]) => x));
    expect(corner).toBeCloseTo(-1 / Math.sin(Math.PI / 3) + 3 / Math.tan(Math.PI / 3), 3);
  });

  it('are cut off at 2.5 widths where a corner is sharp', () => {
    const spike: readonly Point[] = [
      [0, 0],
      [30, -1],
      [30, 1],
    ];
    const [line = []] = cut(
      [pieceOf('spike', spike, {allowances: [{width: 1}, {width: 1}]})],
      [],
    ).lines;
    expect(Math.min(...line.map(([x]) => x))).toBeCloseTo(-2.5, 2);
  });

  it('are cut off square where the cut line of a curved edge crosses them', () => {
    const made = pieceOf('front', rectangle, {
      allowances: [undefined, {width: 1, corner: 'square'}],
    });
    // the top rises at 37 degrees from the corner, and is level from 0.2 cm on
    const shape = made.piece.shape.map(([x, y]): Point => {
      if (y < 30 || x % 20 === 0) return [x, y];
      return [x === 15 ? 19.8 : x, 30.15];
    });
    const [line = []] = cut([{...made, piece: {...made.piece, shape}}], []).lines;
    for (const x of [20, 20.9]) expect(reach(line, [x, 30], [0, 1])).toBeCloseTo(1.15, 1);
  });

  it('end where those of the other side end: square, at one distance from the seam', () => {
    // the right edge of one is sewn to the left edge of the other; tops at 60 and at 100 degrees to
    // it
    const leaning = (angle: number): number => 20 / Math.tan((angle * Math.PI) / 180);
    const one = pieceOf('one', [
      [0, 0],
      [20, 0],
      [20, 30],
      [0, 30 - leaning(60)],
    ]);
    const two = pieceOf('two', [
      [0, 0],
      [20, 0],
      [20, 30 - leaning(100)],
      [0, 30],
    ]);
    const right = one.edges[1] ?? [];
    const left = [...(two.edges[3] ?? [])].reverse();
    const {lines} = cut([one, two], [seamOf([0, right], [1, left])], 1);
    const up: Point = [0, 1];
    const ends = [reach(lines[0] ?? [], [20, 30], up), reach(lines[1] ?? [], [0, 30], up)];
    expect(ends[0]).toBeCloseTo(1 / Math.sin((100 * Math.PI) / 180), 2);
    expect(ends[1]).toBeCloseTo(ends[0] ?? 0, 2);
    // the acute one is cut at a right angle to the seam
    expect(reach(lines[0] ?? [], [20.9, 30], up)).toBeCloseTo(ends[0] ?? 0, 2);
  });
});

describe('notches', () => {
  const tall: readonly Point[] = [
    [0, 0],
    [20, 0],
    [20, 40],
    [0, 40],
  ];
  const shown = (first: string, second: string) => {
    const made = [pieceOf(first, tall), pieceOf(second, tall)];
    const seam = seamOf(
      [0, made[0]?.edges[1] ?? []],
      [1, [...(made[1]?.edges[3] ?? [])].reverse()],
    );
    const {garment, allowances, marks, pieces} = cut(made, [seam], 1);
    return garmentNotches(garment, pieces, marks, allowances.widths);
  };

  it('mark the middle of a long seam on both sides, and slits leave 2 mm', () => {
    const [one = [], two = []] = shown('front', 'side');
    expect(one.map(({at}) => at)).toEqual([[20, 20]]);
    expect(two.map(({at}) => at)).toEqual([[0, 20]]);
    expect(one[0]).toMatchObject({depth: 0.4, width: 1, seam: 0});
  });

  it('are two where a back is sewn', () => {
    const [one = [], two = []] = shown('back', 'side');
    expect(one.map(({at: [, y]}) => y)).toEqual([19.5, 20.5]);
    expect(two.map(({at: [, y]}) => y).sort()).toEqual([19.5, 20.5]);
  });
});

describe('ticks', () => {
  const made = [pieceOf('one', rectangle), pieceOf('two', rectangle)];
  const right = made[0]?.edges[1] ?? [];
  const left = [...(made[1]?.edges[3] ?? [])].reverse();
  const repeat = {...plainPrint, group: 'pmm'} as const;
  /** The second piece continues the first one's print, shifted by `off` upwards. */
  const ticksWith = (off: number) => {
    const pieces = [
      {...(made[0]?.piece ?? squarePiece('')), alignment: {angle: 0, translation: [3, 2] as Point}},
      {
        ...(made[1]?.piece ?? squarePiece('')),
        alignment: {angle: 0, translation: [-17, 2 + off] as Point},
      },
    ];
    const seams = [seamOf([0, right], [1, left])];
    const [one = [], two = []] = matchTicks({pieces, seams}, repeat, () => [0, 0]);
    return {pieces, one, two};
  };

  it('lie where the print’s lines cross the seam, at one point of the print on both sides', () => {
    const {pieces, one, two} = ticksWith(0.05);
    // lines through the origin of the print are at y = 2, 12 and 22 of the first piece
    expect(one.map(({at}) => at.map((v) => Number(v.toFixed(9))))).toEqual([
      [20, 2],
      [20, 12],
      [20, 22],
    ]);
    expect(two.map(({label}) => label)).toEqual(['Aa', 'Ab', 'Ac']);
    const apart = printDistance(repeat);
    for (const [k, {at, label}] of one.entries()) {
      expect(two[k]?.label).toBe(label);
      const [p, q] = [pieces[0], pieces[1]].map((piece, n) =>
        onPrint(
          piece?.alignment ?? {angle: 0, translation: [0, 0]},
          n === 0 ? at : (two[k]?.at ?? at),
        ),
      );
      expect(p && q && apart(p, q)).toBeLessThan(1e-6);
    }
  });

  it('are left out where both sides do not show the same there', () => {
    expect(ticksWith(2).one).toEqual([]);
  });

  it('take the lattice vectors nearest to the grain and to across it', () => {
    const {across, along} = stripeWays(repeat, {angle: 0.1, translation: [0, 0]}, [0, 1]);
    expect(Math.atan2(across[1], across[0])).toBeCloseTo(0.1, 9);
    expect(Math.atan2(along[1], along[0])).toBeCloseTo(0.1 + Math.PI / 2, 9);
  });
});
