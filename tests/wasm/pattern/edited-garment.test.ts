/** Garments after an edit, as read by the solver. */
import {readFileSync} from 'node:fs';

import {garmentFile, readGarment, solve, type GarmentDocument} from 'seamwise/node';
import {expect, it} from 'vitest';

import {edgeLength} from '@/model/garment/edge-curve.js';
import {sew, splitEdge, unsew} from '@/model/garment/edits.js';

const text = readFileSync('public/garments/tee-m.json', 'utf8');
const print = readFileSync('public/prints/p4m.json', 'utf8');

const fitOf = async (garment: string): Promise<number> =>
  (await solve({garment, print, symmetry: 'none', seed: 1, options: {visibility: 'even'}})).metrics
    .fit;

/** Removes all seams and sews them again in the same order. */
const sewnAgain = (document: GarmentDocument): GarmentDocument => {
  const bare = document.seams.reduce((next) => unsew(next, 0).document, document);
  return document.seams.reduce((next, {a, b, sameDirection, weight}) => {
    const {document: sewn} = sew(next, {a: [a], b: [b], sameDirection});
    return {
      ...sewn,
      seams: sewn.seams.map((one, k) => (k < next.seams.length ? one : {...one, weight})),
    };
  }, bare);
};

it('measures edges as the solver samples them, and reads what is split as it was split', async () => {
  const document = await readGarment(text);
  const at = {piece: 0, edge: 2};
  const {document: split} = splitEdge(document, at, 0.3);
  const read = await readGarment(garmentFile(split));
  expect(read.seams).toEqual(split.seams);
  const [whole] = document.pieces.map(({outline}) => outline.map(edgeLength));
  const [parts] = read.pieces.map(({outline}) => outline.map(edgeLength));
  expect((parts?.[2] ?? 0) + (parts?.[3] ?? 0)).toBeCloseTo(whole?.[2] ?? 0, 9);
});

it('fits as before once edges have been split, sewn ones with what they are sewn to', async () => {
  const document = await readGarment(text);
  const hem = splitEdge(document, {piece: 0, edge: 0}, 0.5).document;
  const armhole = splitEdge(hem, {piece: 1, edge: 2}, 0.5).document;
  const [before, after] = [await fitOf(text), await fitOf(garmentFile(armhole))];
  expect(Math.abs(after - before)).toBeLessThan(0.1 * before);
});

it('fits the same once all seams have been made anew', async () => {
  const document = await readGarment(text);
  const again = sewnAgain(document);
  expect(await fitOf(garmentFile(again))).toBeCloseTo(await fitOf(garmentFile(document)), 9);
});
