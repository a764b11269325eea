/** Suggested seams of imported patterns. */
import {importGarment} from 'seamwise/node';
import {expect, it} from 'vitest';

it('are left out with a note where a pattern has too many edges to compare', async () => {
  const square = {
    vertices: [
      [0, 0],
      [20, 0],
      [20, 20],
      [0, 20],
    ],
    edges: [0, 1, 2, 3].map((k) => ({endpoints: [k, (k + 1) % 4]})),
  };
  const panels = Object.fromEntries(Array.from({length: 151}, (_, k) => [`piece ${k}`, square]));
  const pattern = {pattern: {panels, stitches: []}, properties: {units_in_meter: 100}};
  const bytes = new TextEncoder().encode(JSON.stringify(pattern));
  const {report} = await importGarment(bytes, {name: 'squares.json', seams: 'suggest'});
  expect(report.pieces).toHaveLength(151);
  expect(report.seams).toEqual([]);
  expect(report.notes).toContainEqual(
    'No seams are suggested: the pieces have 604 edges, and at most 600 can be compared; import fewer pieces.',
  );
});
