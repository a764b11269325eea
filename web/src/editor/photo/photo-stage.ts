/** The photograph with the print's cells over it, whose corners can be moved by pointer and by keys. */
import {html, LitElement, nothing, svg, type PropertyValues, type TemplateResult} from 'lit';

import {combined, distance, type Point} from '../../model/geometry.js';
import {latticeOf, pixelOf, rebased} from '../../model/photo-map.js';
import type {PhotoMap} from '../../model/photo.js';
import type {GroupName} from '../../model/print.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';
import {controls} from '../style/controls.js';
import {cellLines, middleNode, nodesOf, type PhotoSize} from './lattice-lines.js';
import {stageStyle} from './stage-style.js';
import {marksOn} from './symmetry-marks.js';

/** What lies over the photograph. */
export interface Overlays {
  readonly cells: boolean;
  readonly axes: boolean;
  readonly differing: boolean;
}

/** A corner that was moved; `keeps`: as it was placed. */
export interface Moved {
  readonly map: PhotoMap;
  readonly keeps: boolean;
}

export type TwoPoints = readonly [Point, Point];

/** A node, in lattice coordinates, or one of the two measured points. */
type Held = {readonly node: Point} | {readonly end: 0 | 1};

/** How near to a corner a press takes hold of it, in CSS px. */
const grasp = 18;
const largeStep = 10;
/** Of arrow heads and centres, as a share of the picture's longer side. */
const markSize = 0.011;

const arrows: Readonly<Record<string, Point>> = {
  ...{ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]},
};

/**
 * The map after one node was moved: `base` takes all others along, any other stretches the lattice from there. Nodes keep
 * their numbers.
 */
export function movedNode(
  map: PhotoMap,
  size: PhotoSize,
  base: Point,
  node: Point,
  to: Point,
): PhotoMap {
  const [p, q] = latticeOf(map, size, to);
  const [i, j] = [node[0] - base[0], node[1] - base[1]];
  const [du, dv] = [p - node[0], q - node[1]];
  const squared = i * i + j * j;
  // the least change of both vectors that brings the node there
  const [a, b] = squared === 0 ? [0, 0] : [i / squared, j / squared];
  const [w1, w2]: [Point, Point] = [
    [1 + a * du, a * dv],
    [b * du, 1 + b * dv],
  ];
  const start = squared === 0 ? [base[0] + du, base[1] + dv] : base;
  const [x, y] = combined([w1, w2], -base[0], -base[1]);
  return rebased(map, [w1, w2], [start[0] + x, start[1] + y]);
}

/** Fires `moved` with a `Moved`, and `measured` with `TwoPoints`. */
export class PhotoStage extends LitElement {
  static override properties = {
    picture: {},
    size: {attribute: false},
    map: {attribute: false},
    group: {},
    differing: {attribute: false},
    overlays: {attribute: false},
    points: {attribute: false},
    words: {attribute: false},
    isBusy: {type: Boolean},
    draft: {state: true},
  };
  static override styles = [controls, stageStyle];
  /** Its address. */
  declare picture: string;
  declare size: PhotoSize;
  /** Undefined until there is one. */
  declare map: PhotoMap | undefined;
  declare group: GroupName | undefined;
  declare differing: readonly (readonly Point[])[];
  declare overlays: Overlays;
  /** Whose distance is to be measured; undefined for none. */
  declare points: TwoPoints | undefined;
  declare words: PhotoTexts;
  declare isBusy: boolean;
  /** While a node is held. */
  declare protected draft: PhotoMap | undefined;
  #held: Held | undefined;
  #base: Point = [0, 0];

  constructor() {
    super();
    this.differing = [];
    this.overlays = {cells: true, axes: false, differing: true};
    this.isBusy = false;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('map')) this.draft = undefined;
    const shown = this.#shown;
    if (shown && !this.#held && !this.draft) this.#base = middleNode(shown, this.size);
  }

  protected override updated(): void {
    const {width, height} = this.size;
    const frame = this.renderRoot.querySelector<HTMLElement>('.frame');
    if (frame) {
      frame.style.aspectRatio = `${width} / ${height}`;
      frame.style.setProperty('--shape', String(width / height));
    }
    this.renderRoot.querySelectorAll<HTMLElement>('.handle').forEach((handle) => {
      const at = this.#placeOf(handle.dataset.handle ?? '');
      if (!at) return;
      handle.style.left = `${(100 * at[0]) / width}%`;
      handle.style.top = `${(100 * at[1]) / height}%`;
    });
  }

  get #shown(): PhotoMap | undefined {
    return this.draft ?? this.map;
  }

  protected override render(): TemplateResult {
    const {width, height} = this.size;
    const {words, points} = this;
    const shown = this.#shown;
    return html`<div
      class="frame ${this.isBusy ? 'busy' : ''}"
      @pointerdown=${this.#press}
      @pointermove=${this.#drag}
      @pointerup=${this.#release}
      @pointercancel=${this.#release}
    >
      <img src=${this.picture} alt=${words.photo} decoding="async" draggable="false" />
      <svg viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" aria-hidden="true">
        ${shown ? this.#over(shown) : nothing} ${points ? this.#ruler(points) : nothing}
      </svg>
      ${shown ? words.nodes.map((label, k) => this.#handle(`node${k}`, label)) : nothing}
      ${points ? words.ends.map((label, k) => this.#handle(`end${k}`, label)) : nothing}
    </div>`;
  }

  #over(map: PhotoMap): TemplateResult {
    const {size, overlays, group} = this;
    const lines = overlays.cells ? cellLines(map, size) : '';
    const marks = overlays.axes && group ? marksOn(group, map, size) : undefined;
    const dots = overlays.cells ? nodesOf(map, size) : [];
    const radius = 0.35 * this.#unit;
    const areas = this.differing
      .map((ring) => `M${ring.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}Z`)
      .join('');
    return svg`
      ${overlays.differing ? svg`<path class="differing" d=${areas}></path>` : nothing}
      <path class="casing" d=${lines}></path><path class="cells" d=${lines}></path>
      ${dots.map((node) => {
        const [x, y] = pixelOf(map, size, node);
        return svg`<circle class="dot" cx=${x} cy=${y} r=${radius}></circle>`;
      })}
      ${
        marks
          ? svg`<path class="casing" d=${marks.mirrors + marks.glides}></path>
            <path class="mirrors" d=${marks.mirrors}></path>
            <path class="glides" d=${marks.glides}></path>
            ${marks.centres.map(
              ({order, at}) =>
                svg`<path class="centre" data-order=${order} d=${this.#symbol(order, at)}></path>`,
            )}`
          : nothing
      }
      ${this.#arrow(map, [1, 0], 'w1')} ${this.#arrow(map, [0, 1], 'w2')}`;
  }

  get #unit(): number {
    return markSize * Math.max(this.size.width, this.size.height);
  }

  /** As crystallographers draw them: a lens, a triangle, a square, a hexagon. */
  #symbol(order: 2 | 3 | 4 | 6, [x, y]: Point): string {
    const radius = 0.6 * this.#unit;
    const corner = (k: number): string => {
      const angle = Math.PI * ((2 * k) / order - 0.5);
      const reach = order === 2 && k % 1 !== 0 ? 0.5 * radius : radius;
      return `${(x + reach * Math.cos(angle)).toFixed(1)} ${(y + reach * Math.sin(angle)).toFixed(1)}`;
    };
    const corners = order === 2 ? [0, 0.5, 1, 1.5] : Array.from({length: order}, (_, k) => k);
    return `M${corners.map(corner).join('L')}Z`;
  }

  #arrow(map: PhotoMap, [i, j]: Point, name: 'w1' | 'w2'): TemplateResult {
    const [from, to] = [
      pixelOf(map, this.size, this.#base),
      pixelOf(map, this.size, [this.#base[0] + i, this.#base[1] + j]),
    ];
    const length = distance(from, to);
    if (!(length > 0)) return svg``;
    const along: Point = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const head = Math.min(1.6 * this.#unit, length / 3);
    const side = (sign: number): string => {
      const [x, y] = [
        to[0] - head * (along[0] + 0.5 * sign * along[1]),
        to[1] - head * (along[1] - 0.5 * sign * along[0]),
      ];
      return `${x.toFixed(1)} ${y.toFixed(1)}`;
    };
    const path = `M${from.join(' ')}L${to.join(' ')}M${side(1)}L${to.join(' ')}L${side(-1)}`;
    const away = 3 * this.#unit;
    return svg`<path class="arrow casing" d=${path}></path><path class="arrow ${name}" d=${path}></path>
      <text
        class=${name}
        x=${to[0] + away * along[0]}
        y=${to[1] + away * along[1]}
        font-size=${2 * this.#unit}
      >${name}</text>`;
  }

  #ruler([from, to]: TwoPoints): TemplateResult {
    const line = `M${from.join(' ')}L${to.join(' ')}`;
    return svg`<path class="casing" d=${line}></path><path class="ruler" d=${line}></path>`;
  }

  #handle(name: string, label: string): TemplateResult {
    return html`<button
      class="handle"
      data-handle=${name}
      aria-label=${label}
      title=${label}
      @keydown=${(event: KeyboardEvent) => {
        this.#step(event, name);
      }}
    ></button>`;
  }

  /** Node 0 is the corner of the middle cell, 1 and 2 are the ends of w1 and w2. */
  #heldBy(name: string): Held {
    const number = Number(name.at(-1));
    if (name.startsWith('end')) return {end: number === 1 ? 1 : 0};
    const [u, v] = this.#base;
    return {node: [u + (number === 1 ? 1 : 0), v + (number === 2 ? 1 : 0)]};
  }

  #placeOf(name: string): Point | undefined {
    const held = this.#heldBy(name);
    if ('end' in held) return this.points?.[held.end];
    const shown = this.#shown;
    return shown && pixelOf(shown, this.size, held.node);
  }

  #step(event: KeyboardEvent, name: string): void {
    const direction = arrows[event.key];
    const at = this.#placeOf(name);
    if (!direction || !at) return;
    event.preventDefault();
    const by = event.shiftKey ? largeStep : 1;
    this.#move(this.#heldBy(name), [at[0] + by * direction[0], at[1] + by * direction[1]]);
    this.#settle(event.altKey);
  }

  #at({clientX, clientY}: PointerEvent): Point {
    const frame = this.renderRoot.querySelector('.frame')?.getBoundingClientRect();
    if (!frame) return [0, 0];
    return [
      ((clientX - frame.left) * this.size.width) / frame.width,
      ((clientY - frame.top) * this.size.height) / frame.height,
    ];
  }

  readonly #press = (event: PointerEvent): void => {
    const name = (event.target as HTMLElement).dataset.handle;
    const held = name === undefined ? this.#nearest(event) : this.#heldBy(name);
    if (!held || this.isBusy) return;
    this.#held = held;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
  };

  readonly #drag = (event: PointerEvent): void => {
    if (this.#held) this.#move(this.#held, this.#at(event));
  };

  readonly #release = (event: PointerEvent): void => {
    const held = this.#held;
    this.#held = undefined;
    if (held && 'node' in held) this.#settle(event.altKey);
  };

  /** Any corner that is seen can be taken: the farther from the middle, the finer. */
  #nearest(event: PointerEvent): Held | undefined {
    const shown = this.#shown;
    const frame = this.renderRoot.querySelector('.frame')?.getBoundingClientRect();
    if (!shown || !frame) return undefined;
    const at = this.#at(event);
    const reach = (grasp * this.size.width) / frame.width;
    const [node] = nodesOf(shown, this.size)
      .map((one) => ({one, off: distance(pixelOf(shown, this.size, one), at)}))
      .filter(({off}) => off <= reach)
      .sort((a, b) => a.off - b.off);
    return node && {node: node.one};
  }

  #move(held: Held, to: Point): void {
    if ('end' in held) {
      const [from, end] = this.points ?? [to, to];
      const points: TwoPoints = held.end === 0 ? [to, end] : [from, to];
      this.dispatchEvent(new CustomEvent<TwoPoints>('measured', {detail: points}));
      return;
    }
    const {map, size} = this;
    if (map) this.draft = movedNode(map, size, this.#base, held.node, to);
  }

  #settle(keeps: boolean): void {
    if (!this.draft) return;
    this.dispatchEvent(new CustomEvent<Moved>('moved', {detail: {map: this.draft, keeps}}));
  }
}
