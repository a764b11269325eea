/** The stored drape of the opening sample. */
import {readFileSync} from 'node:fs';

import {expect, it} from 'vitest';

import {readStoredDrape, units} from '@/model/documents/stored-drape.js';
import {welcome} from '@/workbench/samples.js';
import {storedDrape} from '@samples/drapes/encode.js';

const file = readFileSync('public/opening.drape');

it('is small, and shows the sample of a first visit sewn together', async () => {
  expect(file.length).toBeLessThanOrEqual(40_000);
  const {sample, symmetries, alignments, drape} = await readStoredDrape(new Blob([file]));
  expect(sample).toEqual(welcome);
  expect(symmetries.length).toBeGreaterThan(0);
  const {mesh, positions} = drape;
  expect(alignments).toHaveLength(mesh.pieces.length);
  expect(positions).toHaveLength(3 * mesh.size);
  for (const {a, b} of mesh.seams) {
    const [one, other] = [a, b].map(({piece, vertices}) =>
      Array.from(vertices, (vertex) => mesh.pieces[piece]?.sewn[vertex]),
    );
    expect(one).toEqual(other);
  }
});

it('returns a mesh to within half a unit, in another order of vertices', async () => {
  const whole = await readStoredDrape(new Blob([file]));
  const again = await readStoredDrape(new Blob([Uint8Array.from(storedDrape(whole))]));
  const places = ({drape}: typeof whole): readonly string[] =>
    drape.mesh.pieces.flatMap(({triangles, sewn}) =>
      Array.from(triangles, (vertex) =>
        [0, 1, 2]
          .map((k) =>
            Math.round((drape.positions[3 * (sewn[vertex] ?? 0) + k] ?? NaN) / units.space),
          )
          .join(' '),
      ),
    );
  expect(places(again).toSorted()).toEqual(places(whole).toSorted());
});
