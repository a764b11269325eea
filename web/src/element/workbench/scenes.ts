/** The sheets to be drawn of a workbench: the garment as it comes, and as it is or is about to be. */
import {printOf, type DesignPrint} from '../../model/design.js';
import type {Garment} from '../../model/garment.js';
import type {Alignment} from '../../model/geometry.js';
import type {Print} from '../../model/print.js';
import type {Pattern} from '../../model/result.js';
import {
  realigned,
  sceneOf,
  uncut,
  type PatternScene,
  type SceneOptions,
} from '../../viewer/scene.js';
import type {Workbench} from './workbench.js';

export interface Scenes {
  /** The pieces as they come, cut on grain without a thought. */
  readonly before: PatternScene;
  /** The answer, what is known of it so far, or the one before. */
  readonly now: PatternScene;
}

/** Remembers what it made last, since making a sheet costs far more than laying it on the print anew. */
export class SceneMaker {
  readonly #rest = lastOf(sheetAtRest);
  readonly #solved = lastOf(sheetSolved);
  readonly #print = lastOf((print: DesignPrint) => printOf(print));
  readonly #garment = lastOf((text: string) => JSON.parse(text) as Garment);
  readonly #plain = lastOf((names: readonly string[] | undefined) => new Set(names));
  readonly #lying = lastOf(realigned);
  /** Before anything is known the pieces stay as they lay. */
  readonly #waiting = lastOf((rest: PatternScene) =>
    realigned(
      rest,
      rest.pieces.map(({name, alignment}) => this.#last.get(name) ?? alignment),
    ),
  );
  /** How the pieces lay last, by name, and of which garment. */
  #last = new Map<string, Alignment>();
  #lastGarment: Garment | undefined;

  /** Undefined until the solver has read the garment. */
  scenes(desk: Workbench, viewport: NonNullable<SceneOptions['viewport']>): Scenes | undefined {
    const {design, pattern, result, partial} = desk;
    if (!design || !(pattern ?? result)) return undefined;
    const print = this.#print(design.print);
    const garment = this.#garment(design.garment.text);
    if (garment !== this.#lastGarment) this.#last = new Map();
    this.#lastGarment = garment;
    const plain = this.#plain(design.options.plain);
    const rest = this.#rest(
      result ?? pattern,
      print,
      garment,
      viewport.width,
      viewport.height,
      plain,
    );
    if (!rest) return undefined;
    if (result) {
      const now = this.#solved(result, print, garment, viewport.width, viewport.height, plain);
      return {before: rest, now: this.#keep(now ?? rest)};
    }
    return {
      before: rest,
      now: this.#keep(partial ? this.#lying(rest, partial) : this.#waiting(rest)),
    };
  }

  #keep(scene: PatternScene): PatternScene {
    this.#last = new Map(scene.pieces.map(({name, alignment}) => [name, alignment]));
    return scene;
  }
}

type Sheet = (
  pattern: Pattern | undefined,
  print: Print,
  garment: Garment,
  width: number,
  height: number,
  plain: ReadonlySet<string>,
) => PatternScene | undefined;

function sheetAtRest(...[pattern, print, garment, width, height, plain]: Parameters<Sheet>) {
  if (!pattern) return undefined;
  const at = {outline: 'rest', garment, plain, viewport: {width, height}} as const;
  const scene = sceneOf(pattern, print, at);
  return realigned(scene, uncut(scene));
}

function sheetSolved(...[pattern, print, garment, width, height, plain]: Parameters<Sheet>) {
  return pattern && sceneOf(pattern, print, {garment, plain, viewport: {width, height}});
}

/** A function that knows its last answer: the same arguments get the same object. */
export function lastOf<Arguments extends readonly unknown[], Result>(
  make: (...given: Arguments) => Result,
): (...given: Arguments) => Result {
  let last: {readonly given: Arguments; readonly result: Result} | undefined;
  return (...given) => {
    if (!last?.given.every((value, k) => value === given[k])) {
      last = {given, result: make(...given)};
    }
    return last.result;
  };
}
