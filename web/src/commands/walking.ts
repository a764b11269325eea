/** Keyboard navigation in the pattern: from piece to piece, along seams, across to a twin. */
import type {PickIndex} from '../clicks/pick-index.js';
import {
  inwards,
  nextPiece,
  nextSeam,
  outwards,
  readingOrder,
  twin,
  type Direction,
  type Place,
} from '../clicks/walk.js';
import type {Target} from '../workbench/workbench.js';

function placeOf({sheet}: PickIndex, target: Target): Place | undefined {
  if (target.kind === 'piece') return {level: 'piece', piece: target.piece};
  const piece = sheet.seams[target.seam]?.[target.side].piece;
  return piece === undefined
    ? undefined
    : {level: 'seam', piece, seam: target.seam, side: target.side};
}

const targetOf = (place: Place): Target =>
  place.level === 'piece'
    ? {kind: 'piece', piece: place.piece}
    : {kind: 'seam', seam: place.seam, side: place.side};

const directions: Readonly<Record<string, Direction>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
};

function led(index: PickIndex, place: Place, key: string): Place | undefined {
  const direction = directions[key];
  if (direction && place.level === 'piece')
    return {level: 'piece', piece: nextPiece(index, place.piece, direction)};
  if (direction && place.level === 'seam')
    return nextSeam(index, place, direction === 'right' || direction === 'down' ? 1 : -1);
  if (key === 'Enter' && place.level === 'piece') return inwards(index, place);
  if (key === 't' && place.level === 'seam') return twin(index, place);
  return undefined;
}

/** Returns the selection after a key; undefined if the key has no effect. */
export function walked(
  index: PickIndex,
  selected: Target | undefined,
  key: string,
): Target | undefined {
  const place = selected && placeOf(index, selected);
  if (place) {
    const next = led(index, place, key);
    return next && targetOf(next);
  }
  const [first] = readingOrder(index);
  return directions[key] && first !== undefined ? {kind: 'piece', piece: first} : undefined;
}

/** Steps from a seam to its piece, and from a piece to no selection. */
export function steppedOut(index: PickIndex, selected: Target): Target | undefined {
  const place = placeOf(index, selected);
  const out = place && outwards(place);
  return out && targetOf(out);
}
