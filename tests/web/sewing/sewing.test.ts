/**
 * Proposals of the sewing tool for a shirt with sleeves of one piece, and its reactions to answers.
 */
import {expect, it} from 'vitest';

import type {Run} from '@/clicks/run.js';
import type {Suggestion} from '@/clicks/seam-tool.js';
import {editedBy} from '@/sewing/seam-edits.js';
import {sewingOf} from '@/sewing/sewing.js';
import type {EdgeOfPiece} from '@/model/garment/garment-document.js';
import {shirtWithSleeves} from '../../support/garments/shirts.js';

const shirt = shirtWithSleeves();
const at = (name: string, edge: number): EdgeOfPiece => ({
  piece: shirt.pieces.findIndex((one) => one.name === name),
  edge,
});
const cap: Run = [at('sleeve', 2)];
const armholes: Run = [at('front', 2), at('back', 6)];
const pairsOf = (all: readonly Suggestion[]): readonly (readonly [Run, Run])[] =>
  all.map(({a, b}) => [a, b]);

it('names a match only where one is likely, and numbers others all the same', () => {
  const {best, candidates} = sewingOf(shirt, []);
  expect(best([at('front', 1)])?.b).toEqual([at('back', 7)]);
  for (const open of [at('back', 0), at('front', 0), at('back', 4), at('sleeve', 0)]) {
    expect(candidates([open]).length).toBeGreaterThan(2);
    expect(best([open])).toBeUndefined();
  }
});

it('proposes both armholes for a cap, and the cap with the other armhole for one', () => {
  const {best, candidates} = sewingOf(shirt, []);
  expect(pairsOf(candidates(cap).slice(0, 2))).toContainEqual([cap, armholes]);
  expect(best([at('front', 2)])).toMatchObject({a: armholes});
  expect(best(armholes)?.b).toHaveLength(1);
  const {seams} = editedBy(shirt, {
    kind: 'sew',
    a: armholes,
    b: cap,
    sameDirection: false,
  }).document;
  expect(seams).toHaveLength(2);
});

it('is not sure of what was refused, and does not ask for it again', () => {
  const first = sewingOf(shirt, []);
  const [sure] = first.sure();
  if (!sure) throw new Error('nothing is sure');
  const turned: Suggestion = {...sure, a: sure.b, b: sure.a};
  for (const refused of [sure, turned]) {
    const left = sewingOf(shirt, [refused]);
    expect(left.sure().length).toBeLessThan(first.sure().length);
    expect(pairsOf(left.sure())).not.toContainEqual([sure.a, sure.b]);
    expect(pairsOf(left.questions())).not.toContainEqual([sure.a, sure.b]);
  }
});

it('asks about a cap no more once both sides of it are refused', () => {
  const {document} = editedBy(shirt, {kind: 'sewAll', seams: sewingOf(shirt, []).sure()});
  const asked: Suggestion[] = [];
  for (let k = 0; k < 30; k++) {
    const [next] = sewingOf(document, asked).questions();
    if (!next) break;
    asked.push(next);
  }
  const keys = asked.map(({a, b}) => JSON.stringify([a, b]));
  expect(asked.length).toBeLessThan(30);
  expect(new Set(keys).size).toBe(keys.length);
  expect(asked.filter(({a}) => a.length === 2)).toHaveLength(4);
});

it('joins the next edge to a side that was too short, as one step', () => {
  const shoulder = {a: [at('front', 3)], b: [at('back', 5)], sameDirection: false};
  const sewn = editedBy(shirt, {kind: 'sew', ...shoulder}).document;
  const short = {a: [at('front', 2)], b: cap, sameDirection: false};
  const gathered = editedBy(sewn, {kind: 'sew', ...short}).document;
  const number = sewn.seams.length;
  const joined = editedBy(gathered, {
    ...{kind: 'join', seams: [number], a: armholes, b: cap, sameDirection: false},
  });
  expect(joined.seamsOf(number)).toEqual([]);
  expect(joined.document.seams).toHaveLength(number + 2);
  const ends = joined.document.seams.slice(number).map(({a}) => a);
  expect(ends).toEqual(armholes);
});

it('closes each sleeve after one is set in, and does not sew it to the other', () => {
  const {document} = editedBy(shirt, {kind: 'sewAll', seams: sewingOf(shirt, []).sure()});
  const set = editedBy(document, {kind: 'sew', a: armholes, b: cap, sameDirection: false});
  const asked = sewingOf(set.document, []).questions();
  expect(asked.length).toBe(2);
  for (const {a, b} of asked) expect(a[0]?.piece).toBe(b[0]?.piece);
});
