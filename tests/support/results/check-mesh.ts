/** Checks the mesh of one piece. */
import type {Point, ResultPiece} from 'seamwise/node';

import {cross, minus} from '@/model/geometry/vectors.js';
import {signedArea} from '@/model/geometry/polyline.js';
import {aroundLoop, at, crossesItself, sum} from '../plane.js';

/**
 * Faults of a mesh, a message each; no triangle may shrink below the share `leastArea` of its rest
 * area.
 */
export function checkMesh(piece: ResultPiece, leastArea: number): string[] {
  const {name, rest, shape, triangles, outline, holes} = piece;
  const broken: string[] = [];
  const must = (holds: boolean, sentence: string) => {
    if (!holds) broken.push(`${name}: ${sentence}`);
  };
  must(rest.length === shape.length, 'rest and shape differ in vertices');

  const areas = triangles.map((t) => ({rest: area(rest, t), shape: area(shape, t)}));
  must(
    areas.every((t) => t.rest > 0),
    'a rest triangle is not counter-clockwise',
  );
  must(
    areas.every((t) => t.shape > 0),
    'a triangle is flipped',
  );
  const least = Math.min(...areas.map((t) => t.shape / t.rest));
  must(least >= leastArea, `a triangle shrank to ${least} of its area`);

  const loops = [outline, ...holes];
  const inside = sum(loops.map((loop) => signedArea(loop.map((v) => at(rest, v)))));
  const filled = sum(areas.map((t) => t.rest));
  must(Math.abs(inside - filled) <= 1e-6 * (inside + 1), 'triangles do not fill the outline');

  const sides = triangles.flatMap((t) => aroundLoop<number>(t)).map(edgeKey);
  const sideSet = new Set(sides);
  must(sideSet.size === sides.length, 'two triangles lie on the same side of an edge');
  const rim = new Set(loops.flatMap(aroundLoop).map(edgeKey));
  const border = sides.filter((side) => !sideSet.has(side.split(',').reverse().join()));
  must(
    border.length === rim.size && border.every((side) => rim.has(side)),
    "the mesh's border is not its outline",
  );
  const crosses = crossesItself(loops.flatMap((loop) => segments(shape, loop)));
  must(!crosses, 'the outline crosses itself');
  return broken;
}

const edgeKey = ([u, v]: readonly [number, number]): string => `${u},${v}`;

const area = (points: readonly Point[], [i, j, k]: readonly [number, number, number]): number =>
  cross(minus(at(points, j), at(points, i)), minus(at(points, k), at(points, i))) / 2;

const segments = (points: readonly Point[], loop: readonly number[]): [Point, Point][] =>
  aroundLoop(loop).map(([u, v]) => [at(points, u), at(points, v)]);
