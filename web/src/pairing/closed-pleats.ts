/** The outline of a piece with its pleats closed. Lengths in cm. */
import type {GarmentPiece} from '../model/garment/garment-document.js';
import {hiddenParts} from '../model/garment/pleated-edges.js';
import {between, minus, plus, type Point} from '../model/geometry/vectors.js';
import {lengthOf, stepAt} from '../model/geometry/polyline.js';

type Line = readonly Point[];
type Part = readonly [from: number, to: number];

/** Least visible share of an edge; less of it is a rest of a pleat. */
const leastVisible = 0.01;

/** The parts of an edge between the hidden ones, as shares of its length. */
function visibleOf(hidden: readonly Part[]): readonly Part[] {
  let end = 0;
  const parts: Part[] = [];
  for (const [from, to] of [...hidden, [1, 1] as const].sort(([a], [b]) => a - b)) {
    if (from - end > leastVisible) parts.push([end, from]);
    end = Math.max(end, to);
  }
  return parts;
}

/** The part of a line between two shares of its length. */
function partOf(line: Line, [from, to]: Part): Line {
  const [start, end] = [stepAt(line, from), stepAt(line, to)];
  const at = ({step, part}: typeof start): Point => {
    const [p = [0, 0], q = p] = line.slice(step, step + 2);
    return between(p, q, part);
  };
  return [at(start), ...line.slice(start.step + 1, end.step + 1), at(end)];
}

/** The line moved to a point. */
function movedTo(line: Line, start: Point): Line {
  const shift = minus(start, line[0] ?? start);
  return line.map((p) => plus(p, shift));
}

/** An edge with its pleats closed; an edge inside a pleat is hidden and stays as drafted. */
interface ClosedEdge {
  readonly line: Line;
  readonly isHidden: boolean;
}

/** The edges of an outline with all pleats closed. @param lines edges as drafted */
export function closedEdges(
  piece: Pick<GarmentPiece, 'outline' | 'folds'>,
  lines: readonly Line[],
): readonly ClosedEdge[] {
  const hidden = hiddenParts(piece);
  if (hidden.length === 0) return lines.map((line) => ({line, isHidden: false}));
  let end = lines[0]?.[0] ?? [0, 0];
  return lines.map((line, k) => {
    const own = hidden.filter(({edge}) => edge === k).map(({from, to}): Part => [from, to]);
    const visible = visibleOf(own);
    if (visible.length === 0 || lengthOf(line) === 0) return {line, isHidden: true};
    const closed = visible.reduce<Line>((before, part) => {
      const next = movedTo(partOf(line, part), before.at(-1) ?? end);
      return [...before, ...next.slice(before.length > 0 ? 1 : 0)];
    }, []);
    end = closed.at(-1) ?? end;
    return {line: closed, isHidden: false};
  });
}
