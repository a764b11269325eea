/** Arranges pieces as on the body, from the placements of a garment file. Lengths in cm. */
import type {Placement} from '../model/garment/garment-document.js';
import {radians, rotated, type Point} from '../model/geometry/vectors.js';
import type {Pattern, ResultPiece} from '../model/result/result.js';

type Vector = Placement['translation'];

export type Placements = ReadonlyMap<string, Placement>;

/** Placements of the pieces that have one in the file. */
export const placementsIn = (
  marks: ReadonlyMap<string, {readonly placement?: Placement}>,
): Placements =>
  new Map(
    [...marks].flatMap(([name, {placement}]) => (placement ? [[name, placement] as const] : [])),
  );

/** A piece with its space on the sheet, and its position on the body in a view of its face. */
interface Hung {
  readonly block: Block;
  readonly name: string;
  readonly side: 'front' | 'back' | 'left' | 'right';
  /** Position to the right and up. */
  readonly at: Point;
  readonly width: number;
  readonly height: number;
}

/** Cosine of the angle to the front beyond which a piece belongs to the side. */
const sideways = 0.3;
/** Least overlap of two pieces in one row, as a share of the lower one's height. */
const sameRow = 0.5;
const partNames =
  /pocket|collar|cuff|band|stand|strap|belt|flap|facing|placket|welt|(^|[_ ])wb([_ ]|$)/i;
/** Greatest area of a small part, as a share of the largest piece. */
const greatestPart = 0.35;

/** A vector rotated about the fixed axes x, y and z, in this order. [degrees] */
export function turned([x, y, z]: Vector, [rx, ry, rz]: Vector): Vector {
  const about = (angle: number, a: number, b: number): Point => rotated([a, b], radians(angle));
  const [y1, z1] = about(rx, y, z);
  const [z2, x2] = about(ry, z1, x);
  const [x3, y3] = about(rz, x2, y1);
  return [x3, y3, z2];
}

/** Returns whether placements distinguish pieces; those of a flat file are all zero. */
export function isPlaced({pieces}: Pick<Pattern, 'pieces'>, placements: Placements): boolean {
  const all = pieces.map(({name}) => placements.get(name)?.translation);
  const known = all.filter((place) => place !== undefined);
  return (
    known.length === all.length &&
    (all.length === 1 || new Set(known.map((place) => place.join())).size > 1)
  );
}

/** Cosine of the angle to the upward direction beyond which a piece is drawn upside down. */
const upsideDown = -0.5;

/**
 * For each piece, whether it hangs upside down relative to its drawing. Horizontal pieces do not.
 */
export const headDown = (
  {pieces}: Pick<Pattern, 'pieces'>,
  placements: Placements | undefined,
): readonly boolean[] =>
  pieces.map(({name}) => {
    const {rotation} = placements?.get(name) ?? {};
    return rotation !== undefined && turned([0, 1, 0], rotation)[1] < upsideDown;
  });

function hung(
  {name}: ResultPiece,
  middle: Point,
  [width, height]: Point,
  {translation, rotation = [0, 0, 0]}: Placement,
  block: Block,
): Hung {
  const [nx, , nz] = turned([0, 0, 1], rotation);
  const [dx, dy, dz] = turned([middle[0], middle[1], 0], rotation);
  const [x, y, z] = [translation[0] + dx, translation[1] + dy, translation[2] + dz];
  const common = {block, name, width, height};
  if (Math.abs(nz) < sideways && Math.abs(nx) > sideways) {
    return {...common, side: nx > 0 ? 'left' : 'right', at: [nx > 0 ? -z : z, y]};
  }
  // a flat file may orient all faces to the front; the position is then more reliable
  const isFront = Math.abs(z) > 1 ? z > 0 : nz >= 0;
  return {...common, side: isFront ? 'front' : 'back', at: [nz >= 0 ? x : -x, y]};
}

const median = (values: readonly number[]): number =>
  values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? 0;

/**
 * Returns a test for collars, cuffs, bands and pockets: by name, or narrow compared with other
 * pieces.
 */
function partTest(pieces: readonly Hung[]): (piece: Hung) => boolean {
  const area = ({width, height}: Hung): number => width * height;
  const largest = Math.max(...pieces.map(area));
  const narrow = 0.4 * median(pieces.map(({width, height}) => Math.min(width, height)));
  return (piece) => {
    const [short, long] = [piece.width, piece.height].sort((a, b) => a - b) as [number, number];
    const isStrip = short < narrow && long > 2 * short;
    return area(piece) < greatestPart * largest && (isStrip || partNames.test(piece.name));
  };
}

const top = ({at, height}: Hung): number => at[1] + height / 2;
const foot = ({at, height}: Hung): number => at[1] - height / 2;

/** Rows from the top down, with vertical offsets in a row as on the body. */
function rowsOf(pieces: readonly Hung[], gap: number): Block {
  const rows: Hung[][] = [];
  for (const piece of pieces.toSorted((a, b) => b.height - a.height)) {
    const shared = (tallest: Hung): number =>
      Math.min(top(tallest), top(piece)) - Math.max(foot(tallest), foot(piece));
    const row = rows.find(([tallest]) => tallest && shared(tallest) > sameRow * piece.height);
    if (row) row.push(piece);
    else rows.push([piece]);
  }
  const middle = (row: readonly Hung[]): number => row[0]?.at[1] ?? 0;
  return below(
    rows
      .sort((a, b) => middle(b) - middle(a))
      .map((row) => {
        const highest = Math.max(...row.map(top));
        const drops = new Map(row.map((piece) => [piece.block, highest - top(piece)]));
        const blocks = row.toSorted((a, b) => a.at[0] - b.at[0]).map(({block}) => block);
        return beside(blocks, gap, (block) => drops.get(block) ?? 0);
      }),
  );
}

/**
 * An arrangement with a factor of preference: 1, or less if it has to be drawn larger to be chosen.
 */
export interface Arrangement {
  readonly block: Block;
  readonly merit: number;
}

/**
 * Arrangements with fronts between the sleeves, backs below or beside them, and parts at the
 * bottom; for narrow sheets, with sleeves below.
 */
export function onBody(
  pattern: Pick<Pattern, 'pieces'>,
  boxes: readonly {readonly low: Point; readonly width: number; readonly height: number}[],
  blocks: readonly Block[],
  placements: Placements,
  gap: number,
): readonly Arrangement[] {
  const all = pattern.pieces.flatMap((piece, k): Hung[] => {
    const [box, block, placement] = [boxes[k], blocks[k], placements.get(piece.name)];
    if (!box || !block || !placement) return [];
    const {low, width, height} = box;
    const middle: Point = [low[0] + width / 2, low[1] + height / 2];
    return [hung(piece, middle, [width, height], placement, block)];
  });
  const isPart = partTest(all);
  const rows = (side: Hung['side']): Block =>
    rowsOf(
      all.filter((piece) => piece.side === side && !isPart(piece)),
      gap,
    );
  const [front, back, left, right] = (['front', 'back', 'left', 'right'] as const).map(rows) as [
    Block,
    Block,
    Block,
    Block,
  ];
  const parts = all.filter(isPart).sort((a, b) => b.at[1] - a.at[1]);
  const beneath = (block: Block): Block =>
    below([
      block,
      shelves(
        levels(parts).map((level) => level.map((part) => part.block)),
        Math.max(block.width, ...parts.map((part) => part.block.width)),
        gap,
      ),
    ]);
  const row = (...some: Block[]): Block => beside(some, gap);
  const worn = row(right, front, left);
  return [
    {block: beneath(below([worn, back])), merit: 1},
    {block: beneath(row(worn, back)), merit: 1},
    {block: beneath(below([row(front, back), row(right, left)])), merit: 0.8},
    {block: beneath(below([front, back, row(right, left)])), merit: 0.8},
  ];
}

/** Groups of parts at the same height, with the wearer's right first, as in a front view. */
function levels(parts: readonly Hung[]): readonly (readonly Hung[])[] {
  const groups: Hung[][] = [];
  const across = ({side, at}: Hung): number =>
    ({front: at[0], back: -at[0], left: 1e3, right: -1e3})[side];
  for (const part of parts) {
    const group = groups.at(-1);
    if (group?.[0] && Math.abs(group[0].at[1] - part.at[1]) < 1) group.push(part);
    else groups.push([part]);
  }
  return groups.map((group) => group.sort((a, b) => across(a) - across(b)));
}

/**
 * Arranges rectangles with pieces beside and below each other, without overlaps. Lengths in cm, y
 * down.
 */
export interface Block {
  /** Position of the upper left corner of each piece's bounding box. */
  readonly places: readonly {readonly piece: number; readonly at: Point}[];
  readonly width: number;
  readonly height: number;
}

const moved = ({places}: Block, dx: number, dy: number): Block['places'] =>
  places.map(({piece, at: [x, y]}) => ({piece, at: [x + dx, y + dy]}));

const filled = (blocks: readonly Block[]): readonly Block[] =>
  blocks.filter(({places}) => places.length > 0);

/** Blocks from left to right, each `drops` below the common top. */
function beside(
  blocks: readonly Block[],
  gap: number,
  drops: (block: Block, height: number) => number = () => 0,
): Block {
  const all = filled(blocks);
  const tallest = Math.max(0, ...all.map(({height}) => height));
  let width = -gap;
  let height = 0;
  const places = all.flatMap((block) => {
    const [dx, dy] = [width + gap, drops(block, tallest)];
    width = dx + block.width;
    height = Math.max(height, dy + block.height);
    return moved(block, dx, dy);
  });
  return {places, width: Math.max(0, width), height};
}

/** Blocks from the top down, each centred. */
function below(blocks: readonly Block[]): Block {
  const all = filled(blocks);
  const width = Math.max(0, ...all.map((block) => block.width));
  let height = 0;
  const places = all.flatMap((block) => {
    const dy = height;
    height += block.height;
    return moved(block, (width - block.width) / 2, dy);
  });
  return {places, width, height};
}

/** Blocks aligned at the bottom of rows no wider than `limit`; each group stays in one row. */
export function shelves(groups: readonly (readonly Block[])[], limit: number, gap: number): Block {
  const rows: Block[][] = [];
  let used = Infinity;
  for (const group of groups) {
    const {width} = beside(group, gap);
    if (used + gap + width > limit + 1e-9) {
      rows.push([...group]);
      used = width;
    } else {
      rows.at(-1)?.push(...group);
      used += gap + width;
    }
  }
  return below(rows.map((row) => beside(row, gap, (block, height) => height - block.height)));
}
