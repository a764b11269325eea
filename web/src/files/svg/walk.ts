/** Walks an SVG, and resolves groups, transforms, uses and styles to final positions and sizes. */
import {after, apply, scaling, shifting, type PlaneMap} from '../../model/geometry/plane-map.js';
import {minus, unit, type Point} from '../../model/geometry/vectors.js';
import {FileError} from '../../model/base/versioned-file.js';
import type {XmlElement} from '../base/xml.js';
import {linesOf, type Line} from './lines.js';
import {fitOf, growth, hrefOf, isFlat, lengthOf, numbersOf, transformOf} from './values.js';
import {initialStyle, sheetOf, styleOf, type Style, type StyleSheet} from './styles.js';

/** The lines of an element. */
export interface Drawn {
  readonly element: XmlElement;
  /** The enclosing groups, from the root inwards. */
  readonly groups: readonly XmlElement[];
  readonly style: Style;
  readonly lines: readonly Line[];
  /** True if it is drawn through a `use`. */
  readonly isUsed: boolean;
  /** True for the straight line of an arrow. */
  readonly isArrow?: boolean;
  /** Facts that other formats state. */
  readonly hints?: Hints;
}

/** Facts of a line that SVG does not state. */
interface Hints {
  /** The role by the name of its layer or class. */
  readonly stated?: 'piece' | 'sewn line' | 'cut-out' | 'mark';
  /** Key of the style: colour, width, dashes and layer. */
  readonly style: string;
}

export interface DrawnText {
  readonly element: XmlElement;
  readonly groups: readonly XmlElement[];
  /** One entry per line. */
  readonly lines: readonly string[];
  readonly at: Point;
  /** Direction of the baseline, of length 1. */
  readonly along: Point;
  /** Letter height. [mm] */
  readonly size: number;
}

/** A placed symbol. */
interface DrawnSymbol {
  /** The id of the symbol. */
  readonly of: string;
  readonly groups: readonly XmlElement[];
  readonly at: Point;
}

/** A walked SVG in mm, y up. */
export interface Sheet {
  readonly drawn: readonly Drawn[];
  readonly texts: readonly DrawnText[];
  readonly symbols: readonly DrawnSymbol[];
  readonly notes: readonly string[];
  /** Width and height of the view box; 0 if missing. */
  readonly page: Point;
  /** The program that wrote the file, if stated. */
  readonly program?: string;
}

type Contents = Omit<Sheet, 'page' | 'program'>;

const unseen = new Set([
  ...['defs', 'symbol', 'clipPath', 'mask', 'pattern', 'marker', 'linearGradient', 'filter'],
  ...[
    'radialGradient',
    'metadata',
    'title',
    'desc',
    'style',
    'script',
    'namedview',
    'foreignObject',
  ],
]);

/** Greatest number of shapes, far above a pattern of many sizes. */
const mostDrawn = 60_000;
/** Greatest length of path data, about ten thousand points. [characters] */
const longestPath = 300_000;
/** Greatest coordinate, larger than any length of fabric. [mm] */
const furthest = 1e5;
/** Greatest nesting depth of uses. */
const mostUses = 16;

/** The context of a group's children. */
interface Place {
  readonly map: PlaneMap;
  readonly style: Style;
  readonly groups: readonly XmlElement[];
  readonly uses: number;
  /** Width and height of the innermost view. */
  readonly view: Point;
}

/**
 * Walks the file.
 * @param map map from root units to millimetres, y up
 * @throws {FileError} if it is invalid or too large
 */
export function walked(root: XmlElement, map: PlaneMap, file: string): Contents {
  const walk = new Walk(root, file);
  const style = styleOf(root, initialStyle, walk.sheet) ?? initialStyle;
  walk.children(root, {map, style, groups: [], uses: 0, view: insideOf(root, [0, 0])});
  return walk.result();
}

class Walk {
  readonly sheet: StyleSheet;
  readonly #file: string;
  readonly #byId = new Map<string, XmlElement>();
  readonly #drawn: Drawn[] = [];
  readonly #texts: DrawnText[] = [];
  readonly #symbols: DrawnSymbol[] = [];
  readonly #notes = new Set<string>();
  #count = 0;

  constructor(root: XmlElement, file: string) {
    this.#file = file;
    const styles: string[] = [];
    this.#index(root, styles);
    this.sheet = sheetOf(styles);
  }

  result(): Contents {
    return {
      drawn: this.#drawn,
      texts: this.#texts,
      symbols: this.#symbols,
      notes: [...this.#notes],
    };
  }

  #index(element: XmlElement, styles: string[]): void {
    const id = element.attributes.get('id');
    if (id !== undefined && !this.#byId.has(id)) this.#byId.set(id, element);
    if (element.name === 'style') styles.push(textOf(element));
    if (element.name === 'script') this.#notes.add('Scripts in the file are not run.');
    for (const child of element.children) if (typeof child !== 'string') this.#index(child, styles);
  }

  children(element: XmlElement, place: Place): void {
    for (const child of element.children)
      if (typeof child !== 'string') this.#element(child, place);
  }

  #element(element: XmlElement, around: Place): void {
    if (unseen.has(element.name)) return;
    if (++this.#count > mostDrawn) {
      throw new FileError(
        this.#file,
        `draws more than ${mostDrawn} shapes, as a picture does and no pattern; delete all but the outlines and their marks.`,
        {reason: 'complex'},
      );
    }
    const style = styleOf(element, around.style, this.sheet);
    if (!style) return;
    const map = after(around.map, this.#transformOf(element));
    const {uses, view} = around;
    const place = {map, style, groups: [...around.groups, element], uses, view};
    if (element.name === 'use') this.#use(element, place);
    else if (element.name === 'svg')
      this.children(element, {
        ...place,
        map: after(map, viewOf(element, view)),
        view: insideOf(element, view),
      });
    else if (element.name === 'text') this.#text(element, around.groups, place);
    else if (element.name === 'image') this.#notes.add('Pictures in the file are left out.');
    else this.#shape(element, around.groups, place);
  }

  #shape(
    element: XmlElement,
    groups: readonly XmlElement[],
    {map, style, uses, view, ...place}: Place,
  ): void {
    if ((element.attributes.get('d')?.length ?? 0) > longestPath) this.#refusePath(element);
    const shape = linesOf(element, map, view);
    if (!shape) {
      this.children(element, {map, style, uses, view, ...place});
      return;
    }
    const id = element.attributes.get('id') ?? element.name;
    if (shape.isDamaged)
      this.#notes.add(`The path '${id}' is damaged, and read as far as it goes.`);
    if (style.isHidden || shape.lines.length === 0) return;
    if (isFlat(map)) {
      throw new FileError(
        this.#file,
        `flattens '${id}' to a line by its transform; correct the transform, or delete it.`,
      );
    }
    this.#check(shape.lines, id);
    this.#drawn.push({element, groups, style, lines: shape.lines, isUsed: uses > 0});
  }

  #refusePath({attributes}: XmlElement): never {
    throw new FileError(
      this.#file,
      `draws '${attributes.get('id') ?? 'a path'}' through more points than any outline has; simplify it.`,
      {reason: 'complex'},
    );
  }

  #check(lines: readonly Line[], id: string): void {
    const isSane = (value: number): boolean => Math.abs(value) <= furthest; // false for NaN, too
    for (const {start, cubics} of lines) {
      if ([start, ...cubics.flat()].every(([x, y]) => isSane(x) && isSane(y))) continue;
      throw new FileError(
        this.#file,
        `draws '${id}' more than 100 m away; delete it, or correct its numbers.`,
      );
    }
  }

  #use(element: XmlElement, place: Place): void {
    const href = hrefOf(element);
    const id = href.slice(1);
    const [x = 0, y = 0] = ['x', 'y'].map(
      (name, k) => lengthOf(element.attributes.get(name), place.view[k] ?? 0) ?? 0,
    );
    const map = after(place.map, shifting(x, y));
    const target = this.#byId.get(id);
    if (!href.startsWith('#') || !target) {
      this.#notes.add(`What is used from '${href}' is not in the file, and left out.`);
      return;
    }
    if (place.uses >= mostUses) {
      throw new FileError(this.#file, `uses '${id}' within itself; delete that use.`);
    }
    this.#symbols.push({of: id, groups: place.groups, at: apply(map, [0, 0])});
    const inner = {...place, map, uses: place.uses + 1};
    if (target.name === 'symbol')
      this.children(target, {
        ...inner,
        map: after(map, viewOf(target, place.view)),
        view: insideOf(target, place.view),
      });
    else this.#element(target, inner);
  }

  #text(element: XmlElement, groups: readonly XmlElement[], {map, style}: Place): void {
    const lines = linesOfText(element);
    const first = [element, ...element.children.filter((one) => typeof one !== 'string')];
    const [x = 0, y = 0] = ['x', 'y'].map(
      (name) => first.flatMap(({attributes}) => numbersOf(attributes.get(name)))[0] ?? 0,
    );
    if (style.isHidden || lines.length === 0) return;
    const size = style.fontSize * growth(map);
    const at = apply(map, [x, y]);
    const along = unit(minus(apply(map, [x + 1, y]), at));
    this.#texts.push({element, groups, lines, at, along, size});
  }

  #transformOf(element: XmlElement): PlaneMap {
    const transform = element.attributes.get('transform');
    const map = transformOf(transform);
    if (map) return map;
    throw new FileError(
      this.#file,
      `has a transform that cannot be read, '${(transform ?? '').slice(0, 60)}'; correct it.`,
    );
  }
}

/** Width and height of the view inside an `svg` or `symbol`, in its own units. */
function insideOf({attributes}: XmlElement, around: Point): Point {
  const [, , across = 0, down = 0] = numbersOf(attributes.get('viewBox'));
  if (across > 0 && down > 0) return [across, down];
  const side = (name: string, whole: number): number =>
    lengthOf(attributes.get(name), whole) ?? whole;
  return [side('width', around[0]), side('height', around[1])];
}

/** The map from the view box of a nested `svg` or `symbol` to its parent. */
function viewOf({attributes}: XmlElement, around: Point): PlaneMap {
  const at = (name: string, whole: number): number | undefined =>
    lengthOf(attributes.get(name), whole);
  const box = numbersOf(attributes.get('viewBox'));
  const [left = 0, top = 0, across = 0, down = 0] = box;
  const place = shifting(at('x', around[0]) ?? 0, at('y', around[1]) ?? 0);
  if (!(across > 0 && down > 0)) return place;
  const [width, height] = [at('width', around[0]) ?? across, at('height', around[1]) ?? down];
  const [x, y] = fitOf(attributes.get('preserveAspectRatio'), width / across, height / down);
  const middle = shifting((width - x * across) / 2, (height - y * down) / 2);
  return after(after(place, middle), after(scaling(x, y), shifting(-left, -top)));
}

/** The whole text of an element, unchanged. */
const textOf = (element: XmlElement): string =>
  element.children.map((child) => (typeof child === 'string' ? child : textOf(child))).join('');

/** The lines of a text, which begin at parts with their own vertical position. */
function linesOfText(element: XmlElement): string[] {
  const lines: string[] = [''];
  let height: string | undefined = element.attributes.get('y');
  const write = (part: XmlElement): void => {
    for (const child of part.children) {
      if (typeof child === 'string') {
        lines.push(`${lines.pop() ?? ''}${child}`);
        continue;
      }
      const y = child.attributes.get('y');
      const isLower = (numbersOf(child.attributes.get('dy'))[0] ?? 0) !== 0;
      if (isLower || (y !== undefined && y !== height)) lines.push('');
      height = y ?? height;
      write(child);
    }
  };
  write(element);
  return lines.map((line) => line.replaceAll(/\s+/g, ' ').trim()).filter((line) => line !== '');
}
