/** Close-up of one seam, straightened: both sides meet along the sewn line, as in the garment. */
import {OrthographicCamera, Scene} from 'three';

import type {Point} from '../model/geometry/vectors.js';
import {imageCell} from '../model/print/wallpaper.js';
import {LineLayer, LineMaterial, type Stroke} from './line-layer.js';
import type {OnPiece} from '../scene/overlay.js';
import type {Wipe} from './over-layers.js';
import {PrintMaterial} from './print-layer.js';
import type {PatternScene} from '../scene/scene.js';
import {look, Screen, type ScreenEvents} from './screen.js';
import {
  onPieceAt,
  ribbonDepth,
  straightSeam,
  StripMesh,
  type NearSeam,
  type StraightSeam,
} from './seam-ribbon.js';
import {inks, type Appearance} from './strokes.js';
import {TileTexture} from './tile-texture.js';
import type {Tile} from '../image/tile.js';

/** [CSS px per cm] */
const greatestScale = 40;
/** Room beside the ends of the seam. [CSS px] */
const margin = 12;

/** A scene, and the number of one of its seams. */
export interface ShownSeam {
  readonly scene: PatternScene;
  readonly seam: number;
}

interface Strip {
  readonly scene: PatternScene;
  readonly straight: StraightSeam;
  readonly mesh: StripMesh;
  readonly object: Scene;
}

export class SeamStrip {
  readonly #screen: Screen;
  readonly #fabric = new PrintMaterial();
  readonly #line = new LineMaterial();
  readonly #tile: TileTexture;
  readonly #camera = new OrthographicCamera();
  readonly #over = new Scene();
  #appearance: Appearance;
  #shown: ShownSeam | undefined;
  #after: Strip | undefined;
  #before: Strip | undefined;
  #wipe: Wipe | undefined;
  #cursor: number | undefined;
  #lines: LineLayer | undefined;
  #picture: Tile | undefined;
  /** Mesh of the last drawing, and of the one on display. */
  #drawn: StripMesh | undefined;
  #painted: StripMesh | undefined;

  /**
   * Fills `host`, an empty element with its own size.
   * @param painted is called when the element shows another drawing
   * @throws {Error} if the browser has no WebGL 2
   */
  constructor(
    host: HTMLElement,
    {appearance = 'light', painted}: {appearance?: Appearance; painted?: () => void} = {},
  ) {
    this.#appearance = appearance;
    const events: ScreenEvents = {
      resized: () => {
        this.#sharpen();
      },
      draw: () => {
        this.#draw();
      },
      painted: () => {
        this.#painted = this.#drawn;
        painted?.();
      },
    };
    this.#screen = new Screen(host, events, 'aside');
    this.#tile = new TileTexture(this.#screen.renderer, (texture) => {
      this.#fabric.uniforms.tile.value = texture;
      this.#screen.request();
    });
  }

  /** Scale at which the whole seam fits into the width. [CSS px per cm] */
  get scale(): number {
    const room = Math.max(1, this.#screen.size.width - 2 * margin);
    return Math.min(greatestScale, room / (this.#after?.straight.length ?? room));
  }

  /** Start and end of the sewn line. [CSS px from the left] */
  get span(): readonly [number, number] {
    const half = ((this.#after?.straight.length ?? 0) * this.scale) / 2;
    const middle = this.#screen.size.width / 2;
    return [middle - half, middle + half];
  }

  /** False while the element still shows the seam before. */
  get isCurrent(): boolean {
    return this.#painted === this.#after?.mesh;
  }

  /** Shows a seam, or nothing. Cheap when only alignments differ from before. */
  show(shown: ShownSeam | undefined): void {
    const print = this.#shown?.scene.print;
    const isSame = this.#shown?.seam === shown?.seam;
    this.#shown = shown;
    this.#after = this.#laid(isSame ? this.#after : this.#dropped(this.#after), shown?.scene);
    this.#layBefore(isSame);
    if (shown && print !== shown.scene.print) this.setTile(this.#picture);
    this.#sharpen();
    this.#drawLines();
  }

  /** Shows the seam in another scene of the sheet left of the split. */
  setWipe(wipe: Wipe | undefined): void {
    const {before} = this.#wipe ?? {};
    this.#wipe = wipe;
    if (before !== wipe?.before) this.#layBefore(true);
    this.#screen.request();
  }

  /** Shows a line across the seam, at a share of its length in sewing order. */
  setCursor(share: number | undefined): void {
    if (share === this.#cursor) return;
    this.#cursor = share;
    this.#drawLines();
  }

  /** Sets the image of the print's cell; without one, the fabric is plain. */
  setTile(tile: Tile | undefined): void {
    this.#picture = tile;
    if (this.#shown) this.#tile.set(tile, imageCell(this.#shown.scene.print));
  }

  setAppearance(appearance: Appearance): void {
    if (appearance === this.#appearance) return;
    this.#appearance = appearance;
    this.#drawLines();
  }

  /**
   * Returns the place under a point of the host, from its upper left [CSS px]; undefined beyond a
   * piece's edge.
   */
  pieceAt(x: number, y: number): NearSeam | undefined {
    const {straight} = this.#after ?? {};
    if (!straight) return undefined;
    const [left, right] = this.span;
    const gone = (x - left) / (right - left);
    const up = (this.#screen.size.height / 2 - y) / this.scale;
    const side = up >= 0 ? 'a' : 'b';
    const share = straight.runsLeft ? 1 - gone : gone;
    const {columns} = straight[side];
    const depth = columns[Math.round(share * (columns.length - 1))]?.depth ?? -1;
    return Math.abs(up) <= depth ? {side, share, offset: Math.abs(up)} : undefined;
  }

  /** Converts the place to its piece, in that piece's own coordinates. */
  placeOf(near: NearSeam): OnPiece | undefined {
    return this.#after && onPieceAt(this.#after.straight, near);
  }

  dispose(): void {
    this.#dropped(this.#after);
    this.#dropped(this.#before);
    this.#lines?.dispose();
    this.#tile.dispose();
    this.#fabric.dispose();
    this.#line.dispose();
    this.#screen.dispose();
  }

  #layBefore(isSame: boolean): void {
    const scene = this.#shown && this.#wipe?.before;
    this.#before = this.#laid(isSame ? this.#before : this.#dropped(this.#before), scene);
  }

  /**
   * Returns the shown seam in a scene; it is straightened again only if its pieces have changed.
   */
  #laid(known: Strip | undefined, scene: PatternScene | undefined): Strip | undefined {
    const {seam = -1} = this.#shown ?? {};
    const sides = scene?.seams[seam];
    this.#screen.request();
    if (!scene || !sides) return this.#dropped(known);
    const isKnown = [sides.a.piece, sides.b.piece].every(
      (piece) => known?.scene.pieces[piece]?.points === scene.pieces[piece]?.points,
    );
    let strip = isKnown ? known && {...known, scene} : this.#dropped(known);
    if (!strip) {
      const straight = straightSeam(scene, seam);
      if (!straight) return undefined;
      const [mesh, object] = [new StripMesh(straight, this.#fabric), new Scene()];
      object.add(mesh.object);
      strip = {scene, straight, mesh, object};
    }
    strip.mesh.align(scene);
    return strip;
  }

  #dropped(strip: Strip | undefined): Strip | undefined {
    strip?.mesh.dispose();
    return undefined;
  }

  #sharpen(): void {
    this.#tile.sharpen(this.scale * this.#screen.raster.ratio);
  }

  #drawLines(): void {
    if (this.#lines) this.#over.remove(this.#lines.object);
    this.#lines?.dispose();
    this.#lines = undefined;
    this.#screen.request();
    const {straight} = this.#after ?? {};
    if (!straight) return;
    const {accent, mark} = inks[this.#appearance];
    const ends: Point[] = [
      [0, 0],
      [straight.length, 0],
    ];
    const strokes: Stroke[] = [{points: ends, styles: {colour: mark, width: 1}}];
    if (this.#cursor !== undefined) {
      const x = straight.length * (straight.runsLeft ? 1 - this.#cursor : this.#cursor);
      const across: Point[] = [
        [x, -ribbonDepth],
        [x, ribbonDepth],
      ];
      strokes.push({points: across, styles: {colour: accent, width: 2}});
    }
    this.#lines = new LineLayer(strokes, this.#line, 1);
    this.#over.add(this.#lines.object);
  }

  #draw(): void {
    const {renderer, raster, size} = this.#screen;
    this.#drawn = this.#after?.mesh;
    if (!this.#after) return;
    const split = Math.min(1, Math.max(0, this.#wipe?.split ?? 0)) * size.width;
    for (const [strip, from, to] of [
      [this.#before, 0, split],
      [this.#after, split, size.width],
    ] as const) {
      if (!strip) continue;
      const centre: Point = [strip.straight.length / 2, 0];
      look(this.#camera, this.#line, {centre, scale: this.scale}, raster);
      this.#screen.clip(from, to);
      renderer.render(strip.object, this.#camera);
    }
    this.#screen.clip(0, size.width);
    renderer.render(this.#over, this.#camera);
  }
}
