/**
 * Marks of the sewing tool over the pattern: chosen and possible edges, and threads between ends
 * that meet.
 */
import {has, type Run} from '../clicks/run.js';
import {
  directionOf,
  questionOf,
  type Candidate,
  type SeamState,
  type Sewing,
} from '../clicks/seam-tool.js';
import {edgeLength} from '../model/garment/edge-curve.js';
import type {EdgeOfPiece} from '../model/garment/garment-document.js';
import {edgeOf, isOpen, sameEdge, seamAt, twinOf} from '../model/garment/edits.js';
import {leftOf} from '../model/geometry/vectors.js';
import {atShare, stepAt} from '../model/geometry/polyline.js';
import {edgePoints, type LineLook, type OnPiece, type Overlay} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import type {Format} from '../texts/format.js';

type Lines = NonNullable<Overlay['lines']>;
type Threads = NonNullable<Overlay['threads']>;
type Badges = NonNullable<Overlay['badges']>;

const linesOf = ({pieces}: PatternScene, run: Run, look: LineLook): Lines =>
  run.flatMap(({piece, edge}) => {
    const shown = pieces[piece];
    return shown ? [{piece, line: edgePoints(shown, edge), look}] : [];
  });

/** Returns the start and the end of a side. */
function endsOf({pieces}: PatternScene, run: Run): readonly OnPiece[] {
  const at = (edge: EdgeOfPiece | undefined, k: 0 | -1): readonly OnPiece[] => {
    const shown = edge && pieces[edge.piece];
    const point = shown && edgePoints(shown, edge.edge).at(k);
    return point ? [{piece: edge.piece, point}] : [];
  };
  return [...at(run[0], 0), ...at(run.at(-1), -1)];
}

/** Returns threads from both ends of one side to the ends that they meet. */
function threadsOf(scene: PatternScene, a: Run, b: Run, sameDirection: boolean): Threads {
  const [from, to] = [endsOf(scene, a), endsOf(scene, b)];
  return (sameDirection ? to : [...to].reverse()).flatMap((end, k) => {
    const start = from[k];
    return start ? [{from: start, to: end}] : [];
  });
}

/** Returns the numbers of the candidates; an edge in several candidates has all their numbers. */
function badgesOf({pieces}: PatternScene, candidates: readonly Candidate[]): Badges {
  const edges = candidates.flatMap(({b}) => b);
  const first = edges.filter((edge, k) => edges.findIndex((one) => sameEdge(one, edge)) === k);
  return first.flatMap(({piece, edge}) => {
    const shown = pieces[piece];
    if (!shown) return [];
    const {at, along} = atShare(edgePoints(shown, edge), 0.5);
    const numbers = candidates.flatMap(({b}, k) => (has(b, {piece, edge}) ? [k + 1] : []));
    return [{piece, point: at, inwards: leftOf(along), text: numbers.join(' ')}];
  });
}

/** Marks of a seam: both sides, and threads between the ends that meet. */
function sewnMarks(scene: PatternScene, {garment}: Sewing, edge: EdgeOfPiece): Overlay {
  const seam = garment.seams[seamAt(garment, edge) ?? -1];
  if (!seam) return {};
  const twin = [twinOf(seam, edge)];
  return {
    lines: linesOf(scene, [edge, ...twin], 'chosen'),
    threads: threadsOf(scene, [edge], twin, seam.sameDirection),
  };
}

/** @param hovered the edge under the pointer */
export function seamMarks(
  state: SeamState,
  sewing: Sewing,
  scene: PatternScene,
  hovered: EdgeOfPiece | undefined,
): Overlay {
  const {garment, order} = sewing;
  const [first] = state.run;
  const open = order.filter((edge) => isOpen(edgeOf(garment, edge)));
  const {lines = [], ...marks} =
    first === undefined
      ? suggestionMarks(state, sewing, scene)
      : seamAt(garment, first) === undefined
        ? runMarks(state, sewing, scene, hovered)
        : sewnMarks(scene, sewing, first);
  const under = hovered ? [hovered] : [];
  return {
    badges: [],
    ...marks,
    lines: [...linesOf(scene, open, 'open'), ...linesOf(scene, under, 'lit'), ...lines],
  };
}

/**
 * Marks of a side and its candidates. Threads lead to the edge at the pointer or chosen by keys, or
 * else to the likeliest candidate.
 */
function runMarks(
  state: SeamState,
  sewing: Sewing,
  scene: PatternScene,
  hovered: EdgeOfPiece | undefined,
): Overlay {
  const {run, other, isHeld} = state;
  const candidates = sewing.candidates(run);
  const all = candidates.flatMap(({b}) => b);
  const isMeant = hovered && (isHeld || has(all, hovered)) && !has(run, hovered);
  const best = sewing.best(run);
  const [from, to] =
    other.length > 0
      ? [run, other]
      : isMeant
        ? [run, [hovered]]
        : best
          ? [best.a, best.b]
          : [run, []];
  return {
    lines: [...linesOf(scene, [...all, ...other], 'lit'), ...linesOf(scene, from, 'chosen')],
    threads: threadsOf(scene, from, to, directionOf(state, sewing, to)),
    badges: badgesOf(scene, candidates),
  };
}

/** A part of an edge, from its start or to its end. */
export interface Part {
  readonly edge: EdgeOfPiece;
  readonly share: number;
  /** 0 for the first part, 1 for the second. */
  readonly keeps: 0 | 1;
}

/** Marks of an edge from which a part is to be split off, with the length of that part. */
export function partMarks(
  {garment}: Sewing,
  scene: PatternScene,
  {edge, share, keeps}: Part,
  format: Format,
): Overlay {
  const shown = scene.pieces[edge.piece];
  const drafted = edgeOf(garment, edge);
  if (!shown || !drafted) return {};
  const line = edgePoints(shown, edge.edge);
  const {step} = stepAt(line, share);
  const point = atShare(line, share).at;
  const part = keeps === 0 ? [...line.slice(0, step + 1), point] : [point, ...line.slice(step + 1)];
  const length = (keeps === 0 ? share : 1 - share) * edgeLength(drafted);
  return {
    badges: [],
    lines: [...linesOf(scene, [edge], 'lit'), {piece: edge.piece, line: part}],
    points: [{piece: edge.piece, point, label: format.length(length)}],
  };
}

/** Marks of the seams that are almost certain, faintly, and of the seam in question. */
function suggestionMarks(state: SeamState, sewing: Sewing, scene: PatternScene): Overlay {
  if (!state.suggests) return {};
  const question = questionOf(state, sewing);
  const faint = sewing.sure();
  const lines = faint.flatMap(({a, b}) => linesOf(scene, [...a, ...b], 'faint'));
  const middles = faint.flatMap(({a, b}): Threads => {
    const [from, to] = [...a, ...b].flatMap(({piece, edge}) => {
      const shown = scene.pieces[piece];
      return shown ? [{piece, point: atShare(edgePoints(shown, edge), 0.5).at}] : [];
    });
    return from && to ? [{from, to, isFaint: true}] : [];
  });
  if (question?.kind !== 'seam') return {lines, threads: middles};
  const {a, b, sameDirection} = question;
  return {
    lines: [...lines, ...linesOf(scene, [...a, ...b], 'chosen')],
    threads: [...middles, ...threadsOf(scene, a, b, sameDirection)],
  };
}
