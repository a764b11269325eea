/** A tool of the pattern that is loaded at its first use, with its texts. */
import type {PickIndex} from '../clicks/pick-index.js';
import type {Snapped, Target} from '../clicks/pick.js';
import type {Point} from '../model/geometry/vectors.js';
import type {Overlay} from '../scene/overlay.js';
import type {PatternScene} from '../scene/scene.js';
import type {Format} from '../texts/format.js';
import type {Texts} from '../texts/texts.js';

/** A press or a place under the pointer. */
export interface Pointed {
  readonly target: Target;
  /** The point of the piece, or the mark near it. */
  readonly point: Point;
  readonly snapped: Snapped['snapped'];
  /** Greatest distance at which the pointer picks a line. [cm] */
  readonly reachCm: number;
}

export interface LaterTool {
  /** Updates the place under the pointer. */
  hover(at: Pointed | undefined): void;
  /** @param isMore adds to the choice */
  take(at: Pointed, isMore: boolean): void;
  /** Undoes one step. @returns true if there was one */
  back(): boolean;
  words(texts: Texts, format: Format): string;
  marks(scene: PatternScene, texts: Texts): Overlay;
}

/** A tool that changes the garment. */
export interface EditingTool extends LaterTool {
  /** Keys as displayed, and their meaning. */
  readonly keys: readonly (readonly [key: string, meaning: string])[];
  title(texts: Texts): string;
  /** @returns true if the key has an effect */
  press(event: KeyboardEvent, index: PickIndex | undefined): boolean;
}

/** A tool with texts of one language, loaded at its first use. */
export class OnDemand<Tool> {
  readonly #load: () => Promise<Tool>;
  readonly #then: {readonly ready: () => void; readonly failed: (error: unknown) => void};
  #language: string | undefined;
  #tool: Tool | undefined;

  /** @param then called once the tool is loaded, or cannot be */
  constructor(
    load: () => Promise<Tool>,
    then: {readonly ready: () => void; readonly failed: (error: unknown) => void},
  ) {
    this.#load = load;
    this.#then = then;
  }

  /** The tool, if it has been loaded. */
  get tool(): Tool | undefined {
    return this.#tool;
  }

  /** The tool; undefined until it is loaded. Another language loads it again. */
  in(language: string): Tool | undefined {
    if (this.#language !== language) void this.#loadIn(language);
    return this.#tool;
  }

  async #loadIn(language: string): Promise<void> {
    this.#language = language;
    try {
      this.#tool = await this.#load();
      this.#then.ready();
    } catch (error) {
      this.#language = this.#tool = undefined;
      this.#then.failed(error);
    }
  }
}
