import {mirror, solve, symmetries, type Symmetry} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const strips = twoStrips();

/** Strips of 5 cm, one of them a centimetre higher than the other. */
function unequalStrips() {
  const [lower, higher] = [twoStrips(10), twoStrips(11)];
  const panels = {left: lower.pattern.panels.left, right: higher.pattern.panels.right};
  return JSON.stringify({...lower, pattern: {...lower.pattern, panels}});
}

describe('a symmetry that holds', () => {
  it.each<[string, Symmetry]>([
    [
      'an axis',
      {
        kind: 'piece',
        piece: 'left',
        axis: [
          [2.5, 0],
          [2.5, 10],
        ],
      },
    ],
    [
      'an axis clicked 2 mm beside it',
      {
        kind: 'piece',
        piece: 'left',
        axis: [
          [2.7, 0],
          [2.6, 10],
        ],
      },
    ],
    ['two edges', {kind: 'piece', piece: 'left', seams: [1, 3]}],
    ['a pair', {kind: 'pair', pieces: ['left', 'right']}],
  ])('by %s is measured as exact: x goes to 5 - x', async (_, asked) => {
    const {residual, map, mirrors} = await mirror(strips, asked);
    expect(residual).toBeLessThan(1e-6);
    expect(mirrors).toBe(true);
    expect(Math.abs(map.angle)).toBeLessThan(1e-9);
    expect(map.translation[0]).toBeCloseTo(5, 6);
    expect(map.translation[1]).toBeCloseTo(0, 6);
  });

  it('is what the garment shows by itself, map included', async () => {
    const {symmetries: found} = await symmetries(sample('tee'));
    expect(found.map(({kind}) => kind)).toEqual(['piece', 'piece', 'pair']);
    for (const one of found) {
      expect(await mirror(sample('tee'), one)).toEqual({...one, mirrors: true});
    }
  });

  it('can be asked of a solve as it was measured', async () => {
    const measured = await mirror(strips, {kind: 'pair', pieces: ['left', 'right']});
    const {symmetries: imposed} = await solve({
      garment: strips,
      print: checks,
      symmetry: {symmetries: [measured]},
    });
    expect(imposed).toMatchObject([{kind: 'pair', pieces: [0, 1], map: measured.map}]);
  });
});

describe('a symmetry that does not hold', () => {
  it('is measured as it was clicked, when no mirror is near', async () => {
    // across x = 1, the right edge x = 5 maps to x = -3
    const {residual, mirrors, map} = await mirror(strips, {
      kind: 'piece',
      piece: 'left',
      axis: [
        [1, 0],
        [1, 10],
      ],
    });
    expect({residual, mirrors}).toEqual({residual: 3, mirrors: false});
    expect(map.translation[0]).toBeCloseTo(2);
  });

  it('is measured between pieces of different height', async () => {
    const {residual, mirrors} = await mirror(unequalStrips(), {
      kind: 'pair',
      pieces: ['left', 'right'],
    });
    expect(mirrors).toBe(false);
    expect(residual).toBeGreaterThan(0.49); // a centimetre, split between both ends at best
    expect(residual).toBeLessThan(1.01);
  });

  it('is measured between pieces that are nothing alike', async () => {
    const asked: Symmetry = {kind: 'pair', pieces: ['front', 'sleeve_left']};
    const {residual, mirrors} = await mirror(sample('tee'), asked);
    expect(mirrors).toBe(false);
    expect(residual).toBeGreaterThan(5);
    expect(residual).toBeLessThan(100);
  });
});

describe('a symmetry that makes no sense', () => {
  it.each<[string, Symmetry, string]>([
    ['an unknown piece', {kind: 'piece', piece: 'hood'}, 'symmetryUnknownPiece'],
    ['an unknown partner', {kind: 'pair', pieces: ['left', 'hood']}, 'symmetryUnknownPiece'],
    ['an edge too many', {kind: 'piece', piece: 'left', seams: [1, 4]}, 'symmetryMalformed'],
    ['an unknown kind', {kind: 'glide'} as unknown as Symmetry, 'symmetryMalformed'],
    ['nothing', undefined as unknown as Symmetry, 'symmetryMalformed'],
  ])('is refused in a sentence: %s', async (_, asked, code) => {
    await expect(mirror(strips, asked)).rejects.toMatchObject({
      name: 'SolverError',
      code,
      message: expect.stringMatching(/^symmetry: .*\.$/) as string,
    });
  });
});
