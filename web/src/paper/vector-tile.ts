/**
 * Converts a simple SVG image of a print's cell to areas and lines; all prints of this project
 * qualify.
 */
import {colourOf, type Colour} from '../files/base/colours.js';
import {readXml, type XmlElement} from '../files/base/xml.js';
import {pathOf, stepsOf, type PathStep} from '../files/svg/paths.js';
import {propertiesOf} from '../files/svg/styles.js';
import {growth, hrefOf, lengthOf, numbersOf, transformOf} from '../files/svg/values.js';
import {FileError} from '../model/base/versioned-file.js';
import {after, apply, scaling, shifting, type PlaneMap} from '../model/geometry/plane-map.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';

interface Stroke {
  readonly colour: Colour;
  readonly width: number;
  readonly cap: number;
  readonly join: number;
  readonly dash: readonly number[];
}

/** An area or line drawn in one operation. */
export interface Leaf {
  readonly path: readonly PathStep[];
  readonly fill?: Colour;
  readonly isEvenOdd: boolean;
  readonly stroke?: Stroke;
  /** Bounding box. */
  readonly box: Box;
}

/** Leaves that share one opacity as a group. */
interface LeafGroup {
  readonly opacity: number;
  readonly leaves: Leaf[];
}

/** Limits that exceed the needs of any print, and stop files with multiplying uses. */
const mostLeaves = 20_000;
const deepest = 30;

class Unknown extends Error {
  override readonly name = 'Unknown';
}

/** Inherited properties of an element. */
type Style = ReadonlyMap<string, string>;

const inherited = [
  ...['fill', 'fill-rule', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-opacity'],
  ...['stroke-linecap', 'stroke-linejoin', 'stroke-dasharray', 'visibility', 'color'],
];
/** Elements whose content is not drawn in place. */
const unseen = new Set(['defs', 'title', 'desc', 'metadata', 'namedview']);
const containers = new Set(['svg', 'g', 'a']);
/** Attributes that only browsers support. */
const beyond = ['clip-path', 'mask', 'filter', 'mix-blend-mode'];

/** The elements within another, without its text. */
const elementsIn = ({children}: XmlElement): XmlElement[] =>
  children.filter((child) => typeof child !== 'string');

/** The attributes of an element; the declarations of its `style` come before them. */
const declaredBy = ({attributes}: XmlElement): Style =>
  new Map([...attributes, ...Object.entries(propertiesOf(attributes.get('style') ?? ''))]);

class Reader {
  readonly groups: LeafGroup[] = [];
  readonly #named = new Map<string, XmlElement>();
  readonly #size: readonly [number, number];
  #count = 0;
  /** The current group, whose opacity applies to all of its leaves. */
  #group: LeafGroup | undefined;

  constructor(root: XmlElement, size: readonly [number, number]) {
    this.#size = size;
    this.#collect(root, 0);
  }

  #collect(element: XmlElement, depth: number): void {
    if (depth > deepest) throw new Unknown();
    const id = element.attributes.get('id');
    if (id !== undefined) this.#named.set(id, element);
    for (const child of elementsIn(element)) this.#collect(child, depth + 1);
  }

  draw(element: XmlElement, above: PlaneMap, outer: Style, depth = 0): void {
    const {name} = element;
    const attributes = declaredBy(element);
    if (unseen.has(name) || attributes.get('display') === 'none') return;
    if (depth > deepest || beyond.some((key) => (attributes.get(key) ?? 'none') !== 'none')) {
      throw new Unknown();
    }
    const style = new Map(outer);
    for (const key of inherited) {
      const said = attributes.get(key);
      if (said !== undefined && said !== 'inherit') style.set(key, said);
    }
    const own = transformOf(attributes.get('transform'));
    if (!own) throw new Unknown();
    const map = after(above, own);
    this.#through(Number(attributes.get('opacity') ?? 1), () => {
      if (containers.has(name) && (name !== 'svg' || depth === 0)) {
        for (const child of elementsIn(element)) this.draw(child, map, style, depth + 1);
      } else if (name === 'use') {
        const target = this.#named.get(hrefOf(element).slice(1));
        if (!target) throw new Unknown();
        const [x = 0, y = 0] = (['x', 'y'] as const).map(
          (key, k) => lengthOf(attributes.get(key), this.#size[k] ?? 0) ?? 0,
        );
        this.draw(target, after(map, shifting(x, y)), style, depth + 1);
      } else this.#shape(element, map, style);
    });
  }

  /**
   * Draws one element with an opacity. Nested opacities are unsupported, since they would need
   * separate groups.
   */
  #through(opacity: number, draw: () => void): void {
    if (!(opacity >= 0 && opacity <= 1)) throw new Unknown();
    if (opacity === 1) {
      draw();
      return;
    }
    if (this.#group && this.#group.opacity < 1) throw new Unknown();
    this.#group = {opacity, leaves: []};
    this.groups.push(this.#group);
    draw();
    this.#group = undefined;
  }

  #shape(element: XmlElement, map: PlaneMap, style: Style): void {
    const data = pathOf(element, this.#size);
    if (data === undefined) throw new Unknown();
    const {steps, isDamaged} = stepsOf(data);
    if (isDamaged) throw new Unknown();
    if (style.get('visibility') === 'hidden') return;
    const fill = colourOf(style.get('fill') ?? 'black');
    const drawn = colourOf(style.get('stroke') ?? 'none');
    if (fill === undefined || drawn === undefined) throw new Unknown();
    const stroke = drawn && strokeOf(drawn, style, growth(map));
    const [filled, lined] = ['fill-opacity', 'stroke-opacity'].map((key) =>
      Number(style.get(key) ?? 1),
    );
    const opacity = fill ? filled : lined;
    if (fill && stroke && filled !== lined) throw new Unknown();
    const carried = steps.map(({kind, points}) => ({
      kind,
      points: points.map((p) => apply(map, p)),
    }));
    this.#through(opacity ?? 1, () => {
      this.#add({
        path: carried,
        isEvenOdd: style.get('fill-rule') === 'evenodd',
        box: boxAround(carried, stroke ? stroke.width : 0),
        ...(fill && {fill}),
        ...(stroke && {stroke}),
      });
    });
  }

  #add(leaf: Leaf): void {
    if (++this.#count > mostLeaves) throw new Unknown();
    if (leaf.path.length === 0 || !(leaf.fill || leaf.stroke)) return;
    if (!this.#group) {
      this.#group = {opacity: 1, leaves: []};
      this.groups.push(this.#group);
    }
    this.#group.leaves.push(leaf);
  }
}

function strokeOf(colour: Colour, style: Style, scale: number): Stroke {
  const width = (lengthOf(style.get('stroke-width'), NaN) ?? 1) * scale;
  const dash = numbersOf(style.get('stroke-dasharray')).map((part) => part * scale);
  if (!(width >= 0)) throw new Unknown();
  return {
    ...{colour, width, dash},
    cap: Math.max(0, ['butt', 'round', 'square'].indexOf(style.get('stroke-linecap') ?? 'butt')),
    join: Math.max(0, ['miter', 'round', 'bevel'].indexOf(style.get('stroke-linejoin') ?? 'miter')),
  };
}

function boxAround(path: readonly PathStep[], more: number): Box {
  const {low, high} = boxOf(path.flatMap(({points}) => points));
  return {low: [low[0] - more, low[1] - more], high: [high[0] + more, high[1] + more]};
}

/**
 * Stretches the image over a cell, from its lower left corner, y up; undefined for an SVG with more
 * than simple shapes in plain colours. [cm]
 */
export function vectorTile(
  svg: string,
  width: number,
  height: number,
): readonly LeafGroup[] | undefined {
  try {
    const {root} = readXml(svg, 'print');
    if (root.name !== 'svg') return undefined;
    const side = (name: string): number => lengthOf(root.attributes.get(name), NaN) ?? NaN;
    const box = root.attributes.get('viewBox');
    const [x = 0, y = 0, w = NaN, h = NaN] =
      box === undefined ? [0, 0, side('width'), side('height')] : numbersOf(box);
    if (!(w > 0 && h > 0)) return undefined;
    const flipped = after(shifting(0, height), scaling(width / w, -height / h));
    const reader = new Reader(root, [w, h]);
    reader.draw(root, after(flipped, shifting(-x, -y)), new Map());
    return reader.groups;
  } catch (cause) {
    // the browser draws what is beyond this reader, or damaged
    if (cause instanceof Unknown || cause instanceof FileError) return undefined;
    throw cause;
  }
}
