/**
 * Arranges rectangles with pieces beside and below each other, without overlaps. Lengths in cm, y
 * down.
 */
import type {Point} from '../model/geometry/vectors.js';

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
export function beside(
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
export function below(blocks: readonly Block[]): Block {
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
