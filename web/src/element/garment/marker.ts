/** Fabric layout of the answer; loads its code on first use. */
import type {SolverError} from '../../model/failure.js';
import type {ClothLayer, ClothOwner} from './marker-layer.js';

export class Cloth {
  /** Undefined until the first layout. */
  layer: ClothLayer | undefined;
  readonly #owner: ClothOwner;
  readonly #lost: (error: unknown) => SolverError;
  #isAsked = false;

  /** @param lost converts a failed import to an error */
  constructor(owner: ClothOwner, lost: (error: unknown) => SolverError) {
    this.#owner = owner;
    this.#lost = lost;
  }

  /** Starts the layout of the current answer, replacing the previous one. */
  follow(): void {
    const {element, session} = this.#owner;
    if (this.layer) this.layer.follow();
    else if (!this.#isAsked && element.clothWidth !== null && session.result) {
      // the next call of `layPlan` tries again
      this.load().catch((error: unknown) => {
        session.report(error as SolverError);
      });
    }
  }

  /** @throws {SolverError} if the code cannot be loaded */
  async load(): Promise<ClothLayer> {
    this.#isAsked = true;
    const {ClothLayer} = await import('./marker-layer.js').catch((error: unknown) => {
      throw this.#lost(error);
    });
    this.layer ??= new ClothLayer(this.#owner);
    this.layer.follow();
    return this.layer;
  }
}
