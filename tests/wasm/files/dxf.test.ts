import {mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {importGarment, readGarment} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {seamwise} from '../../support/cli/command-line.js';
import {bowedSquare, dxfOf, habits} from '../../support/files/dxf-habits.js';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

const pattern = [
  {...bowedSquare('front', 60), quantity: '1,1', notches: [[30, 0] as const]},
  bowedSquare('back', 50, [100, 0]),
];

describe('a pattern in DXF', () => {
  it('becomes a garment that the core reads, curves as one edge each', async () => {
    const {garment, report} = await importGarment(bytesOf(dxfOf(pattern, habits.gerber)));
    const {pieces, symmetries} = await readGarment(garment);
    expect(pieces.map(({name}) => name)).toEqual(['front', 'front 2', 'back']);
    expect(pieces.map(({outline}) => outline.length)).toEqual([4, 4, 4]);
    expect(pieces.every(({mirroredFromInput}) => !mirroredFromInput)).toBe(true);
    expect(pieces[0]?.grain).toMatchObject({lock: 'on'});
    expect(symmetries).toEqual([{kind: 'pair', pieces: ['front', 'front 2']}]);
    expect(report).toMatchObject({
      pieces: [
        {
          name: 'front',
          widthCm: 60,
          quantity: 2,
          notches: 1,
          grainDeg: 90,
          fold: false,
          taken: true,
        },
        {name: 'back', widthCm: 50, quantity: 1, notches: 0},
      ],
      ...{sizes: ['34', '36', '38'], size: '36', units: {used: 'in', from: 'file'}},
    });
  });

  it('has seams suggested unless they are not wanted, and says so in the file', async () => {
    const bytes = bytesOf(dxfOf(pattern, habits.clo));
    const suggested = await importGarment(bytes);
    const {seams} = await readGarment(suggested.garment);
    expect(seams).toHaveLength(suggested.report.seams.length);
    expect(seams.every((seam) => seam.suggested)).toBe(true);
    for (const seams of ['file', 'none'] as const) {
      expect((await importGarment(bytes, {seams})).report.seams).toEqual([]);
    }
  });

  it('that crosses itself is refused with the name of the piece', async () => {
    const [front] = pattern;
    const crossed = front?.edges.map((edge, k) =>
      k === 1 ? [[60, 0] as const, [-20, 30] as const, [60, 60] as const] : edge,
    );
    const text = dxfOf([{...bowedSquare('front', 60), edges: crossed ?? []}], habits.polypattern);
    await expect(importGarment(bytesOf(text), {name: 'yoke.dxf'})).rejects.toThrow(
      /yoke\.dxf.*'front'.*cross/,
    );
  });

  it('that nobody could wear waits to be told its unit', async () => {
    const bytes = bytesOf(dxfOf(pattern, {...habits.optitex, perCm: 0.01}));
    await expect(importGarment(bytes, {name: 'tent.dxf'})).rejects.toThrow(/^tent\.dxf .*--units/);
    const {report} = await importGarment(bytes, {units: 'm'});
    expect(report.units).toEqual({used: 'm', from: 'flag'});
    expect(report.pieces[0]?.widthCm).toBeCloseTo(60, 3);
  });
});

describe('import at the command line', () => {
  let folder = '';
  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'seamwise-import-'));
    await writeFile(join(folder, 'p.dxf'), dxfOf(pattern, habits.gerber));
  });
  afterAll(() => rm(folder, {recursive: true}));

  it('writes the garment and prints what was found', async () => {
    const out = join(folder, 'p.json');
    const {code, out: printed} = await seamwise(
      'import',
      join(folder, 'p.dxf'),
      '--size',
      '38',
      '--out',
      out,
      '--json',
    );
    expect(code).toBe(0);
    expect(JSON.parse(printed)).toMatchObject({
      size: '38',
      pieces: [{widthCm: 61.8}, {widthCm: 51.5}],
    });
    expect((await readGarment(await readFile(out, 'utf8'))).pieces).toHaveLength(3);
  });

  it('reads garments, too, and keeps their seams', async () => {
    const {code, out} = await seamwise('import', 'public/garments/tee-m.json', '--json');
    expect(code).toBe(0);
    const report = JSON.parse(out) as {pieces: unknown[]; seams: {score: number}[]};
    expect(report.pieces).toHaveLength(4);
    expect(report.seams.length).toBeGreaterThan(0);
    expect(report.seams.every(({score}) => score === 1)).toBe(true);
  });

  it('ends with 2 and one sentence for a size that is not there', async () => {
    const {code, err} = await seamwise('import', join(folder, 'p.dxf'), '--size', 'XL');
    expect(code).toBe(2);
    expect(err).toMatch(/p\.dxf has no size 'XL'; it has 34, 36, 38\.\n$/);
  });
});
