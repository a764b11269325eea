/** What is known of the garment that is worked on, beside its answers: its mesh. */
import type {DesignGarment} from '../model/design.js';
import type {MeshedPattern} from '../model/result.js';

export class KnownGarment {
  #garment: DesignGarment | undefined;
  #pattern: MeshedPattern | undefined;

  get garment(): DesignGarment | undefined {
    return this.#garment;
  }

  get pattern(): MeshedPattern | undefined {
    return this.#pattern;
  }

  /** What was known of another garment is forgotten. @returns whether it was another one */
  meet(garment: DesignGarment): boolean {
    if (garment === this.#garment) return false;
    this.#garment = garment;
    this.#pattern = undefined;
    return true;
  }

  /** @returns whether it is the mesh of the garment that is worked on */
  take(garment: DesignGarment, pattern: MeshedPattern): boolean {
    if (garment !== this.#garment) return false;
    this.#pattern = pattern;
    return true;
  }

  /** Unless it is known already. @returns whether it was not */
  takeFirst(garment: DesignGarment, pattern: MeshedPattern): boolean {
    return !this.#pattern && this.take(garment, pattern);
  }
}
