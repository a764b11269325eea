/** What is known of the garment that is worked on, beside its answers: what its file holds, and its mesh. */
import type {DesignGarment} from '../model/design.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {MeshedPattern} from '../model/result.js';
import type {SolverService} from '../solver/service.js';

export class KnownGarment {
  readonly #solver: Pick<SolverService, 'garment'>;
  readonly #changed: () => void;
  #garment: DesignGarment | undefined;
  #pattern: MeshedPattern | undefined;
  readonly #documents = new WeakMap<DesignGarment, GarmentDocument>();
  /** What an edit has made of the garment, before anybody has read or meshed it. */
  #expected: {readonly garment: DesignGarment; readonly pattern: MeshedPattern} | undefined;
  /** What is being read. */
  #reading: DesignGarment | undefined;

  /** @param changed called when the garment that is worked on has been read */
  constructor(solver: Pick<SolverService, 'garment'>, changed: () => void) {
    this.#solver = solver;
    this.#changed = changed;
  }

  get garment(): DesignGarment | undefined {
    return this.#garment;
  }

  /** Undefined until it has been read. */
  get document(): GarmentDocument | undefined {
    return this.#garment && this.#documents.get(this.#garment);
  }

  get pattern(): MeshedPattern | undefined {
    return this.#pattern;
  }

  /** What the file of a garment holds that comes next, and how it lies until it is meshed. */
  expect(garment: DesignGarment, document: GarmentDocument, pattern: MeshedPattern): void {
    this.#documents.set(garment, document);
    this.#expected = {garment, pattern};
  }

  /** What was known of another garment is forgotten. @returns whether it was another one */
  meet(garment: DesignGarment): boolean {
    if (garment === this.#garment) return false;
    this.#garment = garment;
    this.#pattern = this.#expected?.garment === garment ? this.#expected.pattern : undefined;
    this.#expected = undefined;
    return true;
  }

  /** What a garment's file holds, read once, whether or not it is worked on. @throws {SolverError} when it cannot be read */
  async read(garment: DesignGarment): Promise<GarmentDocument> {
    const known = this.#documents.get(garment);
    if (known) return known;
    const {text, name} = garment;
    const document = await this.#solver.garment(text, {name});
    this.#documents.set(garment, document);
    return document;
  }

  /** Reads the garment that is worked on, unless that is done. What cannot be read cannot be solved, which says why. */
  async learn(): Promise<void> {
    const garment = this.#garment;
    if (!garment || this.#documents.has(garment) || this.#reading === garment) return;
    this.#reading = garment;
    await this.read(garment).catch(() => undefined);
    if (this.#reading === garment) this.#reading = undefined;
    if (garment === this.#garment && this.document) this.#changed();
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
