/** A canvas that fills an element, in whole device pixels; it is drawn only when somebody asks. */
import {OrthographicCamera, WebGLRenderer} from 'three';

import type {LineMaterial} from './line-layer.js';
import type {ScreenSize, SheetView} from './sheet-view.js';

/** Lines are thinner at scales below this. [CSS px per cm] */
const thinBelow = 4;

/** A picture of so many pixels. */
export interface Raster {
  readonly width: number;
  readonly height: number;
  /** [device px per CSS px] */
  readonly ratio: number;
}

/** Lets `camera` see what the view shows, and lines keep their width there. */
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
  /** The element has another size. What is on the canvas is lost; it is drawn right after. */
  readonly resized: () => void;
  readonly draw: () => void;
}

export class Screen {
  readonly renderer: WebGLRenderer;
  readonly #host: HTMLElement;
  readonly #events: ScreenEvents;
  readonly #life = new AbortController();
  readonly #resized: ResizeObserver;
  #size: ScreenSize = {width: 1, height: 1};
  #frame = 0;

  /** @throws {Error} where the browser has no WebGL 2 */
  constructor(host: HTMLElement, events: ScreenEvents) {
    this.#host = host;
    this.#events = events;
    this.renderer = new WebGLRenderer({alpha: true, antialias: false, depth: false});
    this.renderer.setClearColor(0x000000, 0); // the page's own background shows through
    this.renderer.autoClear = false;
    const {domElement: canvas} = this.renderer;
    Object.assign(canvas.style, {display: 'block', position: 'absolute', left: '0', top: '0'});
    if (getComputedStyle(host).position === 'static') host.style.position = 'relative';
    host.append(canvas);
    canvas.addEventListener(
      'webglcontextrestored',
      () => {
        this.request();
      },
      {signal: this.signal},
    );
    this.#resized = new ResizeObserver(() => {
      this.#resize();
    });
    this.#resized.observe(host);
    this.#watchRatio();
    this.#measure();
  }

  /** Fires when the screen is disposed of. */
  get signal(): AbortSignal {
    return this.#life.signal;
  }

  get size(): ScreenSize {
    return this.#size;
  }

  get raster(): Raster {
    const {width, height} = this.renderer.domElement;
    return {width, height, ratio: this.renderer.getPixelRatio()};
  }

  /** Draws with the next frame. */
  request(): void {
    this.#frame ||= requestAnimationFrame(() => {
      this.#draw();
    });
  }

  dispose(): void {
    this.#life.abort();
    this.#resized.disconnect();
    cancelAnimationFrame(this.#frame);
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  #draw(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    if (!this.signal.aborted) this.#events.draw();
  }

  /** @returns whether anything has changed */
  #measure(): boolean {
    const {clientWidth, clientHeight} = this.#host;
    const ratio = globalThis.devicePixelRatio;
    // whole device pixels, so that every one of them is drawn
    const [width, height] = [clientWidth, clientHeight].map(
      (side) => Math.max(1, Math.round(side * ratio)) / ratio,
    ) as [number, number];
    const same =
      width === this.#size.width &&
      height === this.#size.height &&
      ratio === this.renderer.getPixelRatio();
    this.#size = {width, height};
    if (same) return false;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height);
    return true;
  }

  #resize(): void {
    if (!this.#measure()) return;
    this.#events.resized();
    this.#draw(); // a canvas is empty after a change of size
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
