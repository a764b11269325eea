/** Lays pieces out on shelves, so that none overlap. Lengths in cm, y up. */
import type {Point} from '../model/geometry.js';
import type {Pattern} from '../model/result.js';

export interface Layout {
  /** Added to a piece's points to bring it to its place, per piece. */
  readonly offsets: readonly Point[];
  readonly width: number;
  readonly height: number;
}

interface Box {
  readonly piece: number;
  readonly low: Point;
  readonly width: number;
  readonly height: number;
}

/** Room between pieces, and below each for its name. */
export interface Spacing {
  readonly gap: number;
  readonly below: number;
  /** No piece takes less room than this: its name has to fit. */
  readonly least: (name: string) => number;
}

function boxOf(result: Pattern, piece: number): Box {
  const {rest = [], outline = []} = result.pieces[piece] ?? {};
  const points = outline.flatMap((v) => rest.slice(v, v + 1));
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  const low: Point = [Math.min(...xs), Math.min(...ys)];
  return {piece, low, width: Math.max(...xs) - low[0], height: Math.max(...ys) - low[1]};
}

/** Mirrored pairs stay side by side; the tallest come first. */
function inOrder(result: Pattern): readonly (readonly Box[])[] {
  const pairs = result.symmetries.flatMap((s) => (s.kind === 'pair' ? [s.pieces] : []));
  const paired = new Set(pairs.flat());
  const single = result.pieces.map((_, k) => k).filter((k) => !paired.has(k));
  const groups = [...pairs, ...single.map((k) => [k])].map((group) =>
    group.map((k) => boxOf(result, k)),
  );
  const tallest = (group: readonly Box[]): number => Math.max(...group.map(({height}) => height));
  return groups.sort((a, b) => tallest(b) - tallest(a));
}

/** Shelves no wider than `limit`, each centred, pieces standing on a common line. */
function shelves(
  result: Pattern,
  groups: readonly (readonly Box[])[],
  limit: number,
  spacing: Spacing,
): Layout {
  const room = (box: Box): number =>
    Math.max(box.width, spacing.least(result.pieces[box.piece]?.name ?? ''));
  const rows: {boxes: Box[]; width: number; height: number}[] = [];
  for (const group of groups) {
    const width = group.reduce((sum, box) => sum + room(box) + spacing.gap, 0);
    const height = Math.max(...group.map((box) => box.height));
    const row = rows.at(-1);
    if (row && row.width + width <= limit + spacing.gap) {
      row.boxes.push(...group);
      row.width += width;
      row.height = Math.max(row.height, height);
    } else {
      rows.push({boxes: [...group], width, height});
    }
  }
  const width = Math.max(...rows.map((row) => row.width)) - spacing.gap;
  const height = rows.reduce((sum, row) => sum + row.height + spacing.below, 0);
  const offsets: Point[] = result.pieces.map(() => [0, 0]);
  let top = height;
  for (const row of rows) {
    const foot = top - row.height;
    let x = (width - row.width + spacing.gap) / 2;
    for (const box of row.boxes) {
      offsets[box.piece] = [x + (room(box) - box.width) / 2 - box.low[0], foot - box.low[1]];
      x += room(box) + spacing.gap;
    }
    top = foot - spacing.below;
  }
  return {offsets, width, height};
}

/** The layout whose proportions come closest to `aspect` (width to height). */
export function layOut(result: Pattern, aspect: number, spacing: Spacing): Layout {
  const groups = inOrder(result);
  const widths = groups.flat().map((box) => box.width + spacing.gap);
  const all = widths.reduce((sum, width) => sum + width, 0);
  const off = ({width, height}: Layout): number => Math.abs(Math.log(width / height / aspect));
  let best = shelves(result, groups, Infinity, spacing);
  for (let share = 1; share > 0.1; share -= 0.05) {
    const next = shelves(result, groups, all * share, spacing);
    if (off(next) < off(best) - 1e-9) best = next;
  }
  return best;
}
