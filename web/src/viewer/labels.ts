/**
 * Names of pieces and letters of pairs as HTML over the drawing, so that they are text and always
 * legible.
 */
import type {Point} from '../model/geometry/vectors.js';
import {boxOf} from '../model/geometry/polyline.js';
import {chipColours, chipLayer, move, overlap, placeable, type Box} from './chips.js';
import type {Overlay} from '../scene/overlay.js';
import {onSheet} from './overlay-strokes.js';
import {labelLines, labelSize, type PatternScene} from '../scene/scene.js';
import {toScreen, type ScreenSize, type SheetView} from '../scene/sheet-view.js';
import {placed, type Appearance} from './strokes.js';

interface Name {
  readonly element: HTMLElement;
  /** Corners of the piece on the sheet. [cm] */
  readonly low: Point;
  readonly high: Point;
  readonly width: number;
  readonly height: number;
}

interface Letter {
  readonly element: HTMLElement;
  /** Letter of the pair. */
  readonly pair: string;
  readonly piece: number;
  readonly at: Point;
  readonly room: number;
}

/** [CSS px] */
const letterSize = 24;
const leastLetterSize = 15;
const gap = 6;
/** Least height of a piece that carries its name, as a multiple of the name's height. */
const leastCover = 4;

const clamp = (value: number, low: number, high: number): number =>
  Math.max(low, Math.min(value, high));

const padding = {x: 5, y: 1};
const nameFont = {weight: 500, leading: 1.25, family: 'system-ui, sans-serif'};

/**
 * Measures text on a separate canvas: measuring elements would trigger a layout of the whole page.
 * [CSS px]
 */
function sizeOf(lines: readonly string[]): ScreenSize {
  const context = (measuring ??= document.createElement('canvas').getContext('2d'));
  if (context) context.font = `${nameFont.weight} ${labelSize}px ${nameFont.family}`;
  const widths = lines.map((line) => context?.measureText(line).width ?? 0);
  return {
    width: Math.ceil(Math.max(...widths)) + 2 * padding.x,
    height: lines.length * labelSize * nameFont.leading + 2 * padding.y,
  };
}

let measuring: CanvasRenderingContext2D | null | undefined;

export class Labels {
  readonly element = chipLayer();
  #appearance: Appearance;
  #names: readonly Name[] = [];
  #letters: readonly Letter[] = [];
  #overlay: Overlay | undefined;

  constructor(appearance: Appearance) {
    this.#appearance = appearance;
  }

  show(scene: PatternScene, appearance: Appearance): void {
    this.#appearance = appearance;
    const names = scene.pieces.map((piece) =>
      this.#label(labelLines(piece.label).join('\n'), 'name'),
    );
    const letters = scene.symmetries.flatMap((symmetry) => {
      if (symmetry.kind === 'piece') return [];
      return symmetry.marks.map(({piece, at, room}): Letter => {
        return {
          element: this.#label(symmetry.letter, 'letter'),
          ...{pair: symmetry.letter, piece},
          at: onSheet(scene, piece, at),
          room,
        };
      });
    });
    this.element.replaceChildren(...letters.map(({element}) => element), ...names);
    this.#letters = letters;
    this.highlight(this.#overlay);
    this.#names = scene.pieces
      .map((piece, k): Name => {
        const element = names[k] ?? this.#label('', 'name');
        const {low, high} = boxOf(placed(piece, piece.outline));
        return {element, low, high, ...sizeOf(labelLines(piece.label))};
      })
      // the larger piece keeps its name if two names collide
      .sort((a, b) => b.high[1] - b.low[1] - (a.high[1] - a.low[1]));
  }

  /** Shows the letters of the pair that is pointed at or selected, or of all while they are chosen. */
  highlight(overlay: Overlay | undefined): void {
    this.#overlay = overlay;
    const {allPairs = false, hoverPiece, selectPiece} = overlay ?? {};
    const pairs = this.#letters
      .filter(({piece}) => piece === hoverPiece || piece === selectPiece)
      .map(({pair}) => pair);
    for (const {element, pair} of this.#letters)
      element.style.display = allPairs || pairs.includes(pair) ? '' : 'none';
  }

  /** Moves names and letters to a view. */
  place(view: SheetView, size: ScreenSize): void {
    const pieces = this.#names.map(({low, high}) => screenBox(view, size, low, high));
    const names: Box[] = [];
    this.#names.forEach(({element, width, height}, k) => {
      const others = [...names, ...pieces.filter((_, other) => other !== k)];
      const box = places(pieces[k], {width, height}, size).find(
        (place) => !others.some((other) => overlap(other, place)),
      );
      if (box) names.push(box);
      move(element, box && [box.left, box.top]);
      element.style.background = box?.onPiece ? chipColours[this.#appearance].paper : '';
    });
    for (const {element, at, room} of this.#letters) {
      const [x, y] = toScreen(view, size, at);
      // a letter as large as its piece would hide it
      const wide = Math.min(letterSize, 1.5 * room * view.scale);
      const isShown = wide >= leastLetterSize;
      const [left, top] = [x - letterSize / 2, y - letterSize / 2];
      move(element, isShown ? [left, top] : undefined, `scale(${(wide / letterSize).toFixed(2)})`);
    }
  }

  #label(text: string, kind: 'name' | 'letter'): HTMLElement {
    const {text: colour, paper, ring} = chipColours[this.#appearance];
    const element = placeable(document.createElement('span'), {
      boxSizing: 'border-box',
      color: colour,
      textAlign: 'center',
    });
    element.textContent = text;
    Object.assign(
      element.style,
      kind === 'name'
        ? {
            whiteSpace: 'pre',
            padding: `${padding.y}px ${padding.x}px`,
            borderRadius: '4px',
            font: `${nameFont.weight} ${labelSize}px/${nameFont.leading} ${nameFont.family}`,
          }
        : {
            width: `${letterSize}px`,
            height: `${letterSize}px`,
            borderRadius: '50%',
            border: `1px solid ${ring}`,
            background: paper,
            font: `600 13px/${letterSize - 2}px system-ui, sans-serif`,
          },
    );
    return element;
  }
}

const screenBox = (view: SheetView, size: ScreenSize, low: Point, high: Point): Box => {
  const [left, bottom] = toScreen(view, size, low);
  const [right, top] = toScreen(view, size, high);
  return {left, top, right, bottom};
};

/**
 * Returns the possible places of a name, the best first: below its piece, or at the foot of its
 * visible part.
 */
function places(
  piece: Box | undefined,
  {width, height}: ScreenSize,
  size: ScreenSize,
): readonly (Box & {readonly onPiece: boolean})[] {
  if (!piece || !overlap(piece, {left: 0, top: 0, right: size.width, bottom: size.height})) {
    return [];
  }
  // the name stays on the visible part of a piece that is larger than the screen
  const from = Math.max(piece.left, 0) + gap;
  const to = Math.min(piece.right, size.width) - gap;
  const middle = (piece.left + piece.right) / 2;
  const fits = to - from > width;
  const x = fits ? clamp(middle, from + width / 2, to - width / 2) : middle;
  const at = (top: number, onPiece: boolean): Box & {readonly onPiece: boolean} => ({
    ...{left: x - width / 2, top, right: x + width / 2, bottom: top + height},
    onPiece,
  });
  if (x < width / 2 || x > size.width - width / 2) return [];
  const below = piece.bottom + gap;
  const foot = Math.min(piece.bottom, size.height) - gap - height;
  return [
    ...(below + height <= size.height ? [at(below, false)] : []),
    ...(fits && foot > piece.top && piece.bottom - piece.top > leastCover * height
      ? [at(foot, true)]
      : []),
  ];
}
