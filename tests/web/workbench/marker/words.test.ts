/** Texts about the fabric layout, on the page and in its files, in every language. */
import {describe, expect, it} from 'vitest';

import {FlawTool} from '@/clicks/flaw-tool.js';
import {
  costWords,
  lengthRange,
  lyingWords,
  placeWords,
  pointWords,
  roundedLength,
  soldLength,
} from '@/workbench/marker/marker-words.js';
import type {Bolt} from '@/marker/places.js';
import type {LayPlan} from '@/model/result/marker-plan.js';
import {aroundPins} from '@/model/result/pinned-plan.js';
import {signedArea} from '@/model/geometry/polyline.js';
import {runsOf} from '@/files/pdf/fonts/letters.js';
import {widthOf} from '@/files/pdf/text.js';
import type {Source} from '@/texts/base/message.js';
import {formatFor} from '@/texts/format.js';
import {markerTexts} from '@/texts/marker-texts.js';
import {planTextsIn} from '@/texts/plan-texts.js';
import {languages} from '@/texts/preferences.js';

const words = markerTexts('en');
const [cm, inch] = [formatFor('en', 'cm'), formatFor('en', 'inch')];

const bolt: Bolt = {
  ...{repeat: {group: 'p2', w1: [10, 0], w2: [0, 10]}, origin: [3, 2], flaws: []},
  ...{widthCm: 110, selvedgeCm: 1, gapCm: 0.2, isOneWay: false},
};

describe('the length of fabric', () => {
  it('is what there is to buy, rounded up as it is sold', () => {
    expect(soldLength(141, 'cm', words, cm)).toBe('1.45 m');
    expect(soldLength(145.001, 'cm', words, cm)).toBe('1.45 m');
    expect(soldLength(145.1, 'cm', words, cm)).toBe('1.5 m');
    expect(soldLength(91.44, 'inch', words, inch)).toBe('1 yd');
    expect(soldLength(100, 'inch', words, inch)).toBe('1 1/8 yd');
  });

  it('is said in whole centimetres, never too short, and lies in the range that is said', () => {
    expect(roundedLength(120.2, 'cm', cm)).toBe('121 cm');
    expect(lengthRange([120.2, 135.6], 'cm', words, cm)).toMatch(/^120 to 136 cm, /);
    expect(lengthRange([120.995, 136.005], 'cm', words, cm)).toMatch(/^121 to 136 cm, /);
    expect(lengthRange([101.6, 127], 'inch', words, inch)).toMatch(/^40 in to 50 in, /);
  });
});

describe('what the print costs', () => {
  const plan = {lengthCm: 90, freeLengthCm: 80, unplaced: []} as unknown as LayPlan;
  const said = (one: LayPlan) => costWords(one, words, cm);
  const pinned = (lengthCm: number, before?: LayPlan): LayPlan =>
    aroundPins({...plan, lengthCm, freeLengthCm: 79}, before);

  it('is what it takes more than the same pieces without it', () => {
    expect(said(plan)).toEqual(['The print costs 10 cm']);
    expect(said({...plan, freeLengthCm: 89.8})).toEqual(['The print costs no fabric']);
    expect(said({...plan, freeLengthCm: null})).toEqual([]);
  });

  it('is the same with pins, which are told of apart', () => {
    const first = pinned(102, plan);
    expect(said(first)).toEqual(['The print costs 10 cm', 'Your pins cost 12 cm more']);
    expect(said(pinned(104, first))).toEqual([
      'The print costs 10 cm',
      'Your pins cost 14 cm more',
    ]);
    expect(said(pinned(90, plan))).toEqual(['The print costs 10 cm', 'Your pins cost no fabric']);
    // pins that give a better layout than the search
    expect(said(pinned(86, plan))).toEqual(['The print costs 6 cm', 'Your pins cost no fabric']);
  });

  it('is told with that of pins where nobody knows how the pieces lie without them', () => {
    expect(said(pinned(102))).toEqual(['The print and your pins together cost 23 cm']);
  });

  it('is not known while pieces do not lie', () => {
    expect(said({...plan, unplaced: [{result: 0, copy: 0, piece: 'front'}]})).toEqual([]);
  });
});

describe('a place on fabric', () => {
  it('is counted in repeats, or measured', () => {
    expect(pointWords([23, 12], bolt, words, cm)).toBe(
      '4th repeat from the left, 3rd from the start',
    );
    const slanting: Bolt = {...bolt, repeat: {group: 'p2', w1: [9, 1], w2: [-1, 9]}};
    expect(pointWords([23, 12], slanting, words, cm)).toBe(
      '23 cm from the left, 12 cm from the start',
    );
  });

  it('says by how much the piece is turned', () => {
    const piece = {
      outline: [
        [0, 0],
        [8, 0],
        [8, 8],
      ] as const,
      alignment: {angle: 0, translation: [0, 0] as const},
      ...{turns: 'half' as const, up: [0, 1] as const, shifts: []},
    };
    const turned = {piece, place: {angle: Math.PI, translation: [31, 20] as const}};
    expect(placeWords(turned, bolt, words, cm)).toMatch(/from the start, turned 180°$/);
    expect(lyingWords(turned, bolt, words, cm)).toBe(
      '4th repeat from the left, 12 cm from the start, turned 180°',
    );
  });

  it.each([
    [1, '1st'],
    [2, '2nd'],
    [3, '3rd'],
    [11, '11th'],
    [12, '12th'],
    [21, '21st'],
    [112, '112th'],
  ])('has an ordinal: %i', (n, said) => {
    expect(words.at(n, 4)).toBe(`${said} repeat from the left, 4th from the start`);
  });
});

describe('a flaw', () => {
  it('is a box that is dragged, whichever way, counter-clockwise', () => {
    const tool = new FlawTool();
    tool.press([5, 5]);
    tool.move([2, 8]);
    expect(tool.draft).toHaveLength(4);
    const box = tool.release([2, 8]) ?? [];
    expect(signedArea(box)).toBeCloseTo(9);
  });

  it('is a polygon of corners that are clicked, or nothing', () => {
    const tool = new FlawTool();
    for (const corner of [
      [0, 0],
      [0, 4],
      [4, 0],
    ] as const) {
      tool.press(corner);
      expect(tool.release(corner)).toBeUndefined();
    }
    expect(signedArea(tool.close() ?? [])).toBeCloseTo(8);
    tool.press([1, 1]);
    tool.release([1, 1]);
    expect(tool.close()).toBeUndefined();
  });
});

/** Width of a figure, and of the table's first column. [mm] */
const rooms = {figure: 45, name: 36};

it.each(languages)('has room in %s for what stands on a lay plan', (language) => {
  const texts = planTextsIn(language);
  const figures = [
    ...[texts.length, texts.buy, texts.use, texts.cost, texts.proven],
    ...[texts.atBest('1234.5 cm'), texts.roundedUp('1/8 yd')],
    ...[texts.ofWidth('123.4 cm'), texts.without('1234.5 cm')],
  ];
  const wide = (text: string, size: number, most: number): string[] =>
    size * widthOf(text) > most ? [text] : [];
  expect(figures.flatMap((text) => wide(text, 2.6, rooms.figure))).toEqual([]);
  const names = [texts.phase, texts.width, texts.length].map((name) => `${name} (cm)`);
  expect(names.flatMap((text) => wide(text, 2.6, rooms.name))).toEqual([]);
  const {notes, ...others} = texts;
  const all = [notes, others].flatMap((some) =>
    Object.values(some).map((one) =>
      typeof one === 'function' ? (one as unknown as Source).text : one,
    ),
  );
  expect(all.flatMap(runsOf).filter(({isSans}) => !isSans)).toEqual([]);
});
