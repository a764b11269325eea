/** Sets the grain line of a piece by clicks: along an edge, or through two points. */
import type {LineTarget, OnPiece, Target} from '../../clicks/pick.js';
import {draftedPoint} from '../../clicks/sheet.js';
import {angleOf, degrees, distance, minus, type Point} from '../../model/geometry/vectors.js';
import type {Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import {withGrainLines} from '../lists/changed-options.js';
import type {Texts} from '../../texts/texts.js';
import type {LaterTool, Pointed} from '../later-tool.js';
import {mirrorsOf} from '../mirrors.js';
import {withImage} from './grain-proposals.js';
import type {Workbench} from '../workbench.js';

/** Least distance between two points that give a direction. [cm] */
const shortest = 1;

const directionOf = (from: Point, to: Point): number => degrees(angleOf(minus(to, from)));

/** Returns the upward direction of an edge as drafted, since an edge has none itself. [degrees] */
function alongEdge(scene: PatternScene, {piece, edge}: LineTarget): number | undefined {
  const {rest = [], outline = []} = scene.pattern.pieces[piece] ?? {};
  const {edges = []} = scene.pieces[piece] ?? {};
  const count = outline.length;
  const isOf = (k: number): boolean => edges[(k + count) % count] === edge;
  const first = outline.findIndex((_, k) => isOf(k) && !isOf(k - 1));
  let last = first;
  while (first >= 0 && isOf(last)) last++;
  const [from, to] = [rest[outline[first] ?? -1], rest[outline[last % count] ?? -1]];
  if (!from || !to) return undefined;
  const direction = directionOf(from, to);
  return direction > -1e-9 && direction < 180 - 1e-9 ? direction : direction + 180;
}

export class GrainClicks implements LaterTool {
  readonly #workbench: Workbench;
  readonly #changed: () => void;
  #first: OnPiece | undefined;
  #hovered: Pointed | undefined;
  #refused: 'otherPiece' | 'samePoint' | 'unnumbered' | undefined;

  constructor(workbench: Workbench, changed: () => void) {
    this.#workbench = workbench;
    this.#changed = changed;
  }

  begin(): void {
    this.#first = this.#refused = this.#hovered = undefined;
  }

  /** Removes the first point. @returns true if there was one */
  back(): boolean {
    const had = this.#first !== undefined;
    this.begin();
    if (had) this.#changed();
    return had;
  }

  /** Marks the point that a press inside a piece would set, or near a line after the first one. */
  hover(at: Pointed | undefined): void {
    const before = this.#hovered;
    const isPoint = at?.target.kind === 'piece' || this.#first !== undefined;
    this.#hovered = isPoint ? at : undefined;
    if (before || this.#hovered) this.#changed();
  }

  take({target, point}: Pointed): void {
    const scene = this.#workbench.sheet.scenes?.now;
    if (!scene) return;
    this.#set(scene, target, point);
    this.#workbench.selection.select(
      target.kind === 'seam'
        ? {kind: 'seam', seam: target.seam, side: target.side}
        : {kind: 'piece', piece: target.piece},
    );
    this.#changed();
  }

  /** @param snapped position of a click that sets a point */
  #set(scene: PatternScene, target: Target, snapped: Point): void {
    const {piece} = target;
    const here = {piece, point: snapped};
    const first = this.#first;
    this.#refused = undefined;
    if (!first && target.kind !== 'piece') {
      const direction = target.edge === undefined ? undefined : alongEdge(scene, target);
      if (direction === undefined) this.#refused = 'unnumbered';
      else this.#keep(scene, piece, direction);
    } else if (!first) {
      this.#first = here;
    } else if (first.piece !== piece) {
      this.#refused = 'otherPiece';
    } else {
      const [from, to] = [first, here].map((one) => draftedPoint(scene, piece, one.point)) as [
        Point,
        Point,
      ];
      if (distance(from, to) < shortest) this.#refused = 'samePoint';
      else this.#keep(scene, piece, directionOf(from, to));
    }
  }

  /** @param direction counter-clockwise from the x axis of the face-up piece [degrees] */
  #keep(scene: PatternScene, piece: number, direction: number): void {
    this.#first = undefined;
    const {design} = this.#workbench.history;
    const {name} = scene.pieces[piece] ?? {};
    if (!design || name === undefined) return;
    const lines = withImage(name, direction, mirrorsOf(this.#workbench.solving));
    this.#workbench.history.change({options: withGrainLines(design.options, lines)});
  }

  words({grain, symmetry}: Texts): string {
    if (this.#refused) return symmetry.refusals[this.#refused];
    return this.#first ? grain.second : grain.first;
  }

  marks(_: PatternScene, {symmetry}: Texts): Overlay {
    const first = this.#first ? [this.#first] : [];
    if (!this.#hovered) return {points: first};
    const {target, point, snapped} = this.#hovered;
    return {points: [...first, {piece: target.piece, point, label: symmetry.snaps[snapped]}]};
  }
}
