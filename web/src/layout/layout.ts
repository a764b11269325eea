/** Where pieces lie on a sheet: as on the body where the garment tells, else on shelves. Lengths in cm, y up. */
import {minus, type Point} from '../model/geometry.js';
import {boxOf} from '../model/polyline.js';
import type {Pattern} from '../model/result.js';
import type {SheetPlace} from '../model/sheet-place.js';
import {shelves, type Block} from './blocks.js';
import {headDown, isPlaced, onBody, type Arrangement, type Placements} from './on-body.js';

/** Follows from outlines, names, placements and page alone, so that nothing moves while people work on a garment. */
export interface Layout {
  /** Per piece. */
  readonly places: readonly SheetPlace[];
  readonly width: number;
  readonly height: number;
}

interface PieceBox {
  readonly low: Point;
  readonly width: number;
  readonly height: number;
}

/** Room between pieces, and for the name of each. */
interface Spacing {
  readonly gap: number;
  /** Below a piece, by its number and width. */
  readonly below: (piece: number, width: number) => number;
  /** No piece takes less room than this across. */
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

/** Meshed anew, a piece is as much larger or smaller: nothing moves for it. */
const noise = 0.002;

/** The tallest come first, and pairs by name stay side by side, the wearer's right on the left. */
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
  // whole halves, lest twins that were meshed anew swap places
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
  /** Known already. */
  readonly boxes?: readonly PieceBox[];
  /** On shelves, which take the least room, also where placements are known. */
  readonly isPacked?: boolean;
}

/**
 * The arrangement that is largest on a page with the proportions `aspect` (width to height). What placements show
 * to be drawn upside down lies upright, so that mirrored pairs are mirror images of each other.
 */
export function layOut(
  pattern: Pick<Pattern, 'pieces'>,
  aspect: number,
  spacing: Spacing,
  placements?: Placements,
  {boxes = boxesOf(pattern), isPacked = false}: LayoutChoice = {},
): Layout {
  const cells = cellsOf(boxes, spacing);
  const arrangements =
    placements && !isPacked && isPlaced(pattern, placements)
      ? onBody(pattern, boxes, cells, placements, spacing.gap)
      : onShelves(pattern, cells, spacing.gap);
  const size = ({block: {width, height}, merit}: Arrangement): number =>
    merit * Math.min(aspect / width, 1 / height);
  const {block} = arrangements.reduce((best, next) =>
    size(next) > size(best) * (1 + noise) ? next : best,
  );
  const turned = headDown(pattern, placements);
  const places = boxes.map((): SheetPlace => ({offset: [0, 0]}));
  for (const {piece, at} of block.places) {
    const {low, width, height} = boxes[piece] ?? {low: [0, 0], width: 0, height: 0};
    const isTurned = turned[piece] ?? false;
    const [x, y] = isTurned ? [-low[0] - width, -low[1] - height] : low;
    const offset: Point = [at[0] - x, block.height - at[1] - height - y];
    places[piece] = {offset, ...(isTurned && {isTurned})};
  }
  return {places, width: block.width, height: block.height};
}

/** A page to lay pieces out on; its lengths are pixels, and names keep their size whatever the scale. */
interface LayoutPage {
  readonly width: number;
  readonly height: number;
  /** The page may become higher or lower than `height`, which then only gives its proportions. */
  readonly grows?: boolean;
  readonly greatestScale: number;
  readonly gap: number;
  /** What the name of a piece takes below it, when that is so wide. */
  readonly nameHeight: (piece: number, width: number) => number;
  readonly nameWidth: (piece: number) => number;
}

/** Halvings of the scale that is looked for. */
const rounds = 12;

/** The layout with the largest scale at which every name has its room. [px per cm] */
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
  // room for names costs scale, and less of it the smaller the scale: halve towards where both agree
  for (let round = 0; round < rounds || low === 0; round++) {
    const scale = (low + high) / 2;
    const next = at(scale);
    if (scaleOf(next) >= scale) [low, layout] = [scale, next];
    else high = scale;
    if (high < 1e-6) break;
  }
  return {layout, scale: scaleOf(layout)};
}
