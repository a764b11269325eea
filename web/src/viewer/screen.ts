/** A canvas that fills an element, in whole device pixels, and draws only on request. */
import type {OrthographicCamera, WebGLRenderer} from 'three';

import type {LineMaterial} from './line-layer.js';
import type {ScreenSize, SheetView} from '../scene/sheet-view.js';
import {enter, type Drawable, type Raster, type Stage} from './stage.js';

/** Scale below which lines are thinner. [CSS px per cm] */
const thinBelow = 4;
/** Distance outside the visible page within which it is drawn already. */
const rootMargin = '128px';

/** Points `camera` at the view, and keeps the width of lines there. */
export function look(
  camera: OrthographicCamera,
  {uniforms}: LineMaterial,
  {centre, scale}: SheetView,
  {width, height, ratio}: Raster,
): void {
  const [halfWidth, halfHeight] = [width / ratio / scale / 2, height / ratio / scale / 2];
  camera.left = -halfWidth;
  camera.right = halfWidth;
  camera.top = halfHeight;
  camera.bottom = -halfHeight;
  camera.position.set(centre[0], centre[1], 1);
  camera.updateProjectionMatrix();
  uniforms.buffer.value.set(width, height);
  uniforms.scale.value = scale * ratio;
  uniforms.ratio.value = ratio;
  uniforms.weight.value = Math.min(1, Math.max(0.5, scale / thinBelow));
}

export interface ScreenEvents {
  /** The element's size has changed. It is drawn right after. */
  readonly resized: () => void;
  /** Draws onto an empty canvas; may run again without a change. */
  readonly draw: () => void;
  /** Places the elements over the canvas, in the frame that draws a change. */
  readonly arrange?: () => void;
  /** The element shows a drawing, for an aside only some time after it was drawn. */
  readonly painted?: () => void;
  /**
   * The browser has taken the graphics context away, or has restored it, which may never happen.
   */
  readonly lost?: (isLost: boolean) => void;
}

export class Screen implements Drawable {
  readonly isAside: boolean;
  readonly #host: HTMLElement;
  readonly #events: ScreenEvents;
  readonly #stage: Stage;
  readonly #life = new AbortController();
  #size: ScreenSize = {width: 1, height: 1};
  #raster: Raster = {width: 1, height: 1, ratio: 1};
  #hasSize = false;
  #isInView = true; // assumed for now; the browser reports it later
  /** Visible canvas: the renderer's, or that of `#copied`. */
  #canvas: HTMLCanvasElement | undefined;
  #copied: CanvasRenderingContext2D | null = null;

  /** @throws {Error} if the browser has no WebGL 2 */
  constructor(host: HTMLElement, events: ScreenEvents, kind: 'main' | 'aside' = 'main') {
    this.#host = host;
    this.#events = events;
    this.isAside = kind === 'aside';
    this.#measure();
    this.#stage = enter(this);
    if (getComputedStyle(host).position === 'static') host.style.position = 'relative';
    this.#watch();
    this.#watchRatio();
  }

  /** Renderer shared by all screens; use it in `draw`, or with a separate render target. */
  get renderer(): WebGLRenderer {
    return this.#stage.renderer;
  }

  /** Fires when the screen is disposed of. */
  get signal(): AbortSignal {
    return this.#life.signal;
  }

  /** Size of the element; the last one while it has none. */
  get size(): ScreenSize {
    return this.#size;
  }

  get raster(): Raster {
    return this.#raster;
  }

  get hasSize(): boolean {
    return this.#hasSize;
  }

  get isSeen(): boolean {
    return this.#isInView && this.#hasSize;
  }

  /** Draws in one of the next frames, once the element is in view and has a size. */
  request(): void {
    if (!this.signal.aborted) this.#stage.request(this);
  }

  /** Restricts drawing to this part of the width, until the next frame. [CSS px from the left] */
  clip(from: number, to: number): void {
    const {height, ratio} = this.#raster;
    const [left, right] = [Math.round(from * ratio), Math.round(to * ratio)];
    this.renderer.setScissor(left, 0, right - left, height);
  }

  mayBeHidden(): void {
    if (this.#host.clientWidth === 0) this.#resize();
  }

  draw(): void {
    this.#events.draw();
  }

  arrange(): void {
    this.#events.arrange?.();
  }

  lost(isLost: boolean): void {
    this.#events.lost?.(isLost);
  }

  hang(canvas: HTMLCanvasElement): void {
    const {width, height} = this.#size;
    Object.assign(canvas.style, {
      ...{display: 'block', position: 'absolute', left: '0', top: '0'},
      ...{width: `${width}px`, height: `${height}px`},
    });
    if (this.#shows(canvas)) return;
    if (this.#shows(this.#canvas)) this.#canvas?.replaceWith(canvas);
    else this.#host.prepend(canvas); // below all elements over the picture
    this.#canvas = canvas;
    if (this.#copied?.canvas !== canvas) this.#copied = null;
  }

  copy(source: HTMLCanvasElement): void {
    const {width, height} = this.#raster;
    const top = source.height - height;
    this.#paper(width, height)?.drawImage(source, 0, top, width, height, 0, 0, width, height);
  }

  paint(picture: ImageData): void {
    this.#paper(picture.width, picture.height)?.putImageData(picture, 0, 0);
    this.#events.painted?.();
  }

  dispose(): void {
    this.#life.abort();
    this.#stage.leave(this);
    if (this.#shows(this.#canvas)) this.#canvas?.remove();
  }

  /**
   * Returns whether the host still contains a canvas: all screens share the renderer's canvas, and
   * another may have taken it.
   */
  #shows(canvas: HTMLCanvasElement | undefined): boolean {
    return canvas?.parentNode === this.#host;
  }

  /** Returns the context of a separate canvas, which is shown from now on, and empty. */
  #paper(width: number, height: number): CanvasRenderingContext2D | null {
    this.#copied ??= document.createElement('canvas').getContext('2d');
    if (!this.#copied) return null;
    const {canvas} = this.#copied;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    this.#copied.clearRect(0, 0, width, height);
    this.hang(canvas);
    return this.#copied;
  }

  /** @returns true if the size or the ratio is new, or the element has a size again */
  #measure(): boolean {
    const {clientWidth, clientHeight} = this.#host;
    const had = this.#hasSize;
    this.#hasSize = clientWidth > 0 && clientHeight > 0;
    if (!this.#hasSize) return false;
    const ratio = globalThis.devicePixelRatio;
    // whole device pixels, so that each of them is drawn
    const [width, height] = [clientWidth, clientHeight].map((side) =>
      Math.max(1, Math.round(side * ratio)),
    ) as [number, number];
    const before = this.#raster;
    this.#raster = {width, height, ratio};
    this.#size = {width: width / ratio, height: height / ratio};
    return !had || width !== before.width || height !== before.height || ratio !== before.ratio;
  }

  #resize(): void {
    const had = this.#hasSize;
    if (!this.#measure()) {
      if (had !== this.#hasSize) this.#stage.wake();
      return;
    }
    this.#events.resized();
    this.#stage.resized(this);
  }

  #watch(): void {
    const resized = new ResizeObserver(() => {
      this.#resize();
    });
    const moved = new IntersectionObserver(
      (entries) => {
        this.#isInView = entries.at(-1)?.isIntersecting ?? true;
        this.#stage.wake();
      },
      {rootMargin},
    );
    for (const observer of [resized, moved]) {
      observer.observe(this.#host);
      this.signal.addEventListener('abort', () => {
        observer.disconnect();
      });
    }
  }

  /** The ratio changes when a window moves to another screen, or the page is zoomed. */
  #watchRatio(): void {
    const query = matchMedia(`(resolution: ${globalThis.devicePixelRatio}dppx)`);
    const changed = (): void => {
      this.#resize();
      this.#watchRatio();
    };
    query.addEventListener('change', changed, {once: true, signal: this.signal});
  }
}
