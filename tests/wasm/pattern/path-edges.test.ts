/** Path edges: chains of cubics that are read, solved and written as single edges. */
import {garmentFile, readGarment, solve, symmetries} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {redrawn} from '../../support/garments/path-edges.js';
import {checks, sample} from '../../support/garments/samples.js';

const pathsOf = async (name: 'tee' | 'hoodie', parts: number) =>
  redrawn(await readGarment(sample(name)), parts);

describe('a garment drawn as paths', () => {
  it('is written as a file that reads as the same', async () => {
    const document = await pathsOf('hoodie', 25);
    const lengths = document.pieces.flatMap(({outline}) =>
      outline.map((edge) => edge.points.length),
    );
    expect(lengths).toContain(76);
    const again = await readGarment(garmentFile(document), 'written.json');
    for (const [p, piece] of document.pieces.entries()) {
      for (const [k, edge] of piece.outline.entries()) {
        const read = again.pieces[p]?.outline[k]?.points ?? [];
        expect(read).toHaveLength(edge.points.length);
        for (const [i, [x, y]] of edge.points.entries()) {
          expect(Math.hypot((read[i]?.[0] ?? NaN) - x, (read[i]?.[1] ?? NaN) - y)).toBeLessThan(
            1e-9,
          );
        }
      }
    }
  });

  it.each([2, 40])('fits as before, by %d cubics an edge', async (parts) => {
    const drawn = garmentFile(await pathsOf('tee', parts));
    // with even weights, the course of this search does not depend on the last digits
    const options = {visibility: 'even'} as const;
    const [before, after] = [
      await solve({garment: sample('tee'), print: checks, options}),
      await solve({garment: drawn, print: checks, options}),
    ];
    expect(after.seamGroups?.map(({place}) => place)).toEqual(
      before.seamGroups?.map(({place}) => place),
    );
    for (const [p, {name, rest, outline}] of before.pieces.entries()) {
      const drawn = after.pieces[p];
      expect(drawn?.outline).toEqual(outline);
      for (const k of outline) {
        const [[x, y] = [0, 0], [u, v] = [NaN, NaN]] = [rest[k], drawn?.rest[k]];
        expect(Math.hypot(u - x, v - y), name).toBeLessThan(1e-8);
      }
    }
    expect(after.seams.map(({a}) => a.vertices)).toEqual(before.seams.map(({a}) => a.vertices));
    // differences in the last digits of outlines change the course of a search
    expect(Math.abs(after.metrics.fit / before.metrics.fit - 1)).toBeLessThan(5e-3);
    expect(after.symmetries).toHaveLength(before.symmetries.length);
  });

  it('mirrors as before', async () => {
    const found = await symmetries(garmentFile(await pathsOf('hoodie', 12)));
    const before = await symmetries(sample('hoodie'));
    expect(found.symmetries.map(({kind}) => kind)).toEqual(before.symmetries.map(({kind}) => kind));
    for (const {residual} of found.symmetries) expect(residual).toBeLessThan(1e-6);
  });
});
