/** Marks over a photo: cells, their vectors, symmetries, and areas that differ. */
import {svg, type TemplateResult} from 'lit';

import {combined, distance, minus, norm, plus, type Point} from '../../model/geometry/vectors.js';
import {pixelOf} from '../../model/print/photo-map.js';
import type {PhotoMap} from '../../model/print/photo-reading.js';
import type {GroupName} from '../../model/print/repeating-print.js';
import type {ArrowNames} from '../../photo/arrow-names.js';
import {brokenPath, ringPath, type BrokenPlaces} from '../../photo/breaks-on-photo.js';
import {cellLines, nodesOf, type PhotoSize} from '../../photo/lattice-lines.js';
import {marksOn} from '../../photo/symmetry-marks.js';

/** Kinds of marks over the photo. */
export const overlayNames = ['cells', 'axes', 'differing', 'breaks'] as const;
export type Overlays = Readonly<Record<(typeof overlayNames)[number], boolean>>;

export type Vector = keyof ArrowNames;

interface StageMarks {
  readonly map: PhotoMap;
  readonly size: PhotoSize;
  /** The corner at which the vectors begin. */
  readonly base: Point;
  /** Undefined while the user draws a lattice. */
  readonly group: GroupName | undefined;
  readonly differing: readonly (readonly Point[])[];
  readonly broken: BrokenPlaces | undefined;
  readonly overlays: Overlays;
  /** Vector that the user measures along at present. */
  readonly measured: Vector | undefined;
  readonly names: ArrowNames;
}

/** Size of arrow heads and centres, as a share of the image's longer side. */
const markSize = 0.011;

/** Least distance of a name's middle from the border of the image, in units of `unitOf`. */
const nameMargin = 2;
/** Half of the mean width of a letter, in units of `unitOf`. */
const letterWidth = 0.5;
/** Number of possible places for a name along its arrow. */
const nameSteps = 20;

const unitOf = ({width, height}: PhotoSize): number => markSize * Math.max(width, height);

export function stageMarks(marks: StageMarks): TemplateResult {
  const {map, size, overlays, group, broken} = marks;
  const lines = overlays.cells ? cellLines(map, size) : '';
  const dots = overlays.cells ? nodesOf(map, size) : [];
  const differing = overlays.differing ? marks.differing.map(ringPath).join('') : '';
  return svg`
    <path class="differing" d=${differing}></path>
    <path class="broken" d=${broken && overlays.breaks ? brokenPath(map, size, broken) : ''}></path>
    <path class="casing" d=${lines}></path><path class="cells" d=${lines}></path>
    ${dots.map((node) => {
      const [x, y] = pixelOf(map, size, node);
      return svg`<circle class="dot" cx=${x} cy=${y} r=${0.35 * unitOf(size)}></circle>`;
    })}
    ${overlays.axes && group ? symmetries(group, marks) : ''}
    ${arrow(marks, [1, 0], 'w1')} ${marks.names.w2 === undefined ? '' : arrow(marks, [0, 1], 'w2')}`;
}

function symmetries(group: GroupName, {map, size}: StageMarks): TemplateResult {
  const {mirrors, glides, centres} = marksOn(group, map, size);
  return svg`<path class="casing" d=${mirrors + glides}></path>
    <path class="mirrors" d=${mirrors}></path>
    <path class="glides" d=${glides}></path>
    ${centres.map(
      ({order, at}) =>
        svg`<path class="centre" data-order=${order} d=${symbol(order, at, unitOf(size))}></path>`,
    )}`;
}

/** Symbols as in crystallography: a lens, a triangle, a square, a hexagon. */
function symbol(order: 2 | 3 | 4 | 6, [x, y]: Point, unit: number): string {
  const radius = 0.6 * unit;
  const corner = (k: number): Point => {
    const angle = Math.PI * ((2 * k) / order - 0.5);
    const reach = order === 2 && k % 1 !== 0 ? 0.5 * radius : radius;
    return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)];
  };
  const corners = order === 2 ? [0, 0.5, 1, 1.5] : Array.from({length: order}, (_, k) => k);
  return ringPath(corners.map(corner));
}

/**
 * Returns the place of an arrow's name: beyond its end, or else beside it, as near to the end as
 * the image has room.
 */
export function namePlace(from: Point, to: Point, size: PhotoSize, letters = 2): Point {
  const unit = unitOf(size);
  const [dx, dy] = minus(to, from);
  const length = norm([dx, dy]);
  const along: Point = [dx / length, dy / length];
  const across: Point = [-along[1], along[0]];
  const half = letterWidth * letters * unit; // half of the name's width
  const away = 2 * unit + Math.max(unit, half * Math.abs(along[0]));
  const aside = 2 * unit + Math.max(unit, half * Math.abs(along[1]));
  const at = (forth: number, side: number): Point =>
    plus(from, combined([along, across], forth, side));
  const beside = Array.from(
    {length: nameSteps + 1},
    (_, k) => length * (1 - k / nameSteps),
  ).flatMap((forth) => [at(forth, aside), at(forth, -aside)]);
  const margin = Math.max(nameMargin * unit, half);
  const inside = (value: number, most: number): number =>
    Math.min(Math.max(value, margin), most - margin);
  const moved = ([x, y]: Point): Point => [inside(x, size.width), inside(y, size.height)];
  const beyond = at(length + away, 0);
  const free = [beyond, ...beside].find((place) => distance(moved(place), place) === 0);
  return free ?? moved(beyond);
}

function arrow(
  {map, size, base, measured, names}: StageMarks,
  [i, j]: Point,
  name: Vector,
): TemplateResult | undefined {
  const unit = unitOf(size);
  const from = pixelOf(map, size, base);
  const to = pixelOf(map, size, [base[0] + i, base[1] + j]);
  const length = distance(from, to);
  if (!(length > 0)) return undefined;
  const along: Point = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const head = Math.min(1.6 * unit, length / 3);
  const side = (sign: number): string => {
    const [x, y] = [
      to[0] - head * (along[0] + 0.5 * sign * along[1]),
      to[1] - head * (along[1] - 0.5 * sign * along[0]),
    ];
    return `${x.toFixed(1)} ${y.toFixed(1)}`;
  };
  const path = `M${from.join(' ')}L${to.join(' ')}M${side(1)}L${to.join(' ')}L${side(-1)}`;
  const [x, y] = namePlace(from, to, size, (names[name] ?? '').length);
  const marked = measured === name ? `${name} measured` : name;
  return svg`<path class="arrow casing" d=${path}></path>
    <path class="arrow ${marked}" d=${path}></path>
    <text class=${marked} x=${x} y=${y} font-size=${2 * unit}>${names[name]}</text>`;
}
