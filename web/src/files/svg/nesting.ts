/** The closed lines of an SVG, with their strokes. [mm] */
import {closedLine, isTheSame, type ClosedLine} from '../base/closed-lines.js';
import type {Line} from './lines.js';
import {rimOf} from './outlines.js';
import type {Drawn} from './walk.js';

/** Connected lines with the elements that draw them. */
export interface Stroke {
  readonly line: Line;
  readonly drawers: readonly Drawn[];
}

/** A closed line with its measures. */
export interface Loop extends Stroke, ClosedLine {}

/** All closed lines, the largest first, without duplicates. */
export function loopsOf(strokes: readonly Stroke[]): Loop[] {
  const loops = closedStrokes(strokes).sort((a, b) => b.area - a.area);
  return loops.filter((loop, k) => {
    const before = loops[k - 1];
    return before === undefined || !isTheSame(before, loop);
  });
}

/** All closed lines in the order of the file. */
export const closedStrokes = (strokes: readonly Stroke[]): Loop[] =>
  strokes
    .filter(({line}) => line.isClosed)
    .map((stroke) => ({...stroke, ...closedLine(rimOf(stroke.line))}));
