/**
 * The colour of the exported model along a ray is that of the print at the same place of the cut
 * piece.
 */
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {createCanvas, loadImage} from '@napi-rs/canvas';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {coordinates, onPrint, type Alignment, type Point} from '@/model/geometry/vectors.js';
import {seamwise} from '../../support/cli/command-line.js';
import {everywhere, painted, pngOf} from '../../support/image/pictures.js';
import {at} from '../../support/plane.js';
import {readGlb} from '../../support/drape/read-glb.js';
import {shortSkirt} from '../../support/garments/samples.js';

const cell: readonly [Point, Point] = [
  [7, 1],
  [2, 9],
];
const print = {
  ...{format: 'seamwise-print/1', title: 'Everywhere', group: 'p1'},
  ...{w1: cell[0], w2: cell[1], cell: 'primitive', image: 'cell.png'},
};

let folder = '';
const file = (name: string): string => join(folder, name);

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('skirt.json'), shortSkirt());
  writeFileSync(file('print.json'), JSON.stringify(print));
  writeFileSync(
    file('cell.png'),
    pngOf(painted(everywhere.width, everywhere.height, everywhere.paint)),
  );
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

/** A viewer's colour at texture coordinates of a repeating image, (0, 0) its upper left corner. */
async function texels(bytes: Uint8Array): Promise<(s: number, t: number) => readonly number[]> {
  const image = await loadImage(Buffer.from(bytes));
  const context = createCanvas(image.width, image.height).getContext('2d');
  context.drawImage(image, 0, 0);
  const {data} = context.getImageData(0, 0, image.width, image.height);
  const pixel = (share: number, count: number): number =>
    Math.floor((share - Math.floor(share)) * count) % count;
  return (s, t) => {
    const first = 4 * (image.width * pixel(t, image.height) + pixel(s, image.width));
    return [...data.subarray(first, first + 3)];
  };
}

/** Random numbers from 0 to 1, the same in every run. */
function numbers(): () => number {
  let state = 12_345;
  return () => {
    state = (1_103_515_245 * state + 12_345) % 2 ** 31;
    return state / 2 ** 31;
  };
}

it('shows at a hundred places of the cloth what the print has there', async () => {
  const cloth = ['--print', file('print.json')];
  const aligned = await seamwise(
    ...['align', file('skirt.json'), ...cloth, '--no-remedies', '--out', file('result.json')],
  );
  expect(aligned.code, aligned.err).toBeLessThan(2);
  const draped = await seamwise(
    ...['drape', file('result.json'), ...cloth, '--attributes', '--glb', file('skirt.glb')],
  );
  expect(draped.code, draped.err).toBe(0);
  const {pieces} = JSON.parse(readFileSync(file('result.json'), 'utf8')) as {
    readonly pieces: readonly {readonly alignment: Alignment}[];
  };
  const read = readGlb(readFileSync(file('skirt.glb')));
  const [primitive] = read.json.meshes[0]?.primitives ?? [];
  const attribute = (name: string) => read.vectors(primitive?.attributes[name] ?? -1);
  const [uv, shape, piece] = ['TEXCOORD_0', '_SHAPE', '_PIECE'].map(attribute);
  const triangles = read.vectors(primitive?.indices ?? -1).flat();
  const shown = await texels(read.bytesOf(read.json.images?.[0]?.bufferView ?? -1));
  const printed = await texels(readFileSync(file('cell.png')));
  const next = numbers();
  const met = new Set<number>();
  for (let k = 0; k < 100; k++) {
    const first = 3 * Math.floor((next() * triangles.length) / 3);
    const corners = triangles.slice(first, first + 3);
    const [a, b] = [next(), next()].sort((one, other) => one - other) as [number, number];
    const weights = [a, b - a, 1 - b];
    /** Interpolates between the corners of a triangle, like a graphics card. */
    const here = (list: readonly (readonly number[])[] = []): Point =>
      [0, 1].map((axis) =>
        corners.reduce((sum, one, m) => sum + at(weights, m) * at(at(list, one), axis), 0),
      ) as unknown as Point;
    const [owner = -1] = piece?.[corners[0] ?? -1] ?? [];
    met.add(owner);
    const [u, v] = coordinates(cell, onPrint(at(pieces, owner).alignment, here(shape)));
    const [model, file] = [shown(...here(uv)), printed(u, 1 - v)];
    for (const [channel, value] of model.entries())
      expect(Math.abs(value - at(file, channel))).toBeLessThanOrEqual(4);
  }
  expect(met.size).toBe(pieces.length);
});
