/**
 * The view of a drape: its fabric with the print, on a tailor's dummy. Draws only after a change.
 */
import type {DrapeMesh, FabricName, Form} from '../../model/result/draped-garment.js';
import type {Point} from '../../model/geometry/vectors.js';
import {imageCell} from '../../model/print/wallpaper.js';
import type {Tile} from '../../image/tile.js';
import type {PatternScene} from '../../scene/scene.js';
import {navigate} from '../navigation.js';
import {Screen} from '../screen.js';
import {inks, type Appearance} from '../strokes.js';
import {TileTexture} from '../tile-texture.js';
import type {Wipe} from '../over-layers.js';
import {fieldOfView, turned, type Orbit} from './camera.js';
import {DrapeCamera} from './drape-camera.js';
import {finest, MovingFineness} from './fineness.js';
import {DrapePicker, type DrapeTarget} from './drape-picker.js';
import {followPointer} from './follow-pointer.js';
import {garmentPicture, type Paper} from './picture.js';
import {DrapeScene, type Marked} from './drape-scene.js';

/**
 * Delay after the last change before it is drawn at full detail, and an SVG tile at the density of
 * the zoom. [ms]
 */
const rest = 150;
/** The same delay between two poses of a garment that still moves. [ms] */
const betweenPoses = 1000;
/** Turn for a drag. [radians per CSS px] */
const dragTurn = 0.007;
/** Greatest distance of a pointer from a seam that it selects. [CSS px] */
const reach = 6;
const pictureWidth = 1600;

interface GarmentViewOptions {
  readonly appearance?: Appearance;
  /** The wheel scrolls the page, and zooms with ctrl only; a vertical swipe scrolls, too. */
  readonly leavesWheel?: boolean;
  readonly onLost?: (isLost: boolean) => void;
  readonly onPoint?: (target: DrapeTarget | undefined) => void;
  readonly onPick?: (target: DrapeTarget | undefined) => void;
  /** Called when the camera comes to rest, and during a turntable. */
  readonly onMoved?: () => void;
}

/** Settings of a picture. Default: the page's background, seen from the camera's home. */
interface Seen {
  readonly orbit?: Orbit;
  readonly ground?: Paper['ground'];
  readonly hasWipe?: boolean;
}

export class DrapeView {
  readonly #screen: Screen;
  readonly #tile: TileTexture;
  readonly #worn: DrapeScene;
  readonly #camera: DrapeCamera;
  readonly #picker = new DrapePicker();
  readonly #options: GarmentViewOptions;
  #appearance: Appearance;
  #scene: PatternScene | undefined;
  #picture: Tile | undefined;
  /** Pending while the view moves. */
  #pause: ReturnType<typeof setTimeout> | undefined;
  /** The camera was on its way when the last picture was begun, which may have been its end. */
  #wasMoving = false;
  readonly #fineness = new MovingFineness();
  /** The last drawing is coarser than one at rest. */
  #isCoarse = false;

  /**
   * Fills `host`, an empty element with its own size.
   * @throws {Error} if the browser has no WebGL 2
   */
  constructor(host: HTMLElement, options: GarmentViewOptions = {}) {
    this.#options = options;
    this.#appearance = options.appearance ?? 'light';
    this.#worn = new DrapeScene(this.#appearance);
    const quiet = matchMedia('(prefers-reduced-motion: reduce)');
    this.#camera = new DrapeCamera(
      () => ({box: this.#worn.box, aspect: this.#aspect}),
      () => quiet.matches,
      () => {
        this.#moved();
        this.#screen.request();
      },
    );
    this.#screen = new Screen(host, {
      resized: () => {
        this.#camera.fit();
      },
      draw: () => {
        this.#draw();
      },
      arrange: () => {
        if (!this.#wasMoving) return;
        if (this.#camera.isMoving) this.#screen.request();
        this.#stir();
      },
      lost: (isLost) => options.onLost?.(isLost),
    });
    this.#worn.studio.prepare(this.#screen.renderer);
    this.#tile = new TileTexture(this.#screen.renderer, (texture) => {
      texture.colorSpace = 'srgb'; // lighting uses linear colours
      this.#worn.studio.tile = texture;
      this.#screen.request();
    });
    this.#listen(host, this.#screen.signal);
  }

  /** Always null: this view shows no part of a sheet that could be restored. */
  get state(): null {
    return null;
  }

  set state(_: unknown) {
    // the camera is not saved with a step
  }

  /** The camera's public controls. */
  get camera(): Pick<
    DrapeCamera,
    'key' | 'look' | 'turn' | 'zoomBy' | 'setTurntable' | 'isTurning' | 'preset'
  > {
    return this.#camera;
  }

  /** Aligns the fabric with the print as in a scene. Cheap if the alignment is unchanged. */
  show(scene: PatternScene): void {
    if (scene === this.#scene) return;
    const before = this.#scene;
    this.#scene = scene;
    if (before?.print !== scene.print) this.setTile(this.#picture);
    this.#worn.show(scene);
    this.#screen.request();
  }

  /** Sets the image of the print's cell; without one, the fabric is plain. */
  setTile(tile: Tile | undefined): void {
    this.#picture = tile;
    if (this.#scene) this.#tile.set(tile, imageCell(this.#scene.print));
  }

  setAppearance(appearance: Appearance): void {
    if (appearance === this.#appearance) return;
    this.#appearance = appearance;
    this.#worn.setAppearance(appearance);
    this.#screen.request();
  }

  /** Sets whether seams are coloured by mismatch. */
  setSeams(hasSeams: boolean): void {
    this.#worn.setSeams(hasSeams);
    this.#screen.request();
  }

  /**
   * Shows `before` to the left of the split, from the same camera. Cheap when only the split
   * changes.
   */
  setWipe(wipe: Wipe | undefined): void {
    this.#worn.setWipe(wipe);
    this.#screen.request();
  }

  /** Sets whether the dummy is visible. */
  setForm(isShown: boolean): void {
    this.#worn.setForm(isShown);
    this.#screen.request();
  }

  setFabric(fabric: FabricName): void {
    this.#worn.fabric = fabric;
    this.#screen.request();
  }

  setMarked(marked: Marked): void {
    this.#worn.setMarked(marked);
    this.#screen.request();
  }

  /** The form under the garment. */
  set form(form: Form) {
    this.#worn.form = form;
  }

  /** Sets the mesh of the next poses; the current one stays visible until then. */
  set mesh(mesh: DrapeMesh) {
    this.#worn.mesh = mesh;
  }

  /**
   * Moves the mesh's vertices; x, y, z for each. [cm]
   * @param isFinal false while the garment moves on
   */
  pose(positions: Float32Array, isFinal: boolean): void {
    this.#worn.pose = positions;
    this.#screen.request();
    this.#stir(isFinal ? rest : betweenPoses);
  }

  /** Shows nothing until another mesh is set. */
  clear(): void {
    this.#worn.clear();
    this.#screen.request();
  }

  /**
   * Turns the camera to face a piece or a seam.
   * @returns false without a garment
   */
  face(target: DrapeTarget): boolean {
    const {layer} = this.#worn;
    if (layer) this.#camera.face(this.#picker.facing(layer, target));
    return layer !== undefined;
  }

  /** Returns the seam or piece at a point of the host. [CSS px] */
  targetAt(at: Point): DrapeTarget | undefined {
    const {layer, body: form} = this.#worn;
    const {orbit} = this.#camera;
    const {size} = this.#screen;
    return layer && orbit && this.#picker.at(at, {layer, orbit, size, form, reach});
  }

  /** Greatest width of a picture. [px] */
  get widestPicture(): number {
    return garmentPicture.widest(this.#screen.renderer, this.#aspect);
  }

  /**
   * Returns a PNG, seen from the camera's home.
   * @param width of the picture [px]
   * @throws {Error} before a garment is shown, or while the graphics context is lost
   */
  toBlob(width = pictureWidth): Promise<Blob> {
    return garmentPicture.blob(this.#paper(width));
  }

  /** Returns the current view as a PNG at twice the resolution. @throws {Error} as `toBlob` */
  shot(): Promise<Blob> {
    const width = Math.min(this.widestPicture, 2 * this.#screen.raster.width);
    const {orbit} = this.#camera;
    return garmentPicture.blob(this.#paper(width, {...(orbit && {orbit}), hasWipe: true}));
  }

  /**
   * Returns a picture at a share of one turn from the camera's home.
   * @param width of the picture [px]
   * @throws {Error} as `toBlob`
   */
  onTheWayRound(width: number, share: number): Promise<HTMLCanvasElement> {
    const {home} = this.#camera;
    const orbit = home && turned(home, 2 * Math.PI * share);
    return garmentPicture.canvas(this.#paper(width, {...(orbit && {orbit})}));
  }

  /** Returns a picture on white, synchronously; undefined without a garment. */
  onPaper(): HTMLCanvasElement | undefined {
    return this.#worn.isWorn
      ? garmentPicture.now(this.#paper(pictureWidth, {ground: [255, 255, 255]}))
      : undefined;
  }

  dispose(): void {
    clearTimeout(this.#pause);
    this.#camera.stop();
    this.#tile.dispose();
    this.#worn.dispose();
    this.#screen.dispose();
  }

  get #aspect(): number {
    const {width, height} = this.#screen.size;
    return width / height;
  }

  #listen(host: HTMLElement, signal: AbortSignal): void {
    const {leavesWheel, onPoint, onPick} = this.#options;
    const camera = this.#camera;
    const moves = {
      fit: () => {
        camera.look();
      },
      zoomBy: (factor: number) => {
        camera.zoomBy(factor);
      },
      panBy: (dx: number, dy: number, isModified?: boolean) => {
        if (isModified) camera.pan(dx, -dy, this.#screen.size.height);
        else camera.turn(-dragTurn * dx, dragTurn * dy);
      },
    };
    navigate(host, moves, signal, {leavesWheel});
    if (leavesWheel) {
      host.style.touchAction = 'pan-y';
      // one finger may scroll the page, two move the garment
      const hold = (event: TouchEvent): void => {
        if (event.touches.length > 1 && event.cancelable) event.preventDefault();
      };
      for (const type of ['touchstart', 'touchmove'] as const)
        host.addEventListener(type, hold, {signal, passive: false});
    }
    const pressed = (): void => {
      camera.setTurntable(false);
    };
    host.addEventListener('pointerdown', pressed, {signal});
    followPointer(host, signal, {
      point:
        onPoint &&
        ((at) => {
          onPoint(at && this.targetAt(at));
        }),
      pick:
        onPick &&
        ((at) => {
          onPick(this.targetAt(at));
        }),
    });
  }

  #moved(): void {
    this.#stir();
    if (this.#camera.isTurning) this.#options.onMoved?.();
  }

  /** Marks the view as moving until it has rested for a time. [ms] */
  #stir(time = rest): void {
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => {
      this.#pause = undefined;
      if (this.#isCoarse) this.#screen.request();
      const {orbit} = this.#camera;
      if (!orbit) return;
      const height = 2 * orbit.distance * Math.tan(fieldOfView / 2);
      this.#tile.sharpen(this.#screen.raster.height / height);
      this.#options.onMoved?.();
    }, time);
  }

  #paper(width: number, {orbit, ground, hasWipe = false}: Seen = {}): Paper {
    if (this.#worn.settle()) this.#camera.fit();
    const {renderer, size} = this.#screen;
    const raster = {width, height: Math.round(width / this.#aspect), ratio: width / size.width};
    return {
      ...{renderer, raster, ground: ground ?? inks[this.#appearance].paper},
      isReady: this.#worn.layer !== undefined,
      draw: () => {
        const from = orbit ?? this.#camera.home;
        if (from) this.#worn.draw(renderer, raster, finest, from, hasWipe);
      },
      done: () => {
        this.#screen.request();
      },
    };
  }

  #draw(): void {
    if (this.#worn.settle()) this.#camera.fit();
    this.#wasMoving = this.#camera.isMoving;
    const orbit = this.#camera.advance();
    if (!orbit) return;
    const {renderer, raster} = this.#screen;
    const isMoving = this.#pause !== undefined;
    const fineness = isMoving ? this.#fineness.now : finest;
    this.#worn.draw(renderer, raster, fineness, orbit, true);
    this.#isCoarse = fineness !== finest;
    if (!isMoving) return;
    const drawn = performance.now();
    requestAnimationFrame(() => {
      this.#fineness.took(performance.now() - drawn);
    });
  }
}
