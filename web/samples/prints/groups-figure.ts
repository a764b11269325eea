/** The figure of the 17 groups: one leaf, repeated by each of them. */
import {apply, determinant} from '../../src/model/geometry/plane-map.js';
import {groupNames} from '../../src/model/base/core-tables.js';
import {combined, middle, minus, plus, type Point} from '../../src/model/geometry/vectors.js';
import {type GroupName} from '../../src/model/print/repeating-print.js';
import {
  latticeAround,
  latticeType,
  printElements,
  type LatticeType,
} from '../../src/model/print/wallpaper.js';
import {polyline, short, text} from '../../src/files/svg/written.js';
import {cellOf, hexagonal, rhombic, slanted, square, upright, type Lattice} from './design.js';
import {drawElements, elementsWithin, type Elements} from './elements.js';
import {blade, dot, grown, joined} from './shape.js';
import {cornersOf, inkColour, page, places, toPage, type Window} from './sheet.js';
import {pathData, type Cell} from './tile.js';

/** A lattice of every type. [cm] */
const lattices: Readonly<Record<LatticeType, Lattice>> = {
  oblique: slanted([5.4, 0], [1.5, 4.4]),
  rectangular: upright(6.4, 5.6),
  rhombic: rhombic(5.6, 8),
  square: square(7.2),
  hexagonal: hexagonal(7.6),
};

/**
 * Place of the leaf's middle, in parts of w1 and w2, its heading and its size, so that its copies
 * stay apart.
 */
type Spot = readonly [u: number, v: number, heading: number, size: number];
const usual: Spot = [0.25, 0.25, -30, 1];
const spots: Readonly<Partial<Record<GroupName, Spot>>> = {
  cm: [0.71, 0.29, -10, 1],
  pmm: [0.25, 0.25, -45, 0.9],
  pmg: [0.25, 0.5, -80, 0.95],
  cmm: [0.875, 0.375, -70, 0.8],
  p4m: [0.353, 0.147, -60, 0.75],
  p4g: [0.147, 0.147, -100, 0.85],
  p3: [0.33, 0.1, -75, 1],
  p3m1: [0.667, 0.333, -20, 0.85],
  p31m: [0.422, 0.155, -84, 0.9],
  p6: [0.26, 0.16, -70, 0.9],
  p6m: [0.333, 0.122, -70, 0.6],
};

/** A leaf with a berry, around its middle. */
const leaf = joined([
  blade('line', '0,-0.95 -0.42,-0.55 -0.5,0.15 0.1,0.95', '0.25,-0.55 0.35,0.15'),
  dot('line', [0.6, -0.45], 0.2),
]);

/** Colours of copies by a rotation or shift alone, and of mirrored copies. */
const colours = {same: '#4b6a5a', mirrored: '#d08f63', cell: '#ece6da'};
const elementStyle = {line: inkColour, casing: '#fbf9f5', size: 3.2};
/** Width of the visible part in a panel. [cm] */
const seen = 12.5;

function panel(group: GroupName, corner: Point, side: number): string {
  const cell: Cell = cellOf(group, lattices[latticeType(group)]);
  const {w1, w2} = cell;
  const window: Window = {
    corner,
    size: [side, side],
    middle: middle(w1, w2),
    scale: side / seen,
  };
  const at = toPage(window);
  const [u, v, heading, size] = spots[group] ?? usual;
  const foot = combined([w1, w2], u, v);
  const mark = grown(leaf, foot, heading, size);
  const data = mark.flatMap(({outlines}) => outlines.map(pathData)).join('');
  const shifts = latticeAround([w1, w2], 4);
  const copies = printElements(cell).flatMap((element) =>
    shifts.flatMap((vector) => {
      const {xx, xy, yx, yy} = element;
      const shift = plus(element.shift, vector);
      const [x, y] = minus(apply({...element, shift}, foot), window.middle);
      if (Math.max(Math.abs(x), Math.abs(y)) > seen / 2 + 2) return [];
      const matrix = [xx, yx, xy, yy, ...shift].map(short).join(' ');
      const fill = determinant(element) > 0 ? '' : ` fill="${colours.mirrored}"`;
      return [`<use href="#leaf-${group}" transform="matrix(${matrix})"${fill}/>`];
    }),
  );
  const [ox, oy] = at([0, 0]);
  const corners = cornersOf(cell);
  const box = `x="${short(corner[0])}" y="${short(corner[1])}" width="${short(side)}" height="${short(side)}"`;
  return [
    `<g aria-label="${group}">`,
    `<clipPath id="window-${group}"><rect ${box} rx="3"/></clipPath>`,
    `<defs><path id="leaf-${group}" d="${data}"/></defs>`,
    `<rect ${box} rx="3" fill="#fff"/>`,
    `<path d="${polyline(corners.map(at))}Z" fill="${colours.cell}"/>`,
    `<path d="${polyline(corners.map(at))}Z" fill="none" stroke="${inkColour}" stroke-width=".5" stroke-opacity=".5"/>`,
    // below the leaves, as only glides run through them
    drawElements(elementsWithin(cell, corners), at, elementStyle),
    `<g clip-path="url(#window-${group})"><g transform="matrix(${short(window.scale)} 0 0 ${short(-window.scale)} ${short(ox)} ${short(oy)})" fill="${colours.same}">${copies.join('')}</g></g>`,
    text([corner[0], corner[1] + side + 21], group, {size: 16, weight: 600, fill: inkColour}),
    text([corner[0] + side, corner[1] + side + 21], latticeType(group), {
      size: 12,
      fill: '#7c7a75',
      anchor: 'end',
    }),
    '</g>',
  ].join('');
}

/** The legend of the symbols, in the last place. */
function key([x, y]: Point): string {
  const rows: readonly (readonly [name: string, elements: Elements])[] = [
    ['turns by 180°', {centres: [{at: [14, 0], order: 2}], axes: []}],
    ['by 120°', {centres: [{at: [14, 0], order: 3}], axes: []}],
    ['by 90°', {centres: [{at: [14, 0], order: 4}], axes: []}],
    ['by 60°', {centres: [{at: [14, 0], order: 6}], axes: []}],
    ['mirror', {centres: [], axes: [{from: [0, 0], to: [28, 0], glide: false}]}],
    ['glide', {centres: [], axes: [{from: [0, 0], to: [28, 0], glide: true}]}],
  ];
  return rows
    .map(([name, elements], k) => {
      const top = y + 14 + 24 * k;
      const signs = drawElements(elements, ([a, b]) => [x + a, top + b], elementStyle);
      return signs + text([x + 40, top + 4.5], name, {size: 13, fill: inkColour});
    })
    .join('');
}

export function groupsFigure(): string {
  const {width, corners, size} = places(groupNames.length + 1, 6, 22, (side) => side + 44);
  const panels = groupNames.map((group, k) => panel(group, corners[k] ?? [0, 0], width));
  const about =
    'One leaf, repeated by each group. Shaded: the cell of w1 and w2, the origin at its lowest corner (of two, the left one). Light leaves show the other hand.';
  return page(size, 'The 17 wallpaper groups', about, [...panels, key(corners.at(-1) ?? [0, 0])]);
}
