/** Small HTML elements over the drawing. */
import type {Point} from '../model/geometry/vectors.js';
import type {Appearance} from './strokes.js';

/** Box on the screen, y down. [CSS px] */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

export const chipColours: Readonly<
  Record<Appearance, {text: string; paper: string; ring: string; alert: string}>
> = {
  light: {text: '#3b3e44', paper: 'rgb(255 255 255 / 0.9)', ring: '#2b2d31', alert: '#a3221b'},
  dark: {text: '#e4e6ea', paper: 'rgb(24 25 28 / 0.88)', ring: '#d6d8dc', alert: '#ff9d94'},
};

export const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Returns a layer of chips that ignores pointers. */
export function chipLayer(): HTMLElement {
  const layer = document.createElement('div');
  Object.assign(layer.style, {
    position: 'absolute',
    inset: '0',
    overflow: 'hidden',
    pointerEvents: 'none',
    userSelect: 'none',
  });
  return layer;
}

/** Positions an element at the layer's corner; `move` places it. */
export function placeable<E extends HTMLElement | SVGElement>(
  element: E,
  style: Partial<CSSStyleDeclaration>,
): E {
  Object.assign(element.style, {position: 'absolute', left: '0', top: '0'}, style);
  return element;
}

export function textChip(text: string, appearance: Appearance): HTMLElement {
  const {text: colour, paper} = chipColours[appearance];
  const element = placeable(document.createElement('span'), {
    whiteSpace: 'pre',
    padding: '0 5px',
    borderRadius: '4px',
    background: paper,
    color: colour,
    font: '600 11px/18px system-ui, sans-serif',
    fontVariantNumeric: 'tabular-nums',
  });
  element.textContent = text;
  return element;
}

/** Moves an element, or hides it without a place. */
export function move(element: HTMLElement | SVGElement, at: Point | undefined, more = ''): void {
  element.style.visibility = at ? 'visible' : 'hidden';
  if (!at) return;
  const [x, y] = at.map((side) => side.toFixed(1));
  element.style.transform = `translate(${x}px, ${y}px) ${more}`;
}
