/** Locked parts of outlines, as lines to draw. */
import {keptParts} from '../model/design/locks.js';
import type {Locks} from '../model/design/options.js';
import type {MeshedPattern} from '../model/result/result.js';
import type {KeptLine} from '../scene/scene.js';

/**
 * Locked edges of an outline, by their number in it, as runs of neighbours that are all sewn or all
 * not sewn.
 */
function runs(
  outline: readonly number[],
  isKept: (edge: number) => boolean,
  isSewn: (edge: number) => boolean,
): readonly Omit<KeptLine, 'piece'>[] {
  const n = outline.length;
  const continues = (k: number): boolean =>
    isKept(k) && isKept((k + n - 1) % n) && isSewn(k) === isSewn((k + n - 1) % n);
  const starts = outline.flatMap((_, k) => (isKept(k) && !continues(k) ? [k] : []));
  // a run around the whole outline has no start
  const all = starts.length === 0 && n > 0 && isKept(0) ? [0] : starts;
  return all.map((start) => {
    let count = 1;
    while (count < n && continues((start + count) % n)) count++;
    const vertices = Array.from({length: count + 1}, (_, k) => outline[(start + k) % n] ?? 0);
    return {vertices, isSewn: isSewn(start)};
  });
}

/** Lines of the locked edges; undefined when nothing is locked. */
export function keptLines(
  pattern: MeshedPattern,
  locked: Locks | undefined,
): readonly KeptLine[] | undefined {
  if (!locked || Object.keys(locked).length === 0) return undefined;
  const parts = keptParts(pattern, locked);
  return pattern.pieces.flatMap(({outline, edges}, piece) => {
    const {edges: keptEdges = new Set()} = parts[piece] ?? {};
    if (keptEdges.size === 0) return [];
    const sewn = new Set(
      pattern.seams
        .flatMap(({a, b}) => [a, b])
        .filter((side) => side.piece === piece)
        .flatMap(({vertices}) =>
          vertices.slice(1).flatMap((v, k) => [`${vertices[k]} ${v}`, `${v} ${vertices[k]}`]),
        ),
    );
    return runs(
      outline,
      (k) => keptEdges.has(edges[k] ?? -1),
      (k) => sewn.has(`${outline[k]} ${outline[(k + 1) % outline.length]}`),
    ).map((run) => ({...run, piece}));
  });
}
