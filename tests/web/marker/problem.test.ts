import {apply} from '@/model/geometry/plane-map.js';
import type {MarkerGarment} from '@/model/design/marker-garment.js';
import {describe, expect, it} from 'vitest';

import {cutRings, cutRingSteps} from '@/marker/cut-rings.js';
import {saidNote} from '@/marker/draw/note-texts.js';
import {layPlan} from '@/marker/plan.js';
import {markerOrder} from '@/marker/problem.js';
import {equalShifts} from '@/marker/repeats.js';
import type {MarkerSettings} from '@/marker/settings.js';
import {
  degrees,
  distance,
  minus,
  norm,
  onPiece,
  onPrint,
  radians,
  rotated,
  type Alignment,
  type Point,
} from '@/model/geometry/vectors.js';
import type {LayNote} from '@/model/result/lay-note.js';
import type {MarkerAnswer} from '@/model/result/marker-search.js';
import {boxOf, signedArea} from '@/model/geometry/polyline.js';
import {type GroupName} from '@/model/print/repeating-print.js';
import type {ResultPiece, SolveResult} from '@/model/result/result.js';
import {printElements, reduced} from '@/model/print/wallpaper.js';
import {documentOf, draftedSquare} from '../../support/garments/documents.js';
import {
  plainMetrics,
  plainPrint,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';

const result = (more: Partial<SolveResult> = {}): SolveResult => ({
  ...{format: 'seamwise-result/1', units: 'cm', search: [], notes: [], metrics: plainMetrics},
  ...squarePair(),
  ...more,
});

const orderOf = (garment: Partial<MarkerGarment> = {}, settings: Partial<MarkerSettings> = {}) =>
  markerOrder([{result: result(), ...garment}], {widthCm: 140, ...settings});

const saidOf = (notes: readonly LayNote[]): string => notes.map((note) => saidNote(note)).join();

describe('cut lines', () => {
  const rule = {allowanceCm: 1, hemCm: 3};
  const count = (laid: MarkerGarment, asked: typeof rule): number =>
    [...cutRingSteps(laid, asked)].length;

  it('are made piece by piece, so that a page goes on meanwhile, and each once', () => {
    const laid = {result: result()};
    expect(count(laid, rule)).toBeGreaterThanOrEqual(2 * laid.result.pieces.length);
    expect(count(laid, rule)).toBe(0);
    expect(cutRings(laid, rule)).toBe(cutRings({...laid}, {...rule}));
    expect(count(laid, {...rule, hemCm: 5})).toBeGreaterThan(0);
    const [, outline = []] = cutRings(laid, {...rule, hemCm: 5}).rings.values();
    expect(boxOf(outline).low[1]).toBeCloseTo(-5);
  });

  it('are those of printed pieces, whose names messages say with their file', () => {
    const plain = {result: result(), options: {plain: ['left_half']}};
    expect([...cutRings(plain, rule).rings.keys()]).toEqual([1]);
    expect(cutRings(plain, rule).ownAllowances).toBe('none');
  });
});

describe('a problem', () => {
  it('has the cut line of each piece, counter-clockwise, where it lies on the print', () => {
    const {problem, allowanceCm} = orderOf({}, {allowanceCm: 1.5});
    expect(allowanceCm).toBe(1.5);
    expect(problem.pieces.map(({name}) => name)).toEqual(['left_half', 'right_half']);
    for (const [k, {outline, alignment, turns, up, shifts}] of problem.pieces.entries()) {
      const {low, high} = boxOf(outline);
      expect(signedArea(outline)).toBeCloseTo(49, 3);
      expect([...low, ...high].map((side) => Number(side.toFixed(3)))).toEqual([
        -1.5, -1.5, 5.5, 5.5,
      ]);
      expect(alignment.translation).toEqual(k === 0 ? [0, 0] : [-4, 0]);
      expect([turns, shifts]).toEqual(['half', []]);
      expect(distance(up, [0, 1])).toBeLessThan(1e-9);
    }
    expect(problem).toMatchObject({widthCm: 140, selvedgeCm: 1, gapCm: 0.2, nap: 'none'});
    expect(problem).toMatchObject({alsoFree: true, wholeRepeats: false, effort: 1, seed: 1});
    expect(problem.phasesCm).toEqual([0, 1.25, 2.5, 3.75, 5, 6.25, 7.5, 8.75]);
    expect(problem.startCm).toBeUndefined();
  });

  it('has the allowances that the garment states', () => {
    const {outline: edges} = draftedSquare('left_half');
    const [bottom, ...others] = edges;
    const outline = bottom ? [{...bottom, allowance: {width: 2.5}}, ...others] : [];
    const garment = documentOf([
      draftedSquare('left_half', {outline}),
      draftedSquare('right_half'),
    ]);
    const [stated, ruled] = orderOf({garment}, {allowanceCm: 1}).problem.pieces.map((piece) =>
      boxOf(piece.outline),
    );
    expect(stated?.low[1]).toBeCloseTo(-2.5, 3);
    expect(stated?.high[1]).toBeCloseTo(5, 3);
    expect(ruled?.high[1]).toBeCloseTo(5, 3);
  });

  it('lets grain rules say by which turns a piece is laid', () => {
    const turns = (garment: Partial<MarkerGarment>) =>
      orderOf(garment).problem.pieces.map((piece) => piece.turns);
    const grain = {default: 'bias', pieces: {left_half: {lock: 'across'}}} as const;
    expect(turns({options: {grain}})).toEqual(['half', 'quarter']);
    expect(turns({options: {grain: {default: 'free'}}})).toEqual(['any', 'any']);
    expect(turns({options: {grain: {pieces: {right_half: 'free'}}}})).toEqual(['half', 'any']);
    const garment = documentOf([
      draftedSquare('left_half', {grain: {lock: 'bias'}}),
      draftedSquare('right_half'),
    ]);
    expect(turns({garment})).toEqual(['quarter', 'half']);
    expect(turns({garment, options: {grain: {pieces: {left_half: 'on'}}}})[0]).toBe('half');
  });

  it('knows which way is up: along the grain line, or as the piece was solved', () => {
    const up = (more: Partial<ResultPiece>): Point | undefined => {
      const pieces = [squarePiece('one', more)];
      const garment = {result: result({pieces, seams: []})};
      return orderOf(garment).problem.pieces[0]?.up;
    };
    const at = (angle: number): Alignment => ({angle, translation: [0, 0]});
    expect(distance(up({grainAngle: -Math.PI / 2}) ?? [9, 9], [0, -1])).toBeLessThan(1e-9);
    expect(distance(up({grainAngle: 0}) ?? [9, 9], [0, 1])).toBeLessThan(1e-9);
    expect(distance(up({grainAngle: 0.5}) ?? [9, 9], [Math.cos(0.5), Math.sin(0.5)])).toBeLessThan(
      1e-9,
    );
    expect(distance(up({alignment: at(Math.PI / 2)}) ?? [9, 9], [-1, 0])).toBeLessThan(1e-9);
  });

  it('counts copies, results, and pieces that are cut several times', () => {
    const garment = documentOf([
      draftedSquare('left_half', {quantity: 2}),
      draftedSquare('right_half'),
    ]);
    const garments = [
      {result: result(), garment},
      {result: result(), name: 'L.json'},
    ];
    const {problem, pieces} = markerOrder(garments, {widthCm: 140, copies: 2});
    expect(pieces.filter(({result: k, copy}) => k === 0 && copy === 1)).toEqual([
      {result: 0, copy: 1, piece: 'left_half', nth: 0},
      {result: 0, copy: 1, piece: 'left_half', nth: 1},
      {result: 0, copy: 1, piece: 'right_half'},
    ]);
    expect(problem.pieces).toHaveLength(10);
    expect(problem.pieces.map((piece) => piece.garment)).toEqual([0, 0, 0, 1, 1, 1, 2, 2, 3, 3]);
    expect(problem.pieces[9]?.name).toBe('right_half of L.json');
  });

  it('lays each result as often as its garment is wanted', () => {
    const garments = [{result: result(), copies: 3}, {result: result()}];
    const {problem, pieces} = markerOrder(garments, {widthCm: 140, copies: 2});
    expect(problem.pieces.map(({garment}) => garment)).toEqual([0, 0, 1, 1, 2, 2, 3, 3, 4, 4]);
    expect(pieces.map(({result: k, copy}) => 10 * k + copy)).toEqual([
      0, 0, 1, 1, 2, 2, 10, 10, 11, 11,
    ]);
  });

  it('leaves pieces of plain fabric out, and says so', () => {
    const {pieces, notes} = orderOf({options: {plain: ['left_half']}});
    expect(pieces.map(({piece}) => piece)).toEqual(['right_half']);
    expect(notes.map((note) => saidNote(note))).toEqual([
      'Pieces of plain fabric are not in the layout: left_half.',
    ]);
    expect(() => orderOf({options: {plain: ['left_half', 'right_half']}})).toThrow(
      /^All pieces are of plain fabric/,
    );
  });

  it('lets the print move under pieces that nothing holds, if that is asked for', () => {
    const pieces = [...squarePair().pieces, squarePiece('pocket'), squarePiece('facing')];
    const counts = (more: Partial<SolveResult>, settings: Partial<MarkerSettings>): number[] =>
      orderOf({result: result({pieces, ...more})}, settings).problem.pieces.map(
        ({shifts}) => shifts.length,
      );
    const count = equalShifts(plainPrint).length;
    /** Shifts of each of several pieces, which share at most sixty. */
    const each = (pieces: number): number => Math.ceil(count / Math.ceil((count * pieces) / 60));
    expect(counts({}, {})).toEqual([0, 0, 0, 0]);
    expect(counts({}, {shift: 'component'})).toEqual([0, 0, each(2), each(2)]);
    expect(counts({}, {shift: 'component', ignoresPrint: true})).toEqual([0, 0, 0, 0]);
    expect(counts({seams: []}, {shift: 'component'})).toEqual([0, each(3), each(3), each(3)]);
    const line = {line: [[0, 0] as const, [4, 0] as const]};
    const matches = [{a: {piece: 2, ...line}, b: {piece: 0, ...line}}];
    expect(counts({matches}, {shift: 'component'})).toEqual([0, 0, 0, each(1)]);
    const map = {angle: 0, translation: [0, 0]} as const;
    const symmetries = [{kind: 'pair', pieces: [2, 3], map, pairs: []}] as const;
    expect(counts({symmetries}, {shift: 'component'})).toEqual([0, 0, 0, 0]);
  });

  it('takes the upside of the print for a nap', () => {
    const up = markerOrder([{result: result()}], {widthCm: 90}, {oneWay: true});
    expect(up.problem.nap).toBe('one-way');
    const given = markerOrder([{result: result()}], {widthCm: 90, nap: 'garment'}, {oneWay: true});
    expect(given.problem.nap).toBe('garment');
    const free = {grain: {default: 'free'}} as const;
    const turned = orderOf({options: free}, {nap: 'one-way'}).problem.pieces;
    expect(turned.map(({turns}) => turns)).toEqual(['half', 'half']);
  });

  it('lays what has no grain the same way up, as far as the print turns', () => {
    const angles = [-90, 92, -88, 0, 170];
    const pieces = angles.map((degrees, k) =>
      squarePiece(`piece ${k}`, {alignment: {angle: radians(degrees), translation: [k, 3]}}),
    );
    const directions = (group: GroupName): number[] => {
      const print = {...plainPrint, group};
      const options = {grain: {default: 'free'}} as const;
      const {problem} = orderOf(
        {result: result({pieces, seams: [], print}), options},
        {
          nap: 'one-way',
        },
      );
      const shown = (alignment: Alignment): Point => onPrint(alignment, [2, 5]);
      return problem.pieces.map(({alignment, up}, k) => {
        expect(rotated(up, -alignment.angle)[1]).toBeGreaterThan(0.98);
        // the piece shows the same print as before
        const before = shown(pieces[k]?.alignment ?? alignment);
        const off = printElements(print).map((element) =>
          norm(reduced(print, minus(apply(element, before), shown(alignment)))),
        );
        expect(Math.min(...off)).toBeCloseTo(0);
        return Math.round(degrees(-alignment.angle)) + 0;
      });
    };
    expect(directions('pmm')).toEqual([90, 88, 88, 0, 10]);
    expect(directions('p4')).toEqual([0, -2, -2, 0, 10]);
  });

  it('rounds lengths of several plies where the print comes again', () => {
    const {problem, notes} = orderOf({}, {plies: 3});
    expect(problem.wholeRepeats).toBe(true);
    expect(saidOf(notes)).toContain('3 layers is a whole number of repeats (10.00 cm) long');
    const print = {...plainPrint, w1: [8, 1], w2: [-Math.SQRT2, 9]} as const;
    const turned = orderOf({result: result({print})}, {plies: 3});
    expect(turned.problem.wholeRepeats).toBe(false);
    expect(saidOf(turned.notes)).toContain('does not repeat along the fabric');
  });

  it('counts flaws from the cut', () => {
    const flaws: Point[][] = [
      [
        [1, 1],
        [2, 1],
        [2, 2],
      ],
    ];
    expect(orderOf({}, {flaws}).problem.startCm).toBe(0);
    expect(saidOf(orderOf({}, {flaws}).notes)).toContain('measured from the cut');
    const told = orderOf({}, {flaws, startCm: 3});
    expect(told.problem.startCm).toBe(3);
    expect(told.notes).toEqual([]);
  });
});

describe('refuses in one sentence', () => {
  it.each<[Partial<MarkerSettings>, string]>([
    [{widthCm: NaN}, 'widthCm is NaN, but must be a number from 0 to 1000.'],
    [{widthCm: 0}, 'The fabric is 0 cm wide; give its width between its edges.'],
    [{widthCm: 10, selvedgeCm: 5}, 'Between selvedges of 5 cm nothing is left'],
    [{widthCm: 1001}, 'widthCm is 1001'],
    [{gapCm: 21}, 'gapCm is 21, but must be a number from 0 to 20.'],
    [{phaseCm: 150}, 'The print starts 150 cm from the left edge, beyond the fabric'],
    [{phaseCm: -1}, 'phaseCm is -1'],
    [{plies: 0}, 'plies is 0, but must be a whole number from 1 to 1000.'],
    [{copies: 1.5}, 'copies is 1.5, but must be a whole number'],
    [{effort: Infinity}, 'effort is Infinity'],
    [{seed: -1}, 'seed is -1'],
    [
      {
        flaws: [
          [
            [0, 0],
            [1, 1],
          ],
        ],
      },
      'Flaw 1 is no polygon',
    ],
    [
      {
        flaws: [
          [
            [0, 0],
            [1, 1],
            [NaN, 2],
          ],
        ],
      },
      'Flaw 1 is no polygon',
    ],
    [{widthsCm: [0]}, 'widthsCm holds 0'],
    [{copies: 100, allowanceCm: 0}, 'There are 600 pieces, but at most 500 are laid at once'],
  ])('%j', (settings, sentence) => {
    const pieces = ['a', 'b', 'c', 'd', 'e', 'f'].map((name) => squarePiece(name));
    const garment = {result: result({pieces, seams: []})};
    expect(() => orderOf(garment, settings)).toThrow(sentence);
  });

  it('results of one print in several sizes, naming the garments and the sizes', () => {
    const sized = (scale: number): SolveResult => {
      const {w1, w2} = plainPrint;
      const scaled = ([x, y]: Point): Point => [scale * x, scale * y];
      return result({print: {...plainPrint, w1: scaled(w1), w2: scaled(w2)}});
    };
    const garments = [
      {result: sized(1), name: 'S.json'},
      {result: sized(1.04), name: 'M.json'},
      {result: sized(1), name: 'L.json'},
    ];
    expect(() => markerOrder(garments, {widthCm: 140})).toThrow(
      /^One fabric has one size of the print, .*: S.json and L.json on 10 x 1[0-9.]* cm, M.json on 10.4 x 1[0-9.]* cm; align all of them together/,
    );
  });

  it('copies of a garment that are no whole number', () => {
    expect(() => orderOf({copies: 1.5})).toThrow(
      'The number of copies of result 1 is 1.5, but must be a whole number from 1 to 100.',
    );
  });

  it('results of several prints, and none', () => {
    const other = result({print: {...plainPrint, w1: [11, 0]}});
    const garments = [
      {result: result(), name: 'S.json'},
      {result: other, name: 'M.json'},
    ];
    expect(() => markerOrder(garments, {widthCm: 140})).toThrow(
      'M.json was solved for another group or repeat than S.json; lay results of one print together.',
    );
    expect(() => markerOrder([], {widthCm: 140})).toThrow('There is no result to lay');
  });

  it('a cut line that crosses itself, naming the piece', () => {
    const bow: Point[] = [
      [0, 0],
      [4, 4],
      [4, 0],
      [0, 5],
    ];
    const pieces = [squarePiece('bow', {rest: bow, shape: bow})];
    const garment = {result: result({pieces, seams: []})};
    expect(() => orderOf(garment, {allowanceCm: 0})).toThrow(
      /^The cut line of piece 'bow' crosses itself near \(\d.\d, \d.\d\); change its outline/,
    );
  });

  it('what stands on its head where nothing can turn it', () => {
    const pieces = [
      squarePiece('one', {
        alignment: {angle: Math.PI, translation: [0, 0]},
        grainAngle: Math.PI / 2,
      }),
    ];
    const lay = (group: GroupName) =>
      orderOf(
        {result: result({pieces, seams: [], print: {...plainPrint, group}})},
        {nap: 'one-way'},
      );
    expect(() => lay('pm')).toThrow("Piece 'one' was solved upside down, and pm has no half turn");
    expect(lay('p2').problem.nap).toBe('one-way');
  });
});

describe('a plan', () => {
  const order = orderOf({}, {allowanceCm: 1});
  const answer: MarkerAnswer = {
    ...{lengthCm: 8.02, printOrigin: [2.5, 3], boundCm: 8.01, proven: true, freeLengthCm: 6},
    places: [
      {angle: 0, translation: [3, 1.01]},
      {angle: Math.PI, translation: [20, 6.01]},
    ],
    phaseLengthsCm: [9, 8.3, 8.02, 8.3, null, 9.1, 8.3, 8.3],
    widthLengthsCm: [null, 9, 9, 8, 8, 8],
  };
  const plan = layPlan(order, answer);

  it('lays cut lines on fabric that is cut off where the first begins, and the print with them', () => {
    const [one, two] = plan.placements;
    expect(one).toMatchObject({result: 0, copy: 0, piece: 'left_half', angle: 0});
    const all = boxOf(plan.placements.flatMap(({cut}) => cut));
    expect(all.low[1]).toBeCloseTo(0, 9);
    expect(all.high[1]).toBeCloseTo(plan.lengthCm, 9);
    const turned = two && {angle: two.angle, translation: two.translation};
    order.problem.pieces[1]?.outline.forEach((p, k) => {
      expect(
        distance(onPiece(turned ?? {angle: 0, translation: [9, 9]}, p), two?.cut[k] ?? [0, 0]),
      ).toBeLessThan(1e-12);
    });
    expect(two?.translation[1]).toBeCloseTo(6.01 - 0.01, 3);
    expect(plan.printOrigin?.[0]).toBe(2.5);
    expect(plan.printOrigin?.[1]).toBeCloseTo(3 - 0.01, 3);
  });

  it('has figures that can be reckoned again', () => {
    const area = plan.placements.reduce((sum, {cut}) => sum + signedArea(cut), 0);
    expect(plan.useShare).toBeCloseTo(area / (140 * plan.lengthCm), 12);
    expect(plan).toMatchObject({proven: true, boundCm: plan.lengthCm, freeLengthCm: 6});
    expect(plan.phases[2]).toEqual({phaseCm: 2.5, lengthCm: plan.lengthCm});
    expect(plan.widths.map(({lengthCm}) => lengthCm)).toEqual([
      ...[null, 9, 9],
      ...[plan.lengthCm, plan.lengthCm, plan.lengthCm], // the layout on 140 cm fits wider fabric
    ]);
    expect(plan.unplaced).toEqual([]);
  });

  it('says what the place of the print is worth', () => {
    expect(plan.notes).toEqual([
      expect.stringMatching(
        /^7 to 10 cm, depending on where the print starts at the selvedge; measure it\.$/,
      ),
      'At 1 of 8 places where the print may start at the selvedge, not all pieces fit on the fabric.',
    ]);
  });

  it('says a range that holds the lengths it is told beside, to a millimetre', () => {
    const said = (...lengthsCm: number[]): string =>
      saidNote({code: 'phaseRange', pieces: [], lengthsCm, counts: []});
    expect(said(186.4, 198.6)).toMatch(/^186 to 199 cm, depending /);
    expect(said(186.97, 199.02)).toMatch(/^187 to 199 cm, depending /); // 187.0 and 199.0
  });

  it('stays where it is on fabric whose start is told, and has no print where that is ignored', () => {
    const told = layPlan(orderOf({}, {allowanceCm: 1, startCm: 3, phaseCm: 2.5}), answer);
    expect(told.printOrigin).toEqual([2.5, 3]);
    expect(told.placements[0]?.translation).toEqual([3, 1.01]);
    const free = layPlan(orderOf({}, {ignoresPrint: true}), answer);
    expect(free).toMatchObject({printOrigin: null, phases: [], notes: []});
  });

  it('lists what found no place', () => {
    const half = layPlan(order, {...answer, places: [null, ...answer.places.slice(1)]});
    expect(half.unplaced).toEqual([{result: 0, copy: 0, piece: 'left_half'}]);
    expect(half.placements.map(({piece}) => piece)).toEqual(['right_half']);
  });
});
