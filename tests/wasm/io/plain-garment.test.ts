/** Garments as plain GarmentCode: the same outlines and seams, by single curves. */
import {writeFileSync} from 'node:fs';
import {mkdtemp} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {
  convert,
  garmentFile,
  prepare,
  readGarment,
  type DraftedEdge,
  type GarmentCodeSpecification,
  type GarmentDocument,
  type Point,
} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {edgeLength, splitCurve} from '@/model/garment/edge-curve.js';
import {distance} from '@/model/geometry/vectors.js';
import {seamwise} from '../../support/cli/command-line.js';
import {redrawn} from '../../support/garments/path-edges.js';
import {checks, sample} from '../../support/garments/samples.js';

const sum = (numbers: readonly number[]) => numbers.reduce((total, one) => total + one, 0);

function pointAt(edge: DraftedEdge | undefined, share: number): Point {
  if (!edge) return [NaN, NaN];
  return splitCurve(edge, Math.min(1 - 1e-12, Math.max(1e-12, share)))[1].points[0];
}

/** The parts in `split` of each edge of `whole`. */
function partsOf(whole: GarmentDocument, split: GarmentDocument): DraftedEdge[][][] {
  return whole.pieces.map(({outline}, p) => {
    const rest = [...(split.pieces[p]?.outline ?? [])];
    return outline.map((edge) => {
      const end = edge.points.at(-1) ?? edge.points[0];
      const parts: DraftedEdge[] = [];
      for (let part = rest.shift(); part; part = rest.shift()) {
        parts.push(part);
        const to = part.points.at(-1) ?? part.points[0];
        if (distance(to, end) < 1e-6) break;
      }
      return parts;
    });
  });
}

/** Checks a plain file against its original garment; returns both as documents. */
async function checked(whole: GarmentDocument) {
  const text = await convert(garmentFile(whole), {plain: true});
  const file = JSON.parse(text) as GarmentCodeSpecification;
  expect(Object.keys(file)).toEqual(['pattern', 'parameters', 'parameter_order', 'properties']);
  for (const {edges} of Object.values(file.pattern.panels))
    for (const {curvature} of edges)
      if (curvature && 'type' in curvature)
        expect(['quadratic', 'cubic', 'circle']).toContain(curvature.type);
  const split = await readGarment(text, 'plain.json');
  expect(split.pieces.map(({name}) => name)).toEqual(whole.pieces.map(({name}) => name));
  const parts = partsOf(whole, split);
  for (const [p, piece] of whole.pieces.entries()) {
    expect(split.pieces[p]?.mirroredFromInput).toBe(piece.mirroredFromInput);
    expect(sum(parts[p]?.map((those) => those.length) ?? [])).toBe(split.pieces[p]?.outline.length);
    for (const [k, edge] of piece.outline.entries()) {
      const those = parts[p]?.[k] ?? [];
      const [length, lengths] = [edgeLength(edge), those.map(edgeLength)];
      expect(Math.abs(sum(lengths) - length)).toBeLessThan(1e-6);
      for (const [i, part] of those.entries()) {
        const before = sum(lengths.slice(0, i));
        for (const share of [0, 0.3, 0.7]) {
          const at = pointAt(edge, (before + share * (lengths[i] ?? NaN)) / length);
          expect(distance(pointAt(part, share), at)).toBeLessThan(1e-6);
        }
      }
    }
  }
  let number = 0;
  for (const {a, b, sameDirection} of whole.seams) {
    const [one, other] = [a, b].map(({piece, edge}) => parts[piece]?.[edge] ?? []);
    expect(one?.length).toBe(other?.length);
    const [lengthA, lengthB] = [one, other].map((those) => sum(those?.map(edgeLength) ?? []));
    const inOrder = sameDirection ? other : [...(other ?? [])].reverse();
    for (const [k, part] of (one ?? []).entries()) {
      const seam = split.seams[number++];
      expect(seam?.sameDirection).toBe(sameDirection);
      const [edgeA, edgeB] = [seam?.a, seam?.b].map(
        (end) => split.pieces[end?.piece ?? -1]?.outline[end?.edge ?? -1],
      );
      expect(edgeA).toEqual(part);
      expect(edgeB).toEqual(inOrder?.[k]);
      const shareA = edgeLength(part) / (lengthA ?? NaN);
      const shareB = edgeLength(inOrder?.[k] ?? part) / (lengthB ?? NaN);
      expect(Math.abs(shareA - shareB) * Math.min(lengthA ?? 0, lengthB ?? 0)).toBeLessThan(0.004);
    }
  }
  expect(split.seams).toHaveLength(number);
  return split;
}

/** A wavy path of cubics of different lengths along the direction `way`. */
function wave(lengths: readonly number[], from: Point, way: Point): DraftedEdge {
  const at = (x: number, y: number): Point => [
    from[0] + x * way[0] - y * way[1],
    from[1] + x * way[1] + y * way[0],
  ];
  const points: Point[] = [];
  let x = 0;
  for (const [k, length] of lengths.entries()) {
    const bulge = (k % 2 ? -0.1 : 0.1) * length;
    points.push(
      at(x + length / 3, bulge),
      at(x + (2 * length) / 3, bulge / 2),
      at((x += length), 0),
    );
  }
  return {points: [from, points[0] ?? from, ...points.slice(1)]};
}

/** A square of 12 cm with the given right side, sewn to the left side of another one. */
function sewn(right: DraftedEdge, left: DraftedEdge, sameDirection: boolean): GarmentDocument {
  const rest = (x: number): DraftedEdge[] => [
    {
      points: [
        [x, 0],
        [x + 12, 0],
      ],
    },
    {
      points: [
        [x + 12, 12],
        [x, 12],
      ],
    },
  ];
  const [bottom, top] = rest(0);
  const [low, high] = rest(40);
  const piece = (name: string, outline: readonly (DraftedEdge | undefined)[]) => ({
    ...{name, mirroredFromInput: false, holes: [], internalLines: []},
    outline: outline.flatMap((edge) => edge ?? []),
  });
  return {
    pieces: [
      piece('one', [
        bottom,
        right,
        top,
        {
          points: [
            [0, 12],
            [0, 0],
          ],
        },
      ]),
      piece('other', [
        low,
        {
          points: [
            [52, 0],
            [52, 12],
          ],
        },
        high,
        left,
      ]),
    ],
    seams: [
      {a: {piece: 0, edge: 1}, b: {piece: 1, edge: 3}, sameDirection, weight: 1, matched: true},
    ],
    ...{matches: [], symmetries: [], questions: []},
  };
}

const upwards = wave([2, 3, 1.5, 4, 1.5], [12, 0], [0, 1]);
const others: Readonly<Record<string, DraftedEdge>> = {
  'a line': {
    points: [
      [40, 12],
      [40, 0],
    ],
  },
  'a quadratic curve': {
    points: [
      [40, 12],
      [34, 5],
      [40, 0],
    ],
  },
  'a cubic': {
    points: [
      [40, 12],
      [36, 9],
      [42, 2],
      [40, 0],
    ],
  },
  'an arc': {
    points: [
      [40, 12],
      [40, 0],
    ],
    radius: 10,
    sweep: 2 * Math.asin(0.6),
  },
  'another path': wave([1, 4.002, 1.5, 5.498], [40, 12], [0, -1]),
};

describe('a garment as plain GarmentCode', () => {
  it.each(Object.keys(others).flatMap((name) => [[name, true] as const, [name, false] as const]))(
    'splits a path and %s at the same shares (start on start: %s)',
    async (name, sameDirection) => {
      const other = others[name];
      if (!other) throw new Error(name);
      const split = await checked(sewn(upwards, other, sameDirection));
      expect(split.seams.length).toBeGreaterThanOrEqual(5);
    },
  );

  it('makes one cut of two that nearly meet', async () => {
    const nearly = wave([1.5, 4.0003, 1.4997, 3, 2], [40, 12], [0, -1]);
    expect((await checked(sewn(upwards, nearly, false))).seams).toHaveLength(5);
  });

  it('leaves out cubics without length', async () => {
    const with0 = wave([2, 0, 3, 0.0005, 7], [12, 0], [0, 1]);
    const text = await convert(garmentFile(sewn(with0, others['a line'] ?? with0, false)), {
      plain: true,
    });
    const {pieces, seams} = await readGarment(text);
    expect(seams).toHaveLength(3);
    expect(sum(pieces[0]?.outline.slice(1, 4).map(edgeLength) ?? [])).toBeCloseTo(
      edgeLength(with0),
      2,
    );
  });

  it.each(['tee', 'hoodie'] as const)('has the outlines and seams of the %s', async (name) => {
    const whole = await readGarment(sample(name));
    const drawn = redrawn(whole, 3);
    const split = await checked(drawn);
    expect(split.seams.length).toBeGreaterThan(2 * whole.seams.length);
    const placed = whole.pieces.map(({placement}) => placement);
    expect(split.pieces.map(({placement}) => placement)).toEqual(placed);
    const {pieces, seams} = await prepare({
      garment: await convert(garmentFile(drawn), {plain: true}),
      print: checks,
    });
    expect(pieces).toHaveLength(whole.pieces.length);
    expect(seams).toHaveLength(split.seams.length);
  });

  it('says the same of a garment without paths, in centimetres', async () => {
    const whole = await readGarment(sample('trousers'));
    expect((await checked(whole)).seams).toHaveLength(whole.seams.length);
  });

  it('is what the command line writes', async () => {
    const folder = await mkdtemp(join(tmpdir(), 'seamwise-plain-'));
    const file = join(folder, 'tee.json');
    const text = garmentFile(redrawn(await readGarment(sample('tee')), 2));
    writeFileSync(file, text);
    const {code, out} = await seamwise('convert', file, '--plain');
    expect(code).toBe(0);
    expect(out).toBe(await convert(text, {plain: true}));
    expect((await seamwise('symmetries', file, '--plain')).code).toBe(2);
  });
});
