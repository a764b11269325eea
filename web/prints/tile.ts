/** Builds one seamless cell of a print: the group's symmetries applied to motifs. */
import type {Point} from '../src/model/geometry.js';
import type {Print} from '../src/model/print.js';
import {apply, imageCell, printElements, type PlaneMap} from '../src/model/wallpaper.js';
import type {Motif, Shape} from './motifs.js';

/** Where a motif grows: its foot in lattice coordinates (u, v), its direction (degrees from +y) and size. */
export interface Placed {
  readonly motif: Motif;
  readonly at: Point;
  readonly turn: number;
  readonly size: number;
}

export interface Design {
  readonly print: Print;
  readonly ground: string;
  /** Colours 0, 1, 2, ... of the motifs. */
  readonly palette: readonly string[];
  readonly motifs: readonly Placed[];
}

const pixelsPerCm = 64;
const short = (value: number): string => String(Number(value.toFixed(4)) + 0);
const points = (list: readonly Point[]): string =>
  list.map(([x, y]) => `${short(x)} ${short(y)}`).join(' ');

function draw(shape: Shape, palette: readonly string[]): string {
  const colour = palette[shape.colour] ?? 'none';
  if ('centre' in shape) {
    return `<circle cx="${short(shape.centre[0])}" cy="${short(shape.centre[1])}" r="${short(shape.radius)}" fill="${colour}"/>`;
  }
  const path = `M${points(shape.curves.slice(0, 1))}C${points(shape.curves.slice(1))}`;
  return shape.stroke === undefined
    ? `<path d="${path}" fill="${colour}"/>`
    : `<path d="${path}" fill="none" stroke="${colour}" stroke-width="${shape.stroke}" stroke-linecap="round"/>`;
}

/** How far a motif reaches from its foot. [cm] A Bezier curve stays within its control points. */
const reach = (motif: Motif): number =>
  Math.max(
    ...motif.map((shape) =>
      'centre' in shape
        ? Math.hypot(...shape.centre) + shape.radius
        : Math.max(...shape.curves.map((p) => Math.hypot(...p))) + (shape.stroke ?? 0) / 2,
    ),
  );

/** The motif's own coordinates -> the print. */
function placement({at, turn, size}: Placed, {w1, w2}: Print): PlaneMap {
  const a = (turn * Math.PI) / 180;
  const c = size * Math.cos(a);
  const s = size * Math.sin(a);
  const shift: Point = [at[0] * w1[0] + at[1] * w2[0], at[0] * w1[1] + at[1] * w2[1]];
  return {xx: c, xy: -s, yx: s, yy: c, shift};
}

/** Every copy of a motif that can be seen in the cell, as a map from the motif to the image. [cm, y down] */
export function copies(placed: Placed, print: Print): readonly PlaneMap[] {
  const [a, b] = imageCell(print);
  const area = a[0] * b[1] - a[1] * b[0];
  const [width, height] = [Math.hypot(...a), Math.hypot(...b)];
  const intoImage: PlaneMap = {
    xx: (b[1] / area) * width,
    xy: (-b[0] / area) * width,
    yx: (a[1] / area) * height,
    yy: (-a[0] / area) * height,
    shift: [0, height],
  };
  const own = placement(placed, print);
  // in the image the motif may be sheared: what it reaches there is bounded by the cell's own proportions
  const far = reach(placed.motif) * placed.size * ((width * height) / area);
  const seen = ([x, y]: Point): boolean =>
    x > -far && x < width + far && y > -far && y < height + far;

  const found: PlaneMap[] = [];
  const range = [-4, -3, -2, -1, 0, 1, 2, 3, 4];
  for (const element of printElements(print)) {
    for (const i of range) {
      for (const j of range) {
        const t: Point = [i * print.w1[0] + j * print.w2[0], i * print.w1[1] + j * print.w2[1]];
        const at = (p: Point): Point => {
          const [x, y] = apply(element, apply(own, p));
          return apply(intoImage, [x + t[0], y + t[1]]);
        };
        const [o, x, y] = [at([0, 0]), at([1, 0]), at([0, 1])];
        if (seen(o))
          found.push({
            xx: x[0] - o[0],
            yx: x[1] - o[1],
            xy: y[0] - o[0],
            yy: y[1] - o[1],
            shift: o,
          });
      }
    }
  }
  return found;
}

/** The text of the tile's SVG file; its viewBox is the cell in cm. */
export function tile({print, ground, palette, motifs}: Design): string {
  const [a, b] = imageCell(print);
  const [width, height] = [Math.hypot(...a), Math.hypot(...b)];
  const definitions = motifs.map(
    ({motif}, k) => `<g id="m${k}">${motif.map((shape) => draw(shape, palette)).join('')}</g>`,
  );
  const uses = motifs.flatMap((placed, k) =>
    copies(placed, print).map(({xx, yx, xy, yy, shift}) => {
      const matrix = [xx, yx, xy, yy, ...shift].map(short).join(' ');
      return `<use href="#m${k}" transform="matrix(${matrix})"/>`;
    }),
  );
  const size = `width="${Math.round(width * pixelsPerCm)}" height="${Math.round(height * pixelsPerCm)}" viewBox="0 0 ${short(width)} ${short(height)}"`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" ${size} preserveAspectRatio="none">`,
    `<defs>`,
    ...definitions,
    `</defs>`,
    `<rect width="100%" height="100%" fill="${ground}"/>`,
    ...uses,
    '</svg>\n',
  ].join('\n');
}

/** The text of a print file, one field a line. */
export function printFile({print}: Design): string {
  const lines = Object.entries(print).map(
    ([key, value]) => `  ${JSON.stringify(key)}: ${JSON.stringify(value)}`,
  );
  return `{\n${lines.join(',\n')}\n}\n`;
}
