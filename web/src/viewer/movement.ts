/** Shows the change of a pattern's shape: drafted outlines, and exaggerated arrows from there. */
import {between, distance, type Point} from '../model/geometry/vectors.js';
import type {ResultPiece} from '../model/result/result.js';
import {arrowHead, cased, inks, placed, type Appearance} from './strokes.js';
import type {Stroke} from './line-layer.js';
import type {PatternScene} from '../scene/scene.js';

/** Greatest movement of a pattern, and the factor that makes arrows visible. */
interface Movement {
  readonly factor: number;
  /** The drafted point in the coordinates of its piece. [cm] */
  readonly greatest: {readonly piece: number; readonly point: Point; readonly cm: number};
}

const factors = [1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50];
/** Greatest length of an arrow. [cm] */
const longest = 4;
/** Distance between arrows along an outline. [cm] */
const spacing = 2.5;
/** Least length of an arrow. [cm] */
const shortest = 0.15;

export function movementOf(pieces: readonly Pick<ResultPiece, 'rest' | 'shape'>[]): Movement {
  let greatest: Movement['greatest'] = {piece: 0, point: [0, 0], cm: 0};
  pieces.forEach(({rest, shape}, piece) => {
    rest.forEach((point, k) => {
      const cm = distance(point, shape[k] ?? point);
      if (cm > greatest.cm) greatest = {piece, point, cm};
    });
  });
  const factor = factors.findLast((one) => one * greatest.cm < longest + 1e-6) ?? 1;
  return {factor, greatest};
}

/**
 * Returns strokes for the drafted outlines, and arrows from there, `factor` times as long as the
 * movement.
 */
export function movementStrokes(
  scene: PatternScene,
  factor: number,
  appearance: Appearance,
): readonly Stroke[] {
  const {accent, casing, quiet} = inks[appearance];
  return scene.pieces.flatMap((piece, k) => {
    const {rest = [], shape = []} = scene.pattern.pieces[k] ?? {};
    const loops = [piece.outline, ...piece.holes];
    const ghosts = loops.map((loop): Stroke => ({
      points: placed({...piece, points: rest}, loop),
      closed: true,
      styles: {colour: quiet, width: 1.2, dash: [2, 4]},
    }));
    const arrows = loops.flatMap((loop) => {
      const from = placed({...piece, points: rest}, loop);
      const to = placed({...piece, points: shape}, loop);
      return evenly(from).flatMap((n) => {
        const [tail, end] = [from[n], to[n]];
        return tail && end ? arrow(tail, end, factor) : [];
      });
    });
    const strokes = arrows.map((points): Stroke => ({
      points,
      styles: {colour: accent, width: 1.6},
    }));
    return [...ghosts, ...strokes.map((stroke) => cased(stroke, casing)), ...strokes];
  });
}

/** Returns the numbers of points along a closed line that are about `spacing` apart. */
function evenly(line: readonly Point[]): readonly number[] {
  let way = spacing;
  return line.flatMap((point, k) => {
    way += distance(line[k - 1] ?? point, point);
    if (way < spacing) return [];
    way = 0;
    return [k];
  });
}

function arrow(tail: Point, end: Point, factor: number): readonly (readonly Point[])[] {
  const tip = between(tail, end, factor);
  return distance(tail, tip) < shortest ? [] : [[tail, tip], arrowHead(tail, tip)];
}
