/** Suggested seams of imported patterns. */
import {importGarment} from 'seamwise/node';
import {expect, it} from 'vitest';

import {twoStrips} from '../../support/garments/samples.js';

it('are left out with a note where a pattern has too many edges to compare', async () => {
  const strip = twoStrips().pattern.panels.left;
  const panels = Object.fromEntries(Array.from({length: 151}, (_, k) => [`piece ${k}`, strip]));
  const pattern = {pattern: {panels, stitches: []}, properties: {units_in_meter: 100}};
  const bytes = new TextEncoder().encode(JSON.stringify(pattern));
  const {report} = await importGarment(bytes, {name: 'strips.json', seams: 'suggest'});
  expect(report.pieces).toHaveLength(151);
  expect(report.seams).toEqual([]);
  expect(report.notes).toContainEqual(
    'No seams are suggested: the pieces have 604 edges, and at most 600 can be compared; import fewer pieces.',
  );
});
