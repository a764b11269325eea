/** A piece has the same lines and marks in a layout as on the cutting sheet. */
import {cut, layPlanFiles, marker, readGarment, solve} from 'seamwise/node';
import {beforeAll, describe, expect, it} from 'vitest';

import {cutSheet} from '@/cutting/lay-sheet.js';
import type {LaidPiece} from '@/cutting/cut-sheet.js';
import {planPieces} from '@/marker/draw/plan-pieces.js';
import {readDxf} from '@/files/dxf/read-dxf.js';
import {panelMarks} from '@/model/garment/panel-marks.js';
import {onPrint, type Point} from '@/model/geometry/vectors.js';
import type {LayPlan} from '@/model/result/marker-plan.js';
import {checks} from '../../support/garments/samples.js';

const edges = (first: number) =>
  [0, 1, 2, 3].map((k) => ({endpoints: [first + k, first + ((k + 1) % 4)]}));

/** A front with a cut-out and every kind of mark, and a plain back. */
const file = JSON.stringify({
  format: 'seamwise-garment/1',
  properties: {units_in_meter: 100},
  pattern: {
    panels: {
      front: {
        vertices: [
          ...[
            [0, 0],
            [40, 0],
            [40, 60],
            [0, 60],
          ],
          ...[
            [14, 38],
            [26, 38],
            [26, 48],
            [14, 48],
          ],
        ],
        edges: edges(0),
        holes: [edges(4)],
        notches: [
          {edge: 1, at: 0.3},
          {edge: 3, at: 0.5},
        ],
        drillHoles: [[20, 20]],
        internalLines: [
          [
            [5, 10],
            [15, 10],
          ],
        ],
        grain: {
          line: [
            [20, 5],
            [20, 30],
          ],
        },
      },
      back: {
        vertices: [
          [60, 0],
          [100, 0],
          [100, 60],
          [60, 60],
        ],
        edges: edges(0),
        notches: [{edge: 3, at: 0.7}],
      },
    },
    stitches: [
      [
        {panel: 'front', edge: 1},
        {panel: 'back', edge: 3},
      ],
      [
        {panel: 'front', edge: 3},
        {panel: 'back', edge: 1},
      ],
    ],
  },
});

const near = (p: Point): Point => [Number(p[0].toFixed(6)) + 0, Number(p[1].toFixed(6)) + 0];

/** Lines and points of a laid piece in the coordinates of its shape, in no particular order. */
function marksOf({place, cut: lines, sewn, notches, drillHoles, internalLines, ticks}: LaidPiece) {
  const back = (points: readonly Point[]) =>
    points.map((p) => near(onPrint(place, p))).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return {
    cut: lines.map(back),
    sewn: sewn.map(back),
    notches: back(notches.map(({at}) => at)),
    drillHoles: back(drillHoles),
    internalLines: internalLines.map(back),
    ticks: back(ticks.map(({at}) => at)),
  };
}

describe('the pieces of a layout', () => {
  let sheet: readonly LaidPiece[];
  let laid: readonly (LaidPiece | undefined)[];
  let [cutDxf, planDxf, planSvg] = ['', '', ''];

  beforeAll(async () => {
    const garment = await readGarment(file);
    const result = await solve({garment: file, print: checks});
    const results = [{result, garment}];
    const plan: LayPlan = await marker(results, {widthCm: 140, allowanceCm: 1.5});
    laid = planPieces(plan, {results}, ({piece}) => piece).map((piece) => piece.laid);
    const rule = {allowanceCm: 1.5, hemCm: 1.5, units: 'cm'} as const;
    sheet = cutSheet(result, checks, {panels: panelMarks(garment, {})}, rule).pieces;
    cutDxf = (await cut(result, {print: checks, garment, allowanceCm: 1.5})).dxf();
    const files = await layPlanFiles(plan, {print: checks, results});
    [planDxf, planSvg] = [files.dxf(), files.svg()];
  });

  it('are those of the cutting sheet', () => {
    const byName = (a: {name: string}, b: {name: string}): number => a.name.localeCompare(b.name);
    const found = laid.flatMap((piece) => piece ?? []).sort(byName);
    expect(found.map(marksOf)).toEqual([...sheet].sort(byName).map(marksOf));
    expect(found.map((piece) => piece.cut.length)).toEqual([1, 2]);
  });

  it('have the same number of lines on each layer of both DXF files', () => {
    // the layout has the edges of the fabric on layer 8 as well
    const layers = ['1', '4', '7', '11', '13', '14'];
    const counted = (dxf: string) => {
      const lines = dxf.split('\r\n');
      const entities = lines.flatMap((line, k) => {
        const isEntity = line.trim() === '0' && /^(POLYLINE|LINE|POINT)$/.test(lines[k + 1] ?? '');
        return isEntity ? [`${lines[k + 1] ?? ''} ${lines[k + 3] ?? ''}`] : [];
      });
      return layers.map((layer) => entities.filter((one) => one.endsWith(` ${layer}`)).sort());
    };
    expect(counted(planDxf)).toEqual(counted(cutDxf));
    expect(counted(planDxf).map((one) => one.length)).toEqual([2, 5, 2, 1, 1, 3]);
  });

  it('come back from the DXF file, with their marks', () => {
    const drawing = readDxf(new TextEncoder().encode(planDxf), 'plan.dxf', {});
    const counted = drawing.pieces.map((piece) =>
      [piece.holes, piece.notches, piece.drillHoles, piece.internalLines].map((one) => one.length),
    );
    expect(drawing.pieces.map(({name}) => name)).toEqual(['Front', 'Back']);
    expect(counted).toEqual([
      [1, 3, 1, 1],
      [0, 2, 0, 0],
    ]);
    // the fabric's own outline
    expect(drawing.notes).toEqual([expect.stringMatching(/^1 closed line .* 140\.0 x/)]);
  });

  it('tell cut, sewn and marked lines apart by colour', () => {
    const colours = ['cut', 'sew', 'marks'].map((layer) => {
      const drawn = planSvg.matchAll(new RegExp(`class="${layer}"[^>]*stroke="([^"]*)"`, 'g'));
      return [...new Set([...drawn].map(([, colour]) => colour))];
    });
    expect(colours.map((some) => some.length)).toEqual([1, 1, 1]);
    expect(new Set(colours.flat()).size).toBe(3);
  });
});
