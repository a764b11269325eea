/** The pieces of a workbench in their print as a view shows them: flat, or as they are worn. */
import {css, html, type PropertyValues, type TemplateResult} from 'lit';

import type {DesignGarment} from '../../model/design.js';
import type {Motion} from '../../viewer/morph.js';
import type {Tile} from '../../recognition/tile.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Appearance} from '../../viewer/strokes.js';
import {AppearanceController, colourScheme} from '../base/appearance.js';
import {PatientElement} from '../base/workbench-element.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {SceneMaker} from '../../workbench/scenes.js';
import type {SheetWindow, ViewState} from '../../workbench/workbench.js';
import {ShownTile} from './shown-tile.js';

/** The print of the pattern is on the screen. */
export const drawnEvent = 'sw-drawn';
/** How far a drape is. */
export const drapeEvent = 'sw-drape';
/** A graphics context that has not come back within this is not expected any more. [ms] */
const lossPatience = 3000;
/** Nothing can be drawn, or nothing any more; the failure is the `detail`. */
export const undrawableEvent = 'sw-undrawable';

/** What shows a scene. */
interface SceneView {
  /** What part is shown, to come back to it. */
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

/** What every view is begun with. */
interface SceneViewOptions {
  readonly appearance: Appearance;
  readonly onLost: (isLost: boolean) => void;
}

/** Fills an empty element. @throws {Error} where the browser has no WebGL 2 */
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

  /** Another drawing makes the scenes, and keeps the window of the sheet. */
  declare beside: boolean;
  readonly #maker = new SceneMaker();
  readonly #appearance = new AppearanceController(this);
  #view: View | undefined;
  #window: SheetWindow | undefined;
  /** Why nothing can be drawn. */
  #undrawable: string | undefined;
  #isLost = false;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #showsDraft = false;
  /** Of the next way to the answer; usually as always. [ms] */
  #time: number | undefined;
  /** The garment that was drawn last. */
  #drawn: DesignGarment | undefined;
  readonly #tile = new ShownTile(this, {
    texts: () => this.texts,
    shown: () => {
      this.printed();
    },
  });
  #life: AbortController | undefined;
  /** Of the stage. Asking for it at every update would lay the page out each time. [CSS px] */
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
    if (this.workbench.view === this.#window) this.workbench.view = undefined;
  }

  /** Whether the garment is shown as drafted just now. */
  get showsDraft(): boolean {
    return this.#showsDraft;
  }

  /** Shows the garment as drafted, until `showAnswer`. Points and pictures are those of the draft as well. */
  showDraft(): void {
    this.#showsDraft = true;
    this.requestUpdate();
  }

  /** Shows what is known of the answer again, after a way of so many milliseconds. */
  showAnswer(ms: number): void {
    this.#showsDraft = false;
    this.#time = ms;
    this.requestUpdate();
  }

  get view(): View | undefined {
    return this.#view;
  }

  /** A sentence where nothing can be drawn: without WebGL 2, without its context, or without the code for it. */
  protected get undrawable(): string | undefined {
    return this.#undrawable;
  }

  /** Whether seams are drawn by how they match. */
  protected hasSeams?(): boolean;

  /** The code that draws. */
  protected abstract load(): Promise<OpenView<View>>;

  /** The stage is there for somebody to work on, until `signal` fires. */
  protected opened?(stage: HTMLElement, signal: AbortSignal): void;

  /** The scenes of the workbench are shown. */
  protected drew?(view: View): void;

  async #open(signal: AbortSignal): Promise<void> {
    // begun before anything is laid out: the drawing is the heaviest part
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
    if (!this.beside) this.workbench.view = this.#window;
  }

  /** What was taken away usually comes back within a second. */
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

  /** The print is on the screen, or as much of it as there can be. */
  protected printed(): void {
    this.tell(drawnEvent);
  }

  protected tell(type: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(type, {detail, bubbles: true, composed: true}));
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.#size && !this.beside)
      this.workbench.scenes = this.#maker.scenes(this.workbench, this.#size);
  }

  protected override updated(): void {
    const view = this.#view;
    if (!view) return;
    view.setAppearance(this.#appearance.value);
    const {scenes} = this.workbench;
    if (scenes) {
      if (this.#showsDraft) view.show(scenes.before);
      else view.show(scenes.now, this.#motion(), this.#time);
      this.#time = undefined;
      this.drew?.(view);
    }
    if (scenes && this.#life) this.#tile.show(view, this.#life.signal);
  }

  /** What the workbench tells is drawn later, in a task of its own; a picture waits for it. */
  async #drawnAll(): Promise<void> {
    let isUpToDate = false; // more may come meanwhile
    while (!isUpToDate) isUpToDate = await this.updateComplete;
    await this.#tile.settled;
  }

  /** A garment is simply there at first; then an answer moves it all, and what is not an answer yet its shapes alone. */
  #motion(): Motion {
    const {design, result, isHeld} = this.workbench;
    const isKnown = design?.garment === this.#drawn;
    this.#drawn = design?.garment;
    if (!isKnown) return 'none';
    return result && !isHeld ? 'all' : 'shapes';
  }

  protected override render(): TemplateResult {
    return html`<div class="stage"></div>`;
  }
}
