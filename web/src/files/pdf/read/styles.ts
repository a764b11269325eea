/** Groups lines by their style, and joins those of one style. Lengths in mm. */
import {pointsOfChain, type Chain} from '../../base/chain.js';
import {chainsOf} from '../../base/chains.js';
import type {InkLine, InkStyle} from './ink.js';

/** Greatest gap between ends of lines that meet, as programs and joints of pages leave. */
const reach = 0.3;

const keys = new WeakMap<InkStyle, string>();

/** A key that lines of one style share, on all pages. */
export function styleKey(style: InkStyle): string {
  const known = keys.get(style);
  if (known !== undefined) return known;
  const {stroke, isFilled, widthMm, dashMm, layer} = style;
  const isMark = isFilled && stroke === undefined;
  const key = JSON.stringify([stroke, isMark, widthMm.toFixed(1), dashMm, layer]);
  keys.set(style, key);
  return key;
}

/** The lines of each style. */
export function byStyle(lines: readonly InkLine[]): ReadonlyMap<string, readonly InkLine[]> {
  const groups = new Map<string, InkLine[]>();
  for (const line of lines) {
    const key = styleKey(line.style);
    const group = groups.get(key);
    if (group) group.push(line);
    else groups.set(key, [line]);
  }
  return groups;
}

/** Lines of one style joined by their ends. */
export function joinedLines(lines: readonly InkLine[]): InkLine[] {
  const [first] = lines;
  if (!first) return [];
  const closed = lines.filter(({isClosed}) => isClosed);
  const open = lines.filter(({isClosed}) => !isClosed);
  const chains = chainsOf(open, reach).map((chain: Chain): InkLine => {
    const points = pointsOfChain(chain);
    const rim = chain.isClosed ? points.slice(0, -1) : points;
    return {points: rim, isClosed: chain.isClosed, style: first.style};
  });
  return [...closed, ...chains];
}
