/** Recognises marks in pieces and at their outlines: grain, folds, notches and drill holes. [mm] */
import type {DrawnNotch, Run} from '../../model/garment/imported-drawing.js';
import {
  cross,
  distance,
  middle,
  minus,
  plus,
  unit,
  type Point,
} from '../../model/geometry/vectors.js';
import {atShare, boxOf, crossingsOf, lengthOf} from '../../model/geometry/polyline.js';
import {endOf, isLine} from '../base/bezier.js';
import {nearestOn, type Near} from '../../model/geometry/nearest.js';
import {saysFold, saysGrain} from '../base/words.js';
import {longerSide} from '../base/closed-lines.js';
import type {Loop, Stroke} from './nesting.js';
import {pointsOf} from './outlines.js';
import type {DrawnText} from './walk.js';

/** A line that is no outline, with its measures. */
export interface Mark extends Stroke {
  readonly points: readonly Point[];
  readonly length: number;
  /** Point at half of its length. */
  readonly at: Point;
}

/** Length below which lines are ticks. [mm] */
const shortest = 15;

export const isLong = ({length}: Mark): boolean => length >= shortest;

/** Returns whether a stroke is an outline of a letter: small, filled, and without a stroke. */
export const isLetter = ({line, drawers}: Stroke): boolean =>
  drawers.every(
    ({style, element}) =>
      style.stroke === 'none' && style.fill !== 'none' && element.name === 'path',
  ) && longerSide(boxOf(pointsOf(line))) < 2 * shortest;

/** The marks among strokes. Excludes letters, which are filled and have no stroke. */
export const marksOf = (strokes: readonly Stroke[]): Mark[] =>
  strokes.flatMap((stroke) => {
    const points = pointsOf(stroke.line);
    if (isLetter(stroke)) return [];
    return [{...stroke, points, length: lengthOf(points), at: atShare(points, 0.5).at}];
  });

/** The point of a line farthest from its start; arrowheads may follow it. */
const farthest = ({start, cubics}: Run): Point =>
  cubics.reduce(
    (far, [, , end]) => (distance(end, start) > distance(far, start) ? end : far),
    start,
  );

export const grainEnds = ({line}: Mark): [Point, Point] => [line.start, farthest(line)];

/** Diameters of round marks that are drill holes. [mm] */
const drill = {least: 1.5, most: 12};

export function isDrill(mark: Mark): boolean {
  const {line, points} = mark;
  if (!line.isClosed || line.cubics.length < 2 || line.cubics.length > 8) return false;
  const centre = middleOf(mark);
  const radii = points.map((p) => distance(p, centre));
  const [low, high] = [Math.min(...radii), Math.max(...radii)];
  return 2 * low >= drill.least && 2 * high <= drill.most && high - low <= 0.1 * high;
}

/** The centre of a round mark. */
export function middleOf({points}: Mark): Point {
  const {low, high} = boxOf(points);
  return middle(low, high);
}

/** Straight lines of the length of a grain line. */
export const straightOf = (within: readonly Mark[]): readonly Mark[] =>
  straightLines(within).filter(({line}) => distance(line.start, farthest(line)) >= 50);

const straightLines = (within: readonly Mark[]): readonly Mark[] =>
  within.filter(({line}) => isLine({start: line.start, cubics: line.cubics.slice(0, 1)}, 0.1));

/**
 * The grain line: a straight line with that label, with that text beside it, or with arrowheads.
 */
export function grainOf(within: readonly Mark[], texts: readonly DrawnText[]): Mark | undefined {
  const lines = straightLines(within);
  const long = straightOf(within);
  const isCalled = ({drawers}: Mark): boolean =>
    drawers.some(({element, groups}) =>
      saysGrain(
        [element, ...groups.slice(-1)].map(({attributes}) => [...attributes.values()].join(' ')),
      ),
    );
  const hasHeads = ({drawers}: Mark): boolean =>
    drawers.some(
      ({isArrow, element: {attributes}}) =>
        isArrow === true ||
        [...attributes].some(([name, value]) => /marker-(?:start|end)/.test(`${name} ${value}`)),
    );
  const said = texts.filter(({lines}) => saysGrain(lines)).map(({at}) => at);
  const off = ({line}: Mark): number =>
    Math.min(...said.map((at) => nearestOn([line.start, farthest(line)], at, false).off));
  const beside = long.filter((chain) => off(chain) <= 60).sort((a, b) => off(a) - off(b));
  return (
    lines.find(isCalled) ??
    beside[0] ??
    long.find(hasHeads) ??
    lines.find((mark) => isLong(mark) && hasHeads(mark))
  );
}

/**
 * The straight edge on the fold: one without allowance, otherwise the nearest to the text,
 * otherwise the longest.
 */
export function foldOf(
  runs: readonly Run[],
  outer: Loop,
  seam: Loop | undefined,
  texts: readonly DrawnText[],
): Run | undefined {
  const length = (run: Run): number => distance(run.start, endOf(run));
  const straight = runs.filter((run) => isLine(run, 0.1)).sort((a, b) => length(b) - length(a));
  const long = straight.filter((run) => length(run) >= 0.25 * longerSide(outer.box));
  const bare = seam
    ? long.filter((run) => nearestOn(outer.rim, middle(run.start, endOf(run)), true).off < 0.5)
    : [];
  const said = texts.filter(({lines}) => saysFold(lines)).map(({at}) => at);
  const off = (run: Run): number =>
    Math.min(...said.map((at) => nearestOn([run.start, endOf(run)], at, false).off));
  const near = long.filter((run) => off(run) <= 40).sort((a, b) => off(a) - off(b));
  return bare[0] ?? near[0] ?? long[0];
}

/** The point of the sewn line in the direction of a slit from the cut line; undefined beside it. */
function ahead(sewn: readonly Point[], from: Point, slit: readonly Point[]): Near | undefined {
  const [start, end] = [slit[0], slit.at(-1)];
  if (!start || !end || !isLine({start, cubics: slit.slice(1).map((p) => [p, p, p])}, 0.05)) {
    return undefined;
  }
  const inner = distance(start, from) > distance(end, from) ? start : end;
  const along = unit(minus(inner, from));
  const crossings = crossingsOf(sewn, from, along).filter((length) => length > 0);
  const length = Math.min(...crossings);
  return length <= widest ? nearestOn(sewn, plus(from, along, length), true) : undefined;
}

/** Greatest distance between a notch and its outline. [mm] */
const notchReach = 0.5;
/** Greatest allowance between a notch at the cut line and the sewn line. [mm] */
const widest = 40;

export function notchesOf(near: readonly Mark[], sewn: Loop, outer: Loop): DrawnNotch[] {
  const found: DrawnNotch[] = [];
  for (const {line, points, length} of near) {
    if (length > (line.isClosed ? 2 : 1) * shortest || length < 1) continue;
    const onRim = points
      .map((p) => nearestOn(outer.rim, p, true))
      .find(({off}) => off <= notchReach);
    const nearest = onRim && nearestOn(sewn.rim, onRim.at, true);
    if (!nearest || nearest.off > widest) continue;
    const at = line.isClosed ? nearest : (ahead(sewn.rim, onRim.at, points) ?? nearest);
    const way = unit(minus(farthest(line), line.start));
    const next = sewn.rim[(at.step + 1) % sewn.rim.length] ?? at.at;
    const along = unit(minus(next, sewn.rim[at.step] ?? at.at));
    const isAlong = !line.isClosed && Math.abs(cross(way, along)) < 0.5;
    if (isAlong || found.some((other) => distance(other.at, at.at) < 2)) continue;
    found.push({at: at.at, kind: line.isClosed || line.cubics.length === 2 ? 'v' : 'slit'});
  }
  return found;
}
