/** Lines for the print of a symmetric piece, whose axis stays on a mirror line of the print. */
import {leftOf, minus, plus, type Point} from '../../model/geometry/vectors.js';
import {mirroringsOf, ownMirroring} from '../../model/design/pins.js';
import {axisLine, footOnAxis} from '../../model/print/mirror-lines.js';
import {crossingsOf} from '../../model/geometry/polyline.js';
import {wayOnSheet} from '../../model/geometry/sheet-place.js';
import {pick} from '../../scene/marks.js';
import type {Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Texts} from '../../texts/texts.js';
import type {Target} from '../state.js';

/** Returns the parts of an infinite line inside a loop. */
function inside(
  loop: readonly Point[],
  through: Point,
  along: Point,
): readonly (readonly [Point, Point])[] {
  const sorted = crossingsOf(loop, through, along).sort((one, other) => one - other);
  const at = (way: number): Point => plus(through, along, way);
  return sorted.flatMap((start, k) => {
    const end = sorted[k + 1];
    return k % 2 === 0 && end !== undefined ? [[at(start), at(end)] as const] : [];
  });
}

/** Returns the axis of the selected piece, and the next mirror lines of the print on both sides. */
export function railsOf(
  scene: PatternScene,
  selected: Target | undefined,
  {symmetry}: Texts,
): Overlay {
  const number = selected?.kind === 'piece' ? selected.piece : -1;
  const piece = scene.pieces[number];
  const own = piece && ownMirroring(mirroringsOf(scene.pattern), piece.name);
  const at = own && axisLine(scene.print, own.map, piece.alignment);
  if (!at) return {};
  const {along, spacing, isOnMotif} = at;
  const loop = pick(piece.points, piece.outline);
  const foot = footOnAxis(own.map, [0, 0]);
  const lineAt = (step: number): readonly (readonly [Point, Point])[] =>
    inside(loop, plus(foot, leftOf(along), step * spacing), along);
  const axis = lineAt(0);
  const ends = axis.flat();
  const [first, last] = [ends[0], ends.at(-1)];
  if (!first || !last) return {};
  const label = isOnMotif ? symmetry.onMotif : symmetry.onMirror;
  const isUpper = wayOnSheet(piece, minus(first, last))[1] > 0;
  const top = isUpper ? first : last;
  return {
    candidate: {piece: number, axis: [first, last]},
    points: [{piece: number, point: top, label}],
    rails: [-1, 1].flatMap((step) => lineAt(step).map((line) => ({piece: number, line}))),
  };
}
