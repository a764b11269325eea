/** Runs of edges: a side of what is sewn, as it is chosen. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment-document.js';
import {sameEdge, seamAt, sideLength, twinOf} from '../model/garment-edit.js';

/** Edges in the order in which they are sewn, each from its start to its end. */
export type Run = readonly EdgeOfPiece[];

export const has = (run: Run, edge: EdgeOfPiece): boolean => run.some((one) => sameEdge(one, edge));

/** Edges of one piece that follow each other run along its outline, in whatever order they were chosen. */
export function inOrder({pieces}: GarmentDocument, run: Run): Run {
  const [first] = run;
  if (!first || run.some(({piece}) => piece !== first.piece)) return run;
  const count = pieces[first.piece]?.outline.length ?? 0;
  const start = run.find(({piece, edge}) => !has(run, {piece, edge: (edge + count - 1) % count}));
  if (!start) return run;
  const along = run.map((_, k) => ({...start, edge: (start.edge + k) % count}));
  return along.every((edge) => has(run, edge)) ? along : run;
}

/** So many seams that meet at one point are crossed. */
const mostCrossed = 8;

/** The edge that goes on from one: the next of its outline, or where that is sewn, of what it is sewn to. */
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

/** With the edge that goes on from its end, or before its start: over a shoulder from one armhole to the other. */
export function stretched(garment: GarmentDocument, run: Run, by: 1 | -1): Run {
  const end = by > 0 ? run.at(-1) : run[0];
  const next = end && onwards(garment, end, by);
  if (!next || has(run, next)) return run;
  return by > 0 ? [...run, next] : [next, ...run];
}

/** Of lengths, as a share: sides that differ by less are as long as each other. */
const alike = 0.1;

/** An edge with the one that goes on from it where both together are as long as another edge; undefined where none are. */
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
