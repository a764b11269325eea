import {validateBytes} from 'gltf-validator';
import {expect, it} from 'vitest';

import {cellPicture, glb, type GlbOptions} from '@/files/glb/glb.js';
import {coordinates, onPrint, type Alignment} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';
import {at} from '../../support/plane.js';
import {png} from '../../support/image/raw-png.js';
import {readGlb} from '../../support/drape/read-glb.js';
import {squaresDrape, squaresResult} from '../../support/drape/sewn-squares.js';
import {plainPrint} from '../../support/garments/two-squares.js';

const picture = cellPicture(new Uint8Array(png(8, 8)));
if (!picture) throw new Error('a PNG is one');

const alignments: readonly Alignment[] = [
  {angle: 0.3, translation: [31.7, -12.2]},
  {angle: -1.9, translation: [-7.1, 99.3]},
];
const result = {
  pieces: squaresResult.pieces.map((piece, k) => ({
    ...piece,
    alignment: alignments[k] ?? piece.alignment,
  })),
};
const file = (options: GlbOptions = {picture}, print: Print = plainPrint) =>
  glb(result, squaresDrape(), print, options);

it.each<[string, GlbOptions]>([
  ['with a picture', {picture}],
  ['without one', {}],
  ['with a plain piece', {picture, plain: ['left']}],
  ['of plain pieces', {picture, plain: ['left', 'right']}],
  ['with all that can be asked', {picture, attributes: true, form: true, garment: 'Two "squäres"'}],
])('writes files that the validator of glTF finds nothing wrong with: %s', async (_, options) => {
  const {issues, info} = await validateBytes(file(options));
  expect(issues.messages.filter(({severity}) => severity < 2)).toEqual([]);
  expect(issues).toMatchObject({numErrors: 0, numWarnings: 0});
  expect(info.totalTriangleCount).toBe(64 + (options.form ? 12 : 0));
});

it.each<Print>([
  plainPrint,
  {group: 'p1', w1: [7, 1], w2: [2, 9], cell: 'primitive'},
  {group: 'cm', w1: [3, -4], w2: [3, 4], cell: 'rectangular'},
  {group: 'p6m', w1: [6, 0], w2: [3, 3 * Math.sqrt(3)], cell: 'rectangular'},
  {group: 'p1', w1: [5, 0], w2: [3, 4], cell: 'centred'},
])('puts every vertex where it lies on the cell: $group $cell', (print) => {
  const read = readGlb(file({picture, attributes: true}, print));
  const [primitive] = read.json.meshes[0]?.primitives ?? [];
  const attribute = (name: string) => read.vectors(primitive?.attributes[name] ?? -1);
  const places = attribute('_SHAPE');
  const pieces = attribute('_PIECE');
  const cell = imageCell(print);
  expect(places).toHaveLength(50);
  attribute('TEXCOORD_0').forEach(([s = NaN, t = NaN], k) => {
    const [x = NaN, y = NaN] = places[k] ?? [];
    const alignment = at(alignments, pieces[k]?.[0] ?? -1);
    const [u, v] = coordinates(cell, onPrint(alignment, [x, y]));
    for (const off of [s - u, 1 - t - v])
      expect(Math.abs(off - Math.round(off))).toBeLessThan(1e-5);
    expect(Math.max(Math.abs(s), Math.abs(t))).toBeLessThan(4); // near the first cell: precise
  });
});

it('measures in metres, faces the print outwards, and shades smoothly across seams', () => {
  const read = readGlb(file());
  const [primitive] = read.json.meshes[0]?.primitives ?? [];
  const positions = read.vectors(primitive?.attributes.POSITION ?? -1);
  const normals = read.vectors(primitive?.attributes.NORMAL ?? -1);
  const heights = positions.map(([, y = NaN]) => y);
  expect(Math.min(...heights)).toBeCloseTo(1, 6);
  expect(Math.max(...heights)).toBeCloseTo(1.04, 6);
  for (const normal of normals) expect(normal).toEqual([0, 0, 1]);

  const bent = squaresDrape();
  const apex = bent.mesh.pieces[1]?.sewn[12] ?? 0; // the middle of a square
  bent.positions[3 * apex + 2] = 9;
  const seam = [...(bent.mesh.pieces[0]?.sewn ?? [])];
  const other = readGlb(glb(result, bent, plainPrint));
  const [shaded] = other.json.meshes[0]?.primitives ?? [];
  const list = other.vectors(shaded?.attributes.NORMAL ?? -1);
  bent.mesh.pieces[1]?.sewn.forEach((vertex, k) => {
    const twin = seam.indexOf(vertex);
    if (twin >= 0) expect(list[25 + k]).toEqual(list[twin]);
  });
  for (const [x = 0, y = 0, z = 0] of list) expect(Math.hypot(x, y, z)).toBeCloseTo(1, 6);
});

it('holds the picture as it is, which repeats by itself', () => {
  const {json, bytesOf} = readGlb(file({picture, plain: ['left']}));
  expect(json.images).toEqual([{bufferView: expect.any(Number) as number, mimeType: 'image/png'}]);
  expect(bytesOf(json.images?.[0]?.bufferView ?? -1)).toEqual(picture.bytes);
  expect(json.samplers).toEqual([{wrapS: 10497, wrapT: 10497, magFilter: 9729, minFilter: 9987}]);
  expect(json.extensionsUsed).toBeUndefined();
  expect(json.materials.map(({name}) => name)).toEqual(['print', 'plain']);
  expect(json.materials[1]?.pbrMetallicRoughness.baseColorTexture).toBeUndefined();
});

it('says what it shows, and has the form as a node of its own', () => {
  const {json} = readGlb(file({picture, form: true, garment: 'Squares', sha256: 'ab'}));
  expect(json.nodes.map(({name}) => name)).toEqual(['garment', 'form']);
  expect(json.scenes[0]?.nodes).toEqual([0, 1]);
  expect(json.extras).toMatchObject({
    ...{format: 'seamwise-glb/1', garment: 'Squares', sha256: 'ab', units: 'm'},
    ...{print: {group: 'p1', w1: [10, 0], w2: [0, 10]}, pieces: ['right', 'left']},
  });
});

it('writes the same bytes again, and other texture coordinates only for another placing', () => {
  expect(file()).toEqual(file());
  const elsewhere: Alignment = {angle: 1, translation: [3, 4]};
  const moved = {pieces: result.pieces.map((piece) => ({...piece, alignment: elsewhere}))};
  const read = [file(), glb(moved, squaresDrape(), plainPrint, {picture})].map(readGlb);
  const [one, other] = read.map((glb) => {
    const {attributes, indices} = glb.json.meshes[0]?.primitives[0] ?? {indices: -1};
    const {TEXCOORD_0: uv = -1, ...rest} = attributes ?? {};
    return {uv: glb.vectors(uv), rest: [...Object.values(rest), indices].map(glb.vectors)};
  });
  expect(other?.rest).toEqual(one?.rest);
  expect(other?.uv).not.toEqual(one?.uv);
});

it('refuses a drape of another garment', () => {
  const [first, second] = result.pieces;
  if (!first || !second) throw new Error('there are two');
  const swapped = {pieces: [second, first]};
  expect(() => glb(swapped, squaresDrape(), plainPrint)).toThrow(
    "The result has no piece 'right' there; drape it again.",
  );
});

it('knows PNG and JPEG, which glTF has, from all else', () => {
  expect(cellPicture(Uint8Array.of(0xff, 0xd8, 0xff, 0xe0))?.type).toBe('image/jpeg');
  expect(cellPicture(new TextEncoder().encode('<svg/>'))).toBeUndefined();
  expect(cellPicture(new Uint8Array())).toBeUndefined();
});
