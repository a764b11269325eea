/** What is known of the garment that is worked on, beside its answers: what its file holds, its mesh, and how its pieces lie on their way. */
import type {DesignGarment} from '../model/design.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Alignment} from '../model/geometry.js';
import type {MeshedPattern} from '../model/result.js';
import {alignmentsFrom} from '../scene/scene.js';

export class KnownGarment {
  #garment: DesignGarment | undefined;
  readonly #documents = new WeakMap<DesignGarment, GarmentDocument>();
  #pattern: MeshedPattern | undefined;
  #partial: readonly Alignment[] | undefined;

  get garment(): DesignGarment | undefined {
    return this.#garment;
  }

  /** What its file holds; undefined until it has been read. */
  get document(): GarmentDocument | undefined {
    return this.#garment && this.#documents.get(this.#garment);
  }

  get pattern(): MeshedPattern | undefined {
    return this.#pattern;
  }

  /** How the pieces lie in the answer that is on its way; of `pattern`'s pieces. */
  get partial(): readonly Alignment[] | undefined {
    return this.#partial;
  }

  /** What was known of another garment is forgotten. @returns whether it was another one */
  meet(garment: DesignGarment): boolean {
    if (garment === this.#garment) return false;
    this.#garment = garment;
    this.#pattern = undefined;
    this.#partial = undefined;
    return true;
  }

  /** Once for every garment. @returns whether it is the one that is worked on */
  read(garment: DesignGarment, document: GarmentDocument): boolean {
    this.#documents.set(garment, document);
    return garment === this.#garment;
  }

  /** @returns whether it is the mesh of the garment that is worked on */
  take(garment: DesignGarment, pattern: MeshedPattern): boolean {
    if (garment !== this.#garment) return false;
    this.#pattern = pattern;
    this.#partial = undefined;
    return true;
  }

  /** Unless it is known already. @returns whether it was not */
  takeFirst(garment: DesignGarment, pattern: MeshedPattern): boolean {
    return !this.#pattern && this.take(garment, pattern);
  }

  /** @param alignments as a solve reports them @returns whether they are of the garment that is worked on */
  lay(garment: DesignGarment, alignments: Float64Array): boolean {
    if (garment !== this.#garment) return false;
    this.#partial = alignmentsFrom(alignments);
    return true;
  }

  /** No answer is on its way any more. */
  rest(): void {
    this.#partial = undefined;
  }
}
