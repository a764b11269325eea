import {readFile} from 'node:fs/promises';

import {importGarment, readGarment, solve} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {tunic} from '../../support/files/drawn-mesh.js';
import {bodiceArea, freesewing, freesewingPart} from '../../support/files/drawn-svg.js';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const publicFile = (path: string): Promise<string> =>
  readFile(new URL(`../../../public/${path}`, import.meta.url), 'utf8');

describe('a pattern in SVG', () => {
  it('becomes a garment that the core reads, half pieces whole', async () => {
    const {garment, report} = await importGarment(bytesOf(freesewing(freesewingPart('front'))));
    expect(report).toMatchObject({
      units: {used: 'mm', from: 'file'},
      pieces: [{name: 'front', quantity: 1, notches: 2, grainDeg: 90, fold: true, cutLine: true}],
    });
    expect(Math.abs((report.pieces[0]?.areaCm2 ?? 0) - 2 * bodiceArea())).toBeLessThan(0.1);
    const {pieces, symmetries} = await readGarment(garment);
    expect(pieces).toHaveLength(1);
    expect(symmetries).toMatchObject([{kind: 'piece', piece: 'front'}]);
  });
});

describe('a garment of a simulator in OBJ', () => {
  it('comes with its seams, and is solved', async () => {
    const {garment, report} = await importGarment(bytesOf(tunic({grouped: true})));
    expect(report).toMatchObject({
      units: {used: 'm', from: 'guess'},
      pieces: [
        {name: 'front', widthCm: 50},
        {name: 'back', widthCm: 50},
      ],
    });
    expect(report.seams).toHaveLength(4);
    const print = await publicFile('prints/pmm.json');
    const result = await solve({garment, print});
    expect(result.pieces).toHaveLength(2);
    expect(result.seams).toHaveLength(4);
  });
});
