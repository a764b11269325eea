/** How much cloth the answer takes, told by code that is loaded when somebody asks. */
import {SolverError} from '../../model/failure.js';
import type {LayPlan} from '../../model/lay-plan.js';
import {unlessAborted} from '../../solver/answers/unless-aborted.js';
import {asError} from './as-error.js';
import type {ClothLayer, ClothOwner} from './cloth-layer.js';

type Owner = Omit<ClothOwner, 'isAwaited' | 'report'>;

export class Cloth {
  readonly #owner: Owner;
  #layer: ClothLayer | undefined;
  #isLoaded = false;
  #waiting = 0;

  constructor(owner: Owner) {
    this.#owner = owner;
  }

  readonly #report = (error: unknown): void => {
    this.#owner.session.report(asError(error));
  };

  /** Whether a promise of a plan has not been kept yet. */
  readonly isAwaited = (): boolean => this.#waiting > 0;

  /** Undefined until something was to be laid. */
  get layer(): ClothLayer | undefined {
    return this.#layer;
  }

  /** Lays what is shown now, in the place of what was. */
  follow(): void {
    const {element, session} = this.#owner;
    this.#layer?.follow();
    if (this.#isLoaded || element.clothWidth === null || !session.result) return;
    this.#load().catch(this.#report);
  }

  /** @param solve resolves when there is an answer @throws as the element's `layPlan` does */
  async plan(solve: () => Promise<unknown>, signal: AbortSignal | undefined): Promise<LayPlan> {
    const answered = async (): Promise<void> => {
      if (this.#owner.element.clothWidth === null) {
        throw new SolverError({code: 'options', message: this.#owner.texts().garment.noCloth});
      }
      await solve();
    };
    this.#waiting += 1;
    try {
      await answered();
      return await unlessAborted((await this.#load()).plan(answered), signal);
    } finally {
      this.#waiting -= 1;
    }
  }

  /** What fails is tried again when somebody asks for a plan. @throws {SolverError} */
  async #load(): Promise<ClothLayer> {
    this.#isLoaded = true;
    try {
      const {ClothLayer} = await import('./cloth-layer.js');
      this.#layer ??= new ClothLayer({
        ...this.#owner,
        isAwaited: this.isAwaited,
        report: this.#report,
      });
    } catch (error) {
      const message = this.#owner.texts().garment.noTools(asError(error).message);
      throw new SolverError({code: 'network', message});
    }
    this.#layer.follow();
    return this.#layer;
  }
}
