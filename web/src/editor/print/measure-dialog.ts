/** Sets the size of a print by the distance between two points on its image. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import {noPicture, printOf, type DesignPrint} from '../../model/design/design.js';
import {norm, type Point} from '../../model/geometry/vectors.js';
import {resized, tileSize} from '../../model/design/tile-repeat.js';
import {imageCell} from '../../model/print/wallpaper.js';
import {arrowSteps} from '../base/arrow-steps.js';
import {lengthUnit} from '../controls/number-field.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {dragHandle} from '../style/drag-handle.js';
import {icon} from '../style/icons.js';
import {alongStripe, leastRepeat, mostRepeat} from '../../model/print/repeat.js';
import {choiceOf} from '../../print/group-choice.js';

const measureStyle = css`
  dialog {
    width: min(94vw, 40rem);
    max-height: 94vh;
    padding: var(--sw-space-4);
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-paper);
    color: var(--sw-ink);
  }
  dialog::backdrop {
    background: rgb(0 0 0 / 0.4);
  }
  .inside {
    display: grid;
    gap: var(--sw-space-3);
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
  }
  .picture {
    position: relative;
    justify-self: center;
    cursor: crosshair;
    touch-action: none;
  }
  svg.print {
    display: block;
    width: 100%;
    height: 100%;
  }
  line {
    vector-effect: non-scaling-stroke;
    stroke-width: 2;
    stroke: #c22318;
  }
  line.casing {
    stroke: #fff;
    stroke-width: 5;
  }
  .entry {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: var(--sw-space-2);
    align-items: end;
  }
`;

/** Steps of a point per arrow key, without and with Shift, as shares of the longer side. */
const step = 1 / 500;
const largeStep = 1 / 50;
/** Least distance between points for a measurement, as a share of the longer side. */
const nearest = 0.02;
/** Greatest height of the image, as a share of the height of the screen. */
const mostOfScreen = 0.55;

type Two = readonly [Point, Point];

export class MeasureDialog extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    points: {state: true},
    typed: {state: true},
    isOpen: {state: true},
  };
  /** Points in shares of the image, from its upper left corner. */
  declare protected points: Two;
  /** Distance between the points, as entered by the user. [cm] */
  declare protected typed: number | undefined;
  declare protected isOpen: boolean;
  #next: 0 | 1 = 0;

  static override styles = [controls, dragHandle, measureStyle];

  constructor() {
    super();
    this.points = [
      [0.25, 0.5],
      [0.75, 0.5],
    ];
    this.isOpen = false;
  }

  protected override render(): TemplateResult | typeof nothing {
    const print = this.workbench.history.design?.print;
    if (!print || print.image === noPicture) return nothing;
    const texts = this.texts.print.measure;
    return html`<button class="outlined" @click=${this.#open}>${icon.measure} ${texts.open}</button>
      <dialog
        aria-labelledby="title"
        @close=${() => {
          this.isOpen = false;
        }}
      >
        ${this.isOpen ? this.#inside(print) : nothing}
      </dialog>`;
  }

  /** Sets positions by script, since a strict policy allows no styles in the markup. */
  protected override updated(): void {
    const print = this.workbench.history.design?.print;
    const picture = this.renderRoot.querySelector<HTMLElement>('.picture');
    if (!print || !picture) return;
    const {width, height} = windowOn(print);
    picture.style.aspectRatio = `${width} / ${height}`;
    picture.style.width = `min(100%, ${(100 * mostOfScreen * width) / height}vh)`;
    picture.querySelectorAll<HTMLElement>('.handle').forEach((point, k) => {
      const [x, y] = this.points[k === 0 ? 0 : 1];
      point.style.left = `${100 * x}%`;
      point.style.top = `${100 * y}%`;
    });
  }

  #inside(print: DesignPrint): TemplateResult {
    const {print: words, app, controls: limits} = this.texts;
    const texts = words.measure;
    const {format} = this;
    const {name, cm} = lengthUnit[this.workbench.preferences.chosen.units];
    const size = tileSize(this.#measured(print));
    const distance = this.#distance(print);
    const isFar = distance > nearest * this.#longest(print);
    return html`<div class="inside">
      <header>
        <h2 id="title">${texts.open}</h2>
        <button aria-label=${app.close} title=${app.close} @click=${this.#close}>
          ${icon.close}
        </button>
      </header>
      <p id="how" class="soft">${texts.how}</p>
      ${this.#picture(print)}
      <div class="entry">
        <sw-number-field
          .label=${texts.distance(name)}
          .value=${(this.typed ?? distance) / cm}
          .least=${0.1 / cm}
          .most=${mostRepeat / cm}
          .step=${0.1}
          .fractions=${this.workbench.preferences.chosen.units === 'inch'}
          .wrong=${limits.between(format.length(0.1), format.length(mostRepeat))}
          @entered=${({detail}: CustomEvent<number>) => {
            this.typed = detail * cm;
          }}
        ></sw-number-field>
        <button
          class="primary"
          ?disabled=${!isFar || size.width > mostRepeat || size.width < leastRepeat}
          @click=${() => {
            this.workbench.history.change({print: this.#measured(print)}, 'print size');
            this.#close();
          }}
        >
          ${texts.apply}
        </button>
      </div>
      <p role="status">${texts.makes(format.length(size.width), format.length(size.height))}</p>
    </div>`;
  }

  #picture(print: DesignPrint): TemplateResult {
    const {width, height, sides, matrix} = windowOn(print);
    const [[x1, y1], [x2, y2]] = this.points;
    const line = (kind: string) =>
      svg`<line class=${kind} x1=${x1 * width} y1=${y1 * height} x2=${x2 * width} y2=${y2 * height}></line>`;
    return html`<div class="picture" @pointerdown=${this.#press} @pointermove=${this.#drag}>
      <svg class="print" viewBox="0 0 ${width} ${height}" role="img" aria-label=${print.title}>
        ${svg`<pattern
          id="cell"
          patternUnits="userSpaceOnUse"
          width=${sides[0]}
          height=${sides[1]}
          patternTransform="matrix(${matrix.join(' ')})"
        >
          <image href=${print.image} width=${sides[0]} height=${sides[1]} preserveAspectRatio="none"></image>
        </pattern>
        <rect width="100%" height="100%" fill="url(#cell)"></rect>
        ${line('casing')} ${line('')}`}
      </svg>
      ${this.#point(0)} ${this.#point(1)}
    </div>`;
  }

  #point(which: 0 | 1): TemplateResult {
    return html`<button
      class="handle"
      data-point=${which}
      aria-label=${this.texts.print.measure.points[which] ?? ''}
      aria-describedby="how"
      @keydown=${(event: KeyboardEvent) => {
        const direction = arrowSteps[event.key];
        const print = this.workbench.history.design?.print;
        if (!direction || !print) return;
        event.preventDefault();
        const {width, height} = windowOn(print);
        const by = (event.shiftKey ? largeStep : step) * Math.max(width, height);
        const [from, to] = this.points[which];
        this.#move(which, [from + (by * direction[0]) / width, to + (by * direction[1]) / height]);
      }}
    ></button>`;
  }

  /** Returns the print at the entered distance. */
  #measured(print: DesignPrint): DesignPrint {
    const distance = this.#distance(print);
    if (this.typed === undefined || distance === 0) return print;
    const factor = this.typed / distance;
    const size = tileSize(print);
    const isStriped = choiceOf(print) === 'stripes';
    const height = isStriped ? Math.min(size.height, alongStripe) : size.height * factor;
    return resized(print, {...size, width: size.width * factor, height});
  }

  /** Returns the distance between the points at the print's present size. [cm] */
  #distance(print: DesignPrint): number {
    const {width, height} = windowOn(print);
    const [[x1, y1], [x2, y2]] = this.points;
    return Math.hypot((x2 - x1) * width, (y2 - y1) * height);
  }

  #longest(print: DesignPrint): number {
    const {width, height} = windowOn(print);
    return Math.max(width, height);
  }

  #move(which: 0 | 1, [x, y]: Point): void {
    const inside = (value: number): number => Math.min(1, Math.max(0, value));
    const moved: Point = [inside(x), inside(y)];
    this.points = which === 0 ? [moved, this.points[1]] : [this.points[0], moved];
  }

  #at({clientX, clientY, currentTarget}: PointerEvent): Point {
    const {left, top, width, height} = (currentTarget as HTMLElement).getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  }

  /** A press grabs a point, or sets one: the first, the second, and so on. */
  readonly #press = (event: PointerEvent): void => {
    const held = (event.target as HTMLElement).dataset.point;
    if (held === undefined) {
      this.#move(this.#next, this.#at(event));
      this.#next = this.#next === 0 ? 1 : 0;
      return;
    }
    (event.target as HTMLElement).setPointerCapture(event.pointerId);
  };

  readonly #drag = (event: PointerEvent): void => {
    const point = event.target as HTMLElement;
    if (!point.hasPointerCapture(event.pointerId)) return;
    this.#move(point.dataset.point === '1' ? 1 : 0, this.#at(event));
  };

  readonly #open = (): void => {
    this.isOpen = true;
    this.typed = undefined;
    this.#next = 0;
    this.renderRoot.querySelector('dialog')?.showModal();
  };

  readonly #close = (): void => {
    this.renderRoot.querySelector('dialog')?.close();
  };
}

/** Least shorter side of the window, as a share of the longer one. */
const narrowest = 0.4;

/** Returns the displayed part of a print: one cell on the fabric, turned by whole quarters. [cm] */
function windowOn(print: DesignPrint) {
  const [a, b] = imageCell(printOf({...print, turnDeg: 90 * Math.round(print.turnDeg / 90)}));
  const reach = (k: 0 | 1): readonly [number, number] => {
    const corners = [0, a[k], b[k], a[k] + b[k]];
    return [Math.min(...corners), Math.max(...corners)];
  };
  const [[left, right], [bottom, top]] = [reach(0), reach(1)];
  // shows enough of a stripe to point at, since it may repeat after a few millimetres
  const longest = Math.max(right - left, top - bottom);
  const side = (length: number): number => Math.max(length, narrowest * longest);
  const sides = [norm(a), norm(b)] as const;
  // y points down in the image, against the second side of the cell
  const matrix = [
    ...[a[0] / sides[0], -a[1] / sides[0], -b[0] / sides[1], b[1] / sides[1]],
    ...[b[0] - left, top - b[1]],
  ];
  return {width: side(right - left), height: side(top - bottom), sides, matrix};
}
