import {describe, expect, it} from 'vitest';

import {garmentTitle, panelMarks, type PanelMarks} from '@/model/garment/panel-marks.js';
import {documentOf, draftedSquare} from '../../support/garments/documents.js';
import {onPrint, type Alignment, type Point} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {Pattern, ResultPiece, SolveResult} from '@/model/result/result.js';
import {printDistance} from '@/model/print/wallpaper.js';
import {cutLine as cutLineOf} from '@/cutting/cut-line.js';
import {drawSheetSvg} from '@/cutting/draw-sheet-svg.js';
import {notchMark} from '@/cutting/follow.js';
import {cutSheet, type SheetOptions} from '@/cutting/lay-sheet.js';
import {matchMarks} from '@/cutting/match-marks.js';
import {pairLetter, seamLetter} from '@/model/garment/letters.js';
import {seamLetters} from '@/scene/seam-letters.js';
import {carried} from '@/model/geometry/triangles.js';
import {grainLine} from '@/scene/marks.js';
import {isInside} from '@/model/geometry/polyline.js';
import {
  plainMetrics,
  plainPrint,
  square,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';

const extent = (points: readonly Point[]): number[] => [
  Math.min(...points.map(([x]) => x)),
  Math.min(...points.map(([, y]) => y)),
  Math.max(...points.map(([x]) => x)),
  Math.max(...points.map(([, y]) => y)),
];

const box = (width: number, height: number): Point[] => [
  [0, 0],
  [width, 0],
  [width, height],
  [0, height],
];

/**
 * The cut line if every side of the outline and of its holes is an edge with the same allowance.
 */
function cutLine(outline: readonly Point[], holes: readonly (readonly Point[])[], width: number) {
  const loops = [outline, ...holes].map((loop, l) =>
    loop.map((p, k) => ({key: `${l}.${k}`, points: [p, loop[(k + 1) % loop.length] ?? p]})),
  );
  const widths = new Map(loops.flat().map(({key}) => [key, width] as const));
  return cutLineOf(loops, {widths, own: new Set(), corners: new Map(), hems: new Set()});
}

describe('the cut line', () => {
  it('lies outside of the outline by the allowance, with square corners', () => {
    const [line = [], ...others] = cutLine(square, [], 1.5);
    expect(others).toEqual([]);
    expect(line).toHaveLength(4);
    extent(line).forEach((side, k) => {
      expect(side).toBeCloseTo(k < 2 ? -1.5 : 5.5, 4);
    });
  });

  it('lies inside of holes, and small holes close', () => {
    const hole = (side: number): Point[] =>
      box(side, side)
        .reverse()
        .map(([x, y]) => [x + 5, y + 5]);
    const [, inner = []] = cutLine(box(20, 20), [hole(6)], 1);
    extent(inner).forEach((side, k) => {
      expect(side).toBeCloseTo(k < 2 ? 6 : 10, 4);
    });
    expect(cutLine(box(20, 20), [hole(1.9)], 1)).toHaveLength(1);
  });

  it('cuts sharp corners off', () => {
    const spike: Point[] = [
      [0, 0],
      [20, -1],
      [20, 1],
    ];
    const [left] = extent(cutLine(spike, [], 1)[0] ?? []);
    expect(left).toBeLessThanOrEqual(-1 + 1e-4);
    expect(left).toBeGreaterThanOrEqual(-2.5);
  });

  it('does not cross itself over a narrow dart', () => {
    const dart: Point[] = [
      [0, 0],
      [10, 0],
      [10.2, 8],
      [10.4, 0],
      [20, 0],
      [20, 20],
      [0, 20],
    ];
    const lines = cutLine(dart, [], 1);
    expect(lines).toHaveLength(1);
    expect(isInside(lines[0] ?? [], [10.2, 4])).toBe(true);
    expect(lines[0]?.some(([, y]) => y > 0 && y < 20)).toBe(false);
  });

  it('is the outline where there is no allowance', () => {
    expect(cutLine(square, [], 0)).toEqual([square]);
  });
});

/** A square of 4 cm, stretched to 4 x 8 cm. */
const drawnOut: ResultPiece = squarePiece('left_half', {shape: box(4, 8)});

describe('a mark of the drafted piece', () => {
  it('follows the shape inside of it', () => {
    const {triangles, rest, shape} = drawnOut;
    expect(carried(triangles, rest, shape, [1, 2])).toEqual([1, 4]);
  });

  it('follows the shape along its outline, and points out of it', () => {
    const mark = notchMark(drawnOut, {from: [4, 0], to: [4, 4], at: 0.25});
    expect(mark?.at).toEqual([4, 2]);
    expect(mark?.outward[0]).toBeCloseTo(1, 12);
    expect(mark?.outward[1]).toBeCloseTo(0, 12);
  });

  it('is found on an edge that passes the first vertex', () => {
    expect(notchMark(drawnOut, {from: [0, 4], to: [4, 0], at: 0.75})?.at).toEqual([2, 0]);
  });
});

describe('matching marks', () => {
  const alignment: Alignment = {angle: 0.3, translation: [2, -5]};
  const lattice = {group: 'p1', w1: [9, 1], w2: [-2, 7]} as const;
  const marks = matchMarks(lattice, alignment, [box(40, 30)]);

  it('are three, and lie whole repeats apart on the print', () => {
    expect(marks).toHaveLength(3);
    const apart = printDistance(lattice);
    const [first = [0, 0], ...others] = marks.map((p) => onPrint(alignment, p));
    for (const other of others) expect(apart(first, other)).toBeLessThan(1e-9);
  });

  it('lie well inside the piece and far from each other', () => {
    for (const [x, y] of marks) {
      expect(Math.min(x, 40 - x, y, 30 - y)).toBeGreaterThanOrEqual(1.5);
    }
    const [[ax, ay] = [0, 0], [bx, by] = [0, 0], [cx, cy] = [0, 0]] = marks;
    const sides = [
      Math.hypot(ax - bx, ay - by),
      Math.hypot(bx - cx, by - cy),
      Math.hypot(cx - ax, cy - ay),
    ];
    expect(Math.min(...sides)).toBeGreaterThan(15);
  });

  it('keep out of holes', () => {
    const hole = [...box(38, 10)].reverse().map(([x, y]): Point => [x + 1, y + 10]);
    for (const [, y] of matchMarks(lattice, alignment, [box(40, 30), hole])) {
      expect(Math.abs(y - 15)).toBeGreaterThanOrEqual(5 + 1.5 - 1e-9);
    }
  });

  it('stand on motifs where two of them lie well there, though three would elsewhere', () => {
    const dots = {w1: [12, 0], w2: [0, 12]} as const;
    const upright: Alignment = {angle: 0, translation: [4, 1.6]};
    const found = matchMarks(dots, upright, [box(28, 10)]);
    expect(found).toHaveLength(2);
    for (const p of found) {
      const [x, y] = onPrint(upright, p);
      expect(Math.abs(x / 12 - Math.round(x / 12))).toBeLessThan(1e-9);
      expect(y).toBeCloseTo(0, 9);
    }
  });

  it('are fewer on a piece that is smaller than the repeat', () => {
    expect(matchMarks(lattice, alignment, [box(7, 6)])).toHaveLength(1);
    expect(matchMarks(lattice, alignment, [box(2, 2)])).toHaveLength(0);
  });

  it('are soon found on stripes, whose repeat along themselves is next to nothing', () => {
    const stripes = {w1: [9, 0], w2: [0, 0.1]} as const;
    expect(matchMarks(stripes, alignment, [box(40, 100)])).toHaveLength(3);
  });
});

const side = 30;
const piece = (name: string, more: Partial<ResultPiece> = {}): ResultPiece =>
  squarePiece(name, {rest: box(side, side), shape: box(side, side), ...more});
const turned: Alignment = {angle: 0.4, translation: [3, 1]};
const pattern: Pattern = squarePair({
  pieces: [piece('left_half'), piece('right_half', {alignment: turned})],
  symmetries: [{kind: 'pair', pieces: [0, 1], map: {angle: 0, translation: [4, 0]}, pairs: []}],
});
const print: Print = {...plainPrint, title: 'Dots & dashes', w1: [10, 0], w2: [0, 8]};
const panel: PanelMarks = {label: 'Left <half>', notches: [{from: [0, 0], to: [side, 0], at: 0.5}]};

function fileOf({mark, ...options}: Partial<SheetOptions> & {mark?: string} = {}): string {
  const result: SolveResult = {
    format: 'seamwise-result/1',
    units: 'cm',
    ...pattern,
    search: [],
    metrics: plainMetrics,
    notes: [],
  };
  const fabric = {...print, tile: '<svg xmlns="http://www.w3.org/2000/svg"/>'};
  const marks = {title: 'Tie', size: 'M', panels: new Map([['left_half', panel]])};
  return drawSheetSvg(
    cutSheet(result, fabric, marks, {allowanceCm: 1, units: 'cm', ...options}),
    fabric,
    mark === undefined ? {} : {mark},
  );
}

const numbersIn = (text = ''): number[] => (text.match(/-?[\d.]+/g) ?? []).map(Number);
/** The drawing of one of the pieces. */
const group = (svg: string, k: number): string =>
  new RegExp(`<g id="piece-${k}".*`).exec(svg)?.[0] ?? '';
const paths = (svg: string): number[][] =>
  [...svg.matchAll(/ d="([^"]*)"/g)].map(([, d]) => numbersIn(d));
/** The sewing line of one of the pieces, from its corner (0, 0). */
const sewn = (svg: string, k: number): number[] =>
  numbersIn(/ d="([^"]*)"[^>]*stroke-dasharray="4 2"/.exec(group(svg, k))?.[1]);

describe('the file to cut by', () => {
  const svg = fileOf();

  it('has references and layers that Inkscape reads', () => {
    expect(svg).not.toContain(' href=');
    expect(svg.match(/ xlink:href="/g)?.length).toBeGreaterThan(0);
    expect(group(svg, 0)).toMatch(/ inkscape:groupmode="layer" inkscape:label="[^"]+"/);
  });

  it('says how large the repeat of the fabric is', () => {
    expect(svg).toContain('dashes, repeat 10 cm × 8 cm');
    expect(fileOf({units: 'inch'})).toMatch(/repeat 3.15\/16.in × 3.1\/8.in/);
  });

  it('has the millimetre as its unit', () => {
    const [, width, height, view] =
      /<svg[^>]* width="([\d.]+)mm" height="([\d.]+)mm" viewBox="([^"]*)"/.exec(svg) ?? [];
    expect(view).toBe(`0 0 ${width} ${height}`);
    const [cut = []] = paths(group(svg, 0));
    const xs = (path: number[]): number[] => path.filter((_, k) => k % 2 === 0);
    expect(Math.max(...xs(sewn(svg, 0))) - Math.min(...xs(sewn(svg, 0)))).toBeCloseTo(10 * side, 2);
    expect(Math.max(...xs(cut)) - Math.min(...xs(cut))).toBeCloseTo(10 * side + 20, 2);
  });

  it('shows squares of 5 cm and of 2 inches to measure', () => {
    const squares = [
      ...svg.matchAll(/<rect [^>]*width="([\d.]+)" height="\1"[^>]*\/><text[^>]*>([^<]*)/g),
    ];
    expect(squares.map(([, size, label]) => [label, Number(size)])).toEqual([
      ['5 cm', 50],
      ['2 in', 50.8],
    ]);
  });

  it('lays the print under a piece as the piece lies on it', () => {
    const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = numbersIn(
      /id="fabric-1"[^>]*matrix\(([^)]*)\)/.exec(svg)?.[1],
    );
    const [x0 = 0, y0 = 0] = sewn(svg, 1); // the sheet's point of the corner (0, 0)
    const p: Point = [12, 7];
    const [x, y] = [x0 + 10 * p[0] - e, y0 - 10 * p[1] - f];
    const area = a * d - b * c;
    const tile = [(d * x - c * y) / area, (a * y - b * x) / area]; // x to the right, y down
    const expected = onPrint(turned, p);
    expect(tile[0]).toBeCloseTo(10 * expected[0], 1);
    expect(tile[1]).toBeCloseTo(-10 * expected[1], 1);
  });

  it('shows text as text, and whose twin a piece is', () => {
    expect(svg).toContain('Left &#60;half&#62;');
    expect(svg).toContain('Right half');
    expect(svg.match(/>Cut 1, face up, single layer</g)).toHaveLength(2);
    expect(fileOf({plain: ['left_half']})).toContain('>Cut 1 of plain fabric<');
    expect(svg).toContain('Mirror image of Right half');
    expect(svg).toContain('Mirror image of Left &#60;half&#62;');
  });

  it('marks both sides of a seam with the same letter, inside of the pieces', () => {
    const letters = seamLetters(pattern, 0.6);
    expect(letters.map((one) => one.map(({letter}) => letter))).toEqual([['A'], ['A']]);
    for (const [k, one] of letters.entries())
      for (const {at} of one) expect(isInside(pattern.pieces[k]?.shape ?? [], at)).toBe(true);
    expect([0, 25, 26, 77].map(seamLetter)).toEqual(['A', 'Z', 'AA', 'BZ']);
    const pairs = [0, 3, 23, 24, 47].map((first) => pairLetter([99, first]));
    expect(pairs).toEqual(['α', 'δ', 'ω', 'α1', 'ω1']);
    expect(svg.match(/>A<\/text>/g)).toHaveLength(2);
  });

  it('draws the grain along the fabric where nobody says how it runs', () => {
    const arrow = [...group(svg, 1).matchAll(/ d="([^"]*)"[^>]*stroke-width="0.4"/g)];
    expect(arrow).toHaveLength(3); // the shaft, and a head at both ends
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = numbersIn(arrow[0]?.[1]);
    expect(Math.atan2(y0 - y1, x1 - x0)).toBeCloseTo(0.4 + Math.PI / 2, 2);
  });

  it('draws notches as slits of two fifths of the allowance', () => {
    const [x0 = 0, y0 = 0] = sewn(svg, 0);
    const notch = [x0 + 150, y0 + 10, x0 + 150, y0 + 6];
    expect(paths(group(svg, 0))).toContainEqual(notch.map((v) => Number(v.toFixed(2))));
  });

  it('says what the frames around its crosses are, where there are any', () => {
    expect(svg).toContain('the faint frame around each shows one repeat');
    expect(fileOf({plain: ['left_half', 'right_half']})).not.toContain('faint frame');
  });

  it('keeps pieces apart by their cut lines', () => {
    const cuts = [0, 1].map((k) => (paths(group(svg, k))[0] ?? []).filter((_, n) => n % 2 === 0));
    const [first = [], second = []] = cuts.sort((p, q) => Math.min(...p) - Math.min(...q));
    expect(Math.min(...second) - Math.max(...first)).toBeCloseTo(15, 2);
  });

  it('leaves plain pieces white, without matching marks', () => {
    const plain = fileOf({plain: ['left_half']});
    expect(group(plain, 0)).not.toContain('url(#fabric');
    expect(group(plain, 0)).not.toMatch(/>1<\/text>/);
    expect(group(plain, 1)).toMatch(/>1<\/text>/);
  });

  it('opens and closes its elements in order, and is free of NaN', () => {
    const open: string[] = [];
    for (const [, closing, name, selfClosing] of svg.matchAll(/<(\/?)([a-zA-Z]+)[^>]*?(\/?)>/g)) {
      if (closing) expect(open.pop()).toBe(name);
      else if (!selfClosing) open.push(name ?? '');
    }
    expect(open).toEqual([]);
    expect(svg).not.toMatch(/NaN|undefined|Infinity/);
  });
});

describe('what a garment says about its pieces', () => {
  const placement = {translation: [0, 120, 10], rotation: [0, 180, 0]} as const;
  const garment = documentOf(
    [
      draftedSquare('tip', {
        label: 'Tip',
        grain: {
          line: [
            [1, 0.5],
            [1, 3.5],
          ],
        },
        placement,
        notches: [{edge: 1, at: 0.25}],
      }),
      draftedSquare('lining'),
    ],
    {title: 'Tie', size: 'M'},
  );

  it('has notches by the ends of their edges', () => {
    expect(panelMarks(garment).get('tip')).toEqual({
      drafted: garment.pieces[0],
      label: 'Tip',
      grain: [
        [1, 0.5],
        [1, 3.5],
      ],
      placement,
      notches: [{from: [4, 0], to: [4, 4], at: 0.25}],
    });
    expect(panelMarks(garment).get('lining')).toEqual({
      label: 'Lining',
      drafted: garment.pieces[1],
    });
  });

  it('has a title and a size', () => {
    expect(garmentTitle(garment)).toEqual({title: 'Tie', size: 'M'});
    expect(garmentTitle({})).toEqual({});
  });

  it('is titled by its file where it says no title', () => {
    expect(garmentTitle({title: ' '}, 'shirt_mean_specification.json')).toEqual({
      title: 'Shirt mean',
    });
    expect(garmentTitle(garment, 'shirt.json').title).toBe('Tie');
  });

  it('goes after what was decided, and the grain line is drawn where that says', () => {
    const decided = {names: {tip: 'Point'}, grain: {tip: {angleDeg: 0}, lining: 'across'}} as const;
    const marks = panelMarks(garment, decided);
    expect(marks.get('tip')).toMatchObject({label: 'Point', grainDeg: 0});
    expect(marks.get('lining')?.grainDeg).toBeUndefined();
    const [from, to] = grainLine(squarePiece('tip'), marks.get('tip')) ?? [];
    expect(from?.[1]).toBeCloseTo(to?.[1] ?? NaN, 9);
    expect(to?.[0]).toBeGreaterThan(from?.[0] ?? NaN);
  });
});
