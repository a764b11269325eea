/** Draws the pieces of a workbench in their print: flat, or as a drape. */
import {css, html, type PropertyValues, type TemplateResult} from 'lit';

import type {DesignGarment} from '../../model/design/design.js';
import type {Motion} from '../../viewer/morph.js';
import type {Tile} from '../../image/tile.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Appearance} from '../../viewer/strokes.js';
import {AppearanceController, colourScheme} from '../base/appearance.js';
import {PatientElement} from '../base/workbench-element.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {SceneMaker} from '../../workbench/scenes.js';
import type {SheetWindow, ViewState} from '../../workbench/workbench.js';
import {ShownTile} from './shown-tile.js';

/** The drawing of the print is complete. */
export const drawnEvent = 'sw-drawn';
/** Progress of a drape. */
export const drapeEvent = 'sw-drape';
/** Longest time to wait for a lost graphics context. [ms] */
const lossPatience = 3000;
/** Drawing is impossible, or no longer possible; the failure is the `detail`. */
export const undrawableEvent = 'sw-undrawable';

/** A view of a scene. */
interface SceneView {
  /** The visible part, to be restored later. */
  state: ViewState | null;
  readonly widestPicture: number;
  show(scene: PatternScene, motion?: Motion, time?: number): void;
  setTile(tile: Tile | undefined): void;
  setAppearance(appearance: Appearance): void;
  setSeams(hasSeams: boolean): void;
  toBlob(width?: number): Promise<Blob>;
  onPaper(): HTMLCanvasElement | undefined;
  dispose(): void;
}

/** Options of every view. */
interface SceneViewOptions {
  readonly appearance: Appearance;
  readonly onLost: (isLost: boolean) => void;
}

/** Fills an empty element. @throws {Error} if the browser has no WebGL 2 */
export type OpenView<View> = (stage: HTMLElement, options: SceneViewOptions) => View;

export abstract class SceneDrawing<View extends SceneView> extends PatientElement {
  static override properties = {...PatientElement.properties, beside: {type: Boolean}};
  static override styles = [
    colourScheme,
    css`
      :host {
        display: block;
        position: relative;
        overflow: hidden;
      }
      .stage {
        position: absolute;
        inset: 0;
      }
      .stage.gone {
        visibility: hidden; /* what was drawn last is not what there is */
      }
    `,
  ];

  /** True if another drawing makes the scenes, and owns the window of the sheet. */
  declare beside: boolean;
  readonly #maker = new SceneMaker();
  readonly #appearance = new AppearanceController(this);
  #view: View | undefined;
  #window: SheetWindow | undefined;
  /** Reason that drawing is impossible. */
  #undrawable: string | undefined;
  #isLost = false;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  /** The last garment drawn. */
  #drawn: DesignGarment | undefined;
  readonly #tile = new ShownTile(this, {
    texts: () => this.texts,
    shown: () => {
      this.printed();
    },
  });
  #life: AbortController | undefined;
  /**
   * Size of the stage, cached since reading it at every update would cause a layout of the page.
   * [CSS px]
   */
  #size: {readonly width: number; readonly height: number} | undefined;

  constructor() {
    super();
    this.beside = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#life = new AbortController();
    void this.#open(this.#life.signal);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life?.abort();
    clearTimeout(this.#waiting);
    this.#view?.dispose();
    this.#view = undefined;
    this.#isLost = false;
    this.#tile.forget();
    this.#drawn = undefined;
    if (this.workbench.sheet.view === this.#window) this.workbench.sheet.view = undefined;
  }

  get view(): View | undefined {
    return this.#view;
  }

  /** Message if drawing is impossible: no WebGL 2, no context, or no code for it. */
  protected get undrawable(): string | undefined {
    return this.#undrawable;
  }

  /** Returns whether seams are drawn in mismatch colours. */
  protected hasSeams?(): boolean;

  /** Returns a scene to show until the solver has read the garment. */
  protected standIn?(): PatternScene | undefined;

  /** Loads the code of the view. */
  protected abstract load(): Promise<OpenView<View>>;

  /** Runs once the stage accepts input, until `signal` aborts. */
  protected opened?(stage: HTMLElement, signal: AbortSignal): void;

  /** Runs after the scenes of the workbench have been drawn. */
  protected drew?(view: View): void;

  async #open(signal: AbortSignal): Promise<void> {
    // starts before the first layout: the drawing is the largest module
    const code = this.load().catch((error: unknown) => toFailure(error));
    const [viewer] = await Promise.all([code, this.updateComplete]);
    const stage = this.renderRoot.querySelector<HTMLElement>('.stage');
    if (signal.aborted || !stage) return;
    if ('code' in viewer) this.#giveUp(viewer);
    else this.#show(viewer, stage);
    stage.inert = !this.opened;
    this.opened?.(stage, signal);
    const resized = new ResizeObserver(([entry]) => {
      if (entry) this.#size = entry.contentRect;
      this.requestUpdate();
    });
    resized.observe(stage);
    signal.addEventListener('abort', () => {
      resized.disconnect();
    });
    this.requestUpdate();
  }

  #show(open: OpenView<View>, stage: HTMLElement): void {
    try {
      this.#view = open(stage, {
        appearance: this.#appearance.value,
        onLost: (isLost) => {
          this.#turn(isLost);
        },
      });
    } catch {
      const message = this.texts.pattern.noWebGl;
      this.#giveUp({code: 'no-webgl', message, piece: null, seam: null});
      return;
    }
    const view = this.#view;
    view.setSeams(this.hasSeams?.() ?? false);
    const isLost = (): boolean => this.#isLost;
    this.#window = {
      get isLost() {
        return isLost();
      },
      get widest() {
        return view.widestPicture;
      },
      get: () => view.state,
      picture: async (width) => {
        await this.#drawnAll();
        return view.toBlob(width);
      },
      onPaper: () => view.onPaper(),
      set: (state) => {
        view.state = state;
      },
    };
    if (!this.beside) this.workbench.sheet.view = this.#window;
  }

  /** A lost context usually returns within a second. */
  #turn(isLost: boolean): void {
    this.#isLost = isLost;
    clearTimeout(this.#waiting);
    if (isLost) {
      this.#waiting = setTimeout(() => {
        const message = this.texts.pattern.lost;
        this.#giveUp({code: 'no-webgl', message, piece: null, seam: null});
      }, lossPatience);
    } else if (this.#undrawable !== undefined) {
      this.#setUndrawable(undefined);
      this.printed();
    }
  }

  #giveUp(detail: ReturnType<typeof toFailure>): void {
    this.#setUndrawable(detail.message);
    this.tell(undrawableEvent, detail);
  }

  #setUndrawable(why: string | undefined): void {
    this.#undrawable = why;
    this.renderRoot.querySelector('.stage')?.classList.toggle('gone', why !== undefined);
    this.requestUpdate();
  }

  /** The print is drawn, as far as possible. */
  protected printed(): void {
    this.tell(drawnEvent);
  }

  protected tell(type: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(type, {detail, bubbles: true, composed: true}));
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.#size && !this.beside)
      this.workbench.sheet.scenes = this.#maker.scenes(this.workbench, this.#size);
  }

  protected override updated(): void {
    const view = this.#view;
    if (!view) return;
    view.setAppearance(this.#appearance.value);
    const {scenes} = this.workbench.sheet;
    const standIn = scenes ? undefined : this.standIn?.();
    if (standIn) view.show(standIn);
    if (scenes) {
      view.show(scenes.now, this.#motion());
      this.drew?.(view);
    }
    if ((scenes ?? standIn) && this.#life) this.#tile.show(view, this.#life.signal);
  }

  /** Waits for changes to the workbench, which are drawn later in a separate task. */
  async #drawnAll(): Promise<void> {
    let isUpToDate = false; // more changes may arrive meanwhile
    while (!isUpToDate) isUpToDate = await this.updateComplete;
    await this.#tile.settled;
  }

  /**
   * A new garment appears without motion. A result moves the whole garment; changes before a result
   * move shapes only.
   */
  #motion(): Motion {
    const {design, isHeld} = this.workbench.history;
    const {result} = this.workbench.solving;
    const isKnown = design?.garment === this.#drawn;
    this.#drawn = design?.garment;
    if (!isKnown) return 'none';
    return result && !isHeld ? 'all' : 'shapes';
  }

  protected override render(): TemplateResult {
    return html`<div class="stage"></div>`;
  }
}
