/** Names the place of a seam on the body, before the garment is sewn. */
import type {SeamPlace} from '../model/result/result.js';
import type {MeasuredEdge, MeasuredGarment, MeasuredPiece} from './edges.js';
import {sideOf} from './names.js';
import type {PieceKind} from '../model/garment/piece-words.js';

/** Least rise of the direction out of a piece at an edge across it. */
const across = 0.7;
/** Least rise of the direction out of a piece at a sloping shoulder. */
const slope = 0.35;

/** Returns the rise of the direction out of a piece, from -1 to 1: outlines run counter-clockwise. */
const riseOf = ({chord}: MeasuredEdge): number => -chord[0];

/** A kind that gives all its seams to other pieces their name. */
const named: readonly (readonly [PieceKind, SeamPlace])[] = [
  ['pocket', 'pocket'],
  ['cuff', 'cuff'],
  ['hood', 'hood'],
  ['collar', 'collar'],
  ['band', 'band'],
];

function legPlace(
  [a, p]: readonly [MeasuredEdge, MeasuredPiece],
  [b, q]: readonly [MeasuredEdge, MeasuredPiece],
): SeamPlace {
  const areFaces = p.words.face * q.words.face < 0;
  if (!areFaces || p.words.side * q.words.side < 0) return 'crotch';
  const outwards = ([edge, {words}]: readonly [MeasuredEdge, MeasuredPiece]): number =>
    words.face * words.side * edge.place[0];
  const out = outwards([a, p]) + outwards([b, q]);
  return out < 0 ? 'inseam' : 'outseam';
}

/** Returns the place of a seam of two pieces without sleeves, bands and legs. */
function bodyPlace(
  garment: MeasuredGarment,
  [a, p]: readonly [MeasuredEdge, MeasuredPiece],
  [b, q]: readonly [MeasuredEdge, MeasuredPiece],
): SeamPlace {
  const [low, high] = [riseOf(a), riseOf(b)].sort((one, other) => one - other) as [number, number];
  const isYoke = [p, q].some(({words}) => words.all.some((word) => /yoke|passe|canesu/.test(word)));
  if (isYoke && p !== q) return 'yoke';
  const {face} = p.words.face === 0 ? q.words : p.words;
  const areFaces = p.words.face * q.words.face < 0;
  if (low > across) return 'shoulder';
  if (high > across && low < -across) return p.words.kind === q.words.kind ? 'other' : 'waist';
  if (p === q) return face === 0 ? 'other' : face > 0 ? 'centre back' : 'centre front';
  // a sloping seam near the top of front and back
  if (areFaces && a.place[1] > 0.8 && b.place[1] > 0.8 && low > slope) return 'shoulder';
  if (areFaces) return 'side';
  if (face === 0) return 'other';
  const areTwins = p.words.side * q.words.side < 0 && sideOf(garment, a) * sideOf(garment, b) < 0;
  return areTwins ? (face > 0 ? 'centre front' : 'centre back') : 'princess';
}

/** Returns the place of a seam between two edges. */
export function placeOf(garment: MeasuredGarment, one: number, other: number): SeamPlace {
  const {edges, pieces} = garment;
  const [a, b] = [edges[one], edges[other]];
  const [p, q] = [pieces[a?.at.piece ?? -1], pieces[b?.at.piece ?? -1]];
  if (!a || !b || !p || !q) return 'other';
  if (p === q && (a.after === other || b.after === one)) return 'dart';
  const kinds = [p.words.kind, q.words.kind];
  const own = named.find(([kind]) => kinds.includes(kind));
  if (own) return own[1];
  if (kinds[0] === 'sleeve' && kinds[1] === 'sleeve') return 'sleeve';
  if (kinds.includes('sleeve')) {
    const {face} = kinds[0] === 'sleeve' ? q.words : p.words;
    return face < 0 ? 'sleeve head, back' : 'sleeve head, front';
  }
  if (kinds[0] === 'trousers' && kinds[1] === 'trousers') return legPlace([a, p], [b, q]);
  return bodyPlace(garment, [a, p], [b, q]);
}

const order: readonly (readonly SeamPlace[])[] = [
  ['dart', 'princess', 'yoke', 'centre front', 'centre back', 'inseam', 'outseam', 'other'],
  ['side', 'shoulder', 'sleeve'],
  ['crotch', 'sleeve head, front', 'sleeve head, back', 'hood', 'pocket'],
  ['waist', 'band', 'cuff', 'collar', 'facing', 'inside'],
];

/** Returns the step of a sewist at which a seam is sewn: seams around the body come last. */
export const stepOf = (place: SeamPlace): number =>
  order.findIndex((places) => places.includes(place));
