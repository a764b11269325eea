/**
 * State machine that makes seams by clicks and keys: an edge or a run of several, then its partner.
 */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {edgeOf, isOpen, sameEdge, seamAt, sideLength} from '../model/garment/edits.js';
import type {SeamPlace} from '../model/result/result.js';
import {has, inOrder, joined, stretched, type Run} from './run.js';

/** Two sides that may be sewn together. */
export interface Suggestion {
  readonly a: Run;
  readonly b: Run;
  /** Start meets start. */
  readonly sameDirection: boolean;
}

/** A whole seam that is likely. */
export interface SuggestedSeam extends Suggestion {
  /** Edges that are sewn to each other, and those of the seam on the other side of the body. */
  readonly parts?: readonly Suggestion[];
  /** True if `parts` contain the seam on the other side. */
  readonly isPaired?: boolean;
  readonly place?: SeamPlace;
}

/** A possible partner of a side: `a` is that side, or a longer run that contains it. */
export interface Candidate extends Suggestion {
  /** Likelihood, from 0 to 1. */
  readonly p: number;
}

/** The garment and its seam suggestions, as the tool needs them. */
export interface Sewing {
  readonly garment: GarmentDocument;
  /** Returns the possible partners of a run, the likeliest first. */
  readonly candidates: (run: Run) => readonly Candidate[];
  /** Returns the likeliest candidate if it is likely enough to be named. */
  readonly best: (run: Run) => Candidate | undefined;
  /** Returns the seams that are almost certain. */
  readonly sure: () => readonly Suggestion[];
  /** Returns the darts that are not sewn yet and need no question. */
  readonly darts: () => readonly Suggestion[];
  /** Returns the likely seams without an answer, in the order of the questions. */
  readonly questions: () => readonly SuggestedSeam[];
  /** All edges, in keyboard order. */
  readonly order: Run;
}

type Refusal =
  /** The edge is sewn already. */
  | 'sewn'
  /** No edge is chosen. */
  | 'nothing'
  /** The candidate's number does not exist. */
  | 'noCandidate'
  /** Every edge is sewn or stays open. */
  | 'finished';

export interface SeamState {
  /** Chosen edges; empty if nothing is chosen. */
  readonly run: Run;
  /** The next edge becomes the run's partner. */
  readonly isHeld: boolean;
  /** Edges reached by keys while the run is held. */
  readonly other: Run;
  /** The seam gets the opposite of the proposed direction. */
  readonly isTurned: boolean;
  /** Suggestions are shown as questions. */
  readonly suggests: boolean;
  /** Suggestions that the user has declined. */
  readonly answered: readonly Suggestion[];
  /** Suggestions that the user has put off. */
  readonly later: readonly Suggestion[];
  /** All answers to suggestions, in their order. */
  readonly log: readonly ('yes' | 'no' | 'skip')[];
  /** Numbers of the seams with a pending question about gathers. */
  readonly gathered: readonly number[];
  readonly refused: Refusal | undefined;
}

interface Split {
  readonly kind: 'split';
  readonly edge: EdgeOfPiece;
  /** Share of the edge's length from its start. */
  readonly share: number;
  /** The part that stays chosen: the first or the second. */
  readonly keeps: 0 | 1;
}

/** A change of the garment that the user requests. */
export type SeamEdit =
  | {readonly kind: 'sew'; readonly a: Run; readonly b: Run; readonly sameDirection: boolean}
  /** `exactly`: without the mirror images of the seams. */
  | {
      readonly kind: 'sewAll';
      readonly seams: readonly Suggestion[];
      readonly exactly?: true;
    }
  | Split
  | {readonly kind: 'unsew' | 'turn'; readonly seam: number}
  | {readonly kind: 'open'; readonly run: Run; readonly open: boolean}
  | {readonly kind: 'match'; readonly seams: readonly number[]}
  /** Removes seams, and sews one of their sides with an extra edge to the other. */
  | ({readonly kind: 'join'; readonly seams: readonly number[]} & Suggestion);

/** Events about the chosen run. */
type RunEvent =
  /** Number of the candidate, from 1. */
  | {readonly type: 'sewTo'; readonly candidate: number}
  | {readonly type: 'hold'}
  | {readonly type: 'turn'}
  | {readonly type: 'unsew'}
  | {readonly type: 'open'};

export type SeamEvent =
  /** Press on an edge; `extends` adds it to the run. */
  | {readonly type: 'pick'; readonly edge: EdgeOfPiece; readonly extends: boolean}
  /** Keys move to an edge. */
  | {readonly type: 'go'; readonly edge: EdgeOfPiece}
  /** Extends the run at its end (1) or before its start (-1). */
  | {readonly type: 'stretch'; readonly by: 1 | -1}
  | ({readonly type: 'split'} & Omit<Split, 'kind'>)
  | RunEvent
  | {readonly type: 'next' | 'suggest' | 'acceptAll' | 'back' | 'yes' | 'no' | 'skip' | 'join'}
  /** Takes the last answer to a suggestion back; the history takes back the seam of a *yes*. */
  | {readonly type: 'unanswer'}
  /** The garment has changed. */
  | {
      readonly type: 'edited';
      readonly edgesOf: (edge: EdgeOfPiece) => Run;
      readonly gathered: readonly number[];
      /** The part of a split that stays chosen. */
      readonly keeps?: 0 | 1;
    };

interface Answer {
  readonly state: SeamState;
  readonly edit?: SeamEdit;
}

export const nothingChosen: SeamState = {
  ...{run: [], isHeld: false, other: [], isTurned: false},
  ...{suggests: false, answered: [], later: [], log: [], gathered: [], refused: undefined},
};

/** A question to be answered with yes, no or skip. */
export type Question =
  | {
      readonly kind: 'gathered';
      readonly seams: readonly number[];
      /** Seam with the next edge added, which makes the shorter side as long as the other. */
      readonly instead?: Suggestion;
    }
  | ({readonly kind: 'seam'} & SuggestedSeam);

export function questionOf(state: SeamState, sewing: Sewing): Question | undefined {
  const {gathered: seams} = state;
  if (seams.length > 0) {
    const instead = insteadOf(sewing, seams[0] ?? -1);
    return {kind: 'gathered', seams, ...(instead && {instead})};
  }
  if (!state.suggests || state.run.length > 0) return undefined;
  const questions = sewing.questions();
  const isLater = (one: Suggestion): boolean => state.later.some((other) => sameSides(one, other));
  const [oldest] = state.later.flatMap(
    (one) => questions.find((other) => sameSides(one, other)) ?? [],
  );
  const likely = questions.find((one) => !isLater(one)) ?? oldest;
  return likely && {kind: 'seam', ...likely};
}

const sameRun = (one: Run, other: Run): boolean =>
  one.length === other.length && one.every((edge) => has(other, edge));

/** Returns whether two suggestions are about the same sides, in either order. */
export const sameSides = (one: Suggestion, other: Suggestion): boolean =>
  (sameRun(one.a, other.a) && sameRun(one.b, other.b)) ||
  (sameRun(one.a, other.b) && sameRun(one.b, other.a));

function insteadOf({garment}: Sewing, number: number): Suggestion | undefined {
  const seam = garment.seams[number];
  if (!seam) return undefined;
  const isShorter = sideLength(garment, [seam.a]) < sideLength(garment, [seam.b]);
  const [short, long] = isShorter ? [seam.a, seam.b] : [seam.b, seam.a];
  const run = joined(garment, short, long);
  return run && {a: run, b: [long], sameDirection: seam.sameDirection};
}

const isSewn = ({garment}: Sewing, edge: EdgeOfPiece): boolean =>
  seamAt(garment, edge) !== undefined;

/** Drops the question about gathers; any other action ends it. */
const calm = (state: SeamState): SeamState => ({...state, gathered: [], refused: undefined});

const refusing = (state: SeamState, refused: Refusal): Answer => ({state: {...state, refused}});

/**
 * Returns whether two sides are sewn start to start: as proposed, or by default start to end, since
 * outlines run against each other.
 */
export function directionOf(state: SeamState, sewing: Sewing, other: Run): boolean {
  const [first] = other;
  const known = sewing.candidates(state.run).find(({b}) => first && has(b, first));
  return (known?.sameDirection ?? false) !== state.isTurned;
}

function sewn(state: SeamState, sewing: Sewing, other: Run, run = state.run): Answer {
  if (other.length === 0 || other.some((edge) => has(run, edge))) return {state};
  if ([...run, ...other].some((edge) => isSewn(sewing, edge))) return refusing(state, 'sewn');
  const sameDirection = directionOf(state, sewing, other);
  return {state, edit: {kind: 'sew', a: run, b: other, sameDirection}};
}

/** Chooses another run. */
const chosen = (state: SeamState, run: Run, isHeld: boolean): SeamState => ({
  ...state,
  ...{run, isHeld, other: [], isTurned: false},
});

function picked(state: SeamState, sewing: Sewing, edge: EdgeOfPiece, isMore: boolean): Answer {
  const {run, isHeld} = state;
  const sewnAlready = isSewn(sewing, edge);
  if (isMore && run.length > 0) {
    if (has(run, edge))
      return {
        state: chosen(
          state,
          run.filter((one) => !sameEdge(one, edge)),
          isHeld,
        ),
      };
    return sewnAlready
      ? refusing(state, 'sewn')
      : {state: chosen(state, inOrder(sewing.garment, [...run, edge]), true)};
  }
  if (isHeld && has(run, edge)) return {state: chosen(state, run, false)};
  if (isHeld) return sewn(state, sewing, [edge]);
  return {state: chosen(state, [edge], !sewnAlready)};
}

/** Extends the side under the keys along its outline. */
function withStretched(state: SeamState, {garment}: Sewing, by: 1 | -1): SeamState {
  const name = state.isHeld && state.other.length > 0 ? 'other' : 'run';
  return {...state, [name]: stretched(garment, state[name], by)};
}

/**
 * Returns the next shorter edge after the chosen one that is neither sewn nor open, or the longest.
 */
function nextOf({run}: SeamState, {garment, order}: Sewing): EdgeOfPiece | undefined {
  const left = order
    .filter((edge) => seamAt(garment, edge) === undefined && !isOpen(edgeOf(garment, edge)))
    .map((edge) => ({edge, length: sideLength(garment, [edge])}))
    .sort((one, other) => other.length - one.length)
    .map(({edge}) => edge);
  const [present] = run;
  const at = left.findIndex((edge) => present && sameEdge(edge, present));
  return left[(at + 1) % left.length];
}

/** Undoes the last choice. @returns undefined if there is nothing to undo */
function back(state: SeamState): SeamState | undefined {
  if (state.gathered.length > 0 || state.refused) return calm(state);
  if (state.other.length > 0) return {...state, other: []};
  if (state.isHeld) return {...state, isHeld: false, isTurned: false};
  if (state.run.length > 0) return chosen(state, [], false);
  return state.suggests ? {...nothingChosen} : undefined;
}

function answered(state: SeamState, sewing: Sewing, answer: 'yes' | 'no' | 'skip'): Answer {
  const question = questionOf(state, sewing);
  if (question?.kind === 'gathered') {
    const edit = {kind: 'match', seams: question.seams} as const;
    return {state: calm(state), ...(answer === 'no' && {edit})};
  }
  if (!question) return {state};
  const {a, b, sameDirection, parts} = question;
  const logged = {...state, log: [...state.log, answer]};
  if (answer === 'no') return {state: {...logged, answered: [...state.answered, question]}};
  if (answer === 'skip') {
    const others = state.later.filter((one) => !sameSides(one, question));
    return {state: {...logged, later: [...others, question]}};
  }
  return {
    state: logged,
    edit: parts
      ? {kind: 'sewAll', seams: parts, exactly: true}
      : {kind: 'sew', a, b, sameDirection},
  };
}

function unanswered(state: SeamState): SeamState {
  const log = state.log.slice(0, -1);
  switch (state.log.at(-1)) {
    case 'no':
      return {...state, log, answered: state.answered.slice(0, -1)};
    case 'skip':
      return {...state, log, later: state.later.slice(0, -1)};
    default:
      return {...state, log};
  }
}

function edited(
  state: SeamState,
  {edgesOf, gathered, keeps}: Extract<SeamEvent, {readonly type: 'edited'}>,
): SeamState {
  const both = (one: Suggestion): Suggestion[] => {
    const [a, b] = [one.a.flatMap(edgesOf), one.b.flatMap(edgesOf)];
    return a.length === one.a.length && b.length === one.b.length ? [{...one, a, b}] : [];
  };
  return {
    ...calm(state),
    run: state.run.flatMap((edge) => {
      const parts = edgesOf(edge);
      return keeps === undefined || parts.length < 2 ? parts : parts.slice(keeps, keeps + 1);
    }),
    ...{isHeld: false, other: [], isTurned: false},
    answered: state.answered.flatMap(both),
    later: state.later.flatMap(both),
    gathered,
  };
}

/**
 * Returns the state after an event, and the edit it requests; undefined if the event ends the tool.
 * Events without a meaning leave the state unchanged.
 */
export function afterEvent(
  before: SeamState,
  event: SeamEvent,
  sewing: Sewing,
): Answer | undefined {
  if (event.type === 'back') {
    const state = back(before);
    return state && {state};
  }
  if (event.type === 'yes' || event.type === 'no' || event.type === 'skip')
    return answered(before, sewing, event.type);
  const state = calm(before);
  if (event.type === 'join') {
    const question = questionOf(before, sewing);
    if (question?.kind !== 'gathered' || !question.instead) return {state: before};
    return {state, edit: {kind: 'join', seams: question.seams, ...question.instead}};
  }
  const {garment} = sewing;
  const [first] = state.run;
  const seam = first && seamAt(garment, first);
  switch (event.type) {
    case 'edited':
      return {state: edited(state, event)};
    case 'pick':
      return picked(state, sewing, event.edge, event.extends);
    case 'go':
      return {
        state: state.isHeld
          ? {...state, other: has(state.run, event.edge) ? [] : [event.edge], isTurned: false}
          : chosen(state, [event.edge], false),
      };
    case 'stretch':
      return {state: seam === undefined ? withStretched(state, sewing, event.by) : state};
    case 'split': {
      const {edge, share, keeps} = event;
      return {state, edit: {kind: 'split', edge, share, keeps}};
    }
    case 'suggest': {
      if (state.suggests) return {state: {...nothingChosen}};
      const darts = sewing.darts();
      const begun = {...nothingChosen, suggests: true};
      const edit = {kind: 'sewAll', seams: darts, exactly: true} as const;
      return {state: begun, ...(darts.length > 0 && {edit})};
    }
    case 'unanswer':
      return {state: unanswered(state)};
    case 'acceptAll':
      return {state, edit: {kind: 'sewAll', seams: sewing.sure()}};
    case 'next': {
      const next = nextOf(state, sewing);
      return next ? {state: chosen(state, [next], false)} : refusing(state, 'finished');
    }
    case 'sewTo':
    case 'hold':
    case 'turn':
    case 'unsew':
    case 'open':
      return first ? ofRun(state, event, sewing, seam) : refusing(state, 'nothing');
  }
}

/** Applies an event to the chosen run. @param seam number of the run's seam, if it is sewn */
function ofRun(
  state: SeamState,
  event: RunEvent,
  sewing: Sewing,
  seam: number | undefined,
): Answer {
  const {run, isHeld, other} = state;
  switch (event.type) {
    case 'sewTo': {
      if (seam !== undefined) return refusing(state, 'sewn');
      const candidate = sewing.candidates(run)[event.candidate - 1];
      return candidate
        ? sewn(state, sewing, candidate.b, candidate.a)
        : refusing(state, 'noCandidate');
    }
    case 'hold':
      if (seam !== undefined) return refusing(state, 'sewn');
      return isHeld ? sewn(state, sewing, other) : {state: {...state, isHeld: true}};
    case 'turn':
      return seam === undefined
        ? {state: {...state, isTurned: !state.isTurned}}
        : {state, edit: {kind: 'turn', seam}};
    case 'unsew':
      return seam === undefined ? {state} : {state, edit: {kind: 'unsew', seam}};
    case 'open': {
      if (seam !== undefined) return refusing(state, 'sewn');
      const open = !run.every((edge) => isOpen(edgeOf(sewing.garment, edge)));
      return {state, edit: {kind: 'open', run, open}};
    }
  }
}
