import {describe, expect, it} from 'vitest';

import type {Alignment, Point} from '@/model/geometry/vectors.js';
import type {ResultSymmetry, SolveResult} from '@/model/result/result.js';
import {hasOutsidePictures} from '@/image/svg-picture.js';
import {mismatchLine} from '@/scene/colours.js';
import {drawResult} from '@/picture/draw-result.js';
import {
  driftOf,
  finalMismatch,
  mismatchOf,
  meanOf,
  joinedMismatchOf,
  worstOf,
} from '@/scene/mismatch.js';
import {
  plainMetrics,
  plainPrint as print,
  square,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';

/** Two squares on a 10 x 10 cm print in p1, as a result. */
function twoSquares(second: Alignment, symmetries: readonly ResultSymmetry[] = []): SolveResult {
  return {
    format: 'seamwise-result/1',
    units: 'cm',
    ...squarePair({
      pieces: [squarePiece('left_half'), squarePiece('right_half', {alignment: second})],
      symmetries,
    }),
    search: [],
    metrics: {...plainMetrics, maxMovedCm: 0.25},
    notes: [],
  };
}
/** The print continues across the seam if the second square is 4 cm further along it. */
const runsOn: Alignment = {angle: 0, translation: [-4, 0]};
const alignments = ({pieces}: SolveResult): Alignment[] => pieces.map(({alignment}) => alignment);

describe('the fit of a result', () => {
  it('is zero where the print runs on across the seam', () => {
    const result = twoSquares(runsOn);
    expect(mismatchOf(result, 'shape', alignments(result)).total).toBeCloseTo(0, 12);
  });

  it('is length times mismatch where it does not', () => {
    const result = twoSquares({angle: 0, translation: [-4, 0.5]});
    const fit = mismatchOf(result, 'shape', alignments(result));
    expect(fit.seams[0]?.mismatch[0]).toBeCloseTo(0.5, 12);
    expect(fit.total).toBeCloseTo(4 * 0.5, 12);
    expect(fit.mean).toBeCloseTo(0.5, 12);
  });

  it('does not change with a whole repeat, nor when print and pieces turn together', () => {
    const result = twoSquares({angle: 0, translation: [-4 + 20, 0.5 - 10]});
    expect(mismatchOf(result, 'shape', alignments(result)).mean).toBeCloseTo(0.5, 12);
  });

  it('takes no mirror of the print where mirrored seams were forbidden', () => {
    const result = twoSquares({angle: 0, translation: [-4, 4]});
    const mirrored = {...result, print: {...print, group: 'pm'}} as const;
    for (const fit of [mismatchOf, joinedMismatchOf]) {
      const by = (one: SolveResult) => fit(one, 'shape', alignments(one)).total;
      expect(by({...mirrored, continuousOnly: true})).toBeCloseTo(by(result), 12);
      expect(by(mirrored)).toBeLessThan(0.6 * by(result));
    }
  });

  it('leaves out a seam that joins a piece to its own mirror twin', () => {
    const map = {angle: 0, translation: [4, 0]} as const;
    const result = twoSquares({angle: 0, translation: [1, 2]}, [
      {
        kind: 'pair',
        pieces: [0, 1],
        map,
        pairs: [
          [0, 1],
          [1, 0],
          [2, 3],
          [3, 2],
        ],
      },
    ]);
    const fit = mismatchOf(result, 'shape', alignments(result));
    expect(fit.seams[0]?.counts).toBe(false);
    expect(fit.total).toBe(0);
  });
});

describe('the figures of a result', () => {
  /**
   * Two squares joined by two seams of 4 cm and a third of 8 cm, with mismatches of 1, 2 and 0.25
   * cm.
   */
  const three = (): SolveResult => {
    const [seam] = squarePair().seams;
    if (!seam) throw new Error('no seam');
    const long: Point[] = [
      [0, 0],
      [8, 0],
    ];
    const strips = [0, 0.25, 0, 1, 0, 2].map((high, k) =>
      squarePiece(`strip ${k}`, {
        shape: k < 2 ? long : long.map(([x, y]): Point => [x / 2, y]),
        alignment: {angle: 0, translation: [0, high]},
      }),
    );
    const seams = [0, 2, 4].map((piece) => ({
      ...seam,
      a: {piece, vertices: [0, 1]},
      b: {piece: piece + 1, vertices: [0, 1]},
    }));
    return {...twoSquares(runsOn), pieces: strips, seams};
  };

  it('are a mean of the seams by their lengths, which no worst seam is below', () => {
    const fit = finalMismatch(three());
    expect(fit.seams.map(meanOf)).toEqual(
      [0.25, 1, 2].map((cm): unknown => expect.closeTo(cm, 12)),
    );
    expect(fit.mean).toBeCloseTo((8 * 0.25 + 4 * 1 + 4 * 2) / 16, 12);
    expect(worstOf(fit)).toEqual({seam: 2, mean: expect.closeTo(2, 12) as number});
  });

  it('leave out what does not count', () => {
    const result = three();
    const seams = result.seams.map((seam, k) => ({...seam, matched: k !== 2}));
    expect(worstOf(finalMismatch({...result, seams}))?.seam).toBe(1);
    expect(worstOf(finalMismatch({...result, seams: []}))).toBeUndefined();
  });
});

describe('the fit with one symmetry of the print per seam', () => {
  /**
   * The seam of two squares in two edges of 2 cm; the second edge of the right side is `off` to the
   * right.
   */
  function twoEdges(group: 'p1' | 'pm', off: number): SolveResult {
    const left: Point[] = [...square, [4, 2]];
    const right: Point[] = [
      [0, 0],
      [4, 0],
      [4, 4],
      [2 * off, 4],
      [0, 2],
    ];
    const result = twoSquares(runsOn);
    return {
      ...result,
      print: {...print, group},
      pieces: result.pieces.map((piece, k) => {
        const rest = k === 0 ? left : right;
        return {...piece, rest, shape: rest, outline: k === 0 ? [0, 1, 4, 2, 3] : [0, 1, 2, 3, 4]};
      }),
      seams: result.seams.map((seam) => ({
        ...seam,
        a: {piece: 0, vertices: [1, 4, 2]},
        b: {piece: 1, vertices: [0, 4, 3]},
      })),
    };
  }

  it('measures every edge under the symmetry that suits the whole seam', () => {
    // the second edge of the right side is off by a whole repeat: each edge matches, but not both
    // together
    const result = twoEdges('p1', 10);
    const apart = mismatchOf(result, 'shape', alignments(result)).seams[0]?.mismatch;
    apart?.forEach((one) => {
      expect(one).toBeCloseTo(0, 12);
    });
    const [seam] = joinedMismatchOf(result, 'shape', alignments(result)).seams;
    expect(seam?.mismatch[0]).toBeCloseTo(10, 12);
    expect(seam?.mismatch[1]).toBeCloseTo(0, 12); // the longer edge determines the symmetry
  });

  it('tells where the print runs off along the seam', () => {
    const result = twoEdges('p1', 10);
    const [local] = mismatchOf(result, 'shape', alignments(result)).seams;
    const [whole] = joinedMismatchOf(result, 'shape', alignments(result)).seams;
    if (!local || !whole) throw new Error('no seam');
    const drift = driftOf(local, whole, result.print);
    expect(drift?.start).toBeCloseTo(10, 12);
    expect(drift?.end).toBeCloseTo(0, 12);
    expect(drift?.most).toBeCloseTo(10, 12);
    // the repeat is 10 by 8: no random alignment has such a mismatch
    expect(drift?.isLost).toBe(true);
    const large = {...result.print, w1: [100, 0], w2: [0, 80]} as const;
    expect(driftOf(local, whole, large)?.isLost).toBe(false);
    expect(driftOf(whole, whole, result.print)).toBeUndefined();
  });

  it('tells whether the print runs on or is mirrored', () => {
    const result = twoEdges('pm', 0);
    const kindAt = (second: Alignment): unknown => {
      const [seam] = joinedMismatchOf(result, 'shape', [
        {angle: 0, translation: [0, 0]},
        second,
      ]).seams;
      expect(Math.max(...(seam?.mismatch ?? [NaN]))).toBeCloseTo(0, 12);
      return seam?.kind;
    };
    expect(kindAt(runsOn)).toBe('continuous');
    // the seam at (4, y) of the print on the left is at (4, -y) on the right
    expect(kindAt({angle: Math.PI, translation: [4, 0]})).toBe('mirrored');
  });
});

describe('the picture', () => {
  const result = twoSquares({angle: Math.PI / 2, translation: [1, 2]});
  const svg = drawResult(
    result,
    {...print, tile: '<svg xmlns="http://www.w3.org/2000/svg"/>'},
    {title: 'Shirt & <tie>', id: 'x'},
  );

  it('opens and closes its elements in order', () => {
    const open: string[] = [];
    for (const [, closing, name, selfClosing] of svg.matchAll(/<(\/?)([a-zA-Z]+)[^>]*?(\/?)>/g)) {
      if (closing) expect(open.pop()).toBe(name);
      else if (!selfClosing) open.push(name ?? '');
    }
    expect(open).toEqual([]);
  });

  it('shows text as text', () => {
    expect(svg).not.toContain('<tie>');
    expect(svg).toContain('>Left half<');
  });

  it('shows a sign in place of characters that XML cannot hold', () => {
    const strange = drawResult(result, print, {title: 'a\u0000b\u001bc\ud800d\uffffe\tf😀'});
    expect(strange).toContain('<title>a\ufffdb\ufffdc\ufffdd\ufffde\tf😀</title>');
  });

  it('is free of NaN and of ids used twice', () => {
    expect(svg).not.toMatch(/NaN|undefined|Infinity/);
    const ids = [...svg.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id);
    expect(new Set(ids).size).toBe(ids.length);
    expect(ids).toHaveLength(5);
  });

  it('lays the print under a piece as the piece lies on it', () => {
    // p = R w + t: the print's origin is at (1, 2) of the piece, and w1 points up it, which is down
    // in pixels
    const corner = /fill="url\(#x-after-1\)"/.exec(svg)?.index ?? 0;
    const path = svg.slice(svg.lastIndexOf('<path', corner), corner);
    const [x0 = NaN, y0 = NaN] = (/M([\d.]+) ([\d.]+)/.exec(path) ?? []).slice(1).map(Number);
    const [x1 = NaN] = (/L([\d.]+) /.exec(path) ?? []).slice(1).map(Number);
    const scale = (x1 - x0) / 4;
    const matrix =
      /id="x-after-1"[^>]*matrix\(([^)]*)\)/.exec(svg)?.[1]?.split(' ').map(Number) ?? [];
    const expected = [0, -1, 1, 0, x0 + scale, y0 - 2 * scale];
    matrix.forEach((value, k) => {
      expect(value).toBeCloseTo(expected[k] ?? NaN, 1);
    });
    expect(matrix).toHaveLength(6);
  });

  it('counts the seams of the headline, before and after', () => {
    expect(svg).toContain('<desc>0 of 1 visible seams match, 0 before.</desc>');
    expect(svg).toContain('>0 → 0 of 1<');
  });

  it('shows the pieces before as the result says that they were drafted', () => {
    const drafted: Alignment[] = [
      {angle: 0, translation: [0, 0]},
      {angle: 0, translation: [-4, 0]},
    ];
    const before = drawResult({...result, drafted}, {...print, tile: '<svg/>'});
    expect(before).toContain('0 of 1 visible seams match, 1 before');
  });
});

describe('the line along a seam', () => {
  const increase = (values: readonly number[]): void => {
    expect(values).toEqual([...new Set(values)].toSorted((a, b) => a - b));
  };

  it('has steps at 1, 3 and 6 mm, whatever the print', () => {
    const at = [0, 0.1, 0.101, 0.3, 0.301, 0.6, 0.601, 7].map((cm) => mismatchLine(cm).colour);
    expect(new Set(at).size).toBe(4);
    for (const k of [0, 2, 4, 6]) expect(at[k]).toBe(at[k + 1]);
    expect([at[0], at[7]]).toEqual(['#2b9358', '#c83028']);
  });

  it('is told apart by its width and its gaps, too', () => {
    const lines = [0.05, 0.2, 0.5, 2].map((cm) => mismatchLine(cm));
    increase(lines.map(({width}) => width));
    expect(lines[0]?.dash).toBeUndefined();
    increase(lines.map(({width, dash}) => (dash ? dash[1] - width : 0))); // longer than round caps
  });

  it('goes from green at 0 to red at 2 cm and beyond on the scale of the paper', () => {
    const lines = [0, 0.3, 0.6, 1.2, 2].map((cm) => mismatchLine(cm, 'paper'));
    expect(lines[0]?.colour).toBe('#2b9358');
    expect(lines[1]?.dash).toBeUndefined();
    expect(lines[4]?.colour).toBe('#c83028');
    expect(mismatchLine(7, 'paper')).toEqual(lines[4]);
    increase(lines.map(({width}) => width));
    increase(lines.slice(2).map(({dash}) => dash?.[1] ?? 0));
  });
});

it('knows an SVG that takes in pictures from elsewhere, which no browser shows in a print', () => {
  const svg = (inside: string): string => `<svg xmlns="http://www.w3.org/2000/svg">${inside}</svg>`;
  for (const inside of [
    '<image width="4" href="https://a.example/b.png"/>',
    "<image xlink:href='b.png'/>",
    '<svg:image x="1" href = "//a.example/b.png" />',
    '<filter><feImage href="c.svg#d"/></filter>',
    '<use href="c.svg#d"/>',
    '<rect fill="url(c.svg#d)"/>',
    '<style>rect { fill: url("https://a.example/c.svg#d"); }</style>',
  ]) {
    expect(hasOutsidePictures(svg(inside)), inside).toBe(true);
  }
  for (const inside of [
    '<image href="data:image/png;base64,AA"/>',
    '<use href="#leaf"/><use xlink:href="#leaf"/>',
    '<a href="https://a.example"><rect/></a>',
    '<!-- <image href="b.png"/> -->',
    '<image/>',
    '<rect fill="url(#leaf)"/><rect style="fill: url(&quot;#leaf&quot;)"/>',
    "<style>@font-face { font-family: A; src: url(a.woff2); } rect { fill: url('#leaf'); }</style>",
  ]) {
    expect(hasOutsidePictures(svg(inside)), inside).toBe(false);
  }
});
