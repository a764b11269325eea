import {describe, expect, it} from 'vitest';

import {pickIndex} from '@/clicks/pick-index.js';
import {targetsAt, type Target} from '@/clicks/pick.js';
import type {Sheet} from '@/clicks/sheet.js';
import {
  afterEvent,
  outside,
  type MeasuredMirror,
  type SymmetryEvent,
  type SymmetryState,
  type SymmetryTool,
} from '@/clicks/symmetry-tool.js';
import type {Point} from '@/model/geometry/vectors.js';
import {dartedSquare, rectangle, sewnSquares, sheetOf} from '../../support/clickable-sheet.js';

const squares = sewnSquares();

/** Target of a click on a sheet. */
function hit(x: number, y: number, sheet: Sheet = squares): Target {
  const [target] = targetsAt(pickIndex(sheet), [x, y], 0.5);
  if (!target) throw new Error(`nothing at ${x}, ${y}`);
  return target;
}

const pick = (x: number, y: number, snapped?: Point): SymmetryEvent => ({
  type: 'pick',
  target: hit(x, y),
  ...(snapped && {snapped}),
});
const pickPoint = (piece: number, point: Point): SymmetryEvent => ({
  type: 'pickPoint',
  piece,
  point,
});
const back: SymmetryEvent = {type: 'back'};
const commit: SymmetryEvent = {type: 'commit'};
const good: MeasuredMirror = {residual: 0.02, map: {angle: 0, translation: [4, 0]}, mirrors: true};
const bad: MeasuredMirror = {...good, residual: 1.5, mirrors: false};
const measured = (candidate: number, result: MeasuredMirror): SymmetryEvent => ({
  type: 'measured',
  candidate,
  result,
});

function after(
  tool: SymmetryTool,
  events: readonly SymmetryEvent[],
  sheet: Sheet = squares,
): SymmetryState {
  const all: readonly SymmetryEvent[] = [{type: 'start', tool}, ...events];
  return all.reduce((state, event) => afterEvent(state, event, sheet), outside);
}

/**
 * Picks on the first square, whose right side is sewn to the left side of the second, and
 * elsewhere.
 */
const left = pick(0.1, 2);
const right = pick(3.9, 2);
const below = pick(2, 0.1);
const inside = pick(1, 2);
const elsewhere = pick(12, 2);
const elsewhereLeft = pick(10.1, 2);

describe('the tool for symmetric pieces', () => {
  it('starts with nothing chosen', () => {
    expect(after('piece', [])).toEqual({stage: 'idle', tool: 'piece', asked: 0});
  });

  it('takes a first line', () => {
    expect(after('piece', [right])).toMatchObject({
      stage: 'chosen',
      first: {kind: 'line', piece: 0, edge: 3, point: [4, 2], target: {kind: 'seam', side: 'a'}},
    });
  });

  it('proposes two lines of one piece, sewn or not, by their numbers in the file', () => {
    expect(after('piece', [right, left])).toMatchObject({
      stage: 'candidate',
      asked: 1,
      symmetry: {kind: 'piece', piece: 'piece_0', seams: [3, 1]},
    });
  });

  it('proposes an axis through two points inside a piece', () => {
    expect(after('piece', [pick(2, 1), pick(2, 3)])).toMatchObject({
      stage: 'candidate',
      symmetry: {
        kind: 'piece',
        piece: 'piece_0',
        axis: [
          [2, 1],
          [2, 3],
        ],
      },
    });
  });

  it('takes points where they snap to', () => {
    expect(after('piece', [pick(1.9, 1.1, [2, 1])])).toMatchObject({
      first: {kind: 'point', point: [2, 1]},
    });
  });

  it('takes a line for a point after a first point', () => {
    expect(after('piece', [pick(2, 2), pick(2, 0.1, [2, 0])])).toMatchObject({
      symmetry: {
        axis: [
          [2, 2],
          [2, 0],
        ],
      },
    });
  });

  it('takes a point by request though a line is near', () => {
    expect(after('piece', [pickPoint(0, [2, 0]), pickPoint(0, [2, 4])])).toMatchObject({
      symmetry: {
        axis: [
          [2, 0],
          [2, 4],
        ],
      },
    });
  });

  it('gives the axis in the coordinates of the panel, turned over like it', () => {
    const sheet = sewnSquares({mirroredFromInput: true});
    expect(after('piece', [pickPoint(0, [2, 0]), pickPoint(0, [3, 4])], sheet)).toMatchObject({
      symmetry: {
        axis: [
          [-2, 0],
          [-3, 4],
        ],
      },
    });
  });

  it('refuses a line of another piece, says where, and keeps the first', () => {
    const state = after('piece', [right, elsewhereLeft]);
    expect(state).toMatchObject({
      stage: 'refused',
      reason: 'otherPiece',
      at: {piece: 1, point: [0, 2]},
      first: {kind: 'line', edge: 3},
    });
    expect(afterEvent(state, left, squares)).toMatchObject({symmetry: {seams: [3, 1]}});
  });

  it('refuses a point of another piece than the first', () => {
    expect(after('piece', [pick(2, 2), elsewhere])).toMatchObject({reason: 'otherPiece'});
    expect(after('piece', [right, elsewhere])).toMatchObject({reason: 'otherPiece'});
  });

  it('refuses the same line twice, and keeps it', () => {
    expect(after('piece', [right, pick(3.9, 1)])).toMatchObject({
      stage: 'refused',
      reason: 'sameLine',
      at: {point: [4, 1]},
      first: {edge: 3},
    });
  });

  it('tells the legs of a dart apart, though they are one seam', () => {
    const sheet = dartedSquare();
    const legs = [hit(4.6, 6, sheet), hit(3.4, 6, sheet)];
    const events = legs.map((target): SymmetryEvent => ({type: 'pick', target}));
    expect(after('piece', events, sheet)).toMatchObject({symmetry: {seams: [3, 4]}});
  });

  it('refuses two points that are closer than a centimetre', () => {
    expect(after('piece', [pick(2, 2), pick(2, 2.9)])).toMatchObject({
      stage: 'refused',
      reason: 'samePoint',
      first: {kind: 'point'},
    });
    expect(after('piece', [pick(2, 2), pick(2, 3)])).toMatchObject({stage: 'candidate'});
  });

  it('refuses a point after a line', () => {
    expect(after('piece', [right, inside])).toMatchObject({
      stage: 'refused',
      reason: 'pointAfterLine',
      first: {kind: 'line', edge: 3},
    });
    expect(after('piece', [right, pickPoint(0, [0, 2])])).toMatchObject({
      reason: 'pointAfterLine',
    });
  });

  it('refuses a line without a number, and has nothing chosen then', () => {
    const sheet = sheetOf(
      [{loop: rectangle(4, 4)}],
      [
        [
          [0, 0, 1],
          [0, 3, 2],
        ],
      ],
    );
    const target = hit(2, 0.1, sheet);
    const state = after('piece', [{type: 'pick', target}], sheet);
    expect(state).toMatchObject({stage: 'refused', reason: 'unnumbered'});
    expect(state).not.toHaveProperty('first');
    expect(afterEvent(state, back, sheet)).toMatchObject({stage: 'idle'});
  });
});

describe('the tool for symmetric pairs', () => {
  it('proposes two pieces, whatever of them is hit', () => {
    expect(after('pair', [right, elsewhere])).toMatchObject({
      stage: 'candidate',
      symmetry: {kind: 'pair', pieces: ['piece_0', 'piece_1']},
    });
    expect(after('pair', [pickPoint(1, [2, 2]), inside])).toMatchObject({
      symmetry: {pieces: ['piece_1', 'piece_0']},
    });
  });

  it('refuses the same piece twice, and keeps it', () => {
    const state = after('pair', [inside, below]);
    expect(state).toMatchObject({stage: 'refused', reason: 'samePiece', first: {piece: 0}});
    expect(afterEvent(state, elsewhere, squares)).toMatchObject({stage: 'candidate'});
  });
});

describe('a candidate', () => {
  it('is shown with what was measured, and only commits then', () => {
    const asked = after('piece', [left, right]);
    expect(afterEvent(asked, commit, squares)).toBe(asked);
    const shown = afterEvent(asked, measured(1, good), squares);
    expect(shown).toMatchObject({stage: 'candidate', measured: good});
    expect(afterEvent(shown, commit, squares)).toEqual({
      stage: 'committed',
      tool: 'piece',
      asked: 1,
      symmetry: {kind: 'piece', piece: 'piece_0', seams: [1, 3]},
    });
  });

  it('that does not mirror is refused at the second choice, with its residual', () => {
    const state = after('piece', [left, below, measured(1, bad)]);
    expect(state).toMatchObject({
      stage: 'refused',
      reason: 'noMirror',
      at: {piece: 0, point: [2, 0]},
      first: {edge: 1},
      measured: {residual: 1.5},
    });
    expect(afterEvent(state, commit, squares)).toBe(state);
  });

  it('that was refused leaves the first choice for another second one', () => {
    expect(after('piece', [left, below, measured(1, bad), right])).toMatchObject({
      stage: 'candidate',
      asked: 2,
      symmetry: {seams: [1, 3]},
    });
  });

  it('ignores what was measured for an earlier one', () => {
    const second = after('piece', [left, below, back, right]);
    expect(second).toMatchObject({stage: 'candidate', asked: 2});
    expect(afterEvent(second, measured(1, bad), squares)).toBe(second);
    expect(afterEvent(second, measured(2, good), squares)).toMatchObject({measured: good});
  });

  it('ignores what was measured for one before the tool was changed', () => {
    const next = after('piece', [left, right, {type: 'start', tool: 'pair'}, inside, elsewhere]);
    expect(next).toMatchObject({stage: 'candidate', asked: 2});
    expect(afterEvent(next, measured(1, bad), squares)).toBe(next);
  });

  it('is measured once', () => {
    const shown = after('piece', [left, right, measured(1, good)]);
    expect(afterEvent(shown, measured(1, bad), squares)).toBe(shown);
  });

  it('gives way to a new first choice', () => {
    expect(after('piece', [left, right, measured(1, good), below])).toMatchObject({
      stage: 'chosen',
      first: {edge: 2},
    });
  });

  it('is no longer there for a late measurement once it was taken back', () => {
    const state = after('piece', [left, right, back]);
    expect(afterEvent(state, measured(1, good), squares)).toBe(state);
  });
});

describe('a step back', () => {
  const stages = (tool: SymmetryTool, events: readonly SymmetryEvent[]): string =>
    after(tool, events).stage;

  it('goes from a candidate to its first choice, from there to none, and then leaves the tool', () => {
    expect(after('piece', [left, right, back])).toMatchObject({stage: 'chosen', first: {edge: 1}});
    expect(stages('piece', [left, right, back, back])).toBe('idle');
    expect(stages('piece', [left, right, back, back, back])).toBe('outside');
  });

  it('goes from a refusal to the choice that was kept', () => {
    expect(after('piece', [left, left, back])).toMatchObject({stage: 'chosen', first: {edge: 1}});
  });

  it('leaves the tool after a commit', () => {
    expect(stages('pair', [inside, elsewhere, measured(1, good), commit, back])).toBe('outside');
  });
});

describe('a committed symmetry', () => {
  it('is followed by the first choice of the next', () => {
    const done = after('pair', [inside, elsewhere, measured(1, good), commit, elsewhere]);
    expect(done).toMatchObject({stage: 'chosen', first: {piece: 1}});
  });
});

describe('outside of the tools', () => {
  it('nothing but a start changes anything', () => {
    for (const event of [left, back, commit, measured(0, good), pickPoint(0, [1, 1])])
      expect(afterEvent(outside, event, squares)).toBe(outside);
  });
});
