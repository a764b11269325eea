/** Sheets of a workbench to draw: the garment as drafted, and its present or expected state. */
import {
  decidedOf,
  printOf,
  type Design,
  type DesignGarment,
  type DesignPrint,
} from '../model/design/design.js';
import {panelMarks, type PanelDecisions, type PanelMarks} from '../model/garment/panel-marks.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {Alignment} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {mirroringsOf, pinnedPlace} from '../model/design/pins.js';
import type {SolveOptions} from '../model/design/options.js';
import type {MeshedPattern, SolveResult} from '../model/result/result.js';
import type {MismatchScale} from '../scene/colours.js';
import {quietSeams, type SeamWeights} from '../model/result/seam-groups.js';
import {
  realigned,
  sceneOf,
  withQuiet,
  type PatternScene,
  type SceneOptions,
} from '../scene/scene.js';
import {withSampleNames} from '../texts/sample-names.js';
import type {Texts} from '../texts/texts.js';
import {keptLines} from './kept-pins.js';
import {lastOf} from '../model/base/last-of.js';

export interface Scenes {
  /** The pieces as drafted, cut on grain as if the print did not matter; the same in any window. */
  readonly before: PatternScene;
  /** The result, its known part so far, or the result before. */
  readonly now: PatternScene;
  /** Marks of the panels from the garment file, by name. */
  readonly marks: ReadonlyMap<string, PanelMarks>;
}

/** The values of a workbench that are read: a design, and the known parts of its result. */
interface Work {
  readonly history: {readonly design: Design | undefined};
  readonly solving: {
    readonly garment: GarmentDocument | undefined;
    readonly pattern: MeshedPattern | undefined;
    readonly result: SolveResult | undefined;
  };
  readonly running: {readonly partial: readonly Alignment[] | undefined};
  readonly preferences: {
    readonly chosen: {readonly scale: MismatchScale};
    readonly texts: Pick<Texts, 'samples' | 'lists'>;
  };
}

/** Caches the last sheets, since building a sheet costs far more than aligning it anew. */
export class SceneMaker {
  readonly #print = lastOf((print: DesignPrint) => printOf(print));
  readonly #decided = lastOf(
    (names: PanelDecisions['names'], grain: PanelDecisions['grain']): PanelDecisions => ({
      ...(names && {names}),
      ...(grain && {grain}),
    }),
  );
  readonly #marks = lastOf(panelMarks);
  readonly #settings = lastOf(settingsOf);
  readonly #rest = lastOf(sheetAtRest);
  readonly #solved = lastOf(sheetSolved);
  readonly #lying = lastOf(lying);
  readonly #kept = lastOf(keptLines);
  readonly #marked = lastOf((scene: PatternScene, kept: PatternScene['kept']) =>
    kept ? {...scene, kept} : scene,
  );
  readonly #quiet = lastOf((result: SolveResult | undefined, weights: SeamWeights) =>
    result?.seamGroups ? quietSeams(result.seamGroups, weights) : undefined,
  );
  readonly #seenBefore = lastOf(quietened);
  readonly #seenNow = lastOf(quietened);
  /** Alignments before the solver reports any: the pieces stay in place. */
  readonly #waiting = lastOf((rest: PatternScene, pins: Pins) =>
    lying(
      rest,
      rest.pieces.map(({name, alignment}) => this.#last.get(name) ?? alignment),
      pins,
    ),
  );
  /**
   * Size for which each garment was arranged. It is kept, so that pieces stay in place when windows
   * and panels change.
   */
  readonly #rooms = new WeakMap<DesignGarment, Room>();
  /** Garment that was arranged last. */
  #laid: DesignGarment | undefined;
  /** Last alignment of each piece, by name. */
  #last = new Map<string, Alignment>();

  /**
   * Size for the garment before. A garment with the same name is the same one after an edit, so its
   * pieces stay in place.
   */
  #roomBefore({name}: DesignGarment): Room | undefined {
    return this.#laid?.name === name ? this.#rooms.get(this.#laid) : undefined;
  }

  /** Sheets of a design; undefined until the solver has read the garment. */
  scenes(work: Work, shown: Room): Scenes | undefined {
    const {design} = work.history;
    const {garment: document, pattern, result} = work.solving;
    const {partial} = work.running;
    if (!design || !document || !pattern) return undefined;
    const garment = withSampleNames(document, design.garment.name, work.preferences.texts);
    const print = this.#print(design.print);
    if (!this.#roomBefore(design.garment)) this.#last = new Map();
    const {plain, pins, locked} = design.options;
    const {names, grain} = decidedOf(design);
    const decided = this.#decided(names, grain);
    const room = this.#rooms.get(design.garment) ?? this.#roomBefore(design.garment) ?? shown;
    if (isRoom(room)) this.#rooms.set(design.garment, room);
    this.#laid = design.garment;
    const {width, height} = room;
    const settings = this.#settings(
      garment,
      decided,
      plain,
      work.preferences.chosen.scale,
      width,
      height,
    );
    const quiet = this.#quiet(result, design.options.weights);
    const before = this.#rest(pattern, print, settings);
    const now = result
      ? this.#solved(pattern, result, print, settings)
      : partial
        ? this.#lying(before, partial, pins)
        : this.#waiting(before, pins);
    const kept = this.#kept(pattern, locked);
    this.#last = new Map(now.pieces.map(({name, alignment}) => [name, alignment]));
    return {
      before: this.#seenBefore(before, quiet),
      now: this.#seenNow(this.#marked(now, kept), quiet),
      marks: this.#marks(garment, decided),
    };
  }
}

const quietened = (scene: PatternScene, quiet: ReadonlySet<number> | undefined): PatternScene =>
  quiet ? withQuiet(scene, quiet) : scene;

/** Size of a window. [CSS px] */
interface Room {
  readonly width: number;
  readonly height: number;
}

/**
 * Returns whether a size is that of a window, rather than a temporary one while a page is built.
 */
const isRoom = ({width, height}: Room): boolean => Math.min(width, height) > 80;

type Pins = SolveOptions['pins'];

function settingsOf(
  garment: GarmentDocument,
  decided: PanelDecisions,
  plain: readonly string[] | undefined,
  scale: MismatchScale,
  width: number,
  height: number,
): SceneOptions {
  return {garment, decided, plain: new Set(plain), scale, viewport: {width, height}};
}

/** Adds the edges of the file, which clicks need and a result does not contain. */
const withEdges = (scene: PatternScene, {pieces}: MeshedPattern): PatternScene => ({
  ...scene,
  pieces: scene.pieces.map((piece, k) => ({...piece, edges: pieces[k]?.edges ?? []})),
});

const sheetAtRest = (pattern: MeshedPattern, print: Print, settings: SceneOptions): PatternScene =>
  withEdges(sceneOf(pattern, print, {...settings, outline: 'rest'}), pattern);

const sheetSolved = (
  pattern: MeshedPattern,
  result: SolveResult,
  print: Print,
  settings: SceneOptions,
): PatternScene => withEdges(sceneOf(result, print, settings), pattern);

/**
 * Aligns the pieces. Pinned pieces keep their places and their twins mirror them, even if an older
 * result differs.
 */
function lying(scene: PatternScene, alignments: readonly Alignment[], pins: Pins): PatternScene {
  const mirrorings = mirroringsOf(scene.pattern);
  return realigned(
    scene,
    scene.pieces.map(({name, alignment}, k) => {
      const at = alignments[k] ?? alignment;
      return pinnedPlace(scene.print, mirrorings, pins, name, at) ?? at;
    }),
  );
}
