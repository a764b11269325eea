/** The view of a pattern: its pieces on a sheet, each filled with the print as it lies on it. Drawn only when something changes. */
import {OrthographicCamera, Scene} from 'three';

import type {Point} from '../model/geometry.js';
import {imageCell} from '../model/wallpaper.js';
import {Labels} from './labels.js';
import {LineLayer, LineMaterial, type Stroke} from './line-layer.js';
import {movementStrokes} from './movement.js';
import {navigate, type TakesPress} from './navigation.js';
import {OverlayChips} from './overlay-chips.js';
import {overlayStrokes, type Overlay} from './overlay.js';
import {PrintMaterial} from './print-layer.js';
import {SceneLayers} from './scene-layers.js';
import {pieceAt, type PatternScene} from './scene.js';
import {look, Screen} from './screen.js';
import {SeamNotes} from './seam-notes.js';
import {fitted, panned, toScreen, toSheet, zoomed, type SheetView} from './sheet-view.js';
import {sheetOnPaper, snapshot, type Shot} from './snapshot.js';
import type {Appearance} from './strokes.js';
import {TileTexture} from './tile-texture.js';
import type {Tile} from './tile.js';

/** After this long without a change an SVG tile is drawn as densely as the zoom asks for. [ms] */
const rest = 150;
/** Of a picture of the sheet. [px] */
const pictureWidth = 2400;
const greatestPictureSide = 8192;
/** For the picture of a view that is narrower, or has no size yet. [CSS px] */
const leastRoom = 320;

export interface PatternViewOptions {
  readonly appearance?: Appearance;
  /** True: the page follows this press itself, and nothing pans. */
  readonly onPress?: TakesPress;
  /** The wheel scrolls the page, and zooms with ctrl only. */
  readonly leavesWheel?: boolean;
  /** The browser has taken the graphics context away, or given it back, which it may never do. */
  readonly onLost?: (isLost: boolean) => void;
}

/** Another scene of the same sheet, to the left of a line at this part of the width. */
export interface Wipe {
  readonly before: PatternScene;
  readonly split: number;
}

export class PatternView {
  readonly #screen: Screen;
  readonly #labels: Labels;
  readonly #notes = new SeamNotes();
  readonly #chips = new OverlayChips();
  readonly #tile: TileTexture;
  readonly #cloth = new PrintMaterial();
  readonly #line = new LineMaterial();
  readonly #after = new SceneLayers({cloth: this.#cloth, line: this.#line});
  readonly #before = new SceneLayers({cloth: this.#cloth, line: this.#line});
  readonly #over = new Scene();
  readonly #camera = new OrthographicCamera();
  readonly #listeners = new Set<() => void>();
  #movementLayer: LineLayer | undefined;
  #overlayLayer: LineLayer | undefined;
  #appearance: Appearance;
  #hasSeams = true;
  #isBare = false;
  #wipe: Wipe | undefined;
  #movement: {readonly factor: number} | undefined;
  #overlay: Overlay | undefined;
  #picture: Tile | undefined;
  #view: SheetView = {centre: [0, 0], scale: 1};
  /** Nobody has moved the view since it was fitted: it stays so when the room changes. */
  #isFitted = true;
  #pause: ReturnType<typeof setTimeout> | undefined;

  /**
   * Fills `host`, an empty element with a size of its own, and listens to pointers and keys there.
   * @throws {Error} where the browser has no WebGL 2
   */
  constructor(host: HTMLElement, options: PatternViewOptions = {}) {
    this.#appearance = options.appearance ?? 'light';
    this.#screen = new Screen(host, {
      resized: () => {
        if (this.#isFitted) this.fit();
        else this.#move(this.#view);
      },
      draw: () => {
        this.#draw();
      },
      arrange: () => {
        this.#arrange();
      },
      lost: (isLost) => options.onLost?.(isLost),
    });
    this.#tile = new TileTexture(this.#screen.renderer, (texture) => {
      this.#cloth.uniforms.tile.value = texture;
      this.#screen.request();
    });
    this.#labels = new Labels(this.#appearance);
    host.append(this.#labels.element, this.#notes.element, this.#chips.element);
    navigate(host, this, this.#screen.signal, {
      takesPress: options.onPress,
      leavesWheel: options.leavesWheel,
    });
  }

  /** [CSS px per cm] */
  get scale(): number {
    return this.#view.scale;
  }

  /** What part of the sheet is shown, to come back to it. */
  get state(): SheetView {
    return this.#view;
  }

  set state(view: SheetView) {
    if (this.#scene) this.#move(zoomed(view, this.#screen.size, this.#scene.size, 1, this.#middle));
  }

  /** Cheap when only alignments differ from the scene before. A sheet of another size is fitted to the view. */
  show(scene: PatternScene): void {
    const before = this.#scene;
    this.#lay(scene);
    if (before?.print !== scene.print) this.setTile(this.#picture);
    const sameSheet = before?.size.every((side, k) => side === scene.size[k]) ?? false;
    if (!sameSheet) this.fit();
  }

  /** The picture of the print's cell; without one, bare cloth. */
  setTile(tile: Tile | undefined): void {
    this.#picture = tile;
    if (this.#scene) this.#tile.set(tile, imageCell(this.#scene.print));
  }

  /** For a light or dark page; the page itself gives the background. */
  setAppearance(appearance: Appearance): void {
    if (appearance === this.#appearance) return;
    this.#appearance = appearance;
    this.#layAgain();
  }

  /** Whether seams are drawn by how they match, with ranks at the worst. They are by default. */
  setSeams(hasSeams: boolean): void {
    if (hasSeams === this.#hasSeams) return;
    this.#hasSeams = hasSeams;
    this.#layAgain();
  }

  /** Whether nothing but the cloth is shown: no lines, no names, no marks; in pictures as well. */
  setBare(isBare: boolean): void {
    if (isBare === this.#isBare) return;
    this.#isBare = isBare;
    this.#showLines();
    this.#showWords();
    this.#screen.request();
  }

  /** Shows `before` to the left of the split: the same sheet, so nothing jumps. Cheap when only the split changes. */
  setWipe(wipe: Wipe | undefined): void {
    const {before} = this.#wipe ?? {};
    this.#wipe = wipe;
    if (wipe && wipe.before !== before) this.#layBefore(wipe);
    this.#screen.request();
  }

  /** Ghosts the drafted outlines and shows by arrows how they were reshaped. */
  setMovement(movement: {readonly factor: number} | undefined): void {
    this.#movement = movement;
    this.#drawMovement();
  }

  /** Draws over the sheet; nothing else is touched, so it may follow a pointer. */
  setOverlay(overlay: Overlay | undefined): void {
    this.#overlay = overlay;
    this.#drawOverlay();
  }

  /** Shows the whole sheet. */
  fit(): void {
    if (!this.#scene) return;
    this.#move(fitted(this.#scene.size, this.#screen.size));
    this.#isFitted = true;
  }

  /** About a point of the screen, by default its middle. */
  zoomBy(factor: number, at: Point = this.#middle): void {
    if (!this.#scene) return;
    this.#move(zoomed(this.#view, this.#screen.size, this.#scene.size, factor, at));
  }

  /** The sheet follows by (dx, dy). [CSS px] */
  panBy(dx: number, dy: number): void {
    if (this.#scene) this.#move(panned(this.#view, this.#scene.size, dx, dy));
  }

  /** A point of the sheet [cm] as a point of the host, from its upper left. [CSS px] */
  screenOf(point: Point): Point {
    return toScreen(this.#view, this.#screen.size, point);
  }

  /** A point of the host, from its upper left [CSS px], as a point of the sheet. [cm] */
  sheetPointAt(x: number, y: number): Point {
    return toSheet(this.#view, this.#screen.size, [x, y]);
  }

  /** The piece under a point of the host, and the point in that piece's own coordinates. */
  pieceAt(x: number, y: number): ReturnType<typeof pieceAt> {
    return this.#scene && pieceAt(this.#scene, this.sheetPointAt(x, y));
  }

  /** The greatest width of a picture of the whole sheet. [px] */
  get widestPicture(): number {
    const [width, height] = this.#scene?.size ?? [1, 1];
    const most = Math.min(greatestPictureSide, this.#screen.renderer.capabilities.maxTextureSize);
    return Math.floor(most * Math.min(1, width / height));
  }

  /** The whole sheet as a PNG of so many pixels across, in the colours of the page. @throws {Error} before anything is shown, or while the graphics context is lost */
  async toBlob(width = pictureWidth): Promise<Blob> {
    const scene = this.#scene;
    if (!scene) throw new Error('There is no sheet to draw yet.');
    const shot = this.#frame(scene, width);
    const {renderer} = this.#screen;
    const blob = snapshot(renderer, this.#drawn, this.#named(scene), shot, this.#appearance);
    this.#screen.request();
    return blob;
  }

  /** The whole sheet on white, at once, for the printer. @returns nothing before anything is shown, or while the graphics context is lost */
  onPaper(): HTMLCanvasElement | undefined {
    const appearance = this.#appearance;
    this.setAppearance('light');
    const scene = this.#scene;
    const shot = scene && this.#frame(scene, pictureWidth);
    const {renderer} = this.#screen;
    const sheet = shot && sheetOnPaper(renderer, this.#drawn, this.#named(scene), shot);
    this.setAppearance(appearance);
    this.#screen.request();
    return sheet;
  }

  get #drawn(): readonly [Scene, OrthographicCamera] {
    return [this.#after.object, this.#camera];
  }

  #named(scene: PatternScene): PatternScene {
    return this.#isBare ? {...scene, pieces: []} : scene;
  }

  /** Looks at the whole sheet, drawn so many pixels wide. */
  #frame(scene: PatternScene, width: number): Shot {
    const {size} = this.#screen;
    const across = Math.max(size.width, leastRoom);
    const room = {width: across, height: (across * scene.size[1]) / scene.size[0]};
    const view = fitted(scene.size, room);
    const ratio = Math.min(width, this.widestPicture) / room.width;
    const shot = {
      ...{view, ratio},
      width: Math.round(room.width * ratio),
      height: Math.round(room.height * ratio),
    };
    this.#tile.sharpen(view.scale * ratio);
    look(this.#camera, this.#line, view, shot);
    return shot;
  }

  /** Calls back after every zoom, move or change of size. @returns what ends that */
  onViewChange(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  dispose(): void {
    clearTimeout(this.#pause);
    this.#movementLayer?.dispose();
    this.#overlayLayer?.dispose();
    this.#after.dispose();
    this.#before.dispose();
    this.#tile.dispose();
    this.#cloth.dispose();
    this.#line.dispose();
    this.#screen.dispose();
    for (const {element} of [this.#labels, this.#notes, this.#chips]) element.remove();
  }

  get #scene(): PatternScene | undefined {
    return this.#after.scene;
  }

  get #middle(): Point {
    return [this.#screen.size.width / 2, this.#screen.size.height / 2];
  }

  #lay(scene: PatternScene): void {
    const before = this.#scene;
    const isNew = this.#after.show(scene, this.#appearance);
    this.#showLines();
    const shown = [scene, this.#appearance] as const;
    if (isNew) {
      this.#labels.show(scene, this.#appearance);
      this.#notes.show(...shown);
      this.#drawMovement();
    } else if (before?.seams !== scene.seams) this.#notes.update(...shown);
    this.#showWords();
    if (this.#overlay) this.#drawOverlay();
    this.#screen.request();
  }

  #showLines(): void {
    for (const layers of [this.#after, this.#before])
      layers.showLines(!this.#isBare, this.#hasSeams);
  }

  #showWords(): void {
    const show = (words: {readonly element: HTMLElement}, isShown: boolean): void => {
      words.element.style.display = isShown ? '' : 'none';
    };
    show(this.#labels, !this.#isBare);
    show(this.#chips, !this.#isBare);
    show(this.#notes, !this.#isBare && this.#hasSeams);
  }

  #layBefore({before}: Wipe): void {
    this.#before.show(before, this.#appearance);
    this.#showLines();
  }

  #layAgain(): void {
    if (this.#scene) this.#lay(this.#scene);
    if (this.#wipe) this.#layBefore(this.#wipe);
  }

  #drawMovement(): void {
    this.#movementLayer = this.#replaced(
      this.#movementLayer,
      this.#scene && this.#movement
        ? movementStrokes(this.#scene, this.#movement.factor, this.#appearance)
        : [],
      0,
    );
  }

  #drawOverlay(): void {
    const [scene, overlay] = [this.#scene, this.#overlay];
    const strokes = scene && overlay ? overlayStrokes(scene, overlay, this.#appearance) : [];
    this.#overlayLayer = this.#replaced(this.#overlayLayer, strokes, 1);
    if (scene && overlay) this.#chips.show(scene, overlay, this.#appearance);
    else this.#chips.clear();
    this.#notes.highlight(overlay?.highlight?.seam);
  }

  #replaced(
    layer: LineLayer | undefined,
    strokes: readonly Stroke[],
    order: number,
  ): LineLayer | undefined {
    if (layer) this.#over.remove(layer.object);
    layer?.dispose();
    this.#screen.request();
    if (strokes.length === 0) return undefined;
    const next = new LineLayer(strokes, this.#line, order);
    this.#over.add(next.object);
    return next;
  }

  #move(view: SheetView): void {
    this.#view = view;
    this.#isFitted = false;
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => {
      this.#tile.sharpen(view.scale * this.#screen.raster.ratio);
    }, rest);
    this.#screen.request();
    for (const listener of this.#listeners) listener();
  }

  #draw(): void {
    if (!this.#scene) return;
    const {renderer, size, raster} = this.#screen;
    look(this.#camera, this.#line, this.#view, raster);
    if (this.#wipe) {
      this.#screen.clip(0, this.#split);
      renderer.render(this.#before.object, this.#camera);
    }
    this.#screen.clip(this.#split, size.width);
    renderer.render(this.#after.object, this.#camera);
    this.#screen.clip(0, size.width);
    if (!this.#isBare) renderer.render(this.#over, this.#camera);
  }

  /** Where the scene before ends. [CSS px from the left] */
  get #split(): number {
    return Math.min(1, Math.max(0, this.#wipe?.split ?? 0)) * this.#screen.size.width;
  }

  #arrange(): void {
    if (!this.#scene) return;
    const {size} = this.#screen;
    const taken = this.#labels.place(this.#view, size);
    // numbers are those of the scene on the right
    const left = {left: 0, top: 0, right: this.#split, bottom: size.height};
    if (this.#hasSeams) this.#notes.place(this.#view, size, [...taken, left]);
    this.#chips.place(this.#view, size);
  }
}
