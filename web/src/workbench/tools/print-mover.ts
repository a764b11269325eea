/** Moves the print inside a piece: the piece is then pinned, and the others follow. */
import type {Design} from '../../model/design/design.js';
import {
  cross,
  dot,
  leftOf,
  middle,
  minus,
  plus,
  rotated,
  type Alignment,
  type Point,
} from '../../model/geometry/vectors.js';
import {angleAfter, grainRule} from '../../model/design/grain-rule.js';
import {
  mirroringsOf,
  nearestPlace,
  ownMirroring,
  withPin,
  type PieceFacts,
} from '../../model/design/pins.js';
import {axisLine, nextMirrored} from '../../model/print/mirror-lines.js';
import {boxOf} from '../../model/geometry/polyline.js';
import {pick} from '../../scene/marks.js';
import type {ScenePiece} from '../../scene/scene.js';
import {lastOf} from '../../model/base/last-of.js';
import type {Workbench} from '../workbench.js';

/** Shifts the print by a vector in the coordinates of the piece. */
export const shifted = ({angle, translation}: Alignment, way: Point): Alignment => ({
  angle,
  translation: plus(translation, way),
});

/** Turns the print counter-clockwise about a point of the piece. */
const turned = ({angle, translation}: Alignment, by: number, about: Point): Alignment => ({
  angle: angle + by,
  translation: plus(rotated(minus(translation, about), by), about),
});

export function middleOf({points, outline}: ScenePiece): Point {
  const {low, high} = boxOf(pick(points, outline));
  return middle(low, high);
}

/** Properties of a piece that limit its places. */
const factsOf = (design: Design, piece: ScenePiece): PieceFacts & {readonly middle: Point} => ({
  middle: middleOf(piece),
  rule: grainRule(design, piece.name, piece.grain),
});

const mirrorings = lastOf(mirroringsOf);

const same = (one: Alignment | undefined, other: Alignment): boolean =>
  one !== undefined && JSON.stringify(one) === JSON.stringify(other);

/**
 * Pins a piece at the nearest place that keeps its symmetry, and removes its twin's pin. Moves of
 * one piece in quick succession are one step of the history.
 */
export function pin(workbench: Workbench, piece: ScenePiece, wanted: Alignment): void {
  const {design} = workbench.history;
  const {scenes} = workbench.sheet;
  if (!design || !scenes) return;
  const known = mirrorings(scenes.now.pattern);
  const {name} = piece;
  const at = nearestPlace(scenes.now.print, known, name, wanted, factsOf(design, piece));
  const {pins} = design.options;
  if (same(pins?.[name], at)) return;
  workbench.history.change(
    {options: {...design.options, pins: withPin(pins, known, name, at)}},
    `pin ${name}`,
  );
}

/**
 * Returns the alignment at an offset from the present one. An offset across the axis of a symmetric
 * piece leads to the next line that the axis can have.
 */
export function stepped(workbench: Workbench, piece: ScenePiece, way: Point): Alignment {
  const {scenes} = workbench.sheet;
  const wanted = shifted(piece.alignment, way);
  const own = scenes && ownMirroring(mirrorings(scenes.now.pattern), piece.name);
  const line = own && axisLine(scenes.now.print, own.map, piece.alignment);
  if (!line) return wanted;
  const {along, spacing} = line;
  const across = cross(along, way);
  if (Math.abs(across) <= Math.abs(dot(along, way))) return wanted;
  const over = Math.sign(across) * spacing;
  return shifted(piece.alignment, plus([0, 0], leftOf(along), over));
}

/**
 * Returns the alignment after a turn by some degrees, or at the next angle that the symmetry or the
 * grain of the piece allows.
 * @returns undefined if only the present angle is allowed
 */
export function turnedOn(
  workbench: Workbench,
  piece: ScenePiece,
  degrees: number,
): Alignment | undefined {
  const {design} = workbench.history;
  const {scenes} = workbench.sheet;
  if (!design || !scenes) return undefined;
  const {middle, rule} = factsOf(design, piece);
  const {alignment} = piece;
  const sense = degrees > 0 ? 1 : -1;
  const own = ownMirroring(mirrorings(scenes.now.pattern), piece.name);
  const next = own
    ? nextMirrored(scenes.now.print, own.map, alignment, middle, sense, rule)
    : turned(alignment, angleAfter(rule, alignment.angle, degrees) - alignment.angle, middle);
  return next && Math.abs(Math.sin((next.angle - alignment.angle) / 2)) < 1e-9 ? undefined : next;
}

export function unpin(workbench: Workbench, {name}: ScenePiece): void {
  const {pins, ...options} = workbench.history.design?.options ?? {};
  if (!pins || !(name in pins)) return;
  const others = Object.fromEntries(Object.entries(pins).filter(([other]) => other !== name));
  workbench.history.change({
    options: {...options, ...(Object.keys(others).length > 0 && {pins: others})},
  });
}
