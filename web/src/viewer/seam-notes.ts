/** What is written at seams: which are the worst, and whether the print runs on or is mirrored. */
import type {Point} from '../model/geometry.js';
import {chipColours, chipLayer, move, overlap, placeable, type Box} from './chips.js';
import {outsideOf} from './outside.js';
import type {PatternScene, SceneSeam} from './scene.js';
import {atShare, lineOf, type OnLine} from './seam-line.js';
import {toScreen, type ScreenSize, type SheetView} from './sheet-view.js';
import {inks, type Appearance} from './strokes.js';

/** No more seams than this get a rank, and none whose mean is less. */
const mostRanks = 3;
const leastMean = 0.1; // cm
/** From here on every seam shows its kind. [CSS px per cm] */
const glyphScale = 16;
/** [CSS px] */
const glyphSize = 18;
/** Of a rank, across; and from the edge to its middle, the nearest that is free of other things. [CSS px] */
const rankSize = 18;
const rankReaches = [17, 24, 34, 46];

interface Rank {
  readonly element: HTMLElement;
  /** Where the seam misses most, on its outer side. */
  readonly at: Point;
  readonly out: Point;
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

export class SeamNotes {
  readonly element = chipLayer();
  readonly #rankLayer = chipLayer();
  readonly #glyphLayer = chipLayer();
  #ranks: readonly Rank[] = [];
  #glyphs: readonly Glyph[] = [];
  #highlit: number | undefined;

  constructor() {
    this.element.append(this.#glyphLayer, this.#rankLayer);
  }

  show(scene: PatternScene, appearance: Appearance): void {
    this.#glyphs = scene.seams.flatMap((seam, number) => {
      if (!seam.counts) return [];
      return [seam.a, seam.b].map((side) => {
        const {element, ink} = glyph(appearance);
        return {element, ink, seam: number, ...atShare(lineOf(scene, side), 0.5)};
      });
    });
    this.#glyphLayer.replaceChildren(...this.#glyphs.map(({element}) => element));
    this.update(scene, appearance);
  }

  /** After the print has come to lie otherwise along the same seams. */
  update(scene: PatternScene, appearance: Appearance): void {
    for (const {seam, ink} of this.#glyphs) {
      const path = glyphPaths[scene.seams[seam]?.kind ?? 'continuous'];
      for (const stroke of ink) stroke.setAttribute('d', path);
    }
    const worst = scene.seams
      .filter(({counts, mean}) => counts && mean > leastMean)
      .sort((a, b) => b.mean - a.mean)
      .slice(0, mostRanks);
    this.#ranks = worst.flatMap((seam, k) => {
      const [from, to] = lineOf(scene, seam.a).slice(seam.worst.edge);
      if (!from || !to) return [];
      const side = outsideOf(scene.pieces[seam.a.piece], seam.a.vertices);
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
      return [
        {
          element: rankChip(k + 1, appearance),
          at: [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2],
          out: [(side * (to[1] - from[1])) / length, (side * (from[0] - to[0])) / length],
        },
      ];
    });
    this.#rankLayer.replaceChildren(...this.#ranks.map(({element}) => element));
  }

  /** Shows the kind of one seam at any zoom. */
  highlight(seam: number | undefined): void {
    this.#highlit = seam;
  }

  /** Follows the drawing; ranks stay clear of what is `taken`. */
  place(view: SheetView, size: ScreenSize, taken: readonly Box[]): void {
    const all = [...taken];
    for (const {element, at, out} of this.#ranks) {
      const [x, y] = toScreen(view, size, at);
      const box = rankReaches
        .map((reach) => squareAt([x + reach * out[0], y - reach * out[1]]))
        .find((place) => isWithin(place, size) && !all.some((other) => overlap(other, place)));
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

const squareAt = ([x, y]: Point): Box => ({
  left: x - rankSize / 2,
  top: y - rankSize / 2,
  right: x + rankSize / 2,
  bottom: y + rankSize / 2,
});

function rankChip(rank: number, appearance: Appearance): HTMLElement {
  const {text, paper} = chipColours[appearance];
  const element = placeable(document.createElement('span'), {
    boxSizing: 'border-box',
    width: `${rankSize}px`,
    height: `${rankSize}px`,
    borderRadius: '50%',
    background: text,
    color: paper,
    textAlign: 'center',
    font: `600 11px/${rankSize}px system-ui, sans-serif`,
  });
  element.textContent = String(rank);
  return element;
}
