/** Fabric layout of the answer; loads its code on first use. */
import type {SolverError} from '../../model/result/failure.js';
import type {MarkerLayer, MarkerOwner} from './marker-layer.js';

export class Marker {
  /** Undefined until the first layout. */
  layer: MarkerLayer | undefined;
  readonly #owner: MarkerOwner;
  readonly #lost: (error: unknown) => SolverError;
  #isAsked = false;

  /** @param lost converts a failed import to an error */
  constructor(owner: MarkerOwner, lost: (error: unknown) => SolverError) {
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
  async load(): Promise<MarkerLayer> {
    this.#isAsked = true;
    const {MarkerLayer} = await import('./marker-layer.js').catch((error: unknown) => {
      throw this.#lost(error);
    });
    this.layer ??= new MarkerLayer(this.#owner);
    this.layer.follow();
    return this.layer;
  }
}
