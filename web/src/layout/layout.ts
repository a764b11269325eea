/**
 * Lays pieces out on a sheet: as on the body if placements or names tell, otherwise on shelves.
 * Lengths in cm, y up.
 */
import {minus, type Point} from '../model/geometry/vectors.js';
import {boxOf} from '../model/geometry/polyline.js';
import {placementsByName} from './by-name.js';
import type {Pattern} from '../model/result/result.js';
import type {SheetPlace} from '../model/geometry/sheet-place.js';
import {
  headDown,
  isPlaced,
  onBody,
  shelves,
  type Arrangement,
  type Block,
  type Placements,
} from './on-body.js';

/**
 * A layout. It depends only on outlines, names, placements and page, so that nothing moves while
 * people edit a garment.
 */
export interface Layout {
  /** One place per piece. */
  readonly places: readonly SheetPlace[];
  readonly width: number;
  readonly height: number;
}

interface PieceBox {
  readonly low: Point;
  readonly width: number;
  readonly height: number;
}

/** Space between pieces, and for their names. */
interface Spacing {
  readonly gap: number;
  /** Space below a piece, by its index and width. */
  readonly below: (piece: number, width: number) => number;
  /** Least width of a piece's space. */
  readonly least: (piece: number) => number;
}

function boxesOf({pieces}: Pick<Pattern, 'pieces'>): readonly PieceBox[] {
  return pieces.map(({rest, outline}) => {
    const {low, high} = boxOf(outline.flatMap((v) => rest.slice(v, v + 1)));
    const [width, height] = minus(high, low);
    return {low, width, height};
  });
}

function cellsOf(boxes: readonly PieceBox[], spacing: Spacing): readonly Block[] {
  return boxes.map(({width, height}, piece) => {
    const room = Math.max(width, spacing.least(piece));
    return {
      places: [{piece, at: [(room - width) / 2, 0]}],
      width: room,
      height: height + spacing.below(piece, width),
    };
  });
}

const sides: Readonly<Record<string, string>> = {left: 'right', right: 'left', l: 'r', r: 'l'};

/** The other name of a mirrored pair. */
const partner = (name: string): string =>
  name
    .split(/([^a-z]+)/i)
    .map((word) => sides[word.toLowerCase()] ?? word.toLowerCase())
    .join('');

/** Tolerance of the size, so that pieces stay in place when they are meshed again. [share] */
const noise = 0.002;

/**
 * Arrangements on shelves, with the tallest pieces first. Pairs by name stay side by side, with the
 * wearer's right on the left.
 */
function onShelves(
  {pieces}: Pick<Pattern, 'pieces'>,
  cells: readonly Block[],
  gap: number,
): Arrangement[] {
  const numbers = new Map(pieces.map(({name}, k) => [name.toLowerCase(), k]));
  const isRight = (k: number): boolean =>
    /(^|[^a-z])r(ight)?([^a-z]|$)/i.test(pieces[k]?.name ?? '');
  const groups = pieces.flatMap(({name}, k) => {
    const other = numbers.get(partner(name));
    if (other === undefined || other === k) return [cells.slice(k, k + 1)];
    return isRight(k) ? [[k, other].flatMap((n) => cells.slice(n, n + 1))] : [];
  });
  // rounds to half centimetres, so that mirrored pieces keep their order when they are meshed again
  const tallest = (group: readonly Block[]): number =>
    Math.round(2 * Math.max(...group.map(({height}) => height)));
  groups.sort((a, b) => tallest(b) - tallest(a));
  const all = cells.reduce((sum, {width}) => sum + width + gap, 0);
  return Array.from({length: 19}, (_, k) => ({
    block: shelves(groups, all * (1 - k / 20), gap),
    merit: 1,
  }));
}

interface LayoutChoice {
  /** Bounding boxes, if already computed. */
  readonly boxes?: readonly PieceBox[];
  /** Always uses shelves, which take the least space. */
  readonly isPacked?: boolean;
}

/**
 * The arrangement with the largest scale on a page of the proportions `aspect` (width to height).
 * Pieces that are drawn upside down according to their placements are turned, so that mirrored
 * pairs look mirrored.
 */
export function layOut(
  pattern: Pick<Pattern, 'pieces'>,
  aspect: number,
  spacing: Spacing,
  placements?: Placements,
  {boxes = boxesOf(pattern), isPacked = false}: LayoutChoice = {},
): Layout {
  const cells = cellsOf(boxes, spacing);
  const known = placements && isPlaced(pattern, placements);
  const places = isPacked ? undefined : known ? placements : placementsByName(pattern);
  const arrangements = places
    ? onBody(pattern, boxes, cells, places, spacing.gap)
    : onShelves(pattern, cells, spacing.gap);
  const size = ({block: {width, height}, merit}: Arrangement): number =>
    merit * Math.min(aspect / width, 1 / height);
  const {block} = arrangements.reduce((best, next) =>
    size(next) > size(best) * (1 + noise) ? next : best,
  );
  const turned = headDown(pattern, placements);
  const placed = boxes.map((): SheetPlace => ({offset: [0, 0]}));
  for (const {piece, at} of block.places) {
    const {low, width, height} = boxes[piece] ?? {low: [0, 0], width: 0, height: 0};
    const isTurned = turned[piece] ?? false;
    const [x, y] = isTurned ? [-low[0] - width, -low[1] - height] : low;
    const offset: Point = [at[0] - x, block.height - at[1] - height - y];
    placed[piece] = {offset, ...(isTurned && {isTurned})};
  }
  return {places: placed, width: block.width, height: block.height};
}

/** A page for laying pieces out. Lengths are in pixels, and names keep their size at any scale. */
interface LayoutPage {
  readonly width: number;
  readonly height: number;
  /** Lets the height of the page vary; `height` then only determines its proportions. */
  readonly grows?: boolean;
  readonly greatestScale: number;
  readonly gap: number;
  /** Height of a name below a piece of a given width. */
  readonly nameHeight: (piece: number, width: number) => number;
  readonly nameWidth: (piece: number) => number;
}

/** Number of bisections in the search for the scale. */
const rounds = 12;

/** The layout with the largest scale at which all names have enough space. [px per cm] */
export function layOutNamed(
  pattern: Pattern,
  page: LayoutPage,
  placements?: Placements,
): {readonly layout: Layout; readonly scale: number} {
  const {gap, nameHeight, nameWidth} = page;
  const scaleOf = ({width, height}: Layout): number =>
    Math.min(page.width / width, page.grows ? Infinity : page.height / height, page.greatestScale);
  const boxes = boxesOf(pattern);
  const at = (scale: number): Layout =>
    layOut(
      pattern,
      page.width / page.height,
      {
        gap: gap / scale,
        below: (piece, width) => nameHeight(piece, width * scale) / scale,
        least: (piece) => nameWidth(piece) / scale,
      },
      placements,
      {boxes},
    );
  let [low, high] = [0, page.greatestScale];
  let layout = at(high);
  if (scaleOf(layout) >= high) return {layout, scale: high};
  // names take space from the scale, and less of it at smaller scales: bisect to the scale that
  // satisfies both
  for (let round = 0; round < rounds || low === 0; round++) {
    const scale = (low + high) / 2;
    const next = at(scale);
    if (scaleOf(next) >= scale) [low, layout] = [scale, next];
    else high = scale;
    if (high < 1e-6) break;
  }
  return {layout, scale: scaleOf(layout)};
}
