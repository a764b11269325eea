/** Builds one seamless cell of a print by applying the group's symmetries to motifs. */
import {apply, type PlaneMap} from '../../src/model/geometry/plane-map.js';
import type {Cell} from '../../src/image/tile-fabric.js';
import {cross, norm, plus, type Point} from '../../src/model/geometry/vectors.js';
import {boxOf} from '../../src/model/geometry/polyline.js';
import {imageCell, latticeAround, printElements} from '../../src/model/print/wallpaper.js';
import type {Palette} from './palette.js';
import type {Motif, Outline} from './shape.js';

export type {Cell};

/** Formats a number without superfluous zeros: .5, -.25, 3. */
function short(value: number, digits: number): string {
  const [whole = '', fraction = ''] = Math.abs(value).toFixed(digits).split('.');
  const decimals = fraction.replace(/0+$/, '');
  const size = decimals === '' ? whole : `${whole === '0' ? '' : whole}.${decimals}`;
  return value < 0 && size !== '0' ? `-${size}` : size;
}
const list = (values: readonly number[], digits: number): string =>
  values.map((value) => short(value, digits)).join(' ');

/**
 * SVG path of an outline, in steps from point to point on a grid of 0.01 cm, which is finer than a
 * printer's.
 */
export function pathData({start, sides}: Outline): string {
  const grid = 100;
  const snapped = ([x, y]: Point): Point => [Math.round(x * grid), Math.round(y * grid)];
  let from = snapped(start);
  const steps = sides.map((side) => {
    const ends = side.map(snapped);
    const numbers = ends.flatMap(([x, y]) => [(x - from[0]) / grid, (y - from[1]) / grid]);
    from = ends.at(-1) ?? from;
    return (ends.length === 1 ? 'l' : 'c') + list(numbers, 2);
  });
  const packed = steps
    .join('')
    .replace(/ -/g, '-')
    .replace(/(\.\d+) (?=\.)/g, '$1');
  return `M${list(
    snapped(start).map((v) => v / grid),
    2,
  )}${packed}z`;
}

/** The size of the image of one cell. [cm] */
export function imageSize(cell: Cell): readonly [width: number, height: number] {
  const [a, b] = imageCell(cell);
  return [norm(a), norm(b)];
}

/**
 * Map from the print to the image of one cell, in which y runs down; a slanted cell is drawn
 * upright. [cm]
 */
function intoImage(cell: Cell): PlaneMap {
  const [a, b] = imageCell(cell);
  const area = cross(a, b);
  const [width, height] = imageSize(cell);
  return {
    xx: (b[1] / area) * width,
    xy: (-b[0] / area) * width,
    yx: (a[1] / area) * height,
    yy: (-a[0] / area) * height,
    shift: [0, height],
  };
}

/** Every copy of a motif that is visible in the image of the cell, as a map of the print. */
function copies(motif: Motif, cell: Cell): readonly PlaneMap[] {
  const {w1, w2} = cell;
  const [width, height] = imageSize(cell);
  const image = intoImage(cell);
  // the control points of a Bezier curve enclose it
  const hull = motif.flatMap(({outlines}) =>
    outlines.flatMap(({start, sides}) => [start, ...sides.flat()]),
  );
  const seen = (map: PlaneMap): boolean => {
    const all = hull.map((p) => apply(image, apply(map, p)));
    const {low, high} = boxOf(all);
    return low[0] < width && high[0] > 0 && low[1] < height && high[1] > 0;
  };
  const shifts = latticeAround([w1, w2], 4);
  return printElements(cell).flatMap((element) =>
    shifts.flatMap((vector) => {
      const copy = {...element, shift: plus(element.shift, vector)};
      return seen(copy) ? [copy] : [];
    }),
  );
}

/** The value of an SVG attribute; the linear part to 1 in 100 000, the shift to 0.001 cm. */
function transform({xx, yx, xy, yy, shift}: PlaneMap): string {
  const linear = list([xx, yx, xy, yy], 5);
  return linear === '1 0 0 1'
    ? `translate(${list(shift, 3)})`
    : `matrix(${linear} ${list(shift, 3)})`;
}

/** An SVG file whose viewBox is the cell in cm. */
export function tileFile(cell: Cell, pixels: readonly [number, number], content: string[]): string {
  const size = imageSize(cell);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${pixels[0]}" height="${pixels[1]}" viewBox="0 0 ${list(size, 5)}" preserveAspectRatio="none">`,
    ...content,
    '</svg>\n',
  ].join('\n');
}

export const groundOf = (palette: Palette): string =>
  `<rect width="100%" height="100%" fill="${palette.ground}"/>`;

/**
 * The motifs in one cell. Each block is printed in all its copies before the next one. Overlapping
 * copies would otherwise cover each other in some order, which would break the symmetry.
 */
export function printed(cell: Cell, motifs: readonly Motif[], palette: Palette): string[] {
  const definitions: string[] = [];
  const blocks: string[] = [];
  motifs.forEach((motif, k) => {
    const maps = copies(motif, cell).map(transform);
    motif.forEach(({ink, outlines}, level) => {
      const id = `${String.fromCharCode(97 + k)}${level}`;
      definitions.push(`<path id="${id}" d="${outlines.map(pathData).join('')}"/>`);
      const uses = maps.map((map) => `<use href="#${id}" transform="${map}"/>`);
      blocks.push(`<g fill="${palette[ink]}">${uses.join('')}</g>`);
    });
  });
  const upright = transform(intoImage(cell));
  return ['<defs>', ...definitions, '</defs>', `<g transform="${upright}">`, ...blocks, '</g>'];
}
