/**
 * Sizes drawn over each other: told apart by layers, or by colour, width and dashes of their lines.
 * Lengths in mm.
 */
import {FileError} from '../../../model/base/versioned-file.js';
import {lengthOf, boxOf} from '../../../model/geometry/polyline.js';
import {closedLine, isCutAround, type ClosedLine} from '../../base/closed-lines.js';
import type {Sheet} from './assemble.js';
import type {InkLine, InkText} from './ink.js';
import type {PdfLayer} from './open-pdf.js';
import {sharedParts} from './shared-lines.js';
import {byStyle, joinedLines} from './styles.js';
import {rankOf, sizeIn} from './size-names.js';

interface Sized {
  readonly lines: readonly InkLine[];
  readonly texts: readonly InkText[];
  /** All sizes from the smallest; empty for one. */
  readonly sizes: readonly string[];
  readonly size?: string;
  readonly notes: readonly string[];
}

/** Lines by the size that they belong to alone. */
type Nest = ReadonlyMap<string, readonly InkLine[]>;

type Drawn = Pick<Sheet, 'lines' | 'texts'>;

/**
 * The lines of one size.
 * @param wanted the chosen size; without it, the middle one
 * @throws {FileError} if the file has no such size
 */
export function chosenSize(
  {lines, texts}: Drawn,
  layers: readonly PdfLayer[],
  wanted: string | undefined,
  file: string,
): Sized {
  const hidden = new Set(layers.filter(({isShown}) => !isShown).map(({name}) => name));
  const byLayer = nestByLayers(lines);
  const nest = byLayer ?? nestByStyles(lines, texts);
  if (!nest) {
    if (wanted !== undefined) {
      throw new FileError(file, `has one size, and none called '${wanted}'; leave the size out.`);
    }
    const isShown = ({layer}: {readonly layer?: string}): boolean =>
      layer === undefined || !hidden.has(layer);
    const shown = lines.filter(({style}) => isShown(style));
    const isHidden = shown.length < lines.length;
    return {
      ...{lines: shown, texts: texts.filter(isShown), sizes: []},
      notes: isHidden ? [`Hidden layers are left out: ${[...hidden].join(', ')}.`] : [],
    };
  }
  const sizes = [...nest.keys()].sort((a, b) => rankOf(a) - rankOf(b));
  const middle = sizes[Math.floor((sizes.length - 1) / 2)] ?? '';
  const size = wanted === undefined ? middle : sizes.find((one) => isSameSize(one, wanted));
  if (size === undefined) {
    throw new FileError(file, `has no size '${wanted ?? ''}'; choose one of ${sizes.join(', ')}.`);
  }
  const own = nest.get(size) ?? [];
  const of = new Map(
    [...nest].flatMap(([name, some]) => some.map((line) => [line, name] as const)),
  );
  const common = lines.filter((line) => !of.has(line));
  const others = lines.filter((line) => (of.get(line) ?? size) !== size);
  const isOwn = ({layer}: InkText): boolean => {
    const said = layer === undefined || !byLayer ? undefined : sizeIn(layer);
    return said === undefined || said === size;
  };
  return {
    lines: [...common, ...own, ...sharedParts([...own, ...common], others)],
    texts: texts.filter(isOwn),
    ...{sizes, size},
    notes:
      wanted === undefined
        ? [
            `Size ${size} of ${sizes.join(', ')} is read, the middle one; choose another one by its name.`,
          ]
        : [],
  };
}

const isSameSize = (one: string, other: string): boolean =>
  one.toLowerCase() === other.trim().toLowerCase() || one === sizeIn(other);

/** Sizes by names of layers; undefined for fewer than two. */
function nestByLayers(lines: readonly InkLine[]): Nest | undefined {
  const nest = new Map<string, InkLine[]>();
  for (const line of lines) {
    const size = line.style.layer === undefined ? undefined : sizeIn(line.style.layer);
    if (size === undefined) continue;
    const some = nest.get(size);
    if (some) some.push(line);
    else nest.set(size, [line]);
  }
  return nest.size > 1 ? nest : undefined;
}

/** Least length of the lines of a size. */
const leastLength = 400;

/** Area of a closed line that may be a piece. [mm2] */
const pieceArea = 2500;

/** Greatest difference between areas of neighbouring sizes, as a ratio. */
const graded = 1.6;

interface Styled {
  readonly key: string;
  readonly lines: readonly InkLine[];
  /** Closed lines, and boxes of long open ones. */
  readonly shapes: readonly ClosedLine[];
}

/** Sizes by styles whose outlines are nested without a steady distance. */
function nestByStyles(lines: readonly InkLine[], texts: readonly InkText[]): Nest | undefined {
  const styled = [...byStyle(lines.filter(({style}) => style.stroke !== undefined))]
    .filter(([, some]) => some.reduce((sum, {points}) => sum + lengthOf(points), 0) >= leastLength)
    .map(([key, some]): Styled => {
      const shapes = joinedLines(some)
        .filter(({isClosed, points}) => isClosed || lengthOf(points) > leastLength / 2)
        .map(({points}) => closedLine(points))
        .filter(({area}) => area >= pieceArea);
      return {key, lines: some, shapes};
    })
    .filter(({shapes}) => shapes.length > 0);
  const sized = styled.filter((one) =>
    styled.some((other) => other !== one && areSizes(one, other)),
  );
  const isPair =
    sized.length === 2 &&
    sized.every(({shapes}, k) => isAllowance(shapes, sized[1 - k]?.shapes ?? []));
  if (sized.length < 2 || isPair) return undefined;
  const areas = (one: Styled): number => Math.max(...one.shapes.map(({area}) => area));
  const sorted = [...sized].sort((a, b) => areas(a) - areas(b));
  const said = sorted.map(({lines: some}) => legendName(some, texts));
  const names =
    said.every((name) => name !== undefined) && new Set(said).size === said.length
      ? said
      : sorted.map((_, k) => String(k + 1));
  return new Map(sorted.map((one, k) => [names[k] ?? String(k + 1), one.lines]));
}

/** Returns whether most outlines of one style have one of similar size at the same place in the other. */
function areSizes(a: Styled, b: Styled): boolean {
  const matched = a.shapes.filter((one) => b.shapes.some((other) => isNested(one, other)));
  return matched.length >= 0.5 * Math.min(a.shapes.length, b.shapes.length);
}

function isNested(a: ClosedLine, b: ClosedLine): boolean {
  const ratio = Math.max(a.area, b.area) / Math.min(a.area, b.area);
  const off = ([0, 1] as const).map(
    (k) =>
      Math.abs(a.box.low[k] + a.box.high[k] - b.box.low[k] - b.box.high[k]) /
      (a.box.high[k] - a.box.low[k]),
  );
  return ratio <= graded && ratio > 1.002 && off.every((share) => share < 0.3);
}

/** Returns whether the lines of one style are the cut lines around those of the other. */
const isAllowance = (a: readonly ClosedLine[], b: readonly ClosedLine[]): boolean =>
  a.some((one) => b.some((other) => isCutAround(one, other) || isCutAround(other, one)));

/** Length of the sample lines in a legend. */
const sample = {least: 8, most: 90};

/** The size that stands beside a short sample line of a style. */
function legendName(lines: readonly InkLine[], texts: readonly InkText[]): string | undefined {
  for (const line of joinedLines(lines)) {
    const {low, high} = boxOf(line.points);
    const [width, height] = [high[0] - low[0], high[1] - low[1]];
    if (line.isClosed || height > 0.5 || width < sample.least || width > sample.most) continue;
    const y = (low[1] + high[1]) / 2;
    const beside = texts
      .filter(({from, size}) => Math.abs(from[1] + 0.35 * size - y) <= size)
      .map((text) => ({
        size: sizeIn(text.text),
        off: Math.max(low[0] - text.to[0], text.from[0] - high[0]),
      }))
      .filter(({size, off}) => size !== undefined && off > -2 && off < 40)
      .sort((one, other) => one.off - other.off);
    if (beside[0]?.size !== undefined) return beside[0].size;
  }
  return undefined;
}
