/**
 * The view of a pattern: pieces on a sheet, each filled with its part of the print. Draws only
 * after a change.
 */
import {OrthographicCamera} from 'three';

import type {Point} from '../model/geometry/vectors.js';
import {imageCell} from '../model/print/wallpaper.js';
import {LineMaterial} from './line-layer.js';
import {Morph, morphTime, type Motion} from './morph.js';
import {navigate, type TakesPress} from './navigation.js';
import {OverLayers, WipeLayers, type Wipe} from './over-layers.js';
import type {Overlay} from '../scene/overlay.js';
import {PrintMaterial} from './print-layer.js';
import {SceneLayers} from './scene-layers.js';
import {pieceAt, type PatternScene} from '../scene/scene.js';
import {look, Screen} from './screen.js';
import type {ScreenSize} from '../scene/sheet-view.js';
import {framed, sheetOnPaper, snapshot, widestPicture, type Drawing} from './snapshot.js';
import type {Appearance} from './strokes.js';
import {TileTexture} from './tile-texture.js';
import type {Tile} from '../image/tile.js';
import {Viewport, Words} from './viewport.js';

/** Delay after the last change before an SVG tile is drawn at the density of the zoom. [ms] */
const rest = 150;
/** Width of a picture of the sheet. [px] */
const pictureWidth = 2400;

export interface PatternViewOptions {
  readonly appearance?: Appearance;
  /** Returns true if the page handles this press; the view then does not pan. */
  readonly onPress?: TakesPress;
  /** The wheel scrolls the page, and zooms with ctrl only. */
  readonly leavesWheel?: boolean;
  /**
   * Called after the browser has taken the graphics context away, or has restored it, which may
   * never happen.
   */
  readonly onLost?: (isLost: boolean) => void;
}

export class PatternView extends Viewport {
  readonly #screen: Screen;
  readonly #words: Words;
  readonly #tile: TileTexture;
  readonly #fabric = new PrintMaterial();
  readonly #line = new LineMaterial();
  readonly #after = new SceneLayers({fabric: this.#fabric, line: this.#line});
  readonly #before = new WipeLayers({fabric: this.#fabric, line: this.#line});
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
   * Fills `host`, an empty element with its own size, and listens to pointers and keys there.
   * @throws {Error} if the browser has no WebGL 2
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
      this.#fabric.uniforms.tile.value = texture;
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
   * Shows a scene; cheap when only alignments differ from the scene before. A sheet of another size
   * is fitted to the view. During a motion, points, pictures and words already use the new scene.
   * @param motion parts that are animated if the pieces are the same
   * @param time duration of that motion [ms]
   */
  show(scene: PatternScene, motion: Motion = 'none', time = morphTime): void {
    const before = this.#scene;
    if (scene === before) return;
    this.#lay(scene, motion, time);
    if (before?.print !== scene.print) this.setTile(this.#picture);
    const sameSheet = before?.size.every((side, k) => side === scene.size[k]) ?? false;
    if (!sameSheet) this.fit();
  }

  /** Sets the image of the print's cell; without one, the fabric is plain. */
  setTile(tile: Tile | undefined): void {
    this.#picture = tile;
    if (this.#scene) this.#tile.set(tile, imageCell(this.#scene.print));
  }

  /** Adapts to a light or dark page; the page itself provides the background. */
  setAppearance(appearance: Appearance): void {
    if (appearance === this.#appearance) return;
    this.#appearance = appearance;
    this.#layAgain();
  }

  /** Sets whether seams are coloured by mismatch. Default: true. */
  setSeams(hasSeams: boolean): void {
    if (hasSeams === this.#hasSeams) return;
    this.#hasSeams = hasSeams;
    this.#layAgain();
  }

  /**
   * Sets whether only the fabric is shown, without lines, names and marks; applies to pictures as
   * well.
   */
  setBare(isBare: boolean): void {
    if (isBare === this.#isBare) return;
    this.#isBare = isBare;
    this.#showParts();
    this.#screen.request();
  }

  /**
   * Shows `before` to the left of the split: the same sheet, so nothing jumps. Cheap when only the
   * split changes.
   */
  setWipe(wipe: Wipe | undefined): void {
    if (this.#before.set(wipe, this.#appearance)) this.#showParts();
    this.#screen.request();
  }

  /** Shows the drafted outlines, and arrows for the change of shape. */
  setMovement(movement: {readonly factor: number} | undefined): void {
    this.#movement = movement;
    this.#drawMovement();
  }

  /** Draws over the sheet and changes nothing else, so it is fast enough to follow a pointer. */
  setOverlay(overlay: Overlay | undefined): void {
    this.#overlay = overlay;
    this.#drawOverlay();
  }

  /** Returns the piece under a point of the host, and the point in that piece's own coordinates. */
  pieceAt(x: number, y: number): ReturnType<typeof pieceAt> {
    return this.#scene && pieceAt(this.#scene, this.sheetPointAt(x, y));
  }

  /** Greatest width of a picture of the whole sheet. [px] */
  get widestPicture(): number {
    return widestPicture(this.#screen.renderer, this.#scene?.size ?? [1, 1]);
  }

  /**
   * Returns the whole sheet as a PNG, in the colours of the page.
   * @param width of the picture [px]
   * @throws {Error} before a scene is shown, or while the graphics context is lost
   */
  async toBlob(width = pictureWidth): Promise<Blob> {
    const scene = this.#scene;
    if (!scene) throw new Error('There is no sheet to draw yet.');
    const drawing = this.#settled();
    const shot = framed(drawing, scene, width, this.#screen.size.width);
    const blob = snapshot(drawing, this.#named(scene), shot, this.#appearance);
    this.#screen.request();
    return blob;
  }

  /**
   * Returns the whole sheet on white for the printer, synchronously.
   * @returns undefined before a scene is shown, or while the graphics context is lost
   */
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
    this.#fabric.dispose();
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

  /** Ends the motion and returns the drawing. */
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
    } else if (before?.seams !== scene.seams) this.#words.update(scene);
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
    this.#words.place(this.state, size);
    if (this.#morph.isRunning) this.#screen.request();
  }
}
