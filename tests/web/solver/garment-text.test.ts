import {expect, it} from 'vitest';

import {garmentText} from '@/solver/json/garment-text.js';

const plain = {
  pattern: {panels: {front: {vertices: [[0, 0]], edges: []}}, stitches: []},
  properties: {curvature_coords: 'relative', units_in_meter: 100},
};
/** A garment in the project's own format with every field, and with unknown ones. */
const rich = {
  parameters: {length: 20.125, note: 'café'},
  ...plain,
  format: 'seamwise-garment/1',
  'x-shop': {price: 49.9, tags: ['a', null, false, [], {}], says: '"\n\u0001'},
};
const read = (text: string): unknown => JSON.parse(text);

it('gives the same bytes the second time', () => {
  for (const document of [plain, rich]) {
    const once = garmentText(JSON.stringify(document));
    expect(garmentText(once)).toBe(once);
  }
});

it('keeps every field, unknown ones included', () => {
  expect(read(garmentText(JSON.stringify(rich)))).toEqual(rich);
});

it('writes what JSON.stringify writes, the format first', () => {
  const {parameters, pattern, properties} = rich;
  const inOrder = {format: rich.format, parameters, pattern, properties, 'x-shop': rich['x-shop']};
  expect(garmentText(JSON.stringify(rich))).toBe(`${JSON.stringify(inOrder, null, 1)}\n`);
});

it('keeps numbers as they are written, and members in order', () => {
  const text = garmentText('{"x": [1.50, 1E2, 12345678901234567890, -0.0], "b": 1, "10": 2}');
  expect(text).toContain('[\n  1.50,\n  1E2,\n  12345678901234567890,\n  -0.0\n ]');
  expect(text.indexOf('"b"')).toBeLessThan(text.indexOf('"10"'));
});

it('states what was assumed, where it stood', () => {
  const assumed = {units_in_meter: 100, curvature_coords: 'relative'};
  const file = {format: 'seamwise-garment/0', properties: null, pattern: {}};
  const written = read(garmentText(JSON.stringify(file)));
  expect(written).toEqual({format: 'seamwise-garment/1', properties: assumed, pattern: {}});
  expect(Object.keys(written as object)).toEqual(['format', 'properties', 'pattern']);
  expect(read(garmentText('{"properties": {"units_in_meter": null}}'))).toEqual({
    format: 'seamwise-garment/1',
    properties: assumed,
  });
});

it('stays readable for whoever knows the plain format only', () => {
  expect(read(garmentText(JSON.stringify(plain)))).toMatchObject(plain);
});
