/** What is written at seams: how far the worst ones miss, and whether the print runs on or is mirrored. */
import type {Point} from '../model/geometry.js';
import {textWidth} from '../picture/svg.js';
import {chipLayer, move, overlap, placeable, textChip, type Box} from './chips.js';
import type {PatternScene, SceneSeam} from './scene.js';
import {atShare, lineOf, type OnLine} from './seam-line.js';
import {toScreen, type ScreenSize, type SheetView} from './sheet-view.js';
import {inks, type Appearance} from './strokes.js';

/** No more seams than this get a number, and none whose mean is less. */
const mostNumbers = 3;
const leastNumber = 0.1; // cm
/** From here on every seam shows its kind. [CSS px per cm] */
const glyphScale = 16;
/** [CSS px] */
const glyphSize = 18;
const numberReach = 12;

interface Numbered {
  readonly element: HTMLElement;
  readonly at: Point;
  readonly width: number;
  readonly height: number;
}

interface Glyph extends OnLine {
  readonly element: SVGElement;
  readonly seam: number;
  readonly ink: readonly SVGElement[];
}

/** Across a seam that runs along x: two strokes over it, or two arrow heads that meet at it. */
const glyphPaths: Readonly<Record<SceneSeam['kind'], string>> = {
  continuous: 'M6.5 4V14M11.5 4V14',
  mirrored: 'M5 3L9 7.5L13 3M5 15L9 10.5L13 15',
};

/** 3.4 mm, or whatever the page makes of it. */
export type LengthText = (cm: number) => string;
export const millimetres: LengthText = (cm) => `${(10 * cm).toFixed(cm < 1 ? 1 : 0)} mm`;

export class SeamNotes {
  readonly element = chipLayer();
  readonly #numberLayer = chipLayer();
  readonly #glyphLayer = chipLayer();
  #numbers: readonly Numbered[] = [];
  #glyphs: readonly Glyph[] = [];
  #highlit: number | undefined;

  constructor() {
    this.element.append(this.#glyphLayer, this.#numberLayer);
  }

  show(scene: PatternScene, appearance: Appearance, lengthText: LengthText): void {
    this.#glyphs = scene.seams.flatMap((seam, number) => {
      if (!seam.counts) return [];
      return [seam.a, seam.b].map((side) => {
        const {element, ink} = glyph(appearance);
        return {element, ink, seam: number, ...atShare(lineOf(scene, side), 0.5)};
      });
    });
    this.#glyphLayer.replaceChildren(...this.#glyphs.map(({element}) => element));
    this.update(scene, appearance, lengthText);
  }

  /** After the print has come to lie otherwise along the same seams. */
  update(scene: PatternScene, appearance: Appearance, lengthText: LengthText): void {
    for (const {seam, ink} of this.#glyphs) {
      const path = glyphPaths[scene.seams[seam]?.kind ?? 'continuous'];
      for (const stroke of ink) stroke.setAttribute('d', path);
    }
    const worst = scene.seams
      .filter(({counts, mean}) => counts && mean > leastNumber)
      .sort((a, b) => b.mean - a.mean)
      .slice(0, mostNumbers);
    const texts = worst.map((seam) => lengthText(seam.worst.mismatch));
    const chips = texts.map((text) => textChip(text, appearance));
    this.#numberLayer.replaceChildren(...chips);
    this.#numbers = worst.flatMap((seam, k) => {
      const element = chips[k];
      const [from, to] = lineOf(scene, seam.a).slice(seam.worst.edge);
      if (!element || !from || !to) return [];
      const at: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
      // not measured: that would lay the whole page out while answers stream in
      return [{element, at, width: 16 + textWidth(texts[k] ?? '', 11), height: 18}];
    });
  }

  /** Shows the kind of one seam at any zoom. */
  highlight(seam: number | undefined): void {
    this.#highlit = seam;
  }

  /** Follows the drawing; numbers stay clear of what is `taken`. */
  place(view: SheetView, size: ScreenSize, taken: readonly Box[]): void {
    const all = [...taken];
    for (const {element, at, width, height} of this.#numbers) {
      const box = around(toScreen(view, size, at), width, height).find(
        (place) => isWithin(place, size) && !all.some((other) => overlap(other, place)),
      );
      if (box) all.push(box);
      move(element, box && [box.left, box.top]);
    }
    const isNear = view.scale >= glyphScale;
    this.#glyphLayer.style.display = isNear || this.#highlit !== undefined ? '' : 'none';
    if (this.#glyphLayer.style.display === 'none') return;
    for (const {element, seam, at, along} of this.#glyphs) {
      const [x, y] = toScreen(view, size, at);
      const isShown = isNear || seam === this.#highlit;
      const turn = Math.atan2(-along[1], along[0]);
      const corner: Point = [x - glyphSize / 2, y - glyphSize / 2];
      move(element, isShown ? corner : undefined, `rotate(${turn.toFixed(3)}rad)`);
    }
  }
}

function glyph(appearance: Appearance): {element: SVGElement; ink: readonly SVGElement[]} {
  const create = (name: string): SVGElement =>
    document.createElementNS('http://www.w3.org/2000/svg', name);
  const element = placeable(create('svg'), {
    width: `${glyphSize}px`,
    height: `${glyphSize}px`,
    visibility: 'hidden',
  });
  element.setAttribute('viewBox', '0 0 18 18');
  const {casing, mark} = inks[appearance];
  const ink = (
    [
      [casing, 5],
      [mark, 1.8],
    ] as const
  ).map(([colour, width]) => {
    const path = create('path');
    Object.assign(path.style, {
      fill: 'none',
      stroke: `rgb(${colour.join(' ')})`,
      strokeWidth: `${width}px`,
      strokeLinecap: 'round',
      strokeLinejoin: 'round',
    });
    return path;
  });
  element.append(...ink);
  return {element, ink};
}

const isWithin = ({left, top, right, bottom}: Box, {width, height}: ScreenSize): boolean =>
  left >= 0 && top >= 0 && right <= width && bottom <= height;

/** Places beside a point. */
function around([x, y]: Point, width: number, height: number): readonly Box[] {
  const at = (dx: number, dy: number): Box => {
    const left = x + dx * (numberReach + width / 2) - width / 2;
    const top = y + dy * (numberReach + height / 2) - height / 2;
    return {left, top, right: left + width, bottom: top + height};
  };
  return [at(1, 0), at(-1, 0), at(0, -1), at(0, 1), at(1, -1), at(-1, -1), at(1, 1), at(-1, 1)];
}
