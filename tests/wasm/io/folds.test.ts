/** Folds of garment files that cannot be folded: one sentence that names piece and fold. */
import {readGarment, SolverError} from 'seamwise/node';
import {expect, it} from 'vitest';

const fold = (changes: object): string => {
  const line = [
    [4, 10],
    [4, 0],
  ];
  const to = [
    [6, 10],
    [6, 0],
  ];
  const corners = [
    [0, 0],
    [20, 0],
    [20, 10],
    [0, 10],
  ];
  return JSON.stringify({
    pattern: {
      panels: {
        front: {
          vertices: corners,
          edges: corners.map((_, k) => ({endpoints: [k, (k + 1) % 4]})),
          folds: [
            {line, to, kind: 'box'},
            {line, to, kind: 'knife', ...changes},
          ],
        },
      },
      stitches: [],
    },
    properties: {units_in_meter: 100},
  });
};

const refused: readonly (readonly [string, object, string])[] = [
  ['an unknown kind', {kind: 'pinch'}, "unknown kind 'pinch'; write knife, box, inverted, tuck"],
  ['no second line', {to: undefined}, "'to'"],
  ['a line of one point', {line: [[4, 10]]}, "'line'"],
  ['a bent line', {line: [[4, 10], [5, 5], [4, 0]]}, "needs a straight 'line' of two distinct"], // prettier-ignore
  ['a point for a line', {to: [[6, 5], [6, 5]]}, "needs a straight 'to' of two distinct"], // prettier-ignore
  ['a line outside the piece', {to: [[30, 10], [30, 0]]}, 'ends 10 cm outside the piece'], // prettier-ignore
  ['lines that cross', {to: [[2, 10], [6, 0]]}, 'lines that cross'], // prettier-ignore
  ['one line twice', {to: [[4, 10], [4, 0]]}, 'less than 0.1 cm apart'], // prettier-ignore
];

it.each(refused)('refuses a fold with %s', async (_, changes, said) => {
  const read = readGarment(fold(changes), 'skirt.json');
  await expect(read).rejects.toThrow(SolverError);
  await expect(read).rejects.toThrow(said);
  await expect(read).rejects.toThrow(/^skirt\.json: panel 'front', fold 1 .*\.$/);
});

it('reads lines in the same direction', async () => {
  const {pieces} = await readGarment(
    fold({
      to: [
        [6, 0],
        [6, 10],
      ],
    }),
  );
  expect(pieces[0]?.folds?.[1]?.to).toEqual([
    [6, 10],
    [6, 0],
  ]);
});
