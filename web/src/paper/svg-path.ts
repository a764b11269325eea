/** Converts SVG path data to lines and cubics. */
import {rotated, type Point} from '../model/geometry/vectors.js';
import {apply, type PlaneMap} from '../model/print/wallpaper.js';

/** A move, a line, a cubic, or the closing of a subpath. */
interface PathStep {
  readonly kind: 'm' | 'l' | 'c' | 'h';
  /** Operands of the PDF operator of the same name. */
  readonly points: readonly Point[];
}

export type SvgPath = readonly PathStep[];

/** Number of operands per command. */
const counts: Readonly<Record<string, number>> = {
  ...{m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7, z: 0},
};

const number = /\s*,?\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)/iy;
const flag = /\s*,?\s*([01])/y;
const command = /[\s,]*([a-z])/iy;

/** An elliptical arc as cubics, after the implementation notes of SVG 1.1 (F.6). */
function arcSteps(
  from: Point,
  [rx, ry, degrees, isLarge, isPositive, x, y]: readonly number[],
): PathStep[] {
  const to: Point = [x ?? 0, y ?? 0];
  let [a, b] = [Math.abs(rx ?? 0), Math.abs(ry ?? 0)];
  if (a === 0 || b === 0) return [{kind: 'l', points: [to]}];
  const turn = ((degrees ?? 0) * Math.PI) / 180;
  const [px, py] = rotated([(from[0] - to[0]) / 2, (from[1] - to[1]) / 2], -turn);
  const reach = Math.hypot(px / a, py / b);
  if (reach === 0) return [];
  if (reach > 1) [a, b] = [a * reach, b * reach];
  const rest = Math.max(0, (a * b) ** 2 - (a * py) ** 2 - (b * px) ** 2);
  const share =
    Math.sqrt(rest / ((a * py) ** 2 + (b * px) ** 2)) * (isLarge === isPositive ? -1 : 1);
  const middle: Point = [(share * a * py) / b, (-share * b * px) / a];
  const angleAt = (sx: number, sy: number): number =>
    Math.atan2((sy - middle[1]) / b, (sx - middle[0]) / a);
  const start = angleAt(px, py);
  let sweep = angleAt(-px, -py) - start;
  if (isPositive && sweep < 0) sweep += 2 * Math.PI;
  if (!isPositive && sweep > 0) sweep -= 2 * Math.PI;
  const pieces = Math.ceil(Math.abs(sweep) / (Math.PI / 2) - 1e-9);
  const step = sweep / pieces;
  const handle = (4 / 3) * Math.tan(step / 4);
  const onPage = (u: number, v: number): Point => {
    const [dx, dy] = rotated([middle[0] + a * u, middle[1] + b * v], turn);
    return [dx + (from[0] + to[0]) / 2, dy + (from[1] + to[1]) / 2];
  };
  return Array.from({length: pieces}, (_, k): PathStep => {
    const [t, next] = [start + k * step, start + (k + 1) * step];
    const [c, s, d, r] = [Math.cos(t), Math.sin(t), Math.cos(next), Math.sin(next)];
    const last = k === pieces - 1 ? to : onPage(d, r);
    return {
      kind: 'c',
      points: [
        onPage(c - handle * s, s + handle * c),
        onPage(d + handle * r, r - handle * d),
        last,
      ],
    };
  });
}

/** The state of the path reader. */
class Pen {
  readonly steps: PathStep[] = [];
  at: Point = [0, 0];
  #start: Point = [0, 0];
  /** The last control point, which a smooth curve reflects, and the last command. */
  #control: Point = [0, 0];
  #before = '';

  draw(name: string, values: readonly number[]): void {
    const kind = name.toLowerCase();
    const [ox, oy] = name === kind ? this.at : [0, 0];
    const points = Array.from({length: values.length >> 1}, (_, k): Point => [
      (values[2 * k] ?? 0) + ox,
      (values[2 * k + 1] ?? 0) + oy,
    ]);
    const [first = this.at, second = first, third = second] = points;
    const [value = 0] = values;
    if (kind === 'm') {
      this.#start = first;
      this.#go('m', first);
    } else if (kind === 'l') this.#go('l', first);
    else if (kind === 'h') this.#go('l', [value + ox, this.at[1]]);
    else if (kind === 'v') this.#go('l', [this.at[0], value + oy]);
    else if (kind === 'c') this.#curve(first, second, third);
    else if (kind === 's') this.#curve(this.#mirrored('cs'), first, second);
    else if (kind === 'q') this.#quadratic(first, second);
    else if (kind === 't') this.#quadratic(this.#mirrored('qt'), first);
    else if (kind === 'a') {
      const to = [(values[5] ?? 0) + ox, (values[6] ?? 0) + oy];
      this.steps.push(...arcSteps(this.at, [...values.slice(0, 5), ...to]));
      this.at = [to[0] ?? 0, to[1] ?? 0];
    } else {
      this.steps.push({kind: 'h', points: []});
      this.at = this.#start;
    }
    this.#before = kind;
  }

  #go(kind: 'm' | 'l', to: Point): void {
    this.steps.push({kind, points: [to]});
    this.at = to;
  }

  #curve(one: Point, two: Point, to: Point): void {
    this.steps.push({kind: 'c', points: [one, two, to]});
    this.#control = two;
    this.at = to;
  }

  #quadratic(control: Point, to: Point): void {
    const towardsControl = ([x, y]: Point): Point => [
      x + (2 / 3) * (control[0] - x),
      y + (2 / 3) * (control[1] - y),
    ];
    this.#curve(towardsControl(this.at), towardsControl(to), to);
    this.#control = control;
  }

  #mirrored(after: string): Point {
    const [x, y] = this.at;
    const isSmooth = this.#before !== '' && after.includes(this.#before);
    return isSmooth ? [2 * x - this.#control[0], 2 * y - this.#control[1]] : this.at;
  }
}

/** Reads path data; undefined if it is invalid. */
export function readPath(data: string): SvgPath | undefined {
  const pen = new Pen();
  let at = 0;
  const next = (pattern: RegExp): string | undefined => {
    pattern.lastIndex = at;
    const found = pattern.exec(data);
    if (found) at = pattern.lastIndex;
    return found?.[1];
  };
  let name = '';
  while (/[^\s,]/.test(data.slice(at))) {
    const said = next(command);
    // numbers without a command repeat the last one; after a move, they are lines
    name = said ?? (name === 'm' ? 'l' : name === 'M' ? 'L' : name);
    const count = counts[name.toLowerCase()];
    if (count === undefined || (said === undefined && count === 0)) return undefined;
    const values = Array.from({length: count}, (_, k) => {
      const isFlag = name.toLowerCase() === 'a' && (k === 3 || k === 4);
      return Number(next(isFlag ? flag : number));
    });
    if (!values.every(Number.isFinite)) return undefined;
    pen.draw(name, values);
  }
  return pen.steps;
}

export const carriedPath = (path: SvgPath, map: PlaneMap): SvgPath =>
  path.map(({kind, points}) => ({kind, points: points.map((p) => apply(map, p))}));
