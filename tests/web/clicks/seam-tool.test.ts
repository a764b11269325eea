/** Sewing with clicks and keys, on a piece of four edges and another one. */
import {describe, expect, it} from 'vitest';

import {
  afterEvent,
  nothingChosen,
  questionOf,
  type Candidate,
  type SeamEdit,
  type SeamEvent,
  type SeamState,
  type Sewing,
  type Suggestion,
} from '@/clicks/seam-tool.js';
import type {Run} from '@/clicks/run.js';
import type {EdgeOfPiece, GarmentDocument} from '@/model/garment/garment-document.js';
import {setOpen, sew} from '@/model/garment/edits.js';
import {documentOf, draftedSeam, draftedSquare} from '../../support/garments/documents.js';

const at = (piece: number, edge: number): EdgeOfPiece => ({piece, edge});
const bare = documentOf([draftedSquare('one'), draftedSquare('other')]);
const half = documentOf(bare.pieces, {seams: [draftedSeam()]});

/** The likeliest candidate is the same edge of the other piece, then the next edge. */
function sewingOf(garment: GarmentDocument, more: Partial<Sewing> = {}): Sewing {
  const order = [0, 1].flatMap((piece) => [0, 1, 2, 3].map((edge) => at(piece, edge)));
  const candidates = (a: Run): readonly Candidate[] => {
    const [first] = a;
    return first
      ? [0, 1].map((k) => ({
          a,
          b: [at(1 - first.piece, (first.edge + k) % 4)],
          p: 0.9 - k / 2,
          sameDirection: k === 1,
        }))
      : [];
  };
  const nothing = {sure: () => [], darts: () => [], questions: () => [], best: () => undefined};
  return {garment, candidates, ...nothing, order, ...more};
}

/** Applies all events in order. */
function after(
  events: readonly SeamEvent[],
  sewing = sewingOf(bare),
): {readonly state: SeamState; readonly edits: readonly SeamEdit[]; readonly isOver: boolean} {
  let state = nothingChosen;
  const edits: SeamEdit[] = [];
  for (const event of events) {
    const answer = afterEvent(state, event, sewing);
    if (!answer) return {state, edits, isOver: true};
    state = answer.state;
    if (answer.edit) edits.push(answer.edit);
  }
  return {state, edits, isOver: false};
}

const pick = (piece: number, edge: number, isMore = false): SeamEvent => ({
  type: 'pick',
  edge: at(piece, edge),
  extends: isMore,
});
const go = (piece: number, edge: number): SeamEvent => ({type: 'go', edge: at(piece, edge)});
const sewnTo = (b: EdgeOfPiece, sameDirection = false, a = at(0, 1)): SeamEdit => ({
  ...{kind: 'sew', a: [a], b: [b], sameDirection},
});

describe('clicks', () => {
  it('sew the first edge to the second', () => {
    expect(after([pick(0, 1), pick(1, 3)]).edits).toEqual([sewnTo(at(1, 3))]);
  });

  it('sew what is a candidate in its direction, and R turns it', () => {
    expect(after([pick(0, 1), pick(1, 2)]).edits).toEqual([sewnTo(at(1, 2), true)]);
    expect(after([pick(0, 1), {type: 'turn'}, pick(1, 2)]).edits).toEqual([sewnTo(at(1, 2))]);
  });

  it('let an edge go that is clicked again', () => {
    const {state, edits} = after([pick(0, 1), pick(0, 1), pick(1, 3)]);
    expect(edits).toEqual([]);
    expect(state).toMatchObject({run: [at(1, 3)], isHeld: true});
  });

  it('with Shift make one side of several edges, in the order of the outline', () => {
    const {edits} = after([pick(0, 0), pick(0, 3, true), pick(0, 1, true), pick(1, 3)]);
    expect(edits).toEqual([
      {kind: 'sew', a: [at(0, 3), at(0, 0), at(0, 1)], b: [at(1, 3)], sameDirection: false},
    ]);
  });

  it('take a side over several pieces in the order in which it was clicked', () => {
    const {state} = after([pick(1, 0), pick(0, 2, true)]);
    expect(state.run).toEqual([at(1, 0), at(0, 2)]);
  });

  it('choose what is sewn, but do not sew it twice', () => {
    const sewing = sewingOf(half);
    expect(after([pick(0, 1)], sewing).state).toMatchObject({run: [at(0, 1)], isHeld: false});
    const {state, edits} = after([pick(0, 0), pick(0, 1)], sewing);
    expect(edits).toEqual([]);
    expect(state).toMatchObject({refused: 'sewn', run: [at(0, 0)], isHeld: true});
  });
});

describe('keys', () => {
  it('sew to the candidate of a number', () => {
    expect(after([go(0, 1), {type: 'sewTo', candidate: 1}]).edits).toEqual([sewnTo(at(1, 1))]);
    expect(after([go(0, 1), {type: 'sewTo', candidate: 2}]).edits).toEqual([
      sewnTo(at(1, 2), true),
    ]);
    expect(after([go(0, 1), {type: 'sewTo', candidate: 3}]).state.refused).toBe('noCandidate');
    expect(after([{type: 'sewTo', candidate: 1}]).state.refused).toBe('nothing');
  });

  it('hold an edge, lead to another, and sew them', () => {
    const held = [go(0, 1), {type: 'hold'}, go(1, 3)] as const;
    expect(after(held).state).toMatchObject({run: [at(0, 1)], other: [at(1, 3)]});
    expect(after([...held, {type: 'hold'}]).edits).toEqual([sewnTo(at(1, 3))]);
  });

  it('stretch the side that they are at along its outline, and over what is sewn', () => {
    const more = {type: 'stretch', by: 1} as const;
    const before = {type: 'stretch', by: -1} as const;
    expect(after([go(0, 3), more, before]).state.run).toEqual([at(0, 2), at(0, 3), at(0, 0)]);
    // the next edge is sewn: the outline of the other piece continues beyond it
    expect(after([go(0, 3), more, more], sewingOf(half)).state.run).toEqual([
      ...[at(0, 3), at(0, 0), at(1, 0)],
    ]);
    const {state} = after([go(0, 1), {type: 'hold'}, go(1, 0), more]);
    expect(state).toMatchObject({run: [at(0, 1)], other: [at(1, 0), at(1, 1)]});
  });

  it('lead to what is not sewn yet, the longest first', () => {
    const {outline} = draftedSquare('wide');
    const wide = draftedSquare('wide', {
      outline: outline.map((edge) => ({
        points: [
          [1.5 * edge.points[0][0], edge.points[0][1]],
          [1.5 * edge.points[1][0], edge.points[1][1]],
        ],
      })),
    });
    const garment = setOpen(
      {...half, pieces: [bare.pieces[0] ?? wide, wide]},
      at(1, 2),
      true,
    ).document;
    const {state} = after([{type: 'next'}], sewingOf(garment));
    const second = after([{type: 'next'}, {type: 'next'}], sewingOf(garment)).state;
    expect(state.run).toEqual([at(1, 0)]);
    expect(second.run).toEqual([at(0, 0)]);
    const all = bare.pieces.flatMap(({outline}, piece) =>
      outline.map((_, edge) => at(piece, edge)),
    );
    const done = all.reduce((next, edge) => setOpen(next, edge, true).document, bare);
    expect(after([{type: 'next'}], sewingOf(done)).state.refused).toBe('finished');
  });

  it('turn and take apart what is sewn', () => {
    const sewing = sewingOf(half);
    expect(after([go(1, 3), {type: 'turn'}], sewing).edits).toEqual([{kind: 'turn', seam: 0}]);
    expect(after([go(1, 3), {type: 'unsew'}], sewing).edits).toEqual([{kind: 'unsew', seam: 0}]);
    expect(after([go(1, 2), {type: 'unsew'}], sewing).edits).toEqual([]);
  });

  it('say that an edge stays open, and that it does not', () => {
    const open = setOpen(bare, at(0, 2), true).document;
    expect(after([go(0, 2), {type: 'open'}]).edits).toEqual([
      {kind: 'open', run: [at(0, 2)], open: true},
    ]);
    expect(after([go(0, 2), {type: 'open'}], sewingOf(open)).edits).toEqual([
      {kind: 'open', run: [at(0, 2)], open: false},
    ]);
    expect(after([go(0, 1), {type: 'open'}], sewingOf(half)).state.refused).toBe('sewn');
  });

  it('go back step by step, and leave at last', () => {
    const back = {type: 'back'} as const;
    const start = [go(0, 1), {type: 'hold'}, go(1, 3)] as const;
    expect(after([...start, back]).state).toMatchObject({other: [], isHeld: true});
    expect(after([...start, back, back]).state).toMatchObject({run: [at(0, 1)], isHeld: false});
    expect(after([...start, back, back, back]).state.run).toEqual([]);
    expect(after([...start, back, back, back]).isOver).toBe(false);
    expect(after([...start, back, back, back, back]).isOver).toBe(true);
  });
});

describe('suggestions', () => {
  const one: Suggestion = {a: [at(0, 1)], b: [at(1, 3)], sameDirection: false};
  const other: Suggestion = {a: [at(0, 0)], b: [at(1, 2)], sameDirection: true};
  const asking = (...questions: readonly Suggestion[]): Sewing =>
    sewingOf(bare, {questions: () => questions, sure: () => [one, other]});

  it('are asked about one by one: yes sews, and no leads to the next', () => {
    const {state} = after([{type: 'suggest'}], asking(one, other));
    expect(questionOf(state, asking(one, other))).toEqual({kind: 'seam', ...one});
    expect(afterEvent(state, {type: 'yes'}, asking(one, other))?.edit).toEqual(sewnTo(at(1, 3)));
    const no = afterEvent(state, {type: 'no'}, asking(one, other))?.state ?? nothingChosen;
    expect(no.answered).toMatchObject([one]);
    expect(questionOf(no, asking(other))).toEqual({kind: 'seam', ...other});
  });

  it('come back once all others are answered, if they were put off', () => {
    const {state} = after([{type: 'suggest'}, {type: 'skip'}], asking(one, other));
    expect(questionOf(state, asking(one, other))).toEqual({kind: 'seam', ...other});
    expect(questionOf(state, asking(one))).toEqual({kind: 'seam', ...one});
  });

  it('are asked again after the answer is taken back', () => {
    const {state} = after(
      [{type: 'suggest'}, {type: 'skip'}, {type: 'no'}, {type: 'unanswer'}, {type: 'unanswer'}],
      asking(one, other),
    );
    expect(state).toMatchObject({answered: [], later: [], log: []});
  });

  it('begin with the darts, which need no question', () => {
    const darts = [other];
    const {edits, state} = after([{type: 'suggest'}], sewingOf(bare, {darts: () => darts}));
    expect(edits).toEqual([{kind: 'sewAll', seams: darts, exactly: true}]);
    expect(state.suggests).toBe(true);
  });

  it('sew all parts of a whole seam, and no others', () => {
    const whole = {a: [at(0, 0), at(0, 1)], b: [at(1, 2), at(1, 3)], sameDirection: false};
    const sewing = asking({...whole, parts: [one, other]} as Suggestion);
    expect(after([{type: 'suggest'}, {type: 'yes'}], sewing).edits).toEqual([
      {kind: 'sewAll', seams: [one, other], exactly: true},
    ]);
  });

  it('are accepted all at once', () => {
    expect(after([{type: 'suggest'}, {type: 'acceptAll'}], asking(one, other)).edits).toEqual([
      {kind: 'sewAll', seams: [one, other]},
    ]);
  });

  it('keep what was answered over an edit, by its new numbers', () => {
    const {state} = after([{type: 'suggest'}, {type: 'no'}], asking(one, other));
    const edited = sew(bare, {a: [at(0, 0)], b: [at(1, 2)], sameDirection: true});
    const moved = (edge: EdgeOfPiece): readonly EdgeOfPiece[] =>
      edited.edgesOf(edge).map((part) => ({...part, edge: part.edge + 1}));
    const event = {type: 'edited', edgesOf: moved, gathered: []} as const;
    const next = afterEvent(state, event, sewingOf(edited.document))?.state;
    expect(next?.answered).toMatchObject([{a: [at(0, 2)], b: [at(1, 4)]}]);
  });
});

it('asks whether sides of different lengths are gathered, until something else is done', () => {
  const event = {type: 'edited', edgesOf: (edge: EdgeOfPiece) => [edge], gathered: [0]} as const;
  const sewing = sewingOf(half);
  const {state} = after([go(0, 1), event], sewing);
  expect(questionOf(state, sewing)).toEqual({kind: 'gathered', seams: [0]});
  expect(afterEvent(state, {type: 'no'}, sewing)?.edit).toEqual({kind: 'match', seams: [0]});
  expect(afterEvent(state, {type: 'yes'}, sewing)).toEqual({state: {...state, gathered: []}});
  expect(afterEvent(state, go(0, 2), sewing)?.state.gathered).toEqual([]);
});

it('offers the next edge where a side is too short for what it is sewn to, and sews both instead', () => {
  const {outline} = draftedSquare('wide');
  const wide = draftedSquare('wide', {
    outline: outline.map(({points: [from, to]}) => ({
      points: [
        [2 * from[0], from[1]],
        [2 * to[0], to[1]],
      ],
    })),
  });
  const garment = documentOf([...bare.pieces, wide], {
    // two squares side by side, and one of them sewn along a side as long as both
    seams: [draftedSeam(), draftedSeam({a: at(0, 0), b: at(2, 2)})],
  });
  const sewing = sewingOf(garment);
  const state = {...nothingChosen, run: [at(0, 0)], gathered: [1]};
  const instead = {a: [at(0, 0), at(1, 0)], b: [at(2, 2)], sameDirection: false};
  expect(questionOf(state, sewing)).toEqual({kind: 'gathered', seams: [1], instead});
  const answer = afterEvent(state, {type: 'join'}, sewing);
  expect(answer?.edit).toEqual({kind: 'join', seams: [1], ...instead});
  expect(answer?.state.gathered).toEqual([]);
  // two squares have equal lengths: there is no offer
  const plain = {...state, gathered: [0]};
  expect(questionOf(plain, sewing)).toEqual({kind: 'gathered', seams: [0]});
});

it('sews to a candidate with more than the run, where it is one', () => {
  const side = [at(0, 0), at(1, 0)];
  const sewing = sewingOf(half, {
    candidates: () => [{a: side, b: [at(1, 2)], p: 0.5, sameDirection: false}],
  });
  expect(after([go(0, 0), {type: 'sewTo', candidate: 1}], sewing).edits).toEqual([
    {kind: 'sew', a: side, b: [at(1, 2)], sameDirection: false},
  ]);
});
