/**
 * The words of an overlay: names of marked points, letters of the highlighted seam and of found
 * pairs, and messages.
 */
import type {Point} from '../model/geometry/vectors.js';
import {seamLetter} from '../model/garment/letters.js';
import {chipColours, chipLayer, move, placeable, textChip} from './chips.js';
import {outsideOf} from './outside.js';
import {onSheet} from './overlay-strokes.js';
import type {Overlay, Sign} from '../scene/overlay.js';
import {lineOf, type PatternScene} from '../scene/scene.js';
import {atShare} from '../model/geometry/polyline.js';
import {wayOnSheet} from '../model/geometry/sheet-place.js';
import {toScreen, type ScreenSize, type SheetView} from '../scene/sheet-view.js';
import {inks, type Appearance} from './strokes.js';

interface Chip {
  readonly element: HTMLElement;
  /** Point on the sheet. [cm] */
  readonly at: Point;
  /** Offset of the middle from `at`, as a share of the size and in px. */
  readonly off: {readonly share: Point; readonly by: Point};
}

/** Distance from a point to its text. [CSS px] */
const reach = 10;
const letterSize = 20;
/** Distance from a seam to the middle of its letter. [CSS px] */
const letterReach = 18;

export class OverlayChips {
  readonly element = chipLayer();
  #chips: readonly Chip[] = [];
  #message: HTMLElement | undefined;

  show(scene: PatternScene, overlay: Overlay, appearance: Appearance): void {
    const {points = [], ghosts = [], signs = [], badges = [], message} = overlay;
    const beside = {share: [0, -0.5], by: [reach, 0]} as const;
    const named = points.flatMap(({piece, point, label}): Chip[] =>
      label === undefined
        ? []
        : [{element: textChip(label, appearance), at: onSheet(scene, piece, point), off: beside}],
    );
    const letters = ghosts.flatMap((ghost) =>
      ghost.kind === 'piece'
        ? []
        : ghost.marks.map(({piece, at}): Chip => ({
            element: ghostLetter(ghost.letter, appearance),
            at: onSheet(scene, piece, at),
            off: {share: [-0.5, -0.5], by: [0, 0]},
          })),
    );
    const sewn = lettersOf(scene, overlay.highlight?.seam).map(({letter, at, inwards}): Chip => ({
      element: textChip(letter, appearance),
      at,
      off: {share: [-0.5, -0.5], by: [letterReach * inwards[0], -letterReach * inwards[1]]},
    }));
    const decided = signs.map(({piece, point, sign}): Chip => ({
      element: signChip(sign, appearance),
      at: onSheet(scene, piece, point),
      off: {share: [-0.5, -0.5], by: [0, 0]},
    }));
    const numbers = badges.map(({piece, point, inwards, text}): Chip => {
      const [x, y] = wayOnSheet(scene.pieces[piece] ?? {offset: [0, 0]}, inwards);
      return {
        element: badge(text, appearance),
        at: onSheet(scene, piece, point),
        off: {share: [-0.5, -0.5], by: [letterReach * x, -letterReach * y]},
      };
    });
    const said = message && {
      element: messageChip(message.text, message.tone, appearance),
      at: onSheet(scene, message.piece, message.point),
      off: {share: [-0.5, -1], by: [0, -reach]} as const,
    };
    this.#message = said?.element;
    this.#chips = [...letters, ...sewn, ...decided, ...numbers, ...named, ...(said ? [said] : [])];
    this.element.replaceChildren(...this.#chips.map(({element}) => element));
  }

  clear(): void {
    if (this.#chips.length === 0) return;
    this.#chips = [];
    this.element.replaceChildren();
  }

  /** Moves the chips to a view. */
  place(view: SheetView, size: ScreenSize): void {
    for (const {element, at, off} of this.#chips) {
      const [middle, y] = toScreen(view, size, at);
      // a message stays legible at the edge of the screen, too
      const half = element === this.#message ? element.offsetWidth / 2 + reach : -Infinity;
      const x = Math.max(half, Math.min(middle, size.width - half));
      const shift = off.share.map((share) => `${100 * share}%`).join(', ');
      move(element, [x + off.by[0], y + off.by[1]], `translate(${shift})`);
    }
  }
}

/** Returns the letter on both sides of a seam, with the unit vector into the piece. */
function lettersOf(
  scene: PatternScene,
  number = -1,
): readonly {readonly letter: string; readonly at: Point; readonly inwards: Point}[] {
  const seam = scene.seams[number];
  if (!seam) return [];
  return [seam.a, seam.b].map((side) => {
    const {at, along} = atShare(lineOf(scene, side), 0.5);
    const outside = outsideOf(scene.pieces[side.piece], side.vertices);
    return {letter: seamLetter(number), at, inwards: [-outside * along[1], outside * along[0]]};
  });
}

function badge(text: string, appearance: Appearance): HTMLElement {
  const element = placeable(document.createElement('span'), {
    width: `${letterSize}px`,
    height: `${letterSize}px`,
    borderRadius: '50%',
    background: `rgb(${inks[appearance].accent.join(' ')})`,
    color: `rgb(${inks[appearance].paper.join(' ')})`,
    textAlign: 'center',
    font: `600 12px/${letterSize}px system-ui, sans-serif`,
  });
  element.textContent = text;
  return element;
}

function ghostLetter(letter: string, appearance: Appearance): HTMLElement {
  const {text, paper, ring} = chipColours[appearance];
  const element = placeable(document.createElement('span'), {
    boxSizing: 'border-box',
    width: `${letterSize}px`,
    height: `${letterSize}px`,
    borderRadius: '50%',
    border: `1px dashed ${ring}`,
    background: paper,
    color: text,
    opacity: '0.7',
    textAlign: 'center',
    font: `600 11px/${letterSize - 2}px system-ui, sans-serif`,
  });
  element.textContent = letter;
  return element;
}

function messageChip(text: string, tone: 'error' | 'info', appearance: Appearance): HTMLElement {
  const {alert, ring} = chipColours[appearance];
  const element = textChip(text, appearance);
  const colour = tone === 'error' ? alert : ring;
  Object.assign(element.style, {
    whiteSpace: 'pre-wrap',
    width: 'max-content',
    maxWidth: '16rem',
    padding: '3px 8px',
    border: `1px solid ${colour}`,
    ...(tone === 'error' && {color: alert}),
  });
  return element;
}

/** Signs, drawn with one stroke on a square of 16 by 16. */
const signPaths: Readonly<Record<Sign, string>> = {
  pin: 'M5.5 2.5h5M6.5 2.5v4.5L4 9.5h8L9.5 7V2.5M8 9.5V14',
  lock: 'M4 7.5h8v6H4zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5',
};

function signChip(sign: Sign, appearance: Appearance): HTMLElement {
  const {text, paper, ring} = chipColours[appearance];
  const element = placeable(document.createElement('span'), {
    boxSizing: 'border-box',
    width: `${letterSize}px`,
    height: `${letterSize}px`,
    padding: '2px',
    borderRadius: '50%',
    border: `1px solid ${ring}`,
    background: paper,
  });
  element.dataset.sign = sign;
  const picture = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  picture.setAttribute('viewBox', '0 0 16 16');
  Object.assign(picture.style, {display: 'block', width: '100%', height: '100%'});
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  for (const [name, value] of Object.entries({
    ...{d: signPaths[sign], fill: 'none', stroke: text, 'stroke-width': '1.6'},
    ...{'stroke-linecap': 'round', 'stroke-linejoin': 'round'},
  })) {
    path.setAttribute(name, value);
  }
  picture.append(path);
  element.append(picture);
  return element;
}
