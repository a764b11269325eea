/** Parses SVG attribute values: colours, lengths, transforms, and shapes as path data. */
import {radians} from '../model/geometry/vectors.js';
import {after, type PlaneMap} from '../model/print/wallpaper.js';
import type {Colour} from '../files/pdf/content.js';

const named: Readonly<Record<string, string>> = {
  ...{black: '000000', white: 'ffffff', red: 'ff0000', lime: '00ff00', blue: '0000ff'},
  ...{yellow: 'ffff00', cyan: '00ffff', aqua: '00ffff', magenta: 'ff00ff', fuchsia: 'ff00ff'},
  ...{gray: '808080', grey: '808080', silver: 'c0c0c0', maroon: '800000', olive: '808000'},
  ...{green: '008000', purple: '800080', teal: '008080', navy: '000080', orange: 'ffa500'},
  ...{currentcolor: '000000'},
};

/** The colour; null for none, undefined for values that need a browser, such as gradients. */
export function colourOf(text: string): Colour | null | undefined {
  const word = text.toLowerCase();
  if (word === 'none' || word === 'transparent') return null;
  const hex = /^#([\da-f]{6}|[\da-f]{3})$/.exec(word)?.[1] ?? named[word];
  if (hex !== undefined) {
    const long = hex.length === 3 ? hex.replaceAll(/./g, '$&$&') : hex;
    const part = (k: number): number => parseInt(long.slice(k, k + 2), 16) / 255;
    return [part(0), part(2), part(4)];
  }
  const parts = /^rgb\(\s*([^)]*)\)$/.exec(word)?.[1]?.split(/[\s,]+/);
  const [r, g, b] = (parts ?? []).map((part) =>
    part.endsWith('%') ? Number(part.slice(0, -1)) / 100 : Number(part) / 255,
  );
  return [r, g, b].every((part) => part !== undefined && part >= 0 && part <= 1)
    ? [r ?? 0, g ?? 0, b ?? 0]
    : undefined;
}

/**
 * A length in user units. NaN for other units.
 * @param whole length of 100 %
 */
export function lengthOf(text: string | undefined, whole = NaN): number {
  if (text === undefined || text === '') return 0;
  if (text.endsWith('%')) return (Number(text.slice(0, -1)) / 100) * whole;
  return Number(text.replace(/px$/, ''));
}

export const numbersOf = (text: string): readonly number[] =>
  (text.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number);

const linear = (xx: number, xy: number, yx: number, yy: number, x = 0, y = 0): PlaneMap => ({
  ...{xx, xy, yx, yy},
  shift: [x, y],
});

const identity = linear(1, 0, 0, 1);
export const shifted = (x: number, y: number): PlaneMap => linear(1, 0, 0, 1, x, y);
export const scaled = (x: number, y: number): PlaneMap => linear(x, 0, 0, y);

function single(name: string, values: readonly number[]): PlaneMap | undefined {
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = values;
  if (name === 'matrix' && values.length === 6) return linear(a, c, b, d, e, f);
  if (name === 'translate') return shifted(a, b);
  if (name === 'scale') return scaled(a, values.length > 1 ? b : a);
  if (name === 'skewX') return linear(1, Math.tan(radians(a)), 0, 1);
  if (name === 'skewY') return linear(1, 0, Math.tan(radians(a)), 1);
  if (name !== 'rotate') return undefined;
  const [cos, sin] = [Math.cos(radians(a)), Math.sin(radians(a))];
  return after(shifted(b, c), after(linear(cos, -sin, sin, cos), shifted(-b, -c)));
}

/** Parses a list of transforms; undefined if it is invalid. */
export function transformOf(text: string): PlaneMap | undefined {
  let whole: PlaneMap | undefined = identity;
  const rest = text.replaceAll(/(\w+)\s*\(([^)]*)\)[\s,]*/g, (_, name: string, list: string) => {
    const one = single(name, numbersOf(list));
    whole = whole && one && after(whole, one);
    return '';
  });
  return rest.trim() === '' ? whole : undefined;
}

/** Path data of a shape; undefined for other elements. */
export function shapeData(
  name: string,
  value: (key: string) => string | undefined,
  [width, height]: readonly [number, number],
): string | undefined {
  const [across, up] = [
    (key: string) => lengthOf(value(key), width),
    (key: string) => lengthOf(value(key), height),
  ];
  if (name === 'path') return value('d') ?? '';
  if (name === 'line') return `M${across('x1')} ${up('y1')}L${across('x2')} ${up('y2')}`;
  if (name === 'polyline' || name === 'polygon') {
    return `M${value('points') ?? ''}${name === 'polygon' ? 'z' : ''}`;
  }
  if (name === 'circle' || name === 'ellipse') {
    const r = lengthOf(value('r'));
    const [rx, ry] = name === 'circle' ? [r, r] : [across('rx'), up('ry')];
    return `M${across('cx') - rx} ${up('cy')}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0z`;
  }
  if (name !== 'rect') return undefined;
  const [w, h] = [across('width'), up('height')];
  const said = [value('rx') ?? value('ry'), value('ry') ?? value('rx')].map((one) => lengthOf(one));
  const [rx, ry] = [Math.min(said[0] ?? 0, w / 2), Math.min(said[1] ?? 0, h / 2)];
  const corner = (dx: number, dy: number): string =>
    rx > 0 && ry > 0 ? `a${rx} ${ry} 0 0 1 ${dx} ${dy}` : `l${dx} ${dy}`;
  const straight = `M${across('x') + rx} ${up('y')}h${w - 2 * rx}`;
  return `${straight}${corner(rx, ry)}v${h - 2 * ry}${corner(-rx, ry)}h${2 * rx - w}${corner(-rx, -ry)}v${2 * ry - h}${corner(rx, -ry)}z`;
}
