/**
 * The one drawing context of the document, shared by all its screens: a browser drops contexts
 * beyond the sixteenth.
 */
import {WebGLRenderer} from 'three';

import {readBack} from './read-back.js';

/** Number of screens drawn in one frame; the others follow in the next ones. */
const atOnce = 4;
/**
 * Lifetime of the context after its last screen, which may only be moving within the document. [ms]
 */
const grace = 1000;

/** Size of a picture in pixels. */
export interface Raster {
  readonly width: number;
  readonly height: number;
  /** [device px per CSS px] */
  readonly ratio: number;
}

/** A screen as the stage uses it. */
export interface Drawable {
  /** Small and beside a main screen: drawn off screen, and shown once its picture is ready. */
  readonly isAside: boolean;
  readonly raster: Raster;
  /** True if it has a size; an element hidden by a style has none. */
  readonly hasSize: boolean;
  /** True if it is in view and has a size. */
  readonly isSeen: boolean;
  /**
   * Draws into the lower left corner of the current render target; may run again without a change.
   */
  readonly draw: () => void;
  /** Another screen is shown from now on, perhaps in place of this one. */
  readonly mayBeHidden: () => void;
  /** Places the elements over the picture, after a change. */
  readonly arrange: () => void;
  /** Shows the renderer's own canvas. */
  readonly hang: (canvas: HTMLCanvasElement) => void;
  /** Shows a copy of the renderer's canvas. */
  readonly copy: (canvas: HTMLCanvasElement) => void;
  /** Shows a picture drawn off screen. */
  readonly paint: (picture: ImageData) => void;
  /** The context was lost, or was restored. */
  readonly lost: (isLost: boolean) => void;
}

let current: Stage | undefined;

/**
 * Adds a screen to the stage; it is drawn until it leaves.
 * @throws {Error} if the browser has no WebGL 2
 */
export function enter(screen: Drawable): Stage {
  current ??= new Stage(() => {
    current = undefined;
  });
  current.add(screen);
  return current;
}

/**
 * A single main screen is drawn directly and shows the renderer's canvas. Several main screens each
 * show a copy of their drawing. An aside is read back without a copy: a copy has to wait for the
 * graphics card, which would slow down a page with one pattern and a seam strip. While the document
 * is hidden nothing is drawn; changes are drawn once it is visible.
 */
export class Stage {
  readonly renderer: WebGLRenderer;
  readonly #ended: () => void;
  readonly #life = new AbortController();
  readonly #screens = new Set<Drawable>();
  /** Screens to be drawn, in order of their requests. */
  readonly #dirty = new Set<Drawable>();
  /** Screen that shows the renderer's canvas. */
  #direct: Drawable | undefined;
  /** Drawn, but not read back yet. */
  readonly #away = new Set<Drawable>();
  #isLost = false;
  #frame = 0;
  #end: ReturnType<typeof setTimeout> | undefined;

  /** @throws {Error} if the browser has no WebGL 2 */
  constructor(ended: () => void) {
    this.#ended = ended;
    this.renderer = new WebGLRenderer({alpha: true, antialias: false, depth: false});
    this.renderer.autoClear = false;
    this.#prepare();
    const {signal} = this.#life;
    for (const [type, isLost] of [
      ['webglcontextlost', true],
      ['webglcontextrestored', false],
    ] as const) {
      const changed = (): void => {
        this.#turn(isLost);
      };
      this.renderer.domElement.addEventListener(type, changed, {signal});
    }
    const seen = (): void => {
      this.#schedule();
    };
    document.addEventListener('visibilitychange', seen, {signal});
  }

  add(screen: Drawable): void {
    clearTimeout(this.#end);
    for (const other of this.#screens) other.mayBeHidden();
    this.#screens.add(screen);
    if (this.#isLost) screen.lost(true);
    this.request(screen);
  }

  leave(screen: Drawable): void {
    this.#screens.delete(screen);
    this.#dirty.delete(screen);
    if (this.#direct === screen) {
      this.#direct = undefined;
      this.renderer.domElement.remove();
    }
    if (this.#screens.size > 0) this.#schedule();
    else {
      const end = (): void => {
        this.#dispose();
      };
      this.#end = setTimeout(end, this.#isLost ? 0 : grace);
    }
  }

  /** Draws in one of the next frames, once the screen is in view. */
  request(screen: Drawable): void {
    this.#dirty.add(screen);
    this.#schedule();
  }

  /**
   * The screen's size has changed. That empties its canvas, so a direct screen is drawn at once.
   */
  resized(screen: Drawable): void {
    this.request(screen);
    if (screen === this.#direct || screen === this.#soloist()) this.#play();
  }

  /** A screen is visible again. */
  wake(): void {
    this.#schedule();
  }

  #schedule(): void {
    this.#frame ||= requestAnimationFrame(() => {
      this.#play();
    });
  }

  /** Returns the only main screen that has a size. */
  #soloist(): Drawable | undefined {
    const [main, other] = [...this.#screens].filter(({isAside, hasSize}) => !isAside && hasSize);
    return other ? undefined : main;
  }

  #play(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    // all screens keep their last picture
    if (this.#isLost || document.visibilityState === 'hidden') return;
    const [before, direct] = [this.#direct, this.#soloist()];
    this.#direct = direct;
    const isOther = before !== direct;
    // the previous owner of the canvas needs a copy in this very frame
    const queue = new Set(isOther && before?.hasSize ? [before] : []);
    for (const screen of this.#dirty) {
      if (screen.isSeen && !this.#away.has(screen)) queue.add(screen);
    }
    if (direct) queue.delete(direct);
    const next = [...queue].slice(0, direct ? atOnce - 1 : atOnce);
    for (const screen of next) {
      if (screen.isAside) void this.#drawAside(screen);
      else this.#drawCopy(screen);
    }
    const isDue = direct?.isSeen && this.#dirty.has(direct);
    if (direct && (isOther || isDue)) this.#drawDirectly(direct);
    if (next.length < queue.size) this.#schedule();
  }

  #drawDirectly(screen: Drawable): void {
    const {width, height} = screen.raster;
    this.#resize(width, height);
    this.#draw(screen);
    screen.hang(this.renderer.domElement);
  }

  #drawCopy(screen: Drawable): void {
    const {domElement: canvas} = this.renderer;
    const {width, height} = screen.raster;
    this.#resize(Math.max(width, canvas.width), Math.max(height, canvas.height));
    this.#draw(screen);
    screen.copy(canvas);
  }

  async #drawAside(screen: Drawable): Promise<void> {
    this.#away.add(screen);
    try {
      const picture = await readBack(this.renderer, screen.raster, () => {
        this.#draw(screen);
      });
      if (picture && this.#screens.has(screen)) screen.paint(picture);
    } finally {
      this.#away.delete(screen);
      if (this.#dirty.has(screen)) this.#schedule();
    }
  }

  #draw(screen: Drawable): void {
    const {width, height} = screen.raster;
    this.renderer.setViewport(0, 0, width, height);
    this.renderer.setScissor(0, 0, width, height);
    this.renderer.clear();
    screen.draw();
    if (this.#dirty.delete(screen)) screen.arrange();
  }

  #resize(width: number, height: number): void {
    const {domElement: canvas} = this.renderer;
    if (width === canvas.width && height === canvas.height) return;
    this.renderer.setSize(width, height, false);
  }

  /** Sets the state that a restored context has lost. */
  #prepare(): void {
    this.renderer.setClearColor(0x000000, 0); // the page's own background shows through
    this.renderer.setScissorTest(true);
  }

  /** three.js restores everything else of a returning context. */
  #turn(isLost: boolean): void {
    this.#isLost = isLost;
    if (!isLost) this.#prepare();
    for (const screen of this.#screens) {
      screen.lost(isLost);
      this.request(screen);
    }
  }

  #dispose(): void {
    this.#ended();
    this.#life.abort();
    cancelAnimationFrame(this.#frame);
    this.renderer.dispose();
    if (!this.#isLost) this.renderer.forceContextLoss();
  }
}
