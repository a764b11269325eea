import {describe, expect, it} from 'vitest';

import {matchMarks} from '@/cutting/match-marks.js';
import {drawPlanSvg} from '@/marker/draw/draw-plan-svg.js';
import {planDxf} from '@/marker/draw/plan-dxf.js';
import {planPdf} from '@/marker/draw/plan-pdf.js';
import {planPieces} from '@/marker/draw/plan-pieces.js';
import {planSheets} from '@/marker/draw/plan-sheets.js';
import {figuresOf, planWords} from '@/marker/draw/plan-words.js';
import {coordinates, middle, minus, onPiece, type Point} from '@/model/geometry/vectors.js';
import type {LayPlan} from '@/model/result/marker-plan.js';
import type {Print} from '@/model/print/repeating-print.js';
import {placementOf, planOf, rectangle, resultOf} from '../../support/marker/laid-rectangles.js';
import {readPdf} from '../../support/paper/pdf.js';
import {at, greatest} from '../../support/plane.js';
import {holds} from '../../support/marker/rings.js';

const print: Print = {group: 'p2', w1: [8, 0], w2: [0, 8], title: 'Leaves & buds'};
const results = [
  resultOf(print, [
    rectangle('front', 24, 16, {angle: Math.PI, translation: [3, 2]}),
    rectangle('back', 30, 20, {angle: 0, translation: [-1, 4]}),
  ]),
];
const origin: Point = [8.2, 5];
const plan = planOf(
  results,
  [
    placementOf(results, origin, {piece: 0, repeats: [0, 0], turn: Math.PI}),
    placementOf(results, origin, {piece: 1, repeats: [4, 0]}),
  ],
  {printOrigin: origin, widthCm: 90, freeLengthCm: 20},
);
const words = {units: 'cm'} as const;
const options = {print, words, results};

/** Checks that tags are closed in order, and XML's special characters escaped. */
function expectXml(text: string): void {
  const open: string[] = [];
  for (const [tag, slash, name = '', end] of text.matchAll(
    /<(\/?)([a-z]\w*)(?:\s+[\w:-]+="[^"<]*")*\s*(\/?)>/gi,
  )) {
    if (slash === '/') expect(open.pop(), tag).toBe(name);
    else if (end !== '/') open.push(name);
  }
  expect(open).toEqual([]);
  const left = text.replaceAll(/<(\/?)([a-z]\w*)(?:\s+[\w:-]+="[^"<]*")*\s*(\/?)>/gi, '');
  expect(left).not.toMatch(/[<>]/);
  expect(text).not.toMatch(/&(?!#\d+;)/);
}

const wordsIn = (svg: string): string[] =>
  [...svg.matchAll(/<text [^>]*>([^<]*)<\/text>/g)].map(([, content = '']) =>
    content.replaceAll(/&#(\d+);/g, (_, code) => String.fromCodePoint(Number(code))),
  );

/** The pairs of a row of the table, after the name of its piece. */
function pairsOf(svg: string, piece: string): Point[] {
  const all = wordsIn(svg);
  return all
    .slice(all.lastIndexOf(piece) + 1)
    .slice(0, 3)
    .map((pair): Point => {
      const [x = NaN, y = NaN] = pair.split(' × ').map(Number);
      return [x, y];
    });
}

describe('crosses', () => {
  const pieces = planPieces(plan, {results}, ({piece}) => piece);

  it('are those of the pieces to cut, by the same numbers', () => {
    const [front] = at(results, 0).pieces;
    if (!front) throw new Error();
    const marks = matchMarks(print, front.alignment, [front.shape]);
    expect(marks).toHaveLength(3);
    const place = at(plan.placements, 0);
    expect(at(pieces, 0).crosses).toEqual(marks.map((p) => onPiece(place, p)));
  });

  it('lie whole repeats from each other where nothing is known of the pieces, too', () => {
    const unknown = planPieces(plan, {}, ({piece}) => piece);
    for (const {crosses, cut} of [...pieces, ...unknown]) {
      expect(crosses).toHaveLength(3);
      const first = at(crosses, 0);
      for (const p of crosses) {
        const steps = coordinates([print.w1, print.w2], minus(p, first));
        expect(greatest(steps.map((step) => Math.abs(step - Math.round(step))))).toBeLessThan(1e-9);
        expect(holds(cut, p)).toBe(true);
      }
    }
  });

  it('are drawn and told where they are, to a tenth of a millimetre', () => {
    const svg = drawPlanSvg(plan, options);
    const format = {scale: 10, widthCm: 200, heightCm: 400, marginCm: 10};
    const [sheet] = planSheets(plan, print, options, {
      ...{...format, isAsHighAsNeeded: true, isRoll: false},
    });
    const drawn = (sheet?.fabric?.marks ?? []).flatMap((mark) =>
      mark.kind === 'line' && mark.layer === 'matches' && !mark.isClosed
        ? [middle(at(mark.points, 0), at(mark.points, 1))]
        : [],
    );
    pieces.forEach(({name, crosses}, k) => {
      expect(drawn.slice(6 * k, 6 * k + 6)).toEqual(crosses.flatMap((p) => [p, p]));
      const told = pairsOf(svg, at(['Front', 'Back'], k));
      expect(told, name).toHaveLength(3);
      told.forEach((p, n) => {
        expect(Math.hypot(...minus(p, at(crosses, n)))).toBeLessThan(0.01);
      });
    });
  });
});

it('a piece about which nothing is known has a grain line along the selvedge', () => {
  for (const {cut, grain} of planPieces(plan, {}, ({piece}) => piece)) {
    const [from, to] = grain;
    expect(to[0]).toBeCloseTo(from[0], 9);
    expect(to[1] - from[1]).toBeGreaterThan(5);
    for (const end of [from, to]) expect(holds(cut, end)).toBe(true);
  }
});

describe('the plan as SVG', () => {
  it('has a line for each piece, its figures, and a tenth of its size', () => {
    const svg = drawPlanSvg(plan, {...options, title: 'Shirt <M>'});
    expectXml(svg);
    const all = wordsIn(svg);
    expect(all).toContain('Shirt <M>: Fabric layout 1 : 10');
    expect(all.filter((one) => one.startsWith('Front'))).toHaveLength(2);
    for (const one of ['22 cm', '0.25 m', 'rounded up to 5 cm', 'proven shortest']) {
      expect(all).toContain(one);
    }
    expect(all).toContain('without it 20 cm');
    expect(all.join()).toContain('Leaves & buds: the ring is on a corner of its repeat');
    const [, width = '', view = ''] = /width="([\d.]+)mm" .*viewBox="0 0 ([\d.]+) /.exec(svg) ?? [];
    expect(Number(view)).toBeCloseTo(10 * Number(width), 6);
    expect(Number(width)).toBe(208);
  });

  it('has the print where it lies on the fabric', () => {
    const svg = drawPlanSvg(plan, {...options, print: {...print, tile: '<svg/>'}});
    const [, numbers = ''] =
      /id="fabric" xlink:href="#tile" patternTransform="matrix\(([^)]*)\)/.exec(svg) ?? [];
    const [a, b, c, d, x = NaN, y = NaN] = numbers.split(' ').map(Number);
    expect([a, b, c, d]).toEqual([1, 0, 0, 1]);
    // the left edge of the fabric and its start, as in the rest of the drawing
    const [, left = '', top = '', right = '', bottom = ''] =
      /<path d="M([\d.]+) ([\d.]+)L([\d.]+) [\d.]+L[\d.]+ ([\d.]+)L[\d. ]+Z" fill="url\(#fabric\)"/.exec(
        svg,
      ) ?? [];
    expect(Math.abs(Number(right) - Number(left))).toBeCloseTo(900, 6);
    const start = Math.max(Number(top), Number(bottom));
    // the image's upper left corner is the corner of the repeat above the origin
    const [i, j] = coordinates(
      [print.w1, print.w2],
      [(x - Number(left)) / 10 - 8.2, (start - y) / 10 - 5],
    );
    expect(i).toBeCloseTo(Math.round(i), 6);
    expect(j).toBeCloseTo(Math.round(j), 6);
  });

  it('says what has no place, and which garment a piece is of', () => {
    const {placements} = plan;
    const two: LayPlan = {
      ...plan,
      placements: placements.map((one, k) => ({...one, piece: 'front', copy: k})),
      unplaced: [{result: 0, copy: 1, piece: 'back'}],
    };
    const all = wordsIn(drawPlanSvg(two, options));
    expect(all).toContain('Pieces without a place: Back, garment 2.');
    expect(all).toContain('Front, garment 1');
    expect(all).toContain('Front, garment 2');
  });

  it('says no length to buy, and proves nothing, while pieces have no place', () => {
    const all = wordsIn(
      drawPlanSvg({...plan, unplaced: [{result: 0, copy: 0, piece: 'back'}]}, options),
    );
    expect(all).toContain('of the placed pieces');
    for (const one of ['Buy', '0.25 m', 'proven shortest', 'The print costs']) {
      expect(all).not.toContain(one);
    }
  });

  it('tells what pins cost apart from the print', () => {
    const {lengthCm} = plan;
    const pinned = {...plan, lengthCm: lengthCm + 5, unpinnedLengthCm: lengthCm};
    const all = wordsIn(drawPlanSvg(pinned, options));
    expect(all).toContain('without it 20 cm');
    expect(all).toContain('2 cm');
    expect(all.join()).toContain('Pinned pieces cost 5 cm more.');
  });

  it('shows no print and no crosses where the print does not matter', () => {
    const svg = drawPlanSvg({...plan, printOrigin: null, phases: []}, options);
    expectXml(svg);
    expect(svg).not.toContain('<pattern');
    expect(wordsIn(svg).join()).not.toMatch(/Cross|The print costs/);
    expect(wordsIn(svg)).toContain('The print is ignored: pieces may be anywhere.');
  });

  it('has tables of other phases and other fabric', () => {
    const phases = [
      {phaseCm: 8.2, lengthCm: plan.lengthCm},
      {phaseCm: 4.25, lengthCm: null},
    ];
    const svg = drawPlanSvg({...plan, phases, widths: [{widthCm: 110, lengthCm: 40.06}]}, options);
    const all = wordsIn(svg);
    const from = all.indexOf('It starts at (cm)');
    expect(all.slice(from, from + 6)).toEqual([
      'It starts at (cm)',
      '8.2',
      '4.3',
      'Length (cm)',
      '22',
      '–',
    ]);
    expect(all.slice(-3)).toEqual(['110', 'Length (cm)', '40.1']);
  });
});

describe('what is bought', () => {
  const bought = (lengthCm: number, units: 'cm' | 'inch'): string =>
    at(figuresOf({...plan, lengthCm}, planWords({units})), 1).value;

  it('is no less than is laid, as shops cut it', () => {
    expect(bought(140.01, 'cm')).toBe('1.45 m');
    expect(bought(145, 'cm')).toBe('1.45 m');
    expect(bought(145 + 1e-9, 'cm')).toBe('1.45 m');
    expect(bought(200, 'cm')).toBe('2.00 m');
    expect(bought(91.44, 'inch')).toBe('1 yd');
    expect(bought(92, 'inch')).toBe('1 1/8 yd');
    expect(bought(40, 'inch')).toBe('1/2 yd');
  });
});

describe('the plan as PDF', () => {
  const point = 72 / 2.54;
  const sizes = async (some: LayPlan, scale: 1 | 10) => {
    const {bytes, pages} = await planPdf(some, {...options, scale});
    const read = readPdf(bytes).pages;
    expect(read).toHaveLength(pages);
    return read.map(({size}) => size.map((side) => Math.round(10 * (side / point)) / 10));
  };
  /** Repeats the same pieces one after the other. */
  const repeated = (count: number): LayPlan =>
    planOf(
      results,
      Array.from({length: count}, (_, copy) =>
        [0, 1].map((piece) => ({
          ...placementOf(results, origin, {
            ...{piece, copy, repeats: [4 * piece, 3 * copy]},
            turn: piece === 0 ? Math.PI : 0,
          }),
        })),
      ).flat(),
      {printOrigin: origin, widthCm: 90},
    );

  it('is a page of A4, or one as wide as the fabric', async () => {
    expect(await sizes(plan, 10)).toEqual([[21, 29.7]]);
    const [roll, ...others] = await sizes(plan, 1);
    expect(others).toEqual([]);
    expect(roll?.[0]).toBe(90);
    expect(roll?.[1]).toBeGreaterThan(plan.lengthCm);
  });

  it('goes on where it is long, and shows each stretch of fabric once', async () => {
    const long = repeated(25); // 598 cm
    expect(long.lengthCm).toBeCloseTo(24 * 24 + 22, 6);
    expect((await sizes(long, 10)).length).toBeGreaterThan(3);
    const rolls = await sizes(long, 1);
    expect(rolls.map(([width]) => width)).toEqual([90, 90]);
    expect(greatest(rolls.map(([, height = 0]) => height))).toBeLessThanOrEqual(500);
    const format = {scale: 10, widthCm: 210, heightCm: 297, marginCm: 10};
    const parts = planSheets(long, print, options, {
      ...{...format, isAsHighAsNeeded: false, isRoll: false},
    }).flatMap(({fabric}) => (fabric ? [[fabric.from, fabric.to]] : []));
    expect(parts.length).toBeGreaterThan(2);
    expect(at(parts, 0)[0]).toBe(0);
    expect(at(parts, -1)[1]).toBeCloseTo(long.lengthCm, 9);
    parts.slice(1).forEach(([from], k) => {
      expect(from).toBe(at(parts, k)[1]);
    });
  });

  it('lies on its side on paper, or is smaller, where the fabric is wide', async () => {
    expect(await sizes({...plan, widthCm: 220}, 10)).toEqual([[29.7, 21]]);
    expect(await sizes({...plan, widthCm: 320}, 10)).toEqual([[21, 29.7]]);
  });

  it('is the same for the same plan', async () => {
    const [one, other] = [
      await planPdf(plan, {...options, scale: 10}),
      await planPdf(plan, {...options, scale: 10}),
    ];
    expect(one.bytes).toEqual(other.bytes);
  });
});

describe('the plan as DXF', () => {
  it('has a block for each piece, where it lies', () => {
    const lines = planDxf(plan, {results}).split('\r\n');
    const pairs = lines.flatMap((code, k) =>
      k % 2 === 0 ? [[code.trim(), lines[k + 1]] as const] : [],
    );
    const names = (kind: string): (string | undefined)[] =>
      pairs.flatMap(([code, value], k) =>
        code === '0' && value === kind
          ? [pairs.slice(k).find(([other]) => other === '2')?.[1]]
          : [],
      );
    expect(names('BLOCK')).toEqual(['Front', 'Back']);
    expect(names('INSERT')).toEqual(['Front', 'Back']);
    const points = (layer: string, kind: string): Point[] =>
      pairs.flatMap(([code, value], k): Point[] => {
        const [of, x, y] = pairs.slice(k + 1, k + 4);
        if (code !== '0' || value !== kind || of?.[1] !== layer) return [];
        return [[Number(x?.[1]) / 10, Number(y?.[1]) / 10]];
      });
    const cut = points('1', 'VERTEX');
    const wanted = plan.placements.flatMap((one) => one.cut);
    expect(cut).toHaveLength(wanted.length);
    expect(greatest(cut.map((p, k) => Math.hypot(...minus(p, at(wanted, k)))))).toBeLessThan(1e-4);
    // the grain runs along the fabric; three crosses have two lines each, besides the edges of the
    // fabric
    expect(points('7', 'LINE')).toHaveLength(2);
    expect(points('8', 'LINE')).toHaveLength(2 * 6 + 6);
  });
});
