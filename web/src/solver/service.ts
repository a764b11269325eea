import type {Garment} from '../model/garment.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Problem, ProofHooks, SolveHooks} from '../model/problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import type {Answers, QuestionOf} from './protocol.js';
import {
  jsonText,
  mirrorTexts,
  plainNames,
  problemTexts,
  type NamedPrepareHooks,
  type NamedProofHooks,
  type NamedSolveHooks,
} from './texts.js';

/** For any question: what it does not report is not heard. */
export type QuestionHooks = SolveHooks & ProofHooks;

/** For questions about a garment alone. */
export interface GarmentHooks {
  readonly signal?: AbortSignal;
  /** What to call the garment in messages: the name of its file. */
  readonly name?: string;
}

/**
 * The solver, wherever it runs. What a caller hands over is copied, never taken away, and a call never
 * stays pending: when its signal fires, it is rejected at once.
 */
export interface SolverService {
  /**
   * Aligns a print with a sewing pattern and deforms the pattern so that the print matches at its seams.
   * @throws {SolverError} for bad input; the signal's reason, an `AbortError` by default, when it
   *   fires; what a listener throws
   */
  solve(problem: Problem, hooks?: NamedSolveHooks): Promise<SolveResult>;

  /**
   * The garment as a solve would begin with it: checked, meshed, its symmetries settled.
   * @throws {SolverError} as `solve` does
   */
  prepare(problem: Problem, hooks?: NamedPrepareHooks): Promise<MeshedPattern>;

  /**
   * How good alignments of the pieces as drafted can be: looked into until no more can be proven, which may
   * take minutes, or until the signal fires. Solves go before it.
   * @throws {SolverError} as `solve` does
   */
  prove(problem: Problem, hooks?: NamedProofHooks): Promise<Proof>;

  /**
   * Measures one symmetry on a garment, whether or not the garment mirrors so.
   * @throws {SolverError} for bad input, such as a piece that the garment does not have
   */
  mirror(
    garment: Garment | string,
    symmetry: Symmetry,
    hooks?: GarmentHooks,
  ): Promise<MeasuredSymmetry>;

  /** The symmetries a garment shows by itself: what `symmetry: 'auto'` would impose, group permitting. */
  symmetries(garment: Garment | string, hooks?: GarmentHooks): Promise<DetectedSymmetries>;

  /** A garment of any readable format as one document. @throws {SolverError} for bad input */
  garment(garment: Garment | string, hooks?: GarmentHooks): Promise<GarmentDocument>;

  /** A garment of any readable format as the text of a seamwise-garment/1 file. */
  convert(garment: Garment | string, hooks?: GarmentHooks): Promise<string>;
}

/** A service for whoever can answer in texts: it makes the texts. */
export abstract class TextService implements SolverService {
  /** Answers one question; of the hooks, all but the signal are for solves and proofs. @throws as `solve` does */
  abstract ask<K extends keyof Answers>(
    question: QuestionOf<K>,
    hooks: QuestionHooks,
  ): Promise<Answers[K]>;

  async solve(problem: Problem, hooks: NamedSolveHooks = {}): Promise<SolveResult> {
    hooks.signal?.throwIfAborted();
    const texts = problemTexts(problem, hooks.names);
    return this.ask<'solve'>(
      {kind: 'solve', texts, showsPattern: hooks.onPattern !== undefined},
      hooks,
    );
  }

  async prepare(problem: Problem, hooks: NamedPrepareHooks = {}): Promise<MeshedPattern> {
    hooks.signal?.throwIfAborted();
    return this.ask<'prepare'>({kind: 'prepare', texts: problemTexts(problem, hooks.names)}, hooks);
  }

  async prove(problem: Problem, hooks: NamedProofHooks = {}): Promise<Proof> {
    hooks.signal?.throwIfAborted();
    return this.ask<'prove'>({kind: 'prove', texts: problemTexts(problem, hooks.names)}, hooks);
  }

  async mirror(
    garment: Garment | string,
    symmetry: Symmetry,
    {name = plainNames.garment, ...hooks}: GarmentHooks = {},
  ): Promise<MeasuredSymmetry> {
    hooks.signal?.throwIfAborted();
    return this.ask<'mirror'>({kind: 'mirror', texts: mirrorTexts(garment, symmetry, name)}, hooks);
  }

  async symmetries(
    garment: Garment | string,
    {name = plainNames.garment, ...hooks}: GarmentHooks = {},
  ): Promise<DetectedSymmetries> {
    hooks.signal?.throwIfAborted();
    return this.ask<'symmetries'>(
      {kind: 'symmetries', garment: jsonText(garment, name), name},
      hooks,
    );
  }

  async garment(
    garment: Garment | string,
    {name = plainNames.garment, ...hooks}: GarmentHooks = {},
  ): Promise<GarmentDocument> {
    hooks.signal?.throwIfAborted();
    return this.ask<'garment'>({kind: 'garment', garment: jsonText(garment, name), name}, hooks);
  }

  async convert(
    garment: Garment | string,
    {name = plainNames.garment, ...hooks}: GarmentHooks = {},
  ): Promise<string> {
    hooks.signal?.throwIfAborted();
    return this.ask<'convert'>({kind: 'convert', garment: jsonText(garment, name), name}, hooks);
  }
}
