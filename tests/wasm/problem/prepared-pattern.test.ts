import {prepare, solve, type GarmentCodeSpecification, type MeshedPattern} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const strips = {garment: twoStrips(), print: checks};

/** The same strips, seen from the back: their loops run clockwise. */
function clockwiseStrips(): GarmentCodeSpecification {
  const front = twoStrips();
  const turned = Object.entries(front.pattern.panels).map(([name, panel]) => {
    const vertices = panel.vertices.map(([x, y]) => [-x, y] as const);
    return [name, {...panel, vertices}] as const;
  });
  return {...front, pattern: {...front.pattern, panels: Object.fromEntries(turned)}};
}

/** Returns whether every outline edge is on the edge of the strip that it is assigned to. */
function edgesLieOnTheirOwn({pieces}: MeshedPattern): boolean {
  // bottom, right, top, left of a strip 5 cm wide and 10 cm high
  const distances = [
    ([, y]: readonly number[]) => y,
    ([x = NaN]: readonly number[]) => x - 5,
    ([, y = NaN]: readonly number[]) => y - 10,
    ([x]: readonly number[]) => x,
  ];
  return pieces.every(({rest, outline, edges}) =>
    edges.every((edge, k) =>
      [outline[k], outline[(k + 1) % outline.length]].every(
        (vertex = NaN) => Math.abs(distances[edge]?.(rest[vertex] ?? []) ?? NaN) < 1e-9,
      ),
    ),
  );
}

describe('a prepared pattern', () => {
  it('shows every piece as it was drafted, laid on grain as a cutter would lay it', async () => {
    const {print, pieces, seams} = await prepare(strips);
    const {drafted} = await solve(strips);
    expect(print).toEqual(checks);
    expect(pieces.map(({name}) => name)).toEqual(['left', 'right']);
    for (const {rest, shape, alignment} of pieces) {
      expect(shape).toEqual(rest);
      expect(Math.sin(alignment.angle)).toBeCloseTo(0, 9); // upright and upside down are on grain
    }
    expect(pieces.map(({alignment}) => alignment)).toEqual(drafted);
    expect(seams).toMatchObject([{kind: 'continuous', mismatch: [], lengthRatio: 1}]);
  });

  it.each([
    ['as they are', twoStrips()],
    ['of panels that show their back', clockwiseStrips()],
  ])('knows the edges of the file %s', async (_, garment) => {
    const pattern = await prepare({garment, print: checks});
    expect(pattern.pieces.map(({edges}) => [...new Set(edges)])).toEqual([
      [0, 1, 2, 3],
      [0, 1, 2, 3],
    ]);
    expect(edgesLieOnTheirOwn(pattern)).toBe(true);
  });

  it('is the one that a solve begins with', async () => {
    const problem = {garment: sample('tee'), print: {...checks, group: 'pgg'} as const};
    const [pattern, result] = [await prepare(problem), await solve(problem)];
    const {pieces, seams, symmetries, metrics, notes} = result;
    expect(pattern.pieces.map(({rest, triangles}) => ({rest, triangles}))).toEqual(
      pieces.map(({rest, triangles}) => ({rest, triangles})),
    );
    expect(pattern.seams.map(({a, b}) => [a, b])).toEqual(seams.map(({a, b}) => [a, b]));
    expect(pattern.symmetries).toEqual(symmetries);
    expect(pattern.fitRandom).toBe(metrics.fitRandom);
    expect(pattern.notes).toEqual(notes);
    expect(notes).not.toEqual([]);
    expect(pattern.noteDetails).toEqual(result.noteDetails);
    expect(result.noteDetails).toMatchObject([{code: 'noMirrors'}]);
  });

  it('comes before the first alignments of a solve, once', async () => {
    const told: unknown[] = [];
    await solve(
      {...strips, seed: 5},
      {
        onPattern: (pattern) => told.push(pattern),
        onPartial: () => told.push('partial'),
        onProgress: ({phase}) => told.push(phase),
      },
    );
    const first = told.findIndex((step) => step !== 'preparation');
    expect(told[first]).toEqual(await prepare(strips));
    expect(new Set(told.slice(first + 1))).toEqual(
      new Set(['alignment', 'deformation', 'partial']),
    );
  });

  it('is refused for bad input, and when it is no longer wanted', async () => {
    const bad = prepare({...strips, garment: '{'}, {names: {garment: 'a.json'}});
    await expect(bad).rejects.toMatchObject({code: 'notJson', message: /^a\.json /});
    const late = prepare(strips, {signal: AbortSignal.abort('too late')});
    await expect(late).rejects.toBe('too late');
  });
});
