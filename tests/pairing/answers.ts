/** Sews a garment by the questions of the sewing tool, and compares its seams with the true ones. */
import {
  afterEvent,
  nothingChosen,
  questionOf,
  type SeamEvent,
  type SeamState,
  type SuggestedSeam,
} from '@/clicks/seam-tool.js';
import {edgeLine} from '@/model/garment/edge-curve.js';
import type {EdgeOfPiece, GarmentDocument, GarmentPiece} from '@/model/garment/garment-document.js';
import {atShare, boxOf, lengthOf} from '@/model/geometry/polyline.js';
import {distance, minus, type Point} from '@/model/geometry/vectors.js';
import {editedBy} from '@/sewing/seam-edits.js';
import {sewingOf} from '@/sewing/sewing.js';

export interface Sewn {
  readonly garment: GarmentDocument;
  /** Both sides of each question, in their order. */
  readonly questions: readonly SuggestedSeam[];
}

/** Answers *yes* to every question about a garment without seams. */
export function sewnByYes(bare: GarmentDocument): Sewn {
  let garment: GarmentDocument = {...bare, seams: []};
  let state: SeamState = nothingChosen;
  const questions: SuggestedSeam[] = [];
  const send = (event: SeamEvent): void => {
    const answer = afterEvent(state, event, sewingOf(garment, state.answered));
    if (!answer) return;
    state = answer.state;
    if (!answer.edit || answer.edit.kind === 'match') return;
    const edited = editedBy(garment, answer.edit);
    garment = edited.document;
    const done = {type: 'edited', edgesOf: edited.edgesOf, gathered: []} as const;
    state = afterEvent(state, done, sewingOf(garment, []))?.state ?? state;
  };
  send({type: 'suggest'});
  for (;;) {
    const question = questionOf(state, sewingOf(garment, state.answered));
    if (question?.kind !== 'seam') return {garment, questions};
    questions.push(question);
    send({type: 'yes'});
  }
}

const lowOf = ({outline}: GarmentPiece): Point =>
  boxOf(outline.flatMap((edge) => edgeLine(edge))).low;

/** Middle of an edge, from the lower left corner of its piece. */
function middleOf({pieces}: GarmentDocument, {piece, edge}: EdgeOfPiece): Point {
  const own = pieces[piece];
  const drafted = own?.outline[edge];
  if (!own || !drafted) throw new Error(`There is no edge ${edge} of piece ${piece}.`);
  return minus(atShare(edgeLine(drafted), 0.5).at, lowOf(own));
}

/** Returns the edge of the true garment at the place of another, by the names of the pieces. */
function trueEdge(truth: GarmentDocument, sewn: GarmentDocument, at: EdgeOfPiece): string {
  const name = sewn.pieces[at.piece]?.name ?? '';
  const piece = truth.pieces.findIndex((one) => one.name === name);
  const middle = middleOf(sewn, at);
  const edges = truth.pieces[piece]?.outline.map((_, edge) => edge) ?? [];
  const apart = (edge: number): number => distance(middleOf(truth, {piece, edge}), middle);
  const [nearest] = edges.sort((one, other) => apart(one) - apart(other));
  return `${name} ${nearest ?? 'none'}`;
}

const keyOf = (a: string, b: string): string => [a, b].sort().join(' - ');

export interface Score {
  /** Share of the length of the true seams that is sewn. */
  readonly found: number;
  /** Seams that are none of the true ones. */
  readonly wrong: readonly string[];
  /** Edges in more than one seam. */
  readonly twice: number;
}

export function scoreOf(truth: GarmentDocument, sewn: GarmentDocument): Score {
  const nameOf = ({piece, edge}: EdgeOfPiece): string =>
    `${truth.pieces[piece]?.name ?? ''} ${edge}`;
  const wanted = new Map(
    truth.seams.map(({a, b}) => {
      const edge = truth.pieces[a.piece]?.outline[a.edge];
      return [keyOf(nameOf(a), nameOf(b)), edge ? lengthOf(edgeLine(edge)) : 0];
    }),
  );
  const ends = sewn.seams.map(({a, b}) => [trueEdge(truth, sewn, a), trueEdge(truth, sewn, b)]);
  const keys = ends.map(([a = '', b = '']) => keyOf(a, b));
  const sum = (lengths: readonly number[]): number => lengths.reduce((all, one) => all + one, 0);
  const found = [...wanted].flatMap(([key, length]) => (keys.includes(key) ? [length] : []));
  const all = sewn.seams.flatMap(({a, b}) => [a, b].map(({piece, edge}) => `${piece} ${edge}`));
  return {
    found: sum(found) / sum([...wanted.values()]),
    wrong: keys.filter((key) => !wanted.has(key)),
    twice: all.length - new Set(all).size,
  };
}
