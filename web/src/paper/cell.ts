/**
 * Draws the print beneath pieces, cell by cell. PDF has patterns for this purpose, but viewers draw
 * rotated ones up to 12 mm off. Each cell extends slightly beyond its edges, so that no hairline is
 * visible between two. Lengths in cm.
 */
import type {LaidPiece} from '../cutting/cut-sheet.js';
import {paleWhite} from '../cutting/print-ink.js';
import {
  coordinates,
  combined,
  norm,
  onPiece,
  onPrint,
  unit,
  towards,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';
import {imageCell} from '../model/print/wallpaper.js';
import {boxAt, cornersOf, grown, overlap, shared} from './boxes.js';
import {box, filledWith, line, num, nums, scoped, through} from '../files/pdf/content.js';
import type {PdfResources} from '../files/pdf/resources.js';
import type {PdfImage} from '../files/pdf/image.js';
import type {Size} from './vector-cell.js';
import type {Leaf} from './vector-tile.js';

export interface Cell {
  /** Sides of a form's content, on the print. */
  readonly sides: readonly [Point, Point];
  /** Groups by their opacity. Each form is drawn for all cells before the next one. */
  readonly groups: readonly {readonly forms: readonly string[]; readonly opacity: number}[];
  /** Areas and lines of a cell from an SVG. */
  readonly leaves?: readonly Leaf[];
}

/** Enlargement, on every side, of a raster image in its first pass. */
const leastReach = 0.02;
/** Cells with shorter sides are combined to blocks. */
const blockSide = 5;

type Sides = readonly [Point, Point];

const sizeOf = ([a, b]: Sides): Size => [norm(a), norm(b)];

/** The map from a form's rectangle to the oblique cell. */
function shearing([a, b]: Sides): string {
  const parts = [...unit(a), ...unit(b)].map((value) => num(value, 8));
  return `/Matrix[${parts.join(' ')} 0 0]`;
}

const bounds = ({low, high}: Box): string => `/BBox[${nums(...low, ...high)}]`;

/** Combines small cells to blocks. */
function inBlocks(resources: PdfResources, cell: Cell, reach: number): Cell {
  const [a, b] = cell.sides;
  const counts = [a, b].map((side) => Math.max(1, Math.round(blockSide / norm(side))));
  const [across = 1, up = 1] = counts;
  if (across * up === 1) return cell;
  const points = [0, across].flatMap((i) => [0, up].map((j) => combined([a, b], i, j)));
  const places = Array.from({length: across * up}, (_, k) =>
    combined([a, b], k % across, Math.floor(k / across)),
  );
  const block = bounds(grown(boxOf(points), 3 * reach));
  const groups = cell.groups.map(({forms, opacity}) => ({
    opacity,
    forms: forms.map((form) =>
      resources.form(block, places.map((at) => placed(form, at)).join('\n')),
    ),
  }));
  return {sides: [combined([a, b], across, 0), combined([a, b], 0, up)], groups};
}

const placed = (form: string, at: Point): string => `q 1 0 0 1 ${nums(...at)} cm /${form} Do Q`;

/**
 * A cell of vector graphics.
 * @param drawn the contents of the cell by level, in groups with their opacity
 */
export function vectorCell(
  resources: PdfResources,
  sides: Sides,
  drawn: readonly {
    readonly levels: readonly string[];
    readonly reach: number;
    readonly opacity: number;
  }[],
): Cell {
  const matrix = shearing(sides);
  const groups = drawn.map(({levels, reach, opacity}) => {
    const more = `${bounds(grown(boxAt([0, 0], ...sizeOf(sides)), reach))}${matrix}`;
    return {opacity, forms: levels.map((content) => resources.form(more, content))};
  });
  const reach = Math.max(0, ...drawn.map((one) => one.reach));
  return inBlocks(resources, {sides, groups}, reach);
}

/**
 * A cell with a raster image. The image is first drawn slightly larger, so that no paper is visible
 * between two of true size.
 */
export function rasterCell(resources: PdfResources, print: Print, image: PdfImage): Cell {
  const sides = imageCell(print);
  const matrix = shearing(sides);
  const name = resources.image(image);
  const size = sizeOf(sides);
  const [w, h] = size;
  const forms = [leastReach, 0].map((reach) => {
    const drawn = scoped(
      `${nums(w + 2 * reach, 0, 0, h + 2 * reach, -reach, -reach)} cm`,
      `/${name} Do`,
    );
    const more = `${bounds(grown(boxAt([0, 0], ...size), 2 * leastReach))}${matrix}`;
    return resources.form(more, drawn);
  });
  const groups = [{opacity: 1, forms}];
  return inBlocks(resources, {sides, groups}, 2 * leastReach);
}

/** The alignment of the print on the sheet: the piece's place composed with its alignment. */
export const onSheet = (place: Alignment, alignment: Alignment): Alignment => ({
  angle: place.angle + alignment.angle,
  translation: onPiece(place, alignment.translation),
});

/** Corners, on the print, of the cells that meet a box of the sheet. */
function cellsIn(lying: Alignment, sides: readonly [Point, Point], seen: Box): readonly Point[] {
  const corners = cornersOf(seen).map((corner) => coordinates(sides, onPrint(lying, corner)));
  const {low, high} = boxOf(corners);
  const cells: Point[] = [];
  for (let j = Math.floor(low[1]); j <= high[1]; j++) {
    for (let i = Math.floor(low[0]); i <= high[0]; i++) {
      const own = [0, 1].flatMap((u) =>
        [0, 1].map((v) => onPiece(lying, combined(sides, i + u, j + v))),
      );
      if (overlap(boxOf(own), seen)) cells.push(combined(sides, i, j));
    }
  }
  return cells;
}

/** A white tint over a box, which leaves a pale print. */
const tint = (resources: PdfResources, {low, high}: Box): string =>
  scoped(
    `/${resources.opacity(paleWhite)} gs`,
    filledWith([1, 1, 1]),
    box(low, high[0] - low[0], high[1] - low[1]),
    'f',
  );

/** The print within the cut line of a piece, clipped to a window of the sheet. */
export function fabricUnder(
  resources: PdfResources,
  cell: Cell,
  {cut, place, alignment}: Pick<LaidPiece, 'cut' | 'place' | 'alignment'>,
  {window, isPale = false}: {readonly window: Box; readonly isPale?: boolean},
): string {
  const seen = shared(boxOf(cut[0] ?? []), window);
  if (!alignment || seen.low[0] >= seen.high[0] || seen.low[1] >= seen.high[1]) return '';
  const lying = onSheet(place, alignment);
  const [c, s] = towards(lying.angle);
  const onto = through({xx: c, xy: -s, yx: s, yy: c, shift: lying.translation});
  const cells = cellsIn(lying, cell.sides, seen);
  const groups = cell.groups.map(({forms, opacity}) => {
    const all = scoped(onto, ...forms.flatMap((form) => cells.map((at) => placed(form, at))));
    if (opacity === 1) return all;
    const whole = resources.form(
      `${bounds(seen)}/Group<</S/Transparency/CS/DeviceRGB/I true>>`,
      all,
    );
    return scoped(`/${resources.opacity(opacity)} gs`, `/${whole} Do`);
  });
  return scoped(
    cut.map((loop) => line(loop, true)).join('\n'),
    'W* n',
    ...groups,
    isPale ? tint(resources, seen) : '',
  );
}
