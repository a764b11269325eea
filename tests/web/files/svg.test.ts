import {describe, expect, it} from 'vitest';

import {tracedLoop} from '@/files/base/bezier.js';
import {readSvg, useOfSvg} from '@/files/svg/read-svg.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import {cmPer} from '@/files/base/units.js';
import type {Drawing, Run} from '@/model/garment/imported-drawing.js';
import {boxOf, signedArea} from '@/model/geometry/polyline.js';

import {
  bodice,
  bodiceArea,
  freesewing,
  freesewingPart,
  millimetreSheet,
  stroked,
  svg,
  words,
} from '../../support/files/drawn-svg.js';

const read = (text: string): Drawing => readSvg(text, 'pattern.svg');

/** Area of a loop. [cm2] */
function areaOf({unit}: Drawing, loop: readonly Run[] | undefined): number {
  const scale = cmPer(unit.unit);
  return Math.abs(signedArea(tracedLoop(loop ?? [], 0.001 / scale))) * scale * scale;
}

const areas = (drawing: Drawing): number[] => drawing.pieces.map(({sewn}) => areaOf(drawing, sewn));

const whole = bodiceArea();

const expectBodice = (drawing: Drawing, tolerance = 0.02): void => {
  expect(drawing.pieces).toHaveLength(1);
  for (const one of areas(drawing)) expect(Math.abs(one - whole)).toBeLessThan(tolerance);
};

describe("FreeSewing's SVG", () => {
  const drawing = read(freesewing(freesewingPart('front')));
  const [piece] = drawing.pieces;

  it('has a piece for each part, sewn along its fabric line', () => {
    expectBodice(drawing);
    expect(drawing).toMatchObject({
      program: 'FreeSewing 4.10.2',
      unit: {unit: 'mm', because: 'stated', isSure: true},
    });
    expect(piece).toMatchObject({name: 'front', material: 'fabric'});
    expect(piece?.sewn).toHaveLength(6);
  });

  it('has names of lines that are written along them', () => {
    const lines = piece?.internalLines.map((points, k) => [points.length, piece.lineNames?.[k]]);
    expect(lines).toContainEqual([2, 'chest line']);
  });

  it('is cut along its allowance, which ends at the fold', () => {
    const {low, high} = boxOf(tracedLoop(piece?.cut ?? [], 0.01));
    expect([high[0] - low[0], high[1] - low[1]]).toEqual([
      expect.closeTo(250),
      expect.closeTo(420),
    ]);
    expect(areaOf(drawing, piece?.cut)).toBeGreaterThan(whole + 60);
  });

  it('has marks: fold, grain, notches on the outline, buttons, darts; hidden lines without names are none', () => {
    expect(piece?.quantity).toEqual({asDrawn: 1, mirrored: 0});
    expect(piece?.fold?.map(([x]) => x)).toEqual([25, 25]);
    expect(piece?.grain).toEqual(piece?.fold);
    expect(piece?.notches).toEqual([{at: [265, -315], kind: 'slit'}]);
    expect(piece?.drillHoles).toEqual([[75, -215]]);
    expect(piece?.internalLines).toHaveLength(2);
  });

  it('becomes a garment whose half pieces are whole', () => {
    const {pieces, symmetries} = garmentOf(drawing, defaultChoices(drawing));
    const [made] = pieces;
    expect(pieces).toHaveLength(1);
    expect(made?.notches).toHaveLength(2);
    const {low, high} = boxOf(made?.outline.map(({points}) => points[0]) ?? []);
    expect(high[0] - low[0]).toBeCloseTo(48, 6);
    expect(symmetries).toMatchObject([{kind: 'piece', piece: 'front'}]);
  });

  it('takes names from titles that were translated, else from ids', () => {
    const named = (title: string): string | undefined =>
      read(freesewing(freesewingPart('frontLeft').replace('>frontLeft <', `>${title}<`))).pieces[0]
        ?.name;
    expect(named('Vorderteil links')).toBe('Vorderteil links');
    expect(named('frontLeft')).toBe('front left');
  });

  it('counts what is cut mirrored, and of each material', () => {
    const counted = (said: string): unknown =>
      read(freesewing(freesewingPart('cuff').replace(/plugin-annotations:cut[^<]*/, said)))
        .pieces[0]?.quantity;
    expect(counted('cut,4,mirrored,from,fabric,')).toEqual({asDrawn: 2, mirrored: 2});
    expect(counted('cut,1,from,fabric,</tspan><tspan dy="8">,cut,1,from,fabric,')).toEqual({
      ...{asDrawn: 2, mirrored: 0},
    });
    expect(
      counted('cut,2,mirrored,from,fabric,</tspan><tspan dy="8">,cut,2,mirrored,from,interfacing,'),
    ).toEqual({asDrawn: 1, mirrored: 1});
  });
});

describe('the size of an SVG', () => {
  const perMm = (unit: number): string => stroked(bodice(unit, [10, 10]));

  it.each([
    ['millimetres', 'width="300mm" height="450mm" viewBox="0 0 300 450"', 1],
    ['centimetres', 'width="30cm" height="45cm" viewBox="0 0 30 45"', 0.1],
    ['inches', 'width="10in" height="20in" viewBox="0 0 10 20"', 1 / 25.4],
    ['points', 'width="800pt" height="1300pt" viewBox="0 0 800 1300"', 72 / 25.4],
    [
      'millimetres and another view box',
      'width="300mm" height="450mm" viewBox="0 0 3000 4500"',
      10,
    ],
    ['millimetres without a view box', 'width="300mm" height="450mm"', 96 / 25.4],
    ['pixels', 'width="1200px" height="1800px" viewBox="0 0 1200 1800"', 96 / 25.4],
    ['bare numbers', 'width="1200" height="1800"', 96 / 25.4],
    [
      'bare numbers of an old Inkscape',
      'width="1200" height="1800" inkscape:version="0.48.4 r9939"',
      90 / 25.4,
    ],
    [
      'bare numbers of a new Inkscape',
      'width="1200" height="1800" inkscape:version="1.2.2 (b0a84865, 2022)"',
      96 / 25.4,
    ],
    [
      'millimetres of an old Inkscape',
      'width="300mm" height="450mm" inkscape:version="0.48.4" viewBox="0 0 300 450"',
      1,
    ],
  ])('is taken from %s', (_, attributes, unit) => {
    const drawing = read(svg(attributes, perMm(unit)));
    expectBodice(drawing);
    expect(drawing.unit.isSure).toBe(true);
  });

  it.each([
    [
      'as it says',
      '<!-- Generator: Adobe Illustrator 24.1, SVG Export Plug-In -->',
      'width="850.4px" height="1275.6px" viewBox="0 0 850.4 1275.6"',
    ],
    [
      'without a width',
      '<!-- Generator: Adobe Illustrator 24.1, SVG Export Plug-In -->',
      'viewBox="0 0 850.4 1275.6"',
    ],
    ['by its layers alone', '', 'id="Layer_1" data-name="Layer 1" viewBox="0 0 850.4 1275.6"'],
  ])('is in points where Illustrator drew it, %s', (_, comment, attributes) => {
    expectBodice(read(comment + svg(attributes, perMm(72 / 25.4))));
  });

  it('is guessed, and may be asked for, where the file leaves it open', () => {
    const text = svg('width="100%" height="100%" viewBox="0 0 300 450"', perMm(1));
    const drawing = read(text);
    expectBodice(drawing);
    expect(drawing.unit.because).toBe('size');
    expect(drawing.notes.join(' ')).toMatch(/does not say how large/);
    const centimetres = readSvg(svg('viewBox="0 0 30 45"', perMm(0.1)), 'pattern.svg', {
      units: 'cm',
    });
    expect(centimetres.unit).toMatchObject({unit: 'cm', isSure: true});
    expectBodice(centimetres);
    const dense = svg('viewBox="0 0 3543 5315"', perMm(300 / 25.4));
    expectBodice(readSvg(dense, 'pattern.svg', {pixelsPerInch: 300}));
    const shrunk = svg('width="300mm" viewBox="0 0 3543 5315"', perMm(150 / 25.4));
    expectBodice(readSvg(shrunk, 'pattern.svg', {pixelsPerInch: 150}));
    const fifth = svg('width="60mm" viewBox="0 0 60 90"', perMm(0.2));
    expectBodice(readSvg(fifth, 'book.svg', {scale: 5}));
  });

  it('is measured by a test square, whatever else is said', () => {
    const square = (side: number): string => `M 500,400 h ${side} v ${side} h ${-side} z`;
    const sheet = (drawn: number): string =>
      svg(
        millimetreSheet,
        stroked(bodice(drawn, [10, 10])),
        stroked(square(50 * drawn)),
        words(502, 410, 'Test square: 5 cm x 5 cm', 4),
      );
    const small = read(sheet(0.75)); // 72 instead of 96 pixels an inch
    expectBodice(small);
    expect(small.unit.because).toBe('measured');
    expect(small.notes.join(' ')).toMatch(/75\.0 %/);
    const right = read(sheet(1));
    expectBodice(right);
    expect(right.unit.because).toBe('stated');
  });

  it('is measured by the label in a square, and not by text beside it', () => {
    const drawing = read(
      svg(
        millimetreSheet,
        stroked(bodice(0.75, [10, 10])),
        stroked('M 500,400 h 37.5 v 37.5 h -37.5 z'),
        words(515, 420, '5 cm', 4),
        words(540, 415, 'Sew 1 cm inside, 3 cm at hems; test the scale.', 4),
      ),
    );
    expectBodice(drawing);
    expect(drawing.pieces.map(({name}) => name)).toEqual(['piece 1']);
  });
});

describe('shapes of an SVG', () => {
  it('lie where groups, uses, symbols and nested pictures put them', () => {
    const placed = [
      `<g transform="translate(100 50) rotate(30)"><g transform="scale(0.5, 0.5)">${stroked(bodice(2))}</g></g>`,
      `<defs><path id="b" d="${bodice()}"/></defs><use href="#b" x="40" y="20" fill="none" stroke="red"/>`,
      `<symbol id="s" viewBox="0 0 240 400">${stroked(bodice())}</symbol><use xlink:href="#s" transform="matrix(0 1 -1 0 500 0)"/>`,
      `<svg x="10" y="10" width="120" height="200" viewBox="0 0 60 100">${stroked(bodice(0.5))}</svg>`,
    ];
    for (const one of placed) expectBodice(read(svg(millimetreSheet, one)));
  });

  it('may be rectangles, polygons, lines, ovals and round rectangles', () => {
    const drawing = read(
      svg(
        millimetreSheet,
        '<rect x="10" y="10" width="100" height="200" fill="none" stroke="black"/>',
        '<polygon points="150,10 250,10 250,210 150,210" stroke="black"/>',
        '<circle cx="350" cy="110" r="60" stroke="black"/>',
        '<rect x="450" y="10" width="100" height="200" rx="20" stroke="black"/>',
        '<line x1="10" y1="250" x2="110" y2="250"/><line x1="110" y1="250" x2="110" y2="450"/>',
        '<polyline points="10,250 10,450 110.05,450"/>',
      ),
    );
    const sorted = areas(drawing)
      .map((one) => Math.round(one * 10) / 10)
      .sort((a, b) => a - b);
    const round = 200 - (4 - Math.PI) * 4;
    const areasDrawn = [Math.PI * 36, round, 200, 200, 200];
    expect(sorted).toHaveLength(5);
    areasDrawn.forEach((one, k) => {
      expect(Math.abs((sorted[k] ?? 0) - one)).toBeLessThan(0.15);
    });
  });

  it('are read through hidden layers, styles and classes', () => {
    const drawing = read(
      svg(
        millimetreSheet,
        '<style>.st0{fill:none;stroke:#000} .off{display:none}</style>',
        `<path class="st0" d="${bodice()}"/>`,
        `<g style="display:none">${stroked(bodice(1, [250, 0]))}</g>`,
        `<g class="off">${stroked(bodice(1, [250, 0]))}</g>`,
        `<g visibility="hidden">${stroked(bodice(1, [250, 0]))}</g>`,
      ),
    );
    expectBodice(drawing);
  });

  it('drawn as many short steps become few curves', () => {
    const turns = Array.from({length: 180}, (_, k) => (k * Math.PI) / 180);
    const arc = turns.map(
      (t) => `L ${(200 + 150 * Math.cos(t)).toFixed(3)} ${(200 - 150 * Math.sin(t)).toFixed(3)}`,
    );
    const drawing = read(
      svg(millimetreSheet, stroked(`M 350 200 ${arc.slice(1).join(' ')} L 50 200 z`)),
    );
    const [piece] = drawing.pieces;
    expect(piece?.sewn).toHaveLength(2);
    const count = piece?.sewn.reduce((sum, {cubics}) => sum + cubics.length, 0);
    expect(count).toBeLessThan(14);
    expect(areas(drawing)[0]).toBeCloseTo((Math.PI * 225) / 2, 0);
  });
});

describe('pieces of an SVG that no known program drew', () => {
  const offset = (d: string): string => stroked(d);
  const rectangle = (x: number, y: number, width: number, height: number): string =>
    `M ${x} ${y} h ${width} v ${height} h ${-width} z`;

  it('are called by the largest words in them, cut as these say, and folded at the edge beside', () => {
    const drawing = read(
      svg(
        millimetreSheet,
        stroked(bodice(1, [20, 20])),
        words(120, 200, 'Front bodice', 14),
        words(120, 220, 'Cut 1 on fold'),
        words(120, 235, 'Size 38'),
        stroked('M 60 150 L 60 380'),
        words(66, 300, 'Grain'),
        stroked('M 260 300 L 252 300'),
        '<circle cx="150" cy="300" r="2" stroke="black"/>',
        stroked('M 60 390 L 240 390'),
      ),
    );
    const [piece] = drawing.pieces;
    expectBodice(drawing);
    expect(piece).toMatchObject({
      name: 'Front bodice',
      quantity: {asDrawn: 1, mirrored: 0},
      notches: [{at: [expect.closeTo(260), expect.closeTo(-300)], kind: 'slit'}],
      drillHoles: [[expect.closeTo(150), expect.closeTo(-300)]],
    });
    expect(piece?.grain?.map(([x]) => x)).toEqual([expect.closeTo(60), expect.closeTo(60)]);
    expect(piece?.fold?.map(([x]) => x)).toEqual([expect.closeTo(20), expect.closeTo(20)]);
    expect(piece?.internalLines).toHaveLength(1);
  });

  it('have their grain along an arrow with heads of its own', () => {
    const drawing = read(
      svg(
        millimetreSheet,
        stroked(bodice(1, [20, 20])),
        stroked('M 60 150 L 60 380'),
        stroked('M 57 158 L 60 150 L 63 158'),
        stroked('M 57 372 L 60 380 L 63 372'),
      ),
    );
    const [piece] = drawing.pieces;
    expect(piece?.grain?.map(([x]) => x)).toEqual([expect.closeTo(60), expect.closeTo(60)]);
    expect(piece?.internalLines).toEqual([]);
  });

  it('have names of several lines, which go on in lower case or tell pieces apart', () => {
    const named = (x: number, ...lines: readonly string[]): readonly string[] => [
      stroked(rectangle(x, 10, 120, 200)),
      ...lines.map((line, k) => words(x + 10, 60 + 12 * k, line)),
    ];
    const drawing = read(
      svg(
        millimetreSheet,
        ...named(10, 'Pocket', 'lining'),
        ...named(150, 'Yoke', 'Oben'),
        ...named(290, 'Yoke', 'Unten'),
        ...named(430, 'Cuff', 'Brand X'),
      ),
    );
    const names = drawing.pieces.map(({name}) => name);
    expect(names).toEqual(['Pocket lining', 'Yoke Oben', 'Yoke Unten', 'Cuff']);
  });

  it('are read from a cutting sheet of Seamwise without marks of the print', () => {
    const line = (layer: string, d: string): string =>
      `<path class="${layer}" ${stroked(d).slice(6)}`;
    const piece = [
      '<g id="piece-0" aria-label="Left front">',
      '<path d="M 0 0 h 220 v 320 h -220 z" fill="url(#cloth-0)"/>',
      line('cut', rectangle(10, 10, 220, 320)),
      line('sew', rectangle(20, 20, 200, 300)),
      line('cut', rectangle(80, 80, 80, 80)),
      line('marks', 'M 230 100 L 222 100'),
      line('matches', 'M 30 200 L 90 200'),
      '<circle class="matches" cx="60" cy="250" r="3" stroke="black"/>',
      '<rect x="90" y="190" width="70" height="60" fill="#fff" stroke="none"/>',
      words(100, 230, 'Aa', 14),
      '</g>',
    ];
    const {pieces, notes} = read(
      svg(millimetreSheet, '<rect width="100%" height="100%" fill="#fff"/>', ...piece),
    );
    expect(notes).toEqual([]);
    expect(pieces).toMatchObject([
      {
        name: 'Left front',
        holes: [{}],
        notches: [{kind: 'slit'}],
        internalLines: [],
        drillHoles: [],
      },
    ]);
    expect(pieces[0]?.doubtfulHoles).toBeUndefined();
  });

  it('are sewn along the inner of two lines that keep their distance', () => {
    const drawing = read(
      svg(
        millimetreSheet,
        offset(rectangle(10, 10, 220, 320)),
        offset(rectangle(20, 20, 200, 300)),
        offset(rectangle(60, 60, 60, 80)), // a pocket
        words(100, 250, 'Back; cut 2'),
      ),
    );
    const [piece] = drawing.pieces;
    expect(areas(drawing)).toEqual([expect.closeTo(600)]);
    expect(areaOf(drawing, piece?.cut)).toBeCloseTo(704);
    expect(piece?.internalLines).toHaveLength(1);
    expect(piece?.quantity).toEqual({asDrawn: 1, mirrored: 1});
  });

  it('are not the frame of the page', () => {
    const framed = (...more: readonly string[]): Drawing =>
      read(
        svg(
          millimetreSheet,
          offset(rectangle(0, 0, 600, 500)),
          stroked(bodice(1, [20, 20])),
          ...more,
        ),
      );
    expectBodice(framed());
    const drawing = read(
      svg(
        'width="900mm" height="900mm" viewBox="0 0 900 900"',
        offset(rectangle(5, 5, 590, 490)),
        stroked(bodice(1, [20, 20])),
        stroked(bodice(1, [300, 20])),
      ),
    );
    expect(drawing.pieces).toHaveLength(2);
    expect(drawing.notes.join(' ')).toMatch(/^1 closed line \(frame around pieces\): left out/);
  });

  it('hang together by the ends of lines that were drawn one by one', () => {
    const [move = '', ...rest] = bodice(1, [20, 20])
      .replace(' z', '')
      .split(/ (?=[LC])/);
    let from = move.slice(2);
    const single = rest.map((step) => {
      const drawn = stroked(`M ${from} ${step}`);
      from = step.split(' ').at(-1) ?? '';
      return drawn;
    });
    const shuffled = single.map((_, k) => single[(k * 5 + 1) % single.length] ?? '');
    expect(new Set(shuffled).size).toBe(6);
    expectBodice(read(svg(millimetreSheet, ...shuffled)));
  });

  it('are called as their layers and ids are, unless a program made these up', () => {
    const called = (attributes: string): string | undefined =>
      read(svg(millimetreSheet, `<g id="g12">${stroked(bodice(), attributes)}</g>`)).pieces[0]
        ?.name;
    expect(called('id="path1234"')).toBe('piece 1');
    expect(called('id="Back_x5F_left"')).toBe('Back left');
    expect(called('id="path12" inkscape:label="Sleeve"')).toBe('Sleeve');
  });

  it('may lie over each other where GarmentCode drew them', () => {
    const fill = 'fill="rgb(227,175,186)" stroke="rgb(51,51,51)" stroke-width="0.2"';
    const drawing = read(
      svg(
        'width="60.0cm" height="50.0cm" viewBox="0 0 60 50" baseProfile="full"',
        `<path d="${bodice(0.1)}" ${fill}/><path d="M 5,15 L 12,15 L 12,30 L 5,30 L 5,15" ${fill}/>`,
        words(12, 20, 'front', 7),
        words(8.5, 22.5, 'pocket', 7),
        words(5, 15, '0', 7),
      ),
    );
    expect(drawing.pieces.map(({name}) => name)).toEqual(['front', 'pocket']);
    expect(areas(drawing)).toEqual([expect.closeTo(whole, 1), expect.closeTo(105)]);
  });
});

describe('whether an SVG is a pattern or a picture', () => {
  it('is told by outlines of pieces at a size on paper', () => {
    expect(useOfSvg(freesewing(freesewingPart('front')))).toBe('pattern');
    expect(useOfSvg(svg(millimetreSheet, stroked(bodice())))).toBe('pattern');
    expect(useOfSvg(svg('viewBox="0 0 600 500"', stroked(bodice())))).toBe('picture');
    expect(useOfSvg(svg(millimetreSheet, `<path d="${bodice()}" fill="red"/>`))).toBe('picture');
    const small = svg(millimetreSheet, '<circle cx="9" cy="9" r="5" stroke="red"/>');
    expect(useOfSvg(small)).toBe('picture');
    expect(useOfSvg(small.slice(0, -20))).toBe('damaged');
    expect(useOfSvg('no svg at all')).toBe('damaged');
  });
});
