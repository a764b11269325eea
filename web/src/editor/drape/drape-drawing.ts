/** Drape of a workbench's garment without tools; it is simulated while it is in view. */
import {css, type PropertyValues} from 'lit';

import type {DrapeView} from '../../viewer/drape/drape-view.js';
import type {Failure, FailureCode} from '../../model/base/failure.js';
import {lastOf} from '../../model/base/last-of.js';
import {fabricOf, printOf} from '../../model/design/design.js';
import type {PatternScene} from '../../scene/scene.js';
import {standInScene} from '../../scene/stand-in.js';
import type {CameraPreset} from '../../viewer/drape/camera.js';
import {drapesOf, type Drapes} from '../../workbench/drape/drapes.js';
import {
  drapeEvent,
  drawnEvent,
  SceneDrawing,
  undrawableEvent,
  type OpenView,
} from '../pattern/scene-drawing.js';
import {progressLine} from '../style/progress-line.js';
import {viewFrame} from '../style/view-frame.js';

export const drapeStyle = css`
  ${viewFrame} ${progressLine}
  :host {
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
    position: relative;
  }
  /* the bar lies over it */
  .application {
    grid-area: 1 / 1 / 3 / 2;
    position: relative;
  }
  .bar {
    justify-self: start;
  }
  .wipe {
    grid-area: 2 / 1;
    position: relative;
    pointer-events: none;
  }
  .bar,
  .foot,
  progress {
    z-index: 1;
  }
  .foot {
    flex-wrap: nowrap;
    align-items: end;
    min-height: 4.25rem; /* of two lines */
  }
  .group select {
    flex: none;
    width: auto;
    min-height: var(--sw-target);
    border-color: transparent;
    background: transparent;
    color: var(--sw-ink);
  }
  .truth {
    font-size: var(--sw-text);
  }
  @media (prefers-reduced-motion: reduce) {
    .turntable {
      display: none;
    }
  }
  @container (height < 15rem) {
    .bar,
    .zoom,
    sw-legend {
      display: none; /* where there is hardly room for the garment */
    }
    .foot {
      min-height: 0;
    }
  }
  @container (width < 44rem) {
    .foot {
      flex-wrap: wrap;
      align-content: end;
    }
  }
  @container (26rem <= width < 44rem) and (height >= 15rem) {
    .foot {
      min-height: 6rem; /* of the legend or a sentence, above the tools */
    }
  }
  @container (width < 26rem) {
    .application {
      grid-area: 2 / 1;
    }
    .bar,
    .foot {
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    .foot {
      gap: 0 var(--sw-space-2);
      min-height: 0;
    }
    .said {
      min-height: 0;
    }
    .zoom,
    .truth,
    sw-legend {
      display: none;
    }
  }
  /* beside an open sheet, its tools lie over the garment */
  @container (width < 26rem) and (height < 22rem) {
    .application {
      grid-area: 1 / 1 / -1 / 2;
    }
  }
`;

/** Detail of a `drapeEvent`. */
interface DrapeNews {
  readonly stage: 'sew' | 'hang' | 'settle' | 'done';
  /** 0 to 1 */
  readonly fraction: number;
  /** True once the drape no longer moves. */
  readonly settled: boolean;
  /** Notes for the user, one sentence each. */
  readonly notes: readonly string[];
}

/** Codes of failures that no change of the garment mends. */
const lostParts: ReadonlySet<FailureCode> = new Set<FailureCode>([
  'no-wasm',
  'worker-blocked',
  'internal',
]);

export class DrapeDrawing extends SceneDrawing<DrapeView> {
  static override properties = {
    ...SceneDrawing.properties,
    camera: {},
    form: {},
    turntable: {type: Boolean},
  };
  /** Initial view of the camera, to which it returns. */
  declare camera: CameraPreset;
  declare form: 'shown' | 'hidden';
  /** True for a turntable, which runs until the user touches the drape. */
  declare turntable: boolean;
  readonly #standIn = lastOf(({drape, alignments, design}: NonNullable<Drapes['known']>) =>
    standInScene(
      drape.mesh.pieces.map(({name}) => name),
      alignments,
      printOf(design.print),
    ),
  );
  #observer: IntersectionObserver | undefined;
  #isInView = false;
  /** Ends draping. */
  #end: (() => void) | undefined;
  #isPrinted = false;
  #isShaped = false;
  #told = '';

  constructor() {
    super();
    this.camera = 'front';
    this.form = 'shown';
    this.turntable = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#observer = new IntersectionObserver((entries) => {
      this.#isInView = entries.at(-1)?.isIntersecting ?? false;
      this.#drapeInView();
    });
    this.#observer.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#observer?.disconnect();
    this.#isInView = false;
    this.#drapeInView();
    this.#isPrinted = false;
    this.#isShaped = false;
  }

  protected get drapes(): Drapes {
    return drapesOf(this.workbench);
  }

  /** Additional options of a drape with tools. */
  protected viewOptions(): ConstructorParameters<typeof DrapeView>[1] {
    return {leavesWheel: true};
  }

  protected override async load(): Promise<OpenView<DrapeView>> {
    const {DrapeView} = await import('../../viewer/drape/drape-view.js');
    return (stage, options) => {
      const view = new DrapeView(stage, {...options, ...this.viewOptions()});
      view.camera.look(this.camera);
      view.camera.setTurntable(this.turntable);
      return view;
    };
  }

  protected override opened(): void {
    this.#drapeInView();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (!this.view) return;
    if (changed.has('camera')) this.view.camera.look(this.camera);
    if (changed.has('turntable')) this.view.camera.setTurntable(this.turntable);
  }

  protected override standIn(): PatternScene | undefined {
    const {known} = this.drapes;
    return known && this.#standIn(known);
  }

  protected override drew(view: DrapeView): void {
    view.setForm(this.form !== 'hidden');
    const {design} = this.workbench.history;
    if (design) view.setFabric(fabricOf(design));
    this.#tellNews();
  }

  /** The poster stays until the drape has a shape and a print. */
  protected override printed(): void {
    this.#isPrinted = true;
    this.#tellDrawn();
  }

  #tellDrawn(): void {
    if (this.#isPrinted && this.#isShaped) this.tell(drawnEvent);
  }

  #drapeInView(): void {
    const {view} = this;
    if (this.#isInView && view) this.#end ??= this.#begin(view);
    if (this.#isInView) return;
    this.#end?.();
    this.#end = undefined;
  }

  /** @returns function that ends draping */
  #begin(view: DrapeView): () => void {
    const quiet = matchMedia('(prefers-reduced-motion: reduce)');
    let shown = false;
    return this.drapes.show({
      form: (form) => {
        view.form = form;
      },
      mesh: (mesh) => {
        view.mesh = mesh;
      },
      positions: (positions, isFinal) => {
        // reduced motion: only the first shape and the last
        if (shown && quiet.matches && !isFinal) return;
        shown = !isFinal;
        view.pose(positions, isFinal);
        this.#isShaped = true;
        this.#tellDrawn();
      },
      clear: () => {
        view.clear();
      },
    });
  }

  #tellNews(): void {
    const {state, drape} = this.drapes.read;
    if (state.kind === 'draping') {
      const {stage, fraction} = state.progress;
      // the end is reported with the final positions
      if (stage !== 'done')
        this.#tellOnce(drapeEvent, {stage, fraction, settled: false, notes: []});
    } else if (state.kind === 'done') {
      this.#tellOnce(drapeEvent, {
        ...{stage: 'done', fraction: 1, settled: true, notes: drape?.notes ?? []},
      } satisfies DrapeNews);
    } else if (state.kind === 'failed' && lostParts.has(state.failure.code)) {
      this.#tellOnce(undrawableEvent, state.failure);
    }
  }

  #tellOnce(type: string, news: DrapeNews | Failure): void {
    const told = JSON.stringify(news);
    if (told === this.#told) return;
    this.#told = told;
    this.tell(type, news);
  }
}
