/** The photo with the findings over it; points can be moved by pointer and by keys. */
import {css, html, LitElement, nothing, svg, type PropertyValues, type TemplateResult} from 'lit';

import {distance, type Point} from '../../model/geometry/vectors.js';
import {pixelOf} from '../../model/print/photo-map.js';
import type {PhotoMap} from '../../model/print/photo-reading.js';
import type {GroupName} from '../../model/print/repeating-print.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';
import {arrowSteps} from '../base/arrow-steps.js';
import {controls} from '../style/controls.js';
import {dragHandle} from '../style/drag-handle.js';
import {ringPath, type BrokenPlaces} from '../../photo/breaks-on-photo.js';
import type {ArrowNames} from '../../photo/arrow-names.js';
import {middleNode, movedNode, nodesOf, type PhotoSize} from '../../photo/lattice-lines.js';
import {stageMarks, type Overlays, type Vector} from './stage-marks.js';

const stageStyle = css`
  :host {
    display: grid;
    place-items: center;
    min-width: 0;
    min-height: 0;
  }
  .frame {
    position: relative;
    width: min(100%, calc(var(--stage-height, 70dvh) * var(--shape, 1)));
    overflow: hidden;
    touch-action: none;
    user-select: none;
    -webkit-user-select: none;
  }
  img,
  svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
  }
  .busy svg,
  .busy .handle {
    opacity: 0.5;
  }
  path {
    fill: none;
    vector-effect: non-scaling-stroke;
    stroke-linejoin: round;
  }
  .casing {
    stroke: rgb(255 255 255 / 0.55);
    stroke-width: 3;
  }
  .cells {
    stroke: #143a63;
    stroke-width: 1;
  }
  .dot {
    fill: #143a63;
    stroke: #fff;
    vector-effect: non-scaling-stroke;
  }
  .mirrors {
    stroke: #c22318;
    stroke-width: 1.5;
  }
  .glides {
    stroke: #c22318;
    stroke-width: 1.5;
    stroke-dasharray: 5 4;
  }
  .centre {
    fill: #c22318;
    stroke: #fff;
  }
  .differing {
    fill: rgb(194 35 24 / 0.3);
    stroke: #c22318;
  }
  .broken {
    fill: rgb(122 47 181 / 0.45);
  }
  .outline {
    fill: rgb(194 35 24 / 0.12);
    stroke: #c22318;
    stroke-width: 2;
  }
  .arrow {
    stroke-width: 2.5;
    stroke-linecap: round;
  }
  .arrow.casing {
    stroke: #fff;
    stroke-width: 5;
  }
  .arrow.w1,
  .arrow.w2 {
    stroke: #0b5fb3;
  }
  .arrow.measured {
    stroke: #c22318;
    stroke-width: 5;
  }
  text {
    fill: #0b5fb3;
    stroke: #fff;
    stroke-width: 4px;
    paint-order: stroke;
    vector-effect: non-scaling-stroke;
    font-weight: 700;
    text-anchor: middle;
    dominant-baseline: central;
  }
  text.measured {
    fill: #c22318;
  }
  .ruler {
    stroke: #c22318;
    stroke-width: 2;
  }
  .handle[data-handle^='node']::before {
    border-color: #0b5fb3;
  }
  .aiming {
    cursor: crosshair;
  }
`;

/** A moved corner; `keeps`: the lattice stays as placed. */
export interface Moved {
  readonly map: PhotoMap;
  readonly keeps: boolean;
}

export type TwoPoints = readonly [Point, Point];

/** A moved point or pair of points; the user still holds it unless `isSettled`. */
export interface Placed<T> {
  readonly at: T;
  readonly isSettled: boolean;
}

/** A node in lattice coordinates, one of the two measured points, or the place to choose. */
type Held = {readonly node: Point} | {readonly end: 0 | 1} | 'aim';

/** Greatest distance at which a press grabs a corner. [CSS px] */
const grasp = 18;
const largeStep = 10;

/**
 * Fires `moved` with a `Moved`, `measured` with a `Placed<TwoPoints>`, and `aimed` with a
 * `Placed<Point>`.
 */
export class PhotoStage extends LitElement {
  static override properties = {
    picture: {},
    size: {attribute: false},
    map: {attribute: false},
    group: {},
    differing: {attribute: false},
    broken: {attribute: false},
    outline: {attribute: false},
    overlays: {attribute: false},
    points: {attribute: false},
    measured: {},
    names: {attribute: false},
    aim: {attribute: false},
    aimLabel: {},
    words: {attribute: false},
    isBusy: {type: Boolean},
    draft: {state: true},
  };
  static override styles = [controls, dragHandle, stageStyle];
  /** URL of the photo. */
  declare picture: string;
  declare size: PhotoSize;
  /** Undefined until there is a lattice. */
  declare map: PhotoMap | undefined;
  declare group: GroupName | undefined;
  declare differing: readonly (readonly Point[])[];
  declare broken: BrokenPlaces | undefined;
  /** Outline of the coin or card found. */
  declare outline: readonly Point[] | undefined;
  declare overlays: Overlays;
  /** Ends of the distance to measure; undefined for none. */
  declare points: TwoPoints | undefined;
  /** Vector that the user measures along at present. */
  declare measured: Vector | undefined;
  declare names: ArrowNames;
  /** Place that the user has to choose; undefined for none. */
  declare aim: Point | undefined;
  declare aimLabel: string;
  declare words: PhotoTexts;
  declare isBusy: boolean;
  /** Lattice while a node is held. */
  declare protected draft: PhotoMap | undefined;
  #held: Held | undefined;
  #base: Point = [0, 0];

  constructor() {
    super();
    this.differing = [];
    this.aimLabel = '';
    this.overlays = {cells: true, axes: false, differing: true, breaks: true};
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
      const at = this.#placeOf(this.#heldBy(handle.dataset.handle ?? ''));
      if (!at) return;
      handle.style.left = `${(100 * at[0]) / width}%`;
      handle.style.top = `${(100 * at[1]) / height}%`;
    });
  }

  get #shown(): PhotoMap | undefined {
    return this.draft ?? this.map;
  }

  protected override render(): TemplateResult {
    const {size, words, points, aim, group, differing, broken, overlays, measured, names} = this;
    const map = this.#shown;
    const marks = map && {
      ...{map, size, base: this.#base, group, differing, overlays, measured, names},
      broken: this.draft ? undefined : broken,
    };
    return html`<div
      class="frame ${this.isBusy ? 'busy' : ''} ${aim ? 'aiming' : ''}"
      @pointerdown=${this.#press}
      @pointermove=${this.#drag}
      @pointerup=${this.#release}
      @pointercancel=${this.#release}
    >
      <img src=${this.picture} alt=${words.photo} decoding="async" draggable="false" />
      <svg viewBox="0 0 ${size.width} ${size.height}" preserveAspectRatio="none" aria-hidden="true">
        ${marks ? stageMarks(marks) : nothing} ${points ? this.#ruler(points) : nothing}
        ${this.outline ? this.#outline(this.outline) : nothing}
      </svg>
      ${map ? this.#nodes.map((label, k) => this.#handle(`node${k}`, label)) : nothing}
      ${points ? words.ends.map((label, k) => this.#handle(`end${k}`, label)) : nothing}
      ${aim ? this.#handle('aim', this.aimLabel) : nothing}
    </div>`;
  }

  /** Labels of the handles of the middle repeat. */
  get #nodes(): readonly string[] {
    const {names, words} = this;
    const ends = [names.w1, names.w2].filter((name) => name !== undefined);
    return [words.corner, ...ends.map((name) => words.end(name))];
  }

  #ruler([from, to]: TwoPoints): TemplateResult {
    const line = `M${from.join(' ')}L${to.join(' ')}`;
    return svg`<path class="casing" d=${line}></path><path class="ruler" d=${line}></path>`;
  }

  #outline(outline: readonly Point[]): TemplateResult {
    const ring = ringPath(outline);
    return svg`<path class="casing" d=${ring}></path><path class="outline" d=${ring}></path>`;
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
      @click=${({detail}: MouseEvent) => {
        if (name === 'aim' && detail === 0) this.#aimed(true); // Enter, or a screen reader
      }}
    ></button>`;
  }

  /** Node 0 is the corner of the middle cell, 1 and 2 are the ends of w1 and w2. */
  #heldBy(name: string): Held {
    if (name === 'aim') return name;
    const number = Number(name.at(-1));
    if (name.startsWith('end')) return {end: number === 1 ? 1 : 0};
    const [u, v] = this.#base;
    return {node: [u + (number === 1 ? 1 : 0), v + (number === 2 ? 1 : 0)]};
  }

  #placeOf(held: Held): Point | undefined {
    if (held === 'aim') return this.aim;
    if ('end' in held) return this.points?.[held.end];
    const shown = this.#shown;
    return shown && pixelOf(shown, this.size, held.node);
  }

  #step(event: KeyboardEvent, name: string): void {
    const direction = arrowSteps[event.key];
    const held = this.#heldBy(name);
    const at = this.#placeOf(held);
    if (!direction || !at) return;
    event.preventDefault();
    const by = event.shiftKey ? largeStep : 1;
    this.#move(held, [at[0] + by * direction[0], at[1] + by * direction[1]]);
    if (held !== 'aim') this.#settle(held, event.altKey);
  }

  #at({clientX, clientY}: PointerEvent): Point {
    const frame = this.renderRoot.querySelector('.frame')?.getBoundingClientRect();
    if (!frame) return [0, 0];
    const inside = (share: number): number => Math.min(1, Math.max(0, share));
    return [
      this.size.width * inside((clientX - frame.left) / frame.width),
      this.size.height * inside((clientY - frame.top) / frame.height),
    ];
  }

  readonly #press = (event: PointerEvent): void => {
    const name = (event.target as HTMLElement).dataset.handle;
    const held = name !== undefined ? this.#heldBy(name) : this.aim ? 'aim' : this.#nearest(event);
    if (!held || this.isBusy) return;
    this.#held = held;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    if (name === undefined && held === 'aim') this.#move(held, this.#at(event));
  };

  readonly #drag = (event: PointerEvent): void => {
    if (this.#held) this.#move(this.#held, this.#at(event));
  };

  readonly #release = (event: PointerEvent): void => {
    const held = this.#held;
    this.#held = undefined;
    if (held) this.#settle(held, event.altKey);
  };

  /** Any visible corner can be grabbed: the farther from the middle, the finer the change. */
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
    if (held === 'aim') {
      this.aim = to;
      this.#aimed(false);
    } else if ('end' in held) {
      const [from, end] = this.points ?? [to, to];
      this.points = held.end === 0 ? [to, end] : [from, to];
      this.#fire('measured', {at: this.points, isSettled: false});
    } else if (this.map) {
      this.draft = movedNode(this.map, this.size, this.#base, held.node, to);
    }
  }

  #settle(held: Held, keeps: boolean): void {
    if (held === 'aim') this.#aimed(true);
    else if ('end' in held) this.#fire('measured', {at: this.points, isSettled: true});
    else if (this.draft) this.#fire('moved', {map: this.draft, keeps});
  }

  #aimed(isSettled: boolean): void {
    this.#fire('aimed', {at: this.aim, isSettled});
  }

  #fire(type: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(type, {detail}));
  }
}
