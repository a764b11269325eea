/** Symmetries detected on a garment. */
import type {DesignGarment} from '../model/design/design.js';
import type {DetectedSymmetry, Symmetry} from '../model/garment/symmetries.js';
import type {SolverService} from '../solver/service.js';
import {lastOf} from '../model/base/last-of.js';
import type {Pattern} from '../model/result/result.js';
import {asked, concernsSame} from './symmetry-steps.js';

export class FoundSymmetries {
  readonly #solver: SolverService;
  readonly #changed: () => void;
  readonly #unasked = lastOf(
    (found: readonly DetectedSymmetry[], asked: readonly Symmetry[] = []) =>
      found.filter((one) => !asked.some((other) => concernsSame(one, other))),
  );
  readonly #held = lastOf((found: readonly DetectedSymmetry[], {symmetries, pieces}: Pattern) => {
    const nameOf = (piece: number): string => pieces[piece]?.name ?? '';
    const held = symmetries.map((one): Symmetry =>
      one.kind === 'piece'
        ? {kind: 'piece', piece: nameOf(one.piece)}
        : {kind: 'pair', pieces: [nameOf(one.pieces[0]), nameOf(one.pieces[1])]},
    );
    return found.filter((one) => held.some((other) => concernsSame(one, other))).map(asked);
  });
  /** Garment of `#found`. */
  #garment: DesignGarment | undefined;
  #found: readonly DetectedSymmetry[] = [];

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#changed = changed;
  }

  /** Detected symmetries that a result keeps without a request. */
  heldBy(pattern: Pattern): readonly Symmetry[] {
    return this.#held(this.#found, pattern);
  }

  /** Detected symmetries that are not kept yet. */
  beside(asked: readonly Symmetry[] | undefined): readonly DetectedSymmetry[] {
    return this.#unasked(this.#found, asked);
  }

  /** Detects the symmetries of another garment. */
  follow(garment: DesignGarment): void {
    this.forget();
    this.#garment = garment;
    this.#solver.symmetries(garment.text, {name: garment.name}).then(
      ({symmetries}) => {
        if (this.#garment !== garment) return;
        this.#found = symmetries;
        this.#changed();
      },
      () => undefined, // reading also fails in the solve, which reports it
    );
  }

  forget(): void {
    this.#garment = undefined;
    this.#found = [];
  }
}
