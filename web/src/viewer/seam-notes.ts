/** Notes at seams: whether the print continues or is mirrored. */
import {angleOf, type Point} from '../model/geometry/vectors.js';
import {chipLayer, move, placeable} from './chips.js';
import {lineOf, type PatternScene, type SceneSeam} from '../scene/scene.js';
import {atShare, type OnLine} from '../model/geometry/polyline.js';
import {toScreen, type ScreenSize, type SheetView} from '../scene/sheet-view.js';
import {inks, type Appearance} from './strokes.js';

/** Least scale at which all seams show their kind. [CSS px per cm] */
const glyphScale = 16;
/** [CSS px] */
const glyphSize = 18;

interface Glyph extends OnLine {
  readonly element: SVGElement;
  readonly seam: number;
  readonly ink: readonly SVGElement[];
}

/** Glyphs across a seam along x: two strokes over it, or two arrow heads that meet at it. */
const glyphPaths: Readonly<Record<SceneSeam['kind'], string>> = {
  continuous: 'M6.5 4V14M11.5 4V14',
  mirrored: 'M5 3L9 7.5L13 3M5 15L9 10.5L13 15',
};

export class SeamNotes {
  readonly element = chipLayer();
  readonly #glyphLayer = chipLayer();
  #glyphs: readonly Glyph[] = [];
  #highlit: number | undefined;

  constructor() {
    this.element.append(this.#glyphLayer);
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
    this.update(scene);
  }

  /** Updates the notes after alignments change along the same seams. */
  update(scene: PatternScene): void {
    for (const {seam, ink} of this.#glyphs) {
      const path = glyphPaths[scene.seams[seam]?.kind ?? 'continuous'];
      for (const stroke of ink) stroke.setAttribute('d', path);
    }
  }

  /** Shows the kind of one seam at any zoom. */
  highlight(seam: number | undefined): void {
    this.#highlit = seam;
  }

  /** Moves the notes to a view. */
  place(view: SheetView, size: ScreenSize): void {
    const isNear = view.scale >= glyphScale;
    this.#glyphLayer.style.display = isNear || this.#highlit !== undefined ? '' : 'none';
    if (this.#glyphLayer.style.display === 'none') return;
    for (const {element, seam, at, along} of this.#glyphs) {
      const [x, y] = toScreen(view, size, at);
      const isShown = isNear || seam === this.#highlit;
      const turn = angleOf([along[0], -along[1]]);
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
