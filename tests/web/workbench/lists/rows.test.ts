import {describe, expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {Pattern} from '@/model/result/result.js';
import {
  pieceRows,
  seamRows,
  seamText,
  type PieceRow,
  type SeamRow,
} from '@/workbench/lists/rows.js';
import {de} from '@/texts/de.js';
import {en} from '@/texts/en.js';
import {formatFor} from '@/texts/format.js';
import {realigned, sceneOf} from '@/scene/scene.js';
import {documentOf, draftedSeam} from '../../../support/garments/documents.js';
import type {GarmentSeam} from '@/model/garment/garment-document.js';
import {
  plainPrint,
  square,
  squarePair,
  squarePiece,
} from '../../../support/garments/two-squares.js';

interface Shown {
  readonly pattern?: Pattern;
  /** The garment's data about its seams. */
  readonly drafted?: readonly Partial<GarmentSeam>[];
  readonly options?: Design['options'];
  /** Vertical offset of the second piece, before and after. [cm] */
  readonly high?: readonly [number, number];
  readonly oneWay?: boolean;
}

/** The parts of a workbench that the rows read; by default of two sewn squares. */
function workbench({
  pattern = squarePair(),
  drafted = [],
  options = {},
  high = [2, 0],
  oneWay,
}: Shown) {
  const design: Design = {
    garment: {name: 'two.json', text: '{}'},
    print: {
      ...{title: '', group: 'p1', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
      size: {width: 10, height: 10, angleDeg: 90},
    },
    ...{symmetry: 'none', seed: 1, method: 'best', options},
  };
  const lying = (up: number) =>
    pattern.pieces.map(({alignment: {angle, translation}}, k) => ({
      angle,
      translation: [translation[0], translation[1] + k * up] as const,
    }));
  const scene = sceneOf(
    pattern,
    {...plainPrint, oneWay: oneWay ?? false},
    {
      plain: new Set(options.plain),
    },
  );
  const [before, now] = [realigned(scene, lying(high[0])), realigned(scene, lying(high[1]))];
  const meshed = {...pattern, pieces: [], fitRandom: 0, notes: []};
  const garment = documentOf([], {seams: drafted.map(draftedSeam)});
  return {
    history: {design},
    solving: {garment, pattern: meshed, result: undefined},
    sheet: {scenes: {before, now, marks: new Map()}},
  };
}

const seams = (shown: Shown = {}): readonly SeamRow[] => seamRows(workbench(shown), en);
const pieces = (shown: Shown = {}): readonly PieceRow[] => pieceRows(workbench(shown));
const seam = (shown: Shown = {}): Partial<SeamRow> => seams(shown)[0] ?? {};
const piece = (shown: Shown = {}): Partial<PieceRow> => pieces(shown)[0] ?? {};

const twice = (): Pattern => {
  const pattern = squarePair();
  return {...pattern, seams: [...pattern.seams, ...pattern.seams]};
};

describe('rows of seams', () => {
  it('measure length and mismatch, before and after', () => {
    expect(seam({high: [2, 0.5]}).length).toBeCloseTo(4, 12);
    expect(seam({high: [2, 0.5]}).before).toBeCloseTo(2, 12);
    expect(seam({high: [2, 0.5]}).after).toBeCloseTo(0.5, 12);
    expect(seam({high: [2, 0.5]}).worst).toBeCloseTo(0.5, 12);
  });

  it('take names from the garment file, by stitch', () => {
    const drafted = [{name: 'Waist'}, {name: 'Side'}];
    expect(seams({pattern: twice(), drafted}).map(({name}) => name)).toEqual(['Waist', 'Side']);
  });

  it('are named after the pieces where the file has no name', () => {
    expect(seam().name).toBe('Left half to Right half');
    expect(seam().between).toBeUndefined();
  });

  it('number names that are alike', () => {
    const drafted = [{name: 'Side'}, {name: 'Side'}];
    expect(seams({pattern: twice(), drafted}).map(({name}) => name)).toEqual(['Side 1', 'Side 2']);
  });

  it('have the weight of the options, else of the file, else 1', () => {
    const drafted = [{weight: 0.75}];
    expect(seam({drafted, options: {weights: {0: 0.5}}}).weight).toBe(0.5);
    expect(seam({drafted}).weight).toBe(0.75);
    expect(seam().weight).toBe(1);
  });

  it('say which seams are not matched, and which could not be', () => {
    expect(seam()).toMatchObject({matched: true, canMatch: true});
    expect(seam({options: {unmatched: [0]}})).toMatchObject({matched: false, canMatch: true});
    const drafted = [{matched: false}];
    expect(seam({drafted})).toMatchObject({matched: false, canMatch: false});
    const options = {plain: ['left_half']};
    expect(seam({options})).toMatchObject({matched: false, canMatch: false});
  });

  it('stay the same while nothing changes', () => {
    const shown = workbench({});
    expect(seamRows({...shown}, en)).toBe(seamRows(shown, en));
    expect(seamRows(shown, de)).not.toBe(seamRows(shown, en));
  });

  it('are none before the garment has been read', () => {
    const shown = workbench({});
    const solving = {...shown.solving, pattern: undefined};
    expect(seamRows({...shown, sheet: {scenes: undefined}}, en)).toEqual([]);
    expect(pieceRows({...shown, solving})).toEqual([]);
  });
});

describe('the text of a seam', () => {
  const format = formatFor('en', 'cm');
  const drafted = [{name: 'Side seam'}];

  it('tells name, pieces, length, mismatch and kind', () => {
    expect(seams({drafted, high: [2, 0.2]}).map((row) => seamText(row, en, format))).toEqual([
      'Side seam (A), Left half to Right half, 4 cm, mismatch 2 mm, print continues',
    ]);
  });

  it('tells where the print runs off along the seam', () => {
    const row = {
      ...seams({high: [2, 0.2]})[0],
      drift: {start: 0.1, end: 4, most: 4.2, isLost: false},
    };
    const other = {...row, drift: {start: 1, end: 2, most: 2.5, isLost: false}};
    const texts = [row, other].map((one) => seamText(one as SeamRow, en, format));
    expect(texts.map((text) => text.split(', ').slice(4).join(', '))).toEqual([
      'meets at one end, 40 mm off at the other',
      'along the whole seam, up to 25 mm off',
    ]);
  });

  it('tells why it stays off, where that is not that the print runs off', () => {
    const [row] = seams({high: [2, 0.2]});
    const said = (more: Partial<SeamRow>) =>
      row &&
      seamText({...row, ...more}, en, format)
        .split(', ')
        .slice(4)
        .join(', ');
    const drift = {start: 0.1, end: 4, most: 4.2, isLost: false};
    expect(said({})).toBe('');
    expect(said({why: 'grain', drift})).toBe('its two edges run at different angles to the grain');
    expect(said({why: 'others', drift})).toBe('meets at one end, 40 mm off at the other');
    expect(said({drift: {...drift, most: 24.84, isLost: true}})).toBe(
      'the print does not continue across it',
    );
    expect(said({why: 'others'})).toBe('other seams of the same pieces are matched first');
    expect(said({why: 'locked'})).toBe('its outline is kept');
    expect(said({why: 'size'})).toBe('the print is too large for it');
    expect(said({why: 'group'})).toBe('this print has no mirrors for it');
  });

  it('says that one side is gathered, and not where a print runs off that cannot run on', () => {
    const pattern = squarePair();
    const gathered = {...pattern, seams: pattern.seams.map((one) => ({...one, lengthRatio: 0.6}))};
    const [row] = seams({pattern: gathered, high: [2, 0.2]});
    expect(row).toMatchObject({gathered: true, drift: undefined});
    expect(row && seamText(row, en, format)).toMatch(
      /print continues, gathered: the two edges have different lengths$/,
    );
    expect(seam({pattern, high: [2, 0.2]}).gathered).toBe(false);
  });

  it('says that a seam is not counted in place of its kind', () => {
    const pattern = squarePair();
    const off = {...pattern, seams: pattern.seams.map((one) => ({...one, matched: false}))};
    expect(seams({pattern: off}).map((row) => seamText(row, de, formatFor('de', 'cm')))).toEqual([
      'Left half to Right half (A), 4 cm, Versatz 0 mm, zählt nicht',
    ]);
  });
});

describe('rows of pieces', () => {
  it('tell size and number of seams', () => {
    expect(piece()).toMatchObject({label: 'Left half', width: 4, height: 4, seams: 1});
  });

  it('tell how far the outline moved where it moved most', () => {
    const shape = square.map(([x, y], k) => [x + (k === 2 ? 0.3 : 0), y] as const);
    const [, right] = squarePair().pieces;
    const pattern = squarePair({
      pieces: [squarePiece('left_half', {shape}), right ?? squarePiece('')],
    });
    expect(pieces({pattern}).map(({moved}) => moved)).toEqual([expect.closeTo(0.3, 12), 0]);
  });

  it('tell the angle between grain and fabric, either way up unless the print is one-way', () => {
    const turned = (degrees: number): Pattern =>
      squarePair({
        pieces: [
          squarePiece('left_half', {
            alignment: {angle: (degrees * Math.PI) / 180, translation: [0, 0]},
          }),
          squarePiece('right_half'),
        ],
      });
    expect(piece({pattern: turned(-30)}).offGrain).toBeCloseTo(30, 9);
    expect(piece({pattern: turned(170)}).offGrain).toBeCloseTo(10, 9);
    expect(piece({pattern: turned(170), oneWay: true}).offGrain).toBeCloseTo(170, 9);
  });

  it('tell what was decided about the piece alone', () => {
    expect(piece()).toMatchObject({grain: 'all', printed: true, pinned: false});
    const options: Design['options'] = {
      grain: {default: 'on', pieces: {left_half: {lock: 'bias', toleranceDeg: 5}}},
      pins: {left_half: {angle: 0, translation: [0, 0]}},
      plain: ['left_half'],
    };
    expect(piece({options})).toMatchObject({grain: 'bias', printed: false, pinned: true});
  });
});
