/** The view of a pattern: its pieces on a sheet, each filled with the print as it lies on it. Drawn only when something changes. */
import {OrthographicCamera, Scene, WebGLRenderer} from 'three';

import type {Point} from '../model/geometry.js';
import {imageCell} from '../model/wallpaper.js';
import {Labels} from './labels.js';
import {LineLayer, LineMaterial} from './line-layer.js';
import {navigate} from './navigation.js';
import {PrintLayer, PrintMaterial} from './print-layer.js';
import {pieceAt, type PatternScene} from './scene.js';
import {fitted, panned, toScreen, toSheet, zoomed, type SheetView} from './sheet-view.js';
import {markStrokes, outlineStrokes, seamStrokes, type Appearance} from './strokes.js';
import {TileTexture, type Tile} from './tile-texture.js';

/** After this long without a change an SVG tile is drawn as densely as the zoom asks for. [ms] */
const rest = 150;

/** Lines are thinner at scales below this. [CSS px per cm] */
const thinBelow = 4;

interface Layers {
  readonly print: PrintLayer;
  readonly outlines: LineLayer;
  readonly seams: LineLayer;
  readonly marks: LineLayer;
}

/** Whether two scenes differ in nothing but how the pieces lie on the print. */
const sameGeometry = (a: PatternScene, b: PatternScene): boolean =>
  a.symmetries === b.symmetries &&
  a.seams.length === b.seams.length &&
  a.seams.every(({a: side}, k) => side === b.seams[k]?.a) &&
  a.pieces.length === b.pieces.length &&
  a.pieces.every(
    ({points, offset}, k) => points === b.pieces[k]?.points && offset === b.pieces[k].offset,
  );

export class PatternView {
  readonly #host: HTMLElement;
  readonly #renderer: WebGLRenderer;
  readonly #labels: Labels;
  readonly #tile: TileTexture;
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera();
  readonly #cloth = new PrintMaterial();
  readonly #line = new LineMaterial();
  readonly #life = new AbortController();
  readonly #resized: ResizeObserver;
  readonly #listeners = new Set<() => void>();
  #appearance: Appearance;
  #shown: PatternScene | undefined;
  #layers: Layers | undefined;
  #picture: Tile | undefined;
  #view: SheetView = {centre: [0, 0], scale: 1};
  /** Nobody has moved the view since it was fitted: it stays so when the room changes. */
  #isFitted = true;
  #size = {width: 1, height: 1};
  #frame = 0;
  #pause: ReturnType<typeof setTimeout> | undefined;

  /**
   * Fills `host`, an empty element with a size of its own, and listens to pointers and keys there.
   * @throws {Error} where the browser has no WebGL 2
   */
  constructor(host: HTMLElement, {appearance = 'light'}: {appearance?: Appearance} = {}) {
    this.#host = host;
    this.#appearance = appearance;
    this.#renderer = new WebGLRenderer({alpha: true, antialias: false, depth: false});
    this.#renderer.setClearColor(0x000000, 0); // the page's own background shows through
    const {capabilities, domElement: canvas} = this.#renderer;
    this.#tile = new TileTexture(
      {anisotropy: capabilities.getMaxAnisotropy(), side: capabilities.maxTextureSize},
      (texture) => {
        this.#cloth.uniforms.tile.value = texture;
        this.#request();
      },
    );
    this.#labels = new Labels(appearance);
    Object.assign(canvas.style, {display: 'block', position: 'absolute', left: '0', top: '0'});
    if (getComputedStyle(host).position === 'static') host.style.position = 'relative';
    host.append(canvas, this.#labels.element);

    const {signal} = this.#life;
    canvas.addEventListener(
      'webglcontextrestored',
      () => {
        this.#request();
      },
      {signal},
    );
    navigate(host, this, signal);
    this.#resized = new ResizeObserver(() => {
      this.#resize();
    });
    this.#resized.observe(host);
    this.#watchRatio();
    this.#resize();
  }

  /** [CSS px per cm] */
  get scale(): number {
    return this.#view.scale;
  }

  /** Cheap when only alignments differ from the scene before. A sheet of another size is fitted to the view. */
  show(scene: PatternScene): void {
    const before = this.#shown;
    this.#shown = scene;
    if (before && this.#layers && sameGeometry(before, scene)) {
      this.#layers.seams.restyle(seamStrokes(scene, this.#appearance));
    } else {
      this.#build(scene);
    }
    this.#layers?.print.align(scene.pieces, scene.print);
    if (before?.print !== scene.print) this.setTile(this.#picture);
    const sameSheet = before?.size.every((side, k) => side === scene.size[k]) ?? false;
    if (!sameSheet) this.fit();
    this.#request();
  }

  /** The picture of the print's cell; without one, bare cloth. */
  setTile(tile: Tile | undefined): void {
    this.#picture = tile;
    if (this.#shown) this.#tile.set(tile, imageCell(this.#shown.print));
  }

  /** For a light or dark page; the page itself gives the background. */
  setAppearance(appearance: Appearance): void {
    if (appearance === this.#appearance) return;
    this.#appearance = appearance;
    if (!this.#shown) return;
    this.#build(this.#shown);
    this.#layers?.print.align(this.#shown.pieces, this.#shown.print);
    this.#request();
  }

  /** Shows the whole sheet. */
  fit(): void {
    if (!this.#shown) return;
    this.#move(fitted(this.#shown.size, this.#size));
    this.#isFitted = true;
  }

  /** About a point of the screen, by default its middle. */
  zoomBy(factor: number, at: Point = [this.#size.width / 2, this.#size.height / 2]): void {
    if (this.#shown) this.#move(zoomed(this.#view, this.#size, this.#shown.size, factor, at));
  }

  /** The sheet follows by (dx, dy). [CSS px] */
  panBy(dx: number, dy: number): void {
    if (this.#shown) this.#move(panned(this.#view, this.#shown.size, dx, dy));
  }

  /** A point of the sheet [cm] as a point of the host, from its upper left. [CSS px] */
  screenOf(point: Point): Point {
    return toScreen(this.#view, this.#size, point);
  }

  /** A point of the host, from its upper left [CSS px], as a point of the sheet. [cm] */
  sheetPointAt(x: number, y: number): Point {
    return toSheet(this.#view, this.#size, [x, y]);
  }

  /** The piece under a point of the host, and the point in that piece's own coordinates. */
  pieceAt(x: number, y: number): ReturnType<typeof pieceAt> {
    return this.#shown && pieceAt(this.#shown, this.sheetPointAt(x, y));
  }

  /** Calls back after every zoom, move or change of size. @returns what ends that */
  onViewChange(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  dispose(): void {
    this.#life.abort();
    this.#resized.disconnect();
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#pause);
    this.#dropLayers();
    this.#tile.dispose();
    this.#cloth.dispose();
    this.#line.dispose();
    this.#renderer.dispose();
    this.#renderer.domElement.remove();
    this.#labels.element.remove();
  }

  #build(scene: PatternScene): void {
    this.#dropLayers();
    const lines = (strokes: typeof seamStrokes, order: number): LineLayer =>
      new LineLayer(strokes(scene, this.#appearance), this.#line, order);
    this.#layers = {
      print: new PrintLayer(scene.pieces, this.#cloth),
      outlines: lines(outlineStrokes, 1),
      seams: lines(seamStrokes, 2),
      marks: lines(markStrokes, 3),
    };
    this.#scene.add(...Object.values(this.#layers).map(({object}: Layers[keyof Layers]) => object));
    this.#labels.show(scene, this.#appearance);
  }

  #dropLayers(): void {
    this.#scene.clear();
    for (const layer of Object.values(this.#layers ?? {}) as Layers[keyof Layers][])
      layer.dispose();
    this.#layers = undefined;
  }

  #move(view: SheetView): void {
    this.#view = view;
    this.#isFitted = false;
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => {
      this.#tile.sharpen(view.scale * this.#renderer.getPixelRatio());
    }, rest);
    this.#request();
    for (const listener of this.#listeners) listener();
  }

  #resize(): void {
    const {clientWidth, clientHeight} = this.#host;
    const ratio = globalThis.devicePixelRatio;
    // whole device pixels, so that every one of them is drawn
    const [width, height] = [clientWidth, clientHeight].map(
      (side) => Math.max(1, Math.round(side * ratio)) / ratio,
    ) as [number, number];
    this.#size = {width, height};
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height);
    if (this.#isFitted) this.fit();
    else this.#move(this.#view);
    this.#draw(); // a canvas is empty after a change of size
  }

  /** The ratio changes when a window moves to another screen, or the page is zoomed. */
  #watchRatio(): void {
    const query = matchMedia(`(resolution: ${globalThis.devicePixelRatio}dppx)`);
    const changed = (): void => {
      this.#resize();
      this.#watchRatio();
    };
    query.addEventListener('change', changed, {once: true, signal: this.#life.signal});
  }

  #request(): void {
    this.#frame ||= requestAnimationFrame(() => {
      this.#draw();
    });
  }

  #draw(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    if (!this.#layers || this.#life.signal.aborted) return;
    const {centre, scale} = this.#view;
    const ratio = this.#renderer.getPixelRatio();
    const {uniforms} = this.#line;
    const buffer = this.#renderer.getDrawingBufferSize(uniforms.buffer.value);
    const [halfWidth, halfHeight] = [buffer.x / ratio / scale / 2, buffer.y / ratio / scale / 2];
    this.#camera.left = -halfWidth;
    this.#camera.right = halfWidth;
    this.#camera.top = halfHeight;
    this.#camera.bottom = -halfHeight;
    this.#camera.position.set(centre[0], centre[1], 1);
    this.#camera.updateProjectionMatrix();
    uniforms.scale.value = scale * ratio;
    uniforms.ratio.value = ratio;
    uniforms.weight.value = Math.min(1, Math.max(0.5, scale / thinBelow));
    this.#renderer.render(this.#scene, this.#camera);
    this.#labels.place(this.#view, this.#size);
  }
}
