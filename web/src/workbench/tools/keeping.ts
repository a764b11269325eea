/** Keeps parts of pieces as drafted or releases them by a press, and shows the part beforehand. */
import type {Target as Picked} from '../../clicks/pick.js';
import {isKept, keptParts, toggledLock, type Lockable} from '../../model/design/locks.js';
import {pick} from '../../scene/marks.js';
import type {Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../workbench.js';

const partOf = (target: Picked): Lockable =>
  target.kind === 'piece' ? {piece: target.piece} : {piece: target.piece, edge: target.edge};

/** A line that the file does not number applies to its whole piece. */
export function toggleKept(workbench: Workbench, target: Picked): void {
  togglePart(workbench, partOf(target));
}

export function togglePart(workbench: Workbench, part: Lockable): void {
  const {design} = workbench.history;
  const {pattern} = workbench.solving;
  if (design && pattern)
    workbench.history.change({options: toggledLock(design.options, pattern, part)});
}

/** The edge under the pointer, labelled with the effect of a press. */
export function keepMarks(
  {history: {design}, solving: {pattern}}: Workbench,
  scene: PatternScene,
  target: Picked | undefined,
  {keep}: Texts,
): Overlay {
  if (!target || !pattern) return {};
  const part = partOf(target);
  const {outline = [], points = []} = scene.pieces[part.piece] ?? {};
  const {edges = []} = pattern.pieces[part.piece] ?? {};
  const label = isKept(keptParts(pattern, design?.options.locked), part) ? keep.release : keep.keep;
  const lines = outline.flatMap((from, k) =>
    part.edge !== undefined && edges[k] === part.edge
      ? [{piece: part.piece, line: pick(points, [from, outline[(k + 1) % outline.length] ?? from])}]
      : [],
  );
  return {lines, points: [{piece: part.piece, point: target.point, label}]};
}
