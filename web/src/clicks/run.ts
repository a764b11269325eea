/** Runs of edges: sides of a seam during selection. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {sameEdge, seamAt, sideLength, twinOf} from '../model/garment/edits.js';

/** Edges in sewing order, each from its start to its end. */
export type Run = readonly EdgeOfPiece[];

export const has = (run: Run, edge: EdgeOfPiece): boolean => run.some((one) => sameEdge(one, edge));

/** Sorts adjacent edges of one piece along its outline, regardless of the order of selection. */
export function inOrder({pieces}: GarmentDocument, run: Run): Run {
  const [first] = run;
  if (!first || run.some(({piece}) => piece !== first.piece)) return run;
  const count = pieces[first.piece]?.outline.length ?? 0;
  const start = run.find(({piece, edge}) => !has(run, {piece, edge: (edge + count - 1) % count}));
  if (!start) return run;
  const along = run.map((_, k) => ({...start, edge: (start.edge + k) % count}));
  return along.every((edge) => has(run, edge)) ? along : run;
}

/** Greatest number of seams crossed at one point. */
const mostCrossed = 8;

/**
 * Returns the edge that continues another: the next one of its outline, or across each seam there,
 * the next one of the sewn piece.
 */
function onwards(garment: GarmentDocument, end: EdgeOfPiece, by: 1 | -1): EdgeOfPiece | undefined {
  const beside = ({piece, edge}: EdgeOfPiece): EdgeOfPiece => {
    const count = garment.pieces[piece]?.outline.length ?? 1;
    return {piece, edge: (edge + by + count) % count};
  };
  let next = beside(end);
  for (let k = 0; k < mostCrossed; k++) {
    const seam = garment.seams[seamAt(garment, next) ?? -1];
    if (!seam) return next;
    if (seam.sameDirection) return undefined; // beyond it outlines run the other way
    next = beside(twinOf(seam, next));
  }
  return undefined;
}

/**
 * Adds the edge that continues the run at its end, or before its start: across a shoulder from one
 * armhole to the other.
 */
export function stretched(garment: GarmentDocument, run: Run, by: 1 | -1): Run {
  const end = by > 0 ? run.at(-1) : run[0];
  const next = end && onwards(garment, end, by);
  if (!next || has(run, next)) return run;
  return by > 0 ? [...run, next] : [next, ...run];
}

/** Greatest difference between two equally long sides, as a share of a length. */
const alike = 0.1;

/**
 * Returns an edge and the one that continues it if both together are as long as `to`; undefined
 * otherwise.
 */
export function joined(
  garment: GarmentDocument,
  edge: EdgeOfPiece,
  to: EdgeOfPiece,
): Run | undefined {
  const wanted = sideLength(garment, [to]);
  const differenceOf = (run: Run): number => Math.abs(sideLength(garment, run) / wanted - 1);
  return ([1, -1] as const)
    .map((by) => stretched(garment, [edge], by))
    .filter((run) => run.length > 1 && !has(run, to) && differenceOf(run) < alike)
    .sort((one, other) => differenceOf(one) - differenceOf(other))[0];
}
