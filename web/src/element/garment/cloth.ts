/** How much cloth the answer takes, told by code that is loaded when somebody asks. */
import type {SolverError} from '../../model/failure.js';
import type {ClothLayer, ClothOwner} from './cloth-layer.js';

export class Cloth {
  /** Undefined until something was to be laid. */
  layer: ClothLayer | undefined;
  readonly #owner: ClothOwner;
  readonly #lost: (error: unknown) => SolverError;
  #isAsked = false;

  /** @param lost makes what is told of code that cannot be had */
  constructor(owner: ClothOwner, lost: (error: unknown) => SolverError) {
    this.#owner = owner;
    this.#lost = lost;
  }

  /** Lays what is shown now, in the place of what was. */
  follow(): void {
    const {element, session} = this.#owner;
    if (this.layer) this.layer.follow();
    else if (!this.#isAsked && element.clothWidth !== null && session.result) {
      // tried again when somebody asks for a plan
      this.load().catch((error: unknown) => {
        session.report(error as SolverError);
      });
    }
  }

  /** @throws {SolverError} where it cannot be had */
  async load(): Promise<ClothLayer> {
    this.#isAsked = true;
    const {ClothLayer} = await import('./cloth-layer.js').catch((error: unknown) => {
      throw this.#lost(error);
    });
    this.layer ??= new ClothLayer(this.#owner);
    this.layer.follow();
    return this.layer;
  }
}
