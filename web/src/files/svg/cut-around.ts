/** Constructs the cut line from parts that are drawn only along edges with an allowance. [mm] */
import {distance, type Point} from '../../model/geometry/vectors.js';
import {signedArea} from '../../model/geometry/polyline.js';
import {endOf, straight} from '../base/bezier.js';
import {nearestOn, type Near} from '../../model/geometry/nearest.js';
import {meeting, type Line} from './lines.js';
import {areaOf, chained, pointsOf, rimOf} from './outlines.js';

/** Greatest distance between the end of a cut line and the outline. [mm] */
const widest = 80;

/** The closed cut line around a sewn line; undefined if the drawn lines do not form one. */
export function cutAround(sewn: Line, drawn: readonly Line[]): Line | undefined {
  const chains = chained(drawn).map(({line}) => line);
  const area = areaOf(sewn);
  const whole = chains
    .filter(({isClosed}) => isClosed)
    .map((line) => ({line, area: areaOf(line)}))
    .sort((a, b) => b.area - a.area)[0];
  if (whole && whole.area > area) return whole.line;
  const rim = chains
    .filter(({isClosed}) => !isClosed)
    .reduce<readonly Point[]>(replaced, rimOf(sewn));
  const [start, ...rest] = rim;
  if (!start || Math.abs(signedArea(rim)) <= area * (1 + 1e-6)) return undefined;
  const cubics = [...rest, start].map((to, k) => straight(rim[k] ?? start, to));
  return {start, cubics, isClosed: true};
}

/**
 * Replaces a part of a closed line by a line between the same ends, so that the enclosed area is
 * larger.
 */
function replaced(rim: readonly Point[], chain: Line): readonly Point[] {
  const along = pointsOf(chain);
  const [leaves, returns] = [nearestOn(rim, chain.start, true), nearestOn(rim, endOf(chain), true)];
  if (Math.max(leaves.off, returns.off) > widest) return rim;
  const step = [
    ...(leaves.off > meeting ? [leaves.at] : []),
    ...along,
    ...(returns.off > meeting ? [returns.at] : []),
  ];
  const ways = [
    [...step, ...stretch(rim, returns, leaves)],
    [...step.toReversed(), ...stretch(rim, leaves, returns)],
  ];
  const [a = 0, b = 0] = ways.map((way) => Math.abs(signedArea(way)));
  return ways[a >= b ? 0 : 1] ?? rim;
}

/** The corners of a closed line between two of its points, excluding both. */
function stretch(rim: readonly Point[], from: Near, to: Near): Point[] {
  const n = rim.length;
  const along = (one: Near): number => distance(rim[one.step] ?? one.at, one.at);
  const isRound = to.step < from.step || (to.step === from.step && along(to) < along(from));
  const count = to.step - from.step + (isRound ? n : 0);
  return Array.from({length: count}, (_, k) => rim[(from.step + 1 + k) % n] ?? from.at).filter(
    (p) => distance(p, from.at) > meeting && distance(p, to.at) > meeting,
  );
}
