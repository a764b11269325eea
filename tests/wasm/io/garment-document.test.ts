/** Garments as documents: read from both file formats, written, and read again unchanged. */
import {readdirSync, readFileSync} from 'node:fs';

import {garmentFile, readGarment, SolverError, type GarmentCodeSpecification} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

/** Equal documents may differ in their last digits after a conversion of units and frames. */
function expectNear(one: unknown, other: unknown, at = ''): void {
  if (typeof one === 'number' && typeof other === 'number') {
    expect(Math.abs(one - other), at).toBeLessThan(1e-9 * Math.max(1, Math.abs(one)));
  } else if (typeof one === 'object' && typeof other === 'object' && one && other) {
    expect(Object.keys(other).sort(), at).toEqual(Object.keys(one).sort());
    for (const [key, value] of Object.entries(one)) {
      expectNear(value, (other as Record<string, unknown>)[key], `${at}/${key}`);
    }
  } else {
    expect(other, at).toBe(one);
  }
}

const samples = readdirSync('public/garments').filter((name) => name.endsWith('-m.json'));

/** A panel that shows its back, in inches, with every field that a file may have, and more. */
const everything = {
  format: 'seamwise-garment/1',
  title: 'Tie',
  size: 'M',
  author: {name: 'Ada'},
  names: {'2': 'Tip'},
  properties: {units_in_meter: 100 / 2.54, curvature_coords: 'relative', note: 'drawn by hand'},
  pattern: {
    panel_order: ['2', '1'],
    panels: {
      '2': {
        label: 'Tip of the tie',
        translation: [1, 50, 4],
        rotation: [10, 20, 30],
        vertices: [
          [0, 0],
          [0, 20],
          [8, 20],
          [8, 0],
          [3, 8],
          [3, 10],
          [5, 9],
        ],
        edges: [
          {
            endpoints: [0, 1],
            curvature: {
              type: 'path',
              params: [
                [
                  [0.1, 0.02],
                  [0.3, 0.02],
                  [0.4, 0.01],
                ],
                [
                  [0.6, -0.02],
                  [0.9, 0.02],
                ],
              ],
            },
            label: 'left',
          },
          {
            endpoints: [1, 2],
            curvature: {type: 'circle', params: [5, 0, 0]},
            allowance: {width: 0.5, corner: 'square'},
            open: true,
          },
          {
            endpoints: [2, 3],
            curvature: {
              type: 'cubic',
              params: [
                [0.3, 0.1],
                [0.6, -0.05],
              ],
            },
          },
          {endpoints: [3, 0], curvature: [0.5, 0.1], finish: 'raw', allowance: 0},
        ],
        holes: [
          [
            {endpoints: [4, 5]},
            {
              endpoints: [5, 6],
              curvature: {
                type: 'path',
                params: [
                  [
                    [0.1, 0.1],
                    [0.2, 0.1],
                    [0.4, 0.1],
                  ],
                  [
                    [0.6, 0.1],
                    [0.9, 0.1],
                  ],
                ],
              },
            },
            {endpoints: [6, 4], label: 'rim', allowance: 0.25, ribbon: 'red'},
          ],
        ],
        grain: {
          line: [
            [1, 1],
            [2, 12],
          ],
          lock: 'bias',
          toleranceDeg: 5,
        },
        internalLines: [
          [
            [1, 1],
            [2, 2],
            [3, 1],
          ],
        ],
        cutLine: [
          [-1, -1],
          [9, -1],
        ],
        sewLine: [
          [0, 0],
          [8, 0],
        ],
        notches: [{edge: 2, at: 0.25, depth: 0.2}],
        drillHoles: [
          [2, 3],
          [4, 3],
        ],
        folds: [
          {
            line: [
              [1, 18],
              [1, 12],
            ],
            to: [
              [2, 18],
              [2, 12],
            ],
            kind: 'knife',
            stitched: 4,
          },
          {
            line: [
              [6, 18],
              [6, 12],
            ],
            kind: 'press',
          },
        ],
        quantity: 2,
        size: '38',
        material: 'silk',
        pocket: true,
      },
      '1': {
        vertices: [
          [0, 0],
          [8, 0],
          [8, 8],
        ],
        edges: [{endpoints: [0, 1]}, {endpoints: [1, 2]}, {endpoints: [2, 0]}],
      },
    },
    stitches: [[{panel: '2', edge: 3}, {panel: '1', edge: 0}, 'right_wrong']],
  },
  seams: [
    {
      ...{stitch: 0, name: 'Waist', weight: 0.5, matched: false, direction: 'same', tape: 1},
      suggested: true,
    },
  ],
  symmetries: [
    {
      kind: 'piece',
      piece: '2',
      axis: [
        [10, 0],
        [10, 40],
      ],
    },
  ],
  matches: [
    {
      a: {
        piece: '2',
        line: [
          [2, 2],
          [2, 9],
        ],
      },
      b: {
        piece: '1',
        line: [
          [9, 3],
          [9, 8],
        ],
      },
      ...{name: 'Button', thread: 'grey'},
    },
  ],
} as const;

describe('a garment document', () => {
  it.each(samples)('of %s is written as a file that reads as the same', async (name) => {
    const document = await readGarment(readFileSync(`public/garments/${name}`, 'utf8'), name);
    expect(document.pieces.length).toBeGreaterThan(0);
    expect(document.questions).toEqual([]);
    expectNear(document, await readGarment(garmentFile(document), 'written.json'));
  });

  it('keeps all that a file says, in its order, through a file', async () => {
    const text = JSON.stringify(everything).replace('"panels":{"1"', '"panels":{"1"');
    const document = await readGarment(text, 'tie.json');
    const [first, second] = document.pieces;
    const back = document.pieces.find(({name}) => name === '2');
    expect(back).toMatchObject({
      ...{label: 'Tip of the tie', mirroredFromInput: true, quantity: 2, size: '38'},
      ...{material: 'silk', more: {pocket: true}},
      placement: {rotation: [-10, 200, 30]},
      notches: [{edge: 2, at: 0.25, depth: 0.2}],
    });
    expect(back?.outline[0]).toMatchObject({label: 'left'});
    expect(back?.outline[0]?.points).toHaveLength(7);
    expect(back?.outline[0]?.points.at(-1)?.[1]).toBeCloseTo(50.8, 9);
    expect(back?.holes[0]?.map(({points}) => points.length).sort()).toEqual([2, 2, 7]);
    // the file lists the edge between its last and its first vertex
    const rim = back?.holes[0]?.find(({label}) => label === 'rim');
    expect(rim).toMatchObject({allowance: {width: 0.635}, more: {ribbon: 'red'}});
    expect(rim?.points.map(([, y]) => y / 2.54).sort((a, b) => a - b)).toEqual([
      expect.closeTo(8, 6),
      expect.closeTo(9, 6),
    ]);
    expect(document.matches[0]).toMatchObject({name: 'Button', more: {thread: 'grey'}});
    expect(back?.outline[1]?.radius).toBeCloseTo(12.7, 9);
    expect(back?.outline[1]).toMatchObject({
      allowance: {width: 1.27, corner: 'square'},
      open: true,
    });
    expect(back?.outline[3]).toMatchObject({more: {finish: 'raw'}, allowance: {width: 0}});
    expect(back?.drillHoles?.[1]?.[0]).toBeCloseTo(-10.16, 9);
    expect(document.seams[0]?.suggested).toBe(true);
    expect(document.seams[0]).toMatchObject({
      ...{name: 'Waist', weight: 0.5, matched: false, sameDirection: true, more: {tape: 1}},
    });
    expect(document).toMatchObject({
      ...{title: 'Tie', size: 'M', names: {'2': 'Tip'}, more: {author: {name: 'Ada'}}},
      moreProperties: {note: 'drawn by hand'},
      morePattern: {panel_order: ['2', '1']},
      symmetries: [
        {
          axis: [
            [-10, 0],
            [-10, 40],
          ],
        },
      ],
    });
    expectNear(document, await readGarment(garmentFile(document), 'written.json'));
    // names that look like numbers change their order in a JavaScript object
    const turned = {...document, pieces: second && first ? [second, first] : []};
    const seams = document.seams.map((seam) => ({
      ...seam,
      a: {...seam.a, piece: 1 - seam.a.piece},
      b: {...seam.b, piece: 1 - seam.b.piece},
    }));
    expectNear({...turned, seams}, await readGarment(garmentFile({...turned, seams}), 'x.json'));
  });

  it('asks for the unit when nobody could wear what it says', async () => {
    const text = readFileSync('public/garments/tee-m.json', 'utf8');
    const tee = JSON.parse(text) as GarmentCodeSpecification;
    const inMillimetres = {...tee, properties: {...tee.properties, units_in_meter: 1000}};
    const {questions} = await readGarment(inMillimetres);
    expect(questions).toEqual([
      {about: 'units', tallestCm: expect.any(Number) as number, likely: ['cm', 'inch']},
    ]);
  });

  it('of a file that is none is refused as by a solve', async () => {
    await expect(readGarment('{"pattern": {}}', 'odd.json')).rejects.toThrow(
      expect.objectContaining({code: 'notAGarment'}) as SolverError,
    );
  });
});
