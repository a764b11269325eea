/** Data of the present garment, apart from its results: its document and its mesh. */
import type {DesignGarment} from '../model/design/design.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {MeshedPattern} from '../model/result/result.js';
import type {SolverService} from '../solver/service.js';

export class KnownGarment {
  readonly #solver: Pick<SolverService, 'garment'>;
  readonly #changed: () => void;
  #garment: DesignGarment | undefined;
  #pattern: MeshedPattern | undefined;
  readonly #documents = new WeakMap<DesignGarment, GarmentDocument>();
  /** Result of an edit of the garment, before it is read or meshed. */
  #expected: {readonly garment: DesignGarment; readonly pattern: MeshedPattern} | undefined;
  /** Garment that is being read. */
  #reading: DesignGarment | undefined;

  /** @param changed called when the present garment has been read */
  constructor(solver: Pick<SolverService, 'garment'>, changed: () => void) {
    this.#solver = solver;
    this.#changed = changed;
  }

  get garment(): DesignGarment | undefined {
    return this.#garment;
  }

  /** Undefined until the garment has been read. */
  get document(): GarmentDocument | undefined {
    return this.#garment && this.#documents.get(this.#garment);
  }

  get pattern(): MeshedPattern | undefined {
    return this.#pattern;
  }

  /** Stores the document of the next garment, and its pattern until it is meshed. */
  expect(garment: DesignGarment, document: GarmentDocument, pattern: MeshedPattern): void {
    this.#documents.set(garment, document);
    this.#expected = {garment, pattern};
  }

  /**
   * Sets the present garment, and drops the data of another one.
   * @returns whether it was another one
   */
  meet(garment: DesignGarment): boolean {
    if (garment === this.#garment) return false;
    this.#garment = garment;
    this.#pattern = this.#expected?.garment === garment ? this.#expected.pattern : undefined;
    this.#expected = undefined;
    return true;
  }

  /** Document of any garment, read once. @throws {SolverError} when it cannot be read */
  async read(garment: DesignGarment): Promise<GarmentDocument> {
    const known = this.#documents.get(garment);
    if (known) return known;
    const {text, name} = garment;
    const document = await this.#solver.garment(text, {name});
    this.#documents.set(garment, document);
    return document;
  }

  /**
   * Reads the present garment, unless it is read already. Errors are ignored, because the solve
   * reports them, too.
   */
  async learn(): Promise<void> {
    const garment = this.#garment;
    if (!garment || this.#documents.has(garment) || this.#reading === garment) return;
    this.#reading = garment;
    await this.read(garment).catch(() => undefined);
    if (this.#reading === garment) this.#reading = undefined;
    if (garment === this.#garment && this.document) this.#changed();
  }

  /** Stores a mesh. @returns whether it is the mesh of the present garment */
  take(garment: DesignGarment, pattern: MeshedPattern): boolean {
    if (garment !== this.#garment) return false;
    this.#pattern = pattern;
    return true;
  }

  /** Stores a mesh unless there is one. @returns whether it was stored */
  takeFirst(garment: DesignGarment, pattern: MeshedPattern): boolean {
    return !this.#pattern && this.take(garment, pattern);
  }
}
