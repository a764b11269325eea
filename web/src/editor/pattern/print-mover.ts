/** Moves the print inside a piece: the piece is then pinned to it, and the others follow. */
import type {Design} from '../../model/design.js';
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
} from '../../model/geometry.js';
import {angleAfter, grainRule} from '../../model/grain-rule.js';
import {
  mirroringsOf,
  nearestPlace,
  ownMirroring,
  withPin,
  type PieceFacts,
} from '../../model/pins.js';
import {axisLine, nextMirrored} from '../../model/mirror-lines.js';
import {boxOf} from '../../model/polyline.js';
import {pick} from '../../scene/marks.js';
import type {ScenePiece} from '../../scene/scene.js';
import {lastOf} from '../../workbench/last-of.js';
import type {Workbench} from '../../workbench/workbench.js';

/** The print shifted by a way on the sheet. */
export const shifted = ({angle, translation}: Alignment, way: Point): Alignment => ({
  angle,
  translation: plus(translation, way),
});

/** The print turned counter-clockwise about a point of the piece. */
const turned = ({angle, translation}: Alignment, by: number, about: Point): Alignment => ({
  angle: angle + by,
  translation: plus(rotated(minus(translation, about), by), about),
});

export function middleOf({points, outline}: ScenePiece): Point {
  const {low, high} = boxOf(pick(points, outline));
  return middle(low, high);
}

/** What is to be known of a piece to say where it can lie. */
const factsOf = (design: Design, piece: ScenePiece): PieceFacts & {readonly middle: Point} => ({
  middle: middleOf(piece),
  rule: grainRule(design, piece.name, piece.grain),
});

const mirrorings = lastOf(mirroringsOf);

const same = (one: Alignment | undefined, other: Alignment): boolean =>
  one !== undefined && JSON.stringify(one) === JSON.stringify(other);

/**
 * Pins a piece at the nearest place that keeps its symmetry; a twin's pin gives way. Moves of one piece that
 * follow each other quickly are one step of the history.
 */
export function pin(workbench: Workbench, piece: ScenePiece, wanted: Alignment): void {
  const {design, scenes} = workbench;
  if (!design || !scenes) return;
  const known = mirrorings(scenes.now.pattern);
  const {name} = piece;
  const at = nearestPlace(scenes.now.print, known, name, wanted, factsOf(design, piece));
  const {pins} = design.options;
  if (same(pins?.[name], at)) return;
  workbench.change(
    {options: {...design.options, pins: withPin(pins, known, name, at)}},
    `pin ${name}`,
  );
}

/**
 * A place that is so far from where a piece lies. Across the axis of a symmetric piece any way leads to the
 * next line that the axis can lie on.
 */
export function stepped(workbench: Workbench, piece: ScenePiece, way: Point): Alignment {
  const {scenes} = workbench;
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
 * A piece with its print turned by some degrees, or to the next angle that its symmetry or its grain allows.
 * @returns undefined when there is none but the one it has
 */
export function turnedOn(
  workbench: Workbench,
  piece: ScenePiece,
  degrees: number,
): Alignment | undefined {
  const {design, scenes} = workbench;
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
  const {pins, ...options} = workbench.design?.options ?? {};
  if (!pins || !(name in pins)) return;
  const others = Object.fromEntries(Object.entries(pins).filter(([other]) => other !== name));
  workbench.change({
    options: {...options, ...(Object.keys(others).length > 0 && {pins: others})},
  });
}
