/** The view of a pattern: its pieces on a sheet, each filled with the print as it lies on it. Drawn only when something changes. */
import {OrthographicCamera} from 'three';

import type {Point} from '../model/geometry.js';
import {imageCell} from '../model/wallpaper.js';
import {LineMaterial} from './line-layer.js';
import {Morph, morphTime, type Motion} from './morph.js';
import {navigate, type TakesPress} from './navigation.js';
import {OverLayers} from './over-layers.js';
import type {Overlay} from './overlay.js';
import {PrintMaterial} from './print-layer.js';
import {SceneLayers} from './scene-layers.js';
import {pieceAt, type PatternScene} from '../scene/scene.js';
import {look, Screen} from './screen.js';
import type {ScreenSize} from '../scene/sheet-view.js';
import {framed, sheetOnPaper, snapshot, widestPicture, type Drawing} from './snapshot.js';
import type {Appearance} from './strokes.js';
import {TileTexture} from './tile-texture.js';
import type {Tile} from '../recognition/tile.js';
import {Viewport} from './viewport.js';
import {WipeLayers, type Wipe} from './wipe-layers.js';
import {Words} from './words.js';

/** After this long without a change an SVG tile is drawn as densely as the zoom asks for. [ms] */
const rest = 150;
/** Of a picture of the sheet. [px] */
const pictureWidth = 2400;

export interface PatternViewOptions {
  readonly appearance?: Appearance;
  /** True: the page follows this press itself, and nothing pans. */
  readonly onPress?: TakesPress;
  /** The wheel scrolls the page, and zooms with ctrl only. */
  readonly leavesWheel?: boolean;
  /** The browser has taken the graphics context away, or given it back, which it may never do. */
  readonly onLost?: (isLost: boolean) => void;
}

export class PatternView extends Viewport {
  readonly #screen: Screen;
  readonly #words: Words;
  readonly #tile: TileTexture;
  readonly #cloth = new PrintMaterial();
  readonly #line = new LineMaterial();
  readonly #after = new SceneLayers({cloth: this.#cloth, line: this.#line});
  readonly #before = new WipeLayers({cloth: this.#cloth, line: this.#line});
  readonly #over = new OverLayers(this.#line);
  readonly #morph = new Morph();
  readonly #camera = new OrthographicCamera();
  #appearance: Appearance;
  #hasSeams = true;
  #isBare = false;
  #movement: {readonly factor: number} | undefined;
  #overlay: Overlay | undefined;
  #picture: Tile | undefined;
  #pause: ReturnType<typeof setTimeout> | undefined;

  /**
   * Fills `host`, an empty element with a size of its own, and listens to pointers and keys there.
   * @throws {Error} where the browser has no WebGL 2
   */
  constructor(host: HTMLElement, options: PatternViewOptions = {}) {
    super();
    this.#appearance = options.appearance ?? 'light';
    this.#screen = new Screen(host, {
      resized: () => {
        this.resized();
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
    this.#words = new Words(host, this.#appearance);
    this.onViewChange(() => {
      this.#moved();
    });
    navigate(host, this, this.#screen.signal, {
      takesPress: options.onPress,
      leavesWheel: options.leavesWheel,
    });
  }

  /**
   * Cheap when only alignments differ from the scene before. A sheet of another size is fitted to the view.
   * Whatever moves on the screen, everything else here goes by the scene as it is: points, pictures, words.
   * @param motion what moves there instead of being there at once, where the pieces are the same
   * @param time of that motion [ms]
   */
  show(scene: PatternScene, motion: Motion = 'none', time = morphTime): void {
    const before = this.#scene;
    if (scene === before) return;
    this.#lay(scene, motion, time);
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
    this.#showParts();
    this.#screen.request();
  }

  /** Shows `before` to the left of the split: the same sheet, so nothing jumps. Cheap when only the split changes. */
  setWipe(wipe: Wipe | undefined): void {
    if (this.#before.set(wipe, this.#appearance)) this.#showParts();
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

  /** The piece under a point of the host, and the point in that piece's own coordinates. */
  pieceAt(x: number, y: number): ReturnType<typeof pieceAt> {
    return this.#scene && pieceAt(this.#scene, this.sheetPointAt(x, y));
  }

  /** The greatest width of a picture of the whole sheet. [px] */
  get widestPicture(): number {
    return widestPicture(this.#screen.renderer, this.#scene?.size ?? [1, 1]);
  }

  /** The whole sheet as a PNG of so many pixels across, in the colours of the page. @throws {Error} before anything is shown, or while the graphics context is lost */
  async toBlob(width = pictureWidth): Promise<Blob> {
    const scene = this.#scene;
    if (!scene) throw new Error('There is no sheet to draw yet.');
    const drawing = this.#settled();
    const shot = framed(drawing, scene, width, this.#screen.size.width);
    const blob = snapshot(drawing, this.#named(scene), shot, this.#appearance);
    this.#screen.request();
    return blob;
  }

  /** The whole sheet on white, at once, for the printer. @returns nothing before anything is shown, or while the graphics context is lost */
  onPaper(): HTMLCanvasElement | undefined {
    const appearance = this.#appearance;
    const scene = this.#scene;
    if (!scene) return undefined;
    this.setAppearance('light');
    const drawing = this.#settled();
    const shot = framed(drawing, scene, pictureWidth, this.#screen.size.width);
    const sheet = sheetOnPaper(drawing, this.#named(scene), shot);
    this.setAppearance(appearance);
    this.#screen.request();
    return sheet;
  }

  dispose(): void {
    clearTimeout(this.#pause);
    this.#over.dispose();
    this.#after.dispose();
    this.#before.dispose();
    this.#tile.dispose();
    this.#cloth.dispose();
    this.#line.dispose();
    this.#screen.dispose();
    this.#words.dispose();
  }

  protected get sheetSize(): Point | undefined {
    return this.#scene?.size;
  }

  protected get room(): ScreenSize {
    return this.#screen.size;
  }

  get #scene(): PatternScene | undefined {
    return this.#after.scene;
  }

  #named(scene: PatternScene): PatternScene {
    return this.#isBare ? {...scene, pieces: []} : scene;
  }

  /** What is drawn, at the end of its way. */
  #settled(): Drawing {
    this.#morph.end();
    this.#after.blend(1);
    return {
      ...{renderer: this.#screen.renderer, object: this.#after.object, tile: this.#tile},
      ...{camera: this.#camera, line: this.#line},
    };
  }

  #lay(scene: PatternScene, motion: Motion = 'none', time = morphTime): void {
    const before = this.#scene;
    const shown = [scene, this.#appearance] as const;
    const {isNew, moves} = this.#after.show(...shown, this.#screen.isSeen ? motion : 'none');
    if (moves) this.#morph.begin(time);
    else this.#morph.end();
    this.#showParts();
    if (isNew) {
      this.#words.show(...shown);
      this.#drawMovement();
    } else if (before?.seams !== scene.seams) this.#words.update(...shown);
    if (this.#overlay) this.#drawOverlay();
    this.#screen.request();
  }

  #showParts(): void {
    for (const layers of [this.#after, this.#before])
      layers.showLines(!this.#isBare, this.#hasSeams);
    this.#words.setShown(!this.#isBare, this.#hasSeams);
  }

  #layAgain(): void {
    if (this.#scene) this.#lay(this.#scene);
    if (this.#before.layAgain(this.#appearance)) this.#showParts();
  }

  #drawMovement(): void {
    this.#over.showMovement(this.#scene, this.#movement?.factor, this.#appearance);
    this.#screen.request();
  }

  #drawOverlay(): void {
    const shown = [this.#scene, this.#overlay, this.#appearance] as const;
    this.#over.showOverlay(...shown);
    this.#words.showOverlay(...shown);
    this.#screen.request();
  }

  #moved(): void {
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => {
      this.#tile.sharpen(this.scale * this.#screen.raster.ratio);
    }, rest);
    this.#screen.request();
  }

  #draw(): void {
    if (!this.#scene) return;
    const {renderer, size, raster} = this.#screen;
    look(this.#camera, this.#line, this.state, raster);
    this.#after.blend(this.#morph.share);
    this.#before.draw(this.#screen, this.#camera);
    renderer.render(this.#after.object, this.#camera);
    this.#screen.clip(0, size.width);
    if (!this.#isBare) renderer.render(this.#over.object, this.#camera);
  }

  #arrange(): void {
    if (!this.#scene) return;
    const {size} = this.#screen;
    this.#words.place(this.state, size, this.#before.splitOn(size.width));
    if (this.#morph.isRunning) this.#screen.request();
  }
}
