import fc from 'fast-check';
import {describe, expect, it} from 'vitest';

import {tracedLoop} from '@/files/base/bezier.js';
import {readDrawing} from '@/files/read-drawing.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import type {Drawing, DrawnPiece} from '@/model/garment/imported-drawing.js';
import type {GarmentDocument} from '@/model/garment/garment-document.js';
import {boxOf, signedArea} from '@/model/geometry/polyline.js';
import {
  block,
  box,
  closedLine,
  drawnDxf,
  flap,
  insertion,
  segment,
  segments,
  text,
  type Entity,
} from '../../support/files/drawn-dxf.js';
import {cases} from '../../support/level.js';

const read = (dxf: string): Drawing => readDrawing(new TextEncoder().encode(dxf), 'plain.dxf');
const drawn = (...entities: readonly Entity[]): Drawing => read(drawnDxf({entities}));
const garment = (drawing: Drawing): GarmentDocument => garmentOf(drawing, defaultChoices(drawing));

const areaOf = ({sewn}: DrawnPiece): number =>
  Math.round(Math.abs(signedArea(tracedLoop(sewn, 0.01))) / 100);

/** Areas of pieces that are taken. [cm2] */
const areas = ({pieces}: Drawing): number[] =>
  pieces.filter(({doubt}) => doubt === undefined).map(areaOf);

const flapArea = 1150;

describe('closed lines', () => {
  it('are pieces on each layer, whatever lies on the boundary layer', () => {
    expect(
      areas(
        drawn(
          closedLine(flap(0, 0), 1),
          closedLine(box(500, 0, 300, 200), 2),
          closedLine(box(900, 0, 300, 300), 'BACK'),
        ),
      ),
    ).toEqual([flapArea, 600, 900]);
  });

  it.each([
    ['loose', [], [closedLine(box(500, 0, 300, 200), 1)]],
    [
      'in a block that a program named',
      [block('*U7', closedLine(box(500, 0, 300, 200), 1))],
      [insertion('*U7')],
    ],
    [
      'in a block with sewn lines only',
      [block('B', closedLine(box(500, 0, 300, 200), 14))],
      [insertion('B')],
    ],
    ['in a block on layer 0', [block('B', closedLine(box(500, 0, 300, 200), 0))], [insertion('B')]],
  ])('beside a block are pieces, too: %s', (_, blocks, entities) => {
    const drawing = read(
      drawnDxf({
        blocks: [block('A', closedLine(flap(0, 0), 1)), ...blocks],
        entities: [insertion('A'), ...entities],
      }),
    );
    expect(areas(drawing)).toEqual([flapArea, 600]);
  });

  it('outside of each other in one block are pieces, unless its words name one', () => {
    const lines = [closedLine(flap(0, 0), 1), closedLine(box(500, 0, 300, 200), 2)];
    const read1 = (...more: readonly Entity[]): number[] =>
      areas(read(drawnDxf({blocks: [block('A', ...lines, ...more)], entities: [insertion('A')]})));
    expect(read1()).toEqual([flapArea, 600]);
    expect(read1(text('Piece Name: FLAP', [50, 50], 1))).toEqual([flapArea]);
  });

  it('of 4 cm2 and more are pieces, smaller ones are counted', () => {
    const drawing = drawn(
      closedLine(flap(0, 0)),
      closedLine(box(500, 0, 20, 100)),
      closedLine(box(600, 0, 15, 10)),
    );
    expect(areas(drawing)).toEqual([flapArea, 20]);
    expect(drawing.notes).toEqual([
      '1 closed line outside of pieces, marks or below 4 cm²: left out; it is 1.5 x 1.0 cm at x 60.0 cm, y 0.0 cm on layer 0.',
    ]);
  });

  it('inside a piece are cut out, or kept as a mark on another layer', () => {
    const circle = (layer: string): Entity => [0, 'CIRCLE', 8, layer, 10, 250, 20, 150, 40, 80];
    const hole = drawn(closedLine(flap(0, 0)), circle('0'));
    expect(hole.pieces).toMatchObject([{holes: [expect.anything()]}]);
    expect(hole.notes.join()).toMatch(/taken as cut out \(16\.0 x 16\.0 cm/);
    expect(hole.pieces[0]?.doubtfulHoles).toEqual([0]);
    const asLine = garmentOf(hole, {unit: 'mm', pieces: [{take: true, cut: 'once', lines: [0]}]});
    expect(asLine.pieces).toMatchObject([{holes: [], internalLines: [expect.anything()]}]);
    const onBoundary = drawn(closedLine(flap(0, 0), 1), circle('1'));
    expect(onBoundary.pieces).toMatchObject([{holes: [expect.anything()]}]);
    const mark = drawn(closedLine(flap(0, 0)), circle('POCKET'));
    expect(mark.pieces).toMatchObject([{holes: [], internalLines: [expect.anything()]}]);
  });

  it('around a cut-out on the layer of sewn lines are its sewn line', () => {
    const drawing = read(
      drawnDxf({
        blocks: [
          block(
            'A',
            closedLine(box(0, 0, 420, 320), 1),
            closedLine(box(10, 10, 400, 300), 14),
            closedLine(box(110, 110, 80, 80), 11),
            closedLine(box(100, 100, 100, 100), 14),
          ),
        ],
        entities: [insertion('A')],
      }),
    );
    const [piece] = drawing.pieces;
    expect(areas(drawing)).toEqual([1200]);
    expect(piece?.internalLines).toEqual([]);
    expect(piece?.holes.map((hole) => Math.abs(signedArea(tracedLoop(hole, 0.01))))).toEqual([
      expect.closeTo(10_000),
    ]);
  });

  it('that nothing else explains are offered', () => {
    const drawing = drawn(closedLine(flap(0, 0)), closedLine(box(500, 0, 50, 50)));
    expect(areas(drawing)).toEqual([flapArea]);
    expect(drawing.pieces[1]).toMatchObject({
      name: 'closed line on layer 0',
      doubt: 'it is a square or a grid for checking the size (5.0 x 5.0 cm at x 50.0 cm, y 0.0 cm)',
    });
    expect(defaultChoices(drawing).pieces.map(({take}) => take)).toEqual([true, false]);
  });

  it('around a dart are the cut line of the line with the dart', () => {
    const drawing = drawn(
      closedLine(box(0, 0, 320, 520)),
      closedLine([
        [10, 10],
        [150, 10],
        [160, 200],
        [170, 10],
        [310, 10],
        [310, 510],
        [10, 510],
      ]),
    );
    expect(areas(drawing)).toEqual([1481]);
    expect(drawing.pieces[0]?.cut).toBeDefined();
  });
});

describe('frames', () => {
  const frame = box(0, 0, 1189, 841);

  it.each([
    [
      'a frame of lines around one piece',
      [...segments([...frame, [0, 0]]), closedLine(flap(100, 100))],
      1,
    ],
    [
      'a frame in another',
      [
        closedLine(frame),
        closedLine(box(20, 20, 1149, 801)),
        closedLine(flap(100, 100)),
        closedLine(flap(600, 100)),
      ],
      2,
    ],
    [
      'a frame with a title box in its corner',
      [
        closedLine(frame),
        closedLine(box(1009, 0, 180, 60)),
        closedLine(flap(100, 100)),
        closedLine(flap(600, 100)),
      ],
      2,
    ],
    [
      'a title box by its words',
      [
        ...[closedLine(frame), closedLine(box(900, 40, 180, 60)), closedLine(flap(100, 100))],
        ...[text('Scale 1:1', [910, 50]), text('Drawn by A', [910, 80])],
      ],
      1,
    ],
    [
      'a frame around a piece with a cut-out, but of no size of paper',
      [
        closedLine(box(-50, -50, 1000, 500)),
        closedLine(flap(100, 100)),
        closedLine(box(250, 200, 80, 80)),
      ],
      1,
    ],
    [
      'a frame around a piece with words, beside one that does not close',
      [
        closedLine(box(-50, -50, 1000, 500)),
        ...[closedLine(flap(0, 0)), text('Front', [150, 100])],
        ...[...segments([...flap(450, 0), [450, 2]]), text('Back', [600, 100])],
      ],
      1,
    ],
  ])('are no pieces: %s', (_, entities, count) => {
    const drawing = drawn(...entities);
    expect(areas(drawing)).toEqual(Array.from({length: count}, () => flapArea));
    expect(drawing.notes.join(' ')).toMatch(
      /closed lines? \(frame around pieces\): left out; .* cm at/,
    );
  });
});

describe('gaps', () => {
  const gapped = (gap: number): Entity[] =>
    segments([
      [600, 0],
      [900, 0],
      [900, 400],
      [600, 400],
      [600, gap],
    ]);

  it.each([
    [0.05, 2, []],
    [0.25, 2, ["A gap of 0.25 mm in the outline of 'piece 2' at x 60.0 cm, y 0.0 cm was closed."]],
    [
      0.5,
      1,
      [
        'An outline on layer 0 does not close: its ends lie 0.5 mm apart at x 60.0 cm, y 0.0 cm; join them.',
      ],
    ],
  ])('of %d mm are closed or reported', (gap, count, notes) => {
    const drawing = drawn(closedLine(flap(0, 0)), ...gapped(gap));
    expect(areas(drawing)).toHaveLength(count);
    expect(drawing.notes).toEqual(notes);
  });

  const unclosed = segments([...flap(0, 0), [0, 0.8]]);

  it.each([
    ['around the sewn line of a piece', box(110, 20, 200, 200)],
    ['in a large line', box(-100, -100, 650, 500)],
  ])('are reported %s', (_, closed) => {
    const {notes} = drawn(closedLine(closed), ...unclosed);
    expect(notes.join(' ')).toMatch(/on layer 0 does not close: its ends lie 0\.8 mm apart/);
  });

  it('are named if nothing closes', () => {
    expect(() => drawn(...gapped(2))).toThrow(/no closed outline: .*2\.0 mm apart at x 60\.0/);
  });

  it('at T junctions of a net leave its outline', () => {
    const outline: Entity[] = [
      ...segments([
        [0, 0],
        [200, 0],
      ]),
      ...segments([
        [200, 0.1],
        [400, 0],
        [400, 300],
      ]),
      ...segments([
        [400, 300],
        [0, 300],
        [0, 0],
      ]),
    ];
    const construction = [
      segment([200, 0.2], [200, 299.9]),
      segment([0, 150], [200, 150]),
      segment([400, 300], [460, 340]),
    ];
    const drawing = drawn(...outline, ...construction);
    expect(areas(drawing)).toEqual([1200]);
    expect(drawing.pieces[0]?.internalLines.length).toBeGreaterThanOrEqual(2);
  });
});

it('leaves out what the program does not show, and says so', () => {
  const layer = (name: string, flags: number, colour: number): Entity => [
    ...[0, 'LAYER', 2, name, 70, flags, 62, colour],
  ];
  const drawing = read(
    drawnDxf({
      tables: [layer('OFF', 0, -3), layer('ICE', 1, 3)],
      entities: [
        closedLine(flap(0, 0)),
        closedLine(flap(500, 0), 'OFF'),
        closedLine(flap(500, 400), 'ICE'),
        closedLine(flap(0, 400), 0, [60, 1]),
        closedLine(flap(0, 800), 0, [67, 1]),
      ],
    }),
  );
  expect(areas(drawing)).toEqual([flapArea]);
  expect(drawing.notes.join(' ')).toMatch(
    /OFF, which is off.*ICE, which is frozen.*invisible.*paper/,
  );
});

it('leaves out a piece that crosses itself, and opens the others', () => {
  const drawing = drawn(
    closedLine(flap(0, 0)),
    closedLine([
      [500, 0],
      [900, 600],
      [900, 0],
      [550, 500],
    ]),
  );
  expect(defaultChoices(drawing).pieces.map(({take}) => take)).toEqual([true, false]);
  expect(defaultChoices(drawing).notes.join()).toContain('crosses itself');
});

describe('quantities', () => {
  const quantity = (words: string): GarmentDocument =>
    garment(
      read(
        drawnDxf({
          blocks: [block('A', closedLine(flap(0, 0), 1), text(`Quantity: ${words}`, [50, 50], 1))],
          entities: [insertion('A')],
        }),
      ),
    );

  it('in words are as drawn, then mirrored', () => {
    expect(quantity('1,1').symmetries).toMatchObject([{kind: 'pair'}]);
    expect(quantity('2').symmetries).toMatchObject([{kind: 'pair'}]);
    expect(quantity('2,0')).toMatchObject({pieces: [{quantity: 2}], symmetries: []});
    const {pieces} = quantity('0,2');
    expect(pieces).toMatchObject([{quantity: 2}]);
    const {low, high} = boxOf(pieces[0]?.outline.map(({points}) => points[0]) ?? []);
    expect([low[0], high[0]]).toEqual([-40, 0]);
    expect(quantity('2,2').pieces.map((piece) => piece.quantity)).toEqual([2, 2]);
  });

  it('count the columns and rows of an insertion', () => {
    const drawing = read(
      drawnDxf({
        blocks: [block('A', closedLine(flap(0, 0), 1))],
        entities: [insertion('A', [0, 0], [70, 2, 71, 1, 44, 500])],
      }),
    );
    expect(garment(drawing)).toMatchObject({pieces: [{quantity: 2}]});
  });

  it('count the insertions of a block without a boundary beside one with it', () => {
    const drawing = read(
      drawnDxf({
        blocks: [
          block('A', closedLine(flap(0, 0), 1)),
          block('B', closedLine(box(0, 0, 300, 200))),
        ],
        entities: [insertion('A'), insertion('B', [500, 0], [70, 2, 71, 1, 44, 400])],
      }),
    );
    expect(garment(drawing).pieces.map(({quantity = 1}) => quantity)).toEqual([1, 2]);
  });
});

it('names a piece by its text where a program made up the name of its block', () => {
  const named = (name: string): string | undefined =>
    read(
      drawnDxf({
        blocks: [block(name, closedLine(flap(0, 0), 1), text('Side front', [200, 100], 1))],
        entities: [insertion(name)],
      }),
    ).pieces[0]?.name;
  expect(['P1_0', 'A$C2F', 'SLEEVE'].map(named)).toEqual(['Side front', 'Side front', 'SLEEVE']);
});

/** Closed lines of random sizes and places, in and beside each other, on random layers. */
const randomLines = fc.array(
  fc.record({
    x: fc.integer({min: 0, max: 30}),
    y: fc.integer({min: 0, max: 30}),
    width: fc.integer({min: 1, max: 12}),
    height: fc.integer({min: 1, max: 12}),
    layer: fc.constantFrom('0', '1', '2', '8', '11', '14', 'CUT'),
  }),
  {minLength: 1, maxLength: 8},
);

/** Two squares in a narrow rectangle, which is a frame with a title box. */
const framedSquares: {x: number; y: number; width: number; height: number; layer: '0'}[] = [
  {x: 2, y: 6, width: 1, height: 1, layer: '0'},
  {x: 2, y: 6, width: 1, height: 5, layer: '0'},
  {x: 2, y: 7, width: 1, height: 1, layer: '0'},
  {x: 0, y: 0, width: 1, height: 1, layer: '0'},
];

it('accounts for each closed line: as a piece, a part of one, or in a note', () => {
  fc.assert(
    fc.property(randomLines, (lines) => {
      const entities = lines.map(({x, y, width, height, layer}) =>
        closedLine(box(50 * x + 1000, 50 * y, 41 * width, 43 * height), layer),
      );
      const drawing = drawn(closedLine(flap(0, 0)), ...entities);
      const inPieces = drawing.pieces.reduce(
        (sum, {cut, holes, internalLines}) =>
          sum + 1 + (cut ? 1 : 0) + holes.length + internalLines.length,
        0,
      );
      const noted = drawing.notes.reduce((sum, note) => {
        const [, count = '0'] = /^(?:A grid of )?(\d+) closed lines?(?! inside)/.exec(note) ?? [];
        return sum + Number(count);
      }, 0);
      expect(inPieces + noted).toBeGreaterThanOrEqual(1 + lines.length);
    }),
    {numRuns: cases(60, 400), examples: [[framedSquares]]},
  );
});
