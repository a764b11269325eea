import {describe, expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {Pattern, SeamGroup} from '@/model/result/result.js';
import {realigned, sceneOf} from '@/scene/scene.js';
import {de} from '@/texts/de.js';
import {en} from '@/texts/en.js';
import {formatFor} from '@/texts/format.js';
import {
  firstOff,
  foldedWords,
  groupRows,
  nextSeam,
  type GroupRow,
} from '@/workbench/lists/group-rows.js';
import {reasonOf} from '@/workbench/lists/group-actions.js';
import {commonWords} from '@/workbench/lists/names.js';
import {gainOf, headlineOf, sentencesOf} from '@/workbench/lists/verdict.js';
import {documentOf} from '../../../support/garments/documents.js';
import {plainPrint, squarePair} from '../../../support/garments/two-squares.js';

const format = formatFor('en', 'cm');

const group = (seam: number, more: Partial<SeamGroup> = {}): SeamGroup => ({
  ...{seams: [seam], place: 'side', visibility: 2, state: 'matches'},
  ...more,
});

/** Two squares with as many seams as the groups have, all along the same edges. */
function workbench(seamGroups: readonly SeamGroup[], options: Design['options'] = {}) {
  const pair = squarePair();
  const pattern: Pattern = {...pair, seams: seamGroups.flatMap(() => pair.seams)};
  const design: Design = {
    garment: {name: 'two.json', text: '{}'},
    print: {
      ...{title: '', group: 'p1', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
      size: {width: 10, height: 10, angleDeg: 90},
    },
    ...{symmetry: 'none', seed: 1, method: 'best', options},
  };
  const scene = sceneOf(pattern, plainPrint);
  const before = realigned(
    scene,
    pattern.pieces.map(() => ({angle: 0, translation: [0, 0]})),
  );
  const pieces = pattern.pieces.map((piece) => ({...piece, edges: [0, 1, 2, 3]}));
  const solving = {
    ...{garment: documentOf([]), pattern: {...pattern, pieces, fitRandom: 0, notes: []}},
    ...{result: {} as never, seamGroups},
  };
  return {history: {design}, solving, sheet: {scenes: {before, now: scene, marks: new Map()}}};
}

const rows = (groups: readonly SeamGroup[], options?: Design['options']): readonly GroupRow[] =>
  groupRows(workbench(groups, options), en);

describe('the lines of seams', () => {
  it('leave out seams that an edit has removed', () => {
    expect(rows([group(0), group(7)]).map(({seams}) => seams)).toEqual([[0]]);
    const pair = group(0, {seams: [0, 1, 7]});
    expect(rows([pair, group(7)]).map(({seams}) => seams)).toEqual([[0, 1]]);
  });

  it('put the most visible first, and hidden ones at the end', () => {
    const all = rows([
      group(0, {place: 'dart', visibility: 0.5}),
      group(1),
      group(2, {place: 'centre front', visibility: 3}),
      group(3, {place: 'waist', visibility: 3, state: 'cannot', reason: 'gather'}),
    ]);
    expect(all.map(({name}) => name)).toEqual(['Centre front', 'Side seam', 'Waist seam', 'Dart']);
    expect(foldedWords(all, en)).toBe('2 others: gathers, darts');
    expect(foldedWords(all.slice(0, 2), en)).toBeUndefined();
  });

  it('tell left and right as one if they are alike', () => {
    const [left, right] = [group(0, {side: 'left'}), group(1, {side: 'right'})];
    expect(rows([left, right])).toMatchObject([{name: 'Side seams', count: 2, seams: [0, 1]}]);
    const names = (other: Partial<SeamGroup>, options?: Design['options']) =>
      rows([left, {...right, ...other}], options).map(({name}) => name);
    expect(names({state: 'off'})).toEqual(['Side seam, left', 'Side seam, right']);
    expect(names({place: 'shoulder'})).toEqual(['Side seam, left', 'Shoulder, right']);
    expect(names({}, {weights: {1: 2}})).toHaveLength(2);
  });

  it('add pieces, then numbers, to names that are alike', () => {
    expect(rows([group(0), group(1)]).map(({name}) => name)).toEqual([
      'Side seam: Left half to Right half 1',
      'Side seam: Left half to Right half 2',
    ]);
    expect(commonWords('Side left to Front', 'Side right to Front')).toBe('Side to Front');
  });

  it('have no state while there is no result', () => {
    const shown = workbench([group(0)]);
    const solving = {...shown.solving, result: undefined};
    expect(groupRows({...shown, solving}, en)).toMatchObject([{state: undefined}]);
  });

  it('know whether their outlines are kept', () => {
    const locked = {left_half: [1], right_half: [3]};
    expect(rows([group(0)], {locked})).toMatchObject([{kept: true}]);
    expect(rows([group(0)], {locked: {left_half: [1]}})).toMatchObject([{kept: false}]);
  });

  it('fold away the seams that sewing has gathered, with that reason', () => {
    const shown = workbench([group(0, {state: 'choice'})], {unmatched: [0]});
    const [seam] = shown.solving.pattern.seams;
    if (seam) Object.assign(seam, {lengthRatio: 1.3});
    const [row] = groupRows(shown, en);
    expect(row).toMatchObject({isVisible: false, reason: 'gather'});
    expect(row && reasonOf(shown, row, en, format)).toBe(en.remedies.why.gather);
  });

  it('are walked in their order, round and round', () => {
    const all = rows([group(0), group(1, {place: 'centre front', visibility: 3})]);
    expect([1, 0].map((seam) => nextSeam(all, seam, 1))).toEqual([0, 1]);
    expect(nextSeam(all, 1, -1)).toBe(0);
    expect(nextSeam([], undefined, 1)).toBeUndefined();
  });

  it('name the most visible one that does not match', () => {
    const hidden = group(0, {visibility: 0.5, state: 'off'});
    expect(firstOff(rows([hidden, group(1)]))).toBeUndefined();
    expect(firstOff(rows([hidden, group(1), group(2, {state: 'off'})]))?.worst).toBe(2);
  });

  it('give reasons in words that need no lesson', () => {
    const why = (more: Partial<SeamGroup>, options?: Design['options']) => {
      const shown = workbench([group(0, more)], options);
      const [row] = groupRows(shown, en);
      return row && reasonOf(shown, row, en, format);
    };
    expect(why({})).toBeUndefined();
    expect(why({state: 'close', unmatchedEnd: {from: 'top', cm: 2}})).toBe(
      'all but the top 2 cm matches',
    );
    expect(why({state: 'off', reason: 'reach'})).toBe('its outline would change by more than 1 cm');
    expect(why({state: 'off', reason: 'reach'}, {maxChangeCm: 0.5})).toMatch(/0\.5 cm$/);
    expect(why({state: 'choice'}, {unmatched: [0]})).toBe('your choice');
  });
});

describe('the headline', () => {
  const judged = (...groups: readonly SeamGroup[]) => ({
    ...{groups, weights: undefined, most: 0.06},
    before: {matched: 0, counted: groups.length},
  });
  const some = judged(
    group(0),
    group(1, {place: 'centre front', visibility: 3}),
    group(2, {place: 'shoulder', state: 'off', reason: 'group'}),
    group(3, {place: 'yoke', state: 'close', reason: 'others'}),
    group(4, {place: 'outseam', state: 'off', reason: 'group'}),
    group(5, {place: 'outseam'}),
  );

  it('counts the visible seams that match', () => {
    expect(headlineOf(some, en)).toBe('3 of 6 visible seams match');
    expect(headlineOf(judged(group(0), group(1)), en)).toBe('All 2 visible seams match');
    expect(headlineOf(judged(group(0)), en)).toBe('The 1 visible seam matches');
    expect(headlineOf(judged(group(0, {visibility: 0.5, state: 'off'})), en)).toBe(
      '0 of 1 seams match',
    );
    expect(headlineOf(judged(group(0, {state: 'choice'})), en)).toBe('No seam is matched');
    expect(headlineOf(judged(), en)).toBe('No seams yet');
  });

  it('is followed by the places where the print matches and breaks', () => {
    expect(sentencesOf(some, en, format, 'en')).toEqual([
      'The print matches at the centre front and at the side seams.',
      'It comes close at the yoke.',
      'It matches only in part at the outside leg seams.',
      'It breaks at the shoulders.',
      'It has no mirrors for these seams, so left and right can’t both match.',
    ]);
    expect(sentencesOf(some, de, formatFor('de', 'cm'), 'de').slice(0, 2)).toEqual([
      'Das Muster passt an der vorderen Mitte und an den Seitennähten.',
      'Es passt fast an der Passe.',
    ]);
  });

  it('is followed by the largest mismatch if all match', () => {
    expect(sentencesOf(judged(group(0)), en, format, 'en')).toEqual([
      'The largest mismatch is 0.6 mm.',
    ]);
    expect(sentencesOf(judged(), en, format, 'en')).toHaveLength(1);
  });

  it('tells how many would match without it, if fewer', () => {
    expect(gainOf(some, en)).toBe('Without matching, none of them would match.');
    expect(gainOf({...some, before: {matched: 3, counted: 6}}, en)).toBeUndefined();
  });
});
