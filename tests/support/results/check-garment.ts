/** Checks that a result belongs to the garment it was made from. */
import type {GarmentCodeSpecification, Panel, Point, SolveResult, Symmetries} from 'seamwise/node';

import {drawnOutline} from '../garments/panel-curves.js';
import {cross, distance} from '@/model/geometry/vectors.js';
import {at, greatest, scale, sum, toLine} from '../plane.js';

/** Differences of a result from its garment, a message each; empty if there are none. */
export function strays(result: SolveResult, garment: GarmentCodeSpecification): string[] {
  const {panels, stitches} = garment.pattern;
  const broken: string[] = [];
  const must = (holds: boolean, sentence: string) => {
    if (!holds) broken.push(sentence);
  };
  const names = result.pieces.map(({name}) => name);
  must(names.join() === Object.keys(panels).join(), `the pieces are ${names.join()}`);
  const corners = result.pieces.map(({name, rest, outline, mirroredFromInput}) => {
    const panel = panels[name];
    if (!panel) return [];
    const unit = 100 / (garment.properties?.units_in_meter ?? 100);
    const edges = panel.edges.map(({endpoints}) =>
      endpoints.map((v): Point => {
        const [x, y] = scale(at(panel.vertices, v), unit);
        return [mirroredFromInput ? -x : x, y];
      }),
    );
    const rim = outline.map((v) => at(rest, v));
    for (const [corner] of edges) {
      const off = corner ? Math.min(...rim.map((p) => distance(p, corner))) : Infinity;
      must(off < 1e-6, `${name}: rest misses a corner by ${off} cm`);
    }
    const drawn = drawnOutline(garment, name, mirroredFromInput);
    const off = greatest(rim.map((p) => Math.min(...drawn.map((edge) => toLine(p, edge)))));
    must(off < 0.05, `${name}: rest leaves the panel by ${off} cm`);
    const isStraight = panel.edges.every(({curvature}) => !curvature);
    const isClockwise = area(panel) < 0;
    if (isStraight) must(mirroredFromInput === isClockwise, `${name} shows the wrong face`);
    return edges;
  });

  must(result.seams.length === (stitches ?? []).length, `there are ${result.seams.length} seams`);
  (stitches ?? []).forEach(([a, b, how], number) => {
    const seam = result.seams[number];
    if (!seam) return;
    const sides = [a, b].map((end, k) => {
      const {piece, vertices} = k === 0 ? seam.a : seam.b;
      must(end.panel === names[piece], `seam ${number} joins ${names[piece] ?? 'nothing'}`);
      const edge = corners[piece]?.[end.edge] ?? [];
      const ends = [at(vertices, 0), at(vertices, -1)].map((v) =>
        at(at(result.pieces, piece).rest, v),
      );
      const apart = (line: readonly Point[]) => sum(line.map((p, i) => distance(p, at(ends, i))));
      const [ahead, back] = [apart(edge), apart(edge.toReversed())];
      must(Math.min(ahead, back) < 1e-6, `seam ${number} does not run along its edge`);
      return ahead <= back;
    });
    const sameWay = sides[0] === sides[1];
    must(sameWay === (how === 'right_wrong'), `seam ${number} is sewn the wrong way round`);
  });
  return broken;
}

/** The pieces of the requested symmetries and of those in the result, which should be equal. */
export function symmetricPieces(
  {pieces, symmetries}: SolveResult,
  asked: Symmetries,
): {readonly asked: string[]; readonly found: string[]} {
  const found = symmetries.map((one) =>
    (one.kind === 'piece' ? [one.piece] : one.pieces).map((p) => at(pieces, p).name),
  );
  const wanted = asked.symmetries.map((one) => (one.kind === 'piece' ? [one.piece] : one.pieces));
  const names = (list: readonly (readonly string[])[]) =>
    list.map((some) => some.toSorted().join(' = ')).toSorted();
  return {asked: names(wanted), found: names(found)};
}

const area = ({vertices, edges}: Panel): number =>
  sum(edges.map(({endpoints: [i, j]}) => cross(at(vertices, i), at(vertices, j)))) / 2;
