/** DXF files of cutting sheets are imported again, piece by piece. */
import {readFile} from 'node:fs/promises';

import {prepare, readGarment, type MeshedPattern} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import type {CutSheet, LaidPiece} from '@/cutting/cut-sheet.js';
import {cutSheet} from '@/cutting/lay-sheet.js';
import {draftedSheet} from '@/cutting/drafted-sheet.js';
import {sheetDxf, type DxfOptions} from '@/cutting/out/sheet-dxf.js';
import {readDxf} from '@/files/dxf/read-dxf.js';
import {nearestOn} from '@/model/geometry/nearest.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import {edgeLine} from '@/model/garment/edge-curve.js';
import {foldLines} from '@/model/garment/folds.js';
import type {DraftedFold, GarmentDocument, GarmentPiece} from '@/model/garment/garment-document.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import {atShare} from '@/model/geometry/polyline.js';
import {distance, type Point} from '@/model/geometry/vectors.js';
import {checks} from '../../support/garments/samples.js';
import {isThorough, sampleOf} from '../../support/level.js';

/** A commit takes the first three: between them they are written in each format. */
const samples = sampleOf(3, [
  ...['tee', 'apron', 'gathered-skirt', 'asymmetric-dress', 'hoodie', 'patchwork-jacket'],
  ...['princess-dress', 'raglan', 'shift-dress', 'shirt', 'six-gore-skirt', 'trousers'],
]);

const formats: readonly DxfOptions[] = [
  {style: 'aama', unit: 'mm'},
  {style: 'aama', unit: 'in'},
  {style: 'astm', unit: 'mm'},
  {style: 'astm', unit: 'in'},
];

/** The drafted pieces of a garment on the print's crossing lines, with allowances. */
function sheetOf(garment: GarmentDocument, pattern: MeshedPattern): CutSheet {
  const marks = {title: 'Sample', size: 'M', panels: panelMarks(garment)};
  return cutSheet(pattern, checks, marks, {allowanceCm: 1, units: 'cm'});
}

function imported(dxf: string, size?: string): GarmentDocument {
  const drawing = readDxf(new TextEncoder().encode(dxf), 'sheet.dxf', {
    ...(size !== undefined && {size}),
  });
  const choices = defaultChoices(drawing);
  expect([...choices.notes, ...drawing.notes]).toEqual([]);
  return garmentOf(drawing, choices);
}

const traced = (loop: GarmentPiece['outline']): readonly Point[] =>
  loop.flatMap((edge) => edgeLine(edge, 64).slice(0, -1));

/** Greatest distance of every third point from a line. [cm] */
const off = (points: readonly Point[], line: readonly Point[], isClosed = true): number =>
  Math.max(0, ...points.map((at, k) => (k % 3 === 0 ? nearestOn(line, at, isClosed).off : 0)));

const notchesOf = ({outline, notches = []}: GarmentPiece): readonly Point[] =>
  notches.flatMap(({edge, at}) => {
    const drawn = outline[edge];
    return drawn ? [atShare(edgeLine(drawn, 400), at).at] : [];
  });

/** Greatest distances between the lines and marks of a laid piece and those of an imported one. */
function farthest(laid: LaidPiece, piece: GarmentPiece): Record<string, number> {
  const [sewn = [], ...cutOuts] = laid.sewn;
  const {outline, holes, cutLine, internalLines, drillHoles = []} = piece;
  const found = notchesOf(piece);
  const counts = [holes, internalLines, drillHoles, found].map((marks) => marks.length);
  const {notches} = laid;
  const drawn = [cutOuts, laid.internalLines, laid.drillHoles, notches];
  expect([laid.name, ...counts]).toEqual([laid.name, ...drawn.map((marks) => marks.length)]);
  return {
    sewn: off(sewn, traced(outline)),
    cut: cutLine ? off(laid.cut[0] ?? [], cutLine) : 0,
    holes: Math.max(0, ...cutOuts.map((hole, k) => off(hole, traced(holes[k] ?? [])))),
    inner: Math.max(
      0,
      ...internalLines.map((line, k) => off(laid.internalLines[k] ?? [], line, false)),
    ),
    drills: Math.max(
      0,
      ...laid.drillHoles.map((hole, k) => distance(hole, drillHoles[k] ?? [0, 0])),
    ),
    notches: Math.max(0, ...notches.map(({at}) => Math.min(...found.map((p) => distance(p, at))))),
  };
}

const tooFar = (sheet: CutSheet, {pieces}: GarmentDocument): string[] =>
  sheet.pieces.flatMap((laid, k) =>
    Object.entries(pieces[k] ? farthest(laid, pieces[k]) : {missing: Infinity})
      .filter(([, far]) => far > 0.005)
      .map(([what, far]) => `${laid.name}: ${what} ${far}`),
  );

/** The first format, and the others of a sample: all of them in a thorough run, else one in turn. */
function formatsOf(sample: number): readonly DxfOptions[] {
  const [first = {}, ...others] = formats;
  return [first, ...(isThorough ? others : others.slice(sample % 3, (sample % 3) + 1))];
}

describe.each(samples.map((name, k) => [name, formatsOf(k)] as const))(
  'the DXF of the %s',
  (name, written) => {
    it('is imported again to 0.05 mm, in each format', async () => {
      const text = await readFile(`public/garments/${name}-m.json`, 'utf8');
      const garment = await readGarment(text, name);
      const sheet = sheetOf(garment, await prepare({garment: text, print: checks}));
      const notches = sheet.pieces.flatMap((piece) => piece.notches);
      expect(notches.filter(({seam}) => seam === undefined)).toEqual([]);
      const [first, ...others] = written.map((format) => imported(sheetDxf(sheet, format)));
      expect(first && tooFar(sheet, first)).toEqual([]);
      // other formats differ by rounding alone
      const corners = ({pieces}: GarmentDocument): number[] =>
        pieces.flatMap(({outline}) => outline.flatMap(({points: [[x, y]]}) => [x, y]));
      const known = first ? corners(first) : [];
      for (const other of others) {
        const off = corners(other).map((x, k) => Math.abs(x - (known[k] ?? NaN)));
        expect(Math.max(...off)).toBeLessThan(0.005);
      }
      const drafted = draftedSheet(garment, {allowanceCm: 0, units: 'cm'});
      expect(tooFar(drafted, imported(sheetDxf(drafted)))).toEqual([]);
    });
  },
);

it.each(['box-pleated-skirt', 'tucked-blouse'])(
  'the DXF of the %s contains its folds',
  async (name) => {
    const garment = await readGarment(
      await readFile(`public/garments/${name}-m.json`, 'utf8'),
      name,
    );
    const sheet = draftedSheet(garment, {allowanceCm: 1, units: 'cm'});
    const {pieces} = imported(sheetDxf(sheet));
    sheet.pieces.forEach(({name: piece, folds}, k) => {
      const found = pieces[k]?.folds ?? [];
      expect(found.map(({kind}) => kind)).toEqual(folds.map(({kind}) => kind));
      const ends = (all: readonly Pick<DraftedFold, 'line' | 'to'>[]) =>
        all.flatMap((fold) => foldLines(fold).flat());
      const off = ends(found).map((p, n) => distance(p, ends(folds)[n] ?? [0, 0]));
      expect(Math.max(0, ...off), piece).toBeLessThan(0.005);
      expect(pieces[k]?.internalLines, piece).toEqual([]);
    });
  },
);
