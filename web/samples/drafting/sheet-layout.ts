/**
 * Places of a garment's pieces on a sheet: in rows, at the largest scale at which they fit. y runs
 * down.
 */
import type {Point} from '../../src/model/geometry/vectors.js';
import {pointAt} from './curves.js';
import type {Garment, Panel} from './panel.js';

export interface Placed {
  readonly panel: Panel;
  /** Map from panel coordinates (cm) to the page (px). */
  readonly toPage: (p: Point) => Point;
  /** The middle of the lower edge of its box, the place of its name. [px] */
  readonly foot: Point;
}

interface SheetLayout {
  readonly pieces: readonly Placed[];
  /** [px] */
  readonly height: number;
  /** [px per cm] */
  readonly scale: number;
}

/** Room of a sheet and of a piece's name. [px] */
interface SheetRoom {
  readonly width: number;
  readonly height: number;
  readonly gap: number;
  readonly name: {readonly height: number; readonly width: (panel: Panel) => number};
}

interface Box {
  readonly panel: Panel;
  readonly low: Point;
  readonly high: Point;
}

function boxOf(panel: Panel): Box {
  const points = panel.edges.flatMap(({curve}) =>
    [0, 0.2, 0.4, 0.6, 0.8].map((t) => pointAt(curve, t)),
  );
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return {
    panel,
    low: [Math.min(...xs), Math.min(...ys)],
    high: [Math.max(...xs), Math.max(...ys)],
  };
}

const tallness = ({low, high}: Box): number => high[1] - low[1];

const seenFromBehind = ({placement}: Panel): boolean => Math.abs(placement.rotation[1]) > 90;

/**
 * Mirrored pairs stay side by side, the wearer's left at the right of a front and at the left of a
 * back; the tallest pieces come first.
 */
function groupsOf({panels: all, symmetries}: Garment): readonly (readonly Box[])[] {
  const find = (name: string): Panel[] => all.filter((panel) => panel.name === name);
  const named = new Set(symmetries.flat());
  return [...symmetries, ...all.filter(({name}) => !named.has(name)).map(({name}) => [name])]
    .map((names) => {
      const panels = names.flatMap(find);
      return (panels.every(seenFromBehind) ? panels : panels.toReversed()).map(boxOf);
    })
    .sort((a, b) => Math.max(...b.map(tallness)) - Math.max(...a.map(tallness)));
}

interface Shelf {
  readonly boxes: Box[];
  width: number;
}

function shelvesAt(
  scale: number,
  groups: readonly (readonly Box[])[],
  room: SheetRoom,
): {readonly shelves: readonly Shelf[]; readonly roomOf: (box: Box) => number} {
  const roomOf = ({panel, low, high}: Box): number =>
    Math.max(scale * (high[0] - low[0]), room.name.width(panel)) + room.gap;
  const shelves: Shelf[] = [];
  for (const group of groups) {
    const width = group.reduce((sum, box) => sum + roomOf(box), 0);
    const shelf = shelves.find((one) => one.width + width <= room.width + room.gap);
    if (shelf) {
      shelf.boxes.push(...group);
      shelf.width += width;
    } else shelves.push({boxes: [...group], width});
  }
  return {shelves, roomOf};
}

/** Places a garment's pieces below `top`, between `left` and `left + room.width`. */
export function layOutSheet(
  garment: Garment,
  [left, top]: Point,
  room: SheetRoom,
  largest: number,
): SheetLayout {
  const groups = groupsOf(garment);
  const heightOf = ({boxes}: Shelf, scale: number): number =>
    scale * Math.max(...boxes.map(tallness)) + room.name.height;
  const fits = (scale: number): boolean => {
    const {shelves} = shelvesAt(scale, groups, room);
    const height = shelves.reduce((sum, shelf) => sum + heightOf(shelf, scale), 0);
    const width = Math.max(...shelves.map((shelf) => shelf.width)) - room.gap;
    return height <= room.height && width <= room.width;
  };
  let scale = largest;
  while (!fits(scale)) scale *= 0.98;
  // slightly smaller if that avoids an almost empty row
  const count = shelvesAt(scale, groups, room).shelves.length;
  const compact = 0.92 * scale;
  if (shelvesAt(compact, groups, room).shelves.length < count) scale = compact;
  const {shelves, roomOf} = shelvesAt(scale, groups, room);
  const pieces: Placed[] = [];
  let y = top;
  for (const shelf of shelves) {
    const base = y + heightOf(shelf, scale) - room.name.height;
    let x = left + (room.width - shelf.width + room.gap) / 2;
    for (const box of shelf.boxes) {
      const middle = x + (roomOf(box) - room.gap) / 2;
      const [mx, low] = [(box.low[0] + box.high[0]) / 2, box.low[1]];
      pieces.push({
        panel: box.panel,
        toPage: ([px, py]) => [middle + scale * (px - mx), base - scale * (py - low)],
        foot: [middle, base],
      });
      x += roomOf(box);
    }
    y += heightOf(shelf, scale);
  }
  return {pieces, height: y - top, scale};
}
