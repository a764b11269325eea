/**
 * State machine that defines symmetries by clicks: two lines or two points of a piece, or two
 * pieces.
 */
import {distance, type MirrorMap, type Point} from '../model/geometry/vectors.js';
import type {Symmetry} from '../model/garment/symmetries.js';
import type {LineTarget, OnPiece, Target} from './pick.js';
import {inputPoint, type Sheet} from './sheet.js';

/** `piece`: a piece that is symmetric in itself. `pair`: two pieces that mirror onto each other. */
export type SymmetryTool = 'piece' | 'pair';

/** Interpretation of a press. */
export type Choice = OnPiece &
  (
    | {readonly kind: 'line'; readonly target: LineTarget; readonly edge: number}
    | {readonly kind: 'point' | 'piece'}
  );

/** Deviation of the drafted outlines from a symmetry, measured by the solver. */
export interface MeasuredMirror {
  /** Greatest distance of an outline from its mirror image. [cm] */
  readonly residual: number;
  /** p' = R F p + t */
  readonly map: MirrorMap;
  /** The residual is small enough. */
  readonly mirrors: boolean;
}

type Refusal =
  /** The second choice is on another piece than the first. */
  | 'otherPiece'
  /** The first line is chosen again. */
  | 'sameLine'
  /** The two points are too close to give the axis a direction. */
  | 'samePoint'
  /** The first piece of a pair is chosen again. */
  | 'samePiece'
  /** A point follows a line on its piece. */
  | 'pointAfterLine'
  /** The line has no edge number in the file. */
  | 'unnumbered'
  /** Both choices are valid, but the pieces do not mirror. */
  | 'noMirror';

interface Working {
  readonly tool: SymmetryTool;
  /** Number of candidates so far. */
  readonly asked: number;
}

export type SymmetryState =
  | {readonly stage: 'outside'; readonly asked: number}
  | (Working & {readonly stage: 'idle'})
  | (Working & {readonly stage: 'chosen'; readonly first: Choice})
  | (Working & {
      /**
       * The solver measures a candidate, then it is shown, then confirmed. Its number is `asked`.
       */
      readonly stage: 'candidate';
      readonly first: Choice;
      readonly second: Choice;
      readonly symmetry: Symmetry;
      readonly measured?: MeasuredMirror;
    })
  | (Working & {
      /** The next choice goes with `first`, if there is one. */
      readonly stage: 'refused';
      readonly reason: Refusal;
      readonly at: OnPiece;
      readonly first?: Choice;
      readonly measured?: MeasuredMirror;
    })
  | (Working & {readonly stage: 'committed'; readonly symmetry: Symmetry});

export type SymmetryEvent =
  | {readonly type: 'start'; readonly tool: SymmetryTool}
  | {
      readonly type: 'pick';
      readonly target: Target;
      /** Point used if the press is taken for a point. Default: the target's point. */
      readonly snapped?: Point;
    }
  /** Press that always means a point, regardless of lines nearby. */
  | {readonly type: 'pickPoint'; readonly piece: number; readonly point: Point}
  | {readonly type: 'back'}
  /** `candidate` is the number of the measured one. */
  | {readonly type: 'measured'; readonly candidate: number; readonly result: MeasuredMirror}
  | {readonly type: 'commit'};

export const outside: SymmetryState = {stage: 'outside', asked: 0};

/** Least distance of an axis's two points. [cm] */
const shortestAxis = 1;

type Active = Exclude<SymmetryState, {readonly stage: 'outside'}>;

type Pick = Extract<SymmetryEvent, {readonly type: 'pick' | 'pickPoint'}>;

/**
 * Returns a press as a choice. After a first point a line counts as a point, too, since axes end on
 * outlines.
 */
function choiceOf(tool: SymmetryTool, first: Choice | undefined, event: Pick): Choice | Refusal {
  const {piece, point} = event.type === 'pick' ? event.target : event;
  if (tool === 'pair') return {kind: 'piece', piece, point};
  if (event.type === 'pickPoint') return {kind: 'point', piece, point};
  const {target, snapped = point} = event;
  if (target.kind === 'piece' || first?.kind === 'point')
    return {kind: 'point', piece, point: snapped};
  const {edge} = target;
  return edge === undefined ? 'unnumbered' : {kind: 'line', piece, point, target, edge};
}

/** Returns the symmetry that two choices define, or the reason for refusing them. */
function proposal(sheet: Sheet, first: Choice, second: Choice): Symmetry | Refusal {
  const nameOf = ({piece}: Choice): string => sheet.pieces[piece]?.name ?? '';
  const isSamePiece = first.piece === second.piece;
  if (first.kind === 'piece')
    return isSamePiece ? 'samePiece' : {kind: 'pair', pieces: [nameOf(first), nameOf(second)]};
  if (!isSamePiece) return 'otherPiece';
  const piece = nameOf(first);
  if (first.kind === 'line') {
    if (second.kind !== 'line') return 'pointAfterLine';
    return first.edge === second.edge
      ? 'sameLine'
      : {kind: 'piece', piece, seams: [first.edge, second.edge]};
  }
  if (distance(first.point, second.point) < shortestAxis) return 'samePoint';
  const drafted = ({point}: Choice): Point => inputPoint(sheet, first.piece, point);
  return {kind: 'piece', piece, axis: [drafted(first), drafted(second)]};
}

/** Returns the choice that the next one goes with. */
const firstOf = (state: SymmetryState): Choice | undefined =>
  state.stage === 'chosen' || state.stage === 'refused' ? state.first : undefined;

function picked(state: Active, event: Pick, sheet: Sheet): SymmetryState {
  const {tool, asked} = state;
  const first = firstOf(state);
  const refused = (reason: Refusal): SymmetryState => {
    const {piece, point} = event.type === 'pick' ? event.target : event;
    return {stage: 'refused', tool, asked, reason, at: {piece, point}, ...(first && {first})};
  };
  const choice = choiceOf(tool, first, event);
  if (typeof choice === 'string') return refused(choice);
  if (!first) return {stage: 'chosen', tool, asked, first: choice};
  const symmetry = proposal(sheet, first, choice);
  return typeof symmetry === 'string'
    ? refused(symmetry)
    : {stage: 'candidate', tool, asked: asked + 1, first, second: choice, symmetry};
}

/** Undoes the last choice; a refusal is only dropped. */
function back(state: Active): SymmetryState {
  const {tool, asked} = state;
  switch (state.stage) {
    case 'candidate':
      return {stage: 'chosen', tool, asked, first: state.first};
    case 'refused':
      return state.first
        ? {stage: 'chosen', tool, asked, first: state.first}
        : {stage: 'idle', tool, asked};
    case 'chosen':
      return {stage: 'idle', tool, asked};
    case 'idle':
    case 'committed':
      return {stage: 'outside', asked};
  }
}

/** Returns the state after a change of design, of the same garment or to another one. */
export function outlived(state: SymmetryState, isSameGarment: boolean): SymmetryState {
  if (state.stage === 'outside') return state;
  if (!isSameGarment) return {stage: 'idle', tool: state.tool, asked: state.asked};
  return state.stage === 'refused' ? back(state) : state;
}

function measured(state: Active, candidate: number, result: MeasuredMirror): SymmetryState {
  if (state.stage !== 'candidate' || state.asked !== candidate || state.measured) return state;
  if (result.mirrors) return {...state, measured: result};
  const {tool, asked, first, second: at} = state;
  return {stage: 'refused', tool, asked, reason: 'noMirror', at, first, measured: result};
}

/**
 * Returns the state after an event. Events without a meaning leave the state unchanged. A choice
 * after a candidate starts a new one.
 */
export function afterEvent(
  state: SymmetryState,
  event: SymmetryEvent,
  sheet: Sheet,
): SymmetryState {
  if (event.type === 'start') return {stage: 'idle', tool: event.tool, asked: state.asked};
  if (state.stage === 'outside') return state;
  switch (event.type) {
    case 'pick':
    case 'pickPoint':
      return picked(state, event, sheet);
    case 'back':
      return back(state);
    case 'measured':
      return measured(state, event.candidate, event.result);
    case 'commit': {
      if (state.stage !== 'candidate' || !state.measured) return state;
      const {tool, asked, symmetry} = state;
      return {stage: 'committed', tool, asked, symmetry};
    }
  }
}
