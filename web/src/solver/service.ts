import type {Drape, DrapeSettings} from '../model/result/draped-garment.js';
import type {Garment} from '../model/garment/specification.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/result/marker-search.js';
import type {
  PhotoHooks,
  PhotoObject,
  PhotoObjectRequest,
  PhotoPixels,
  PhotoReading,
  PhotoRequest,
  PhotoTileRequest,
} from '../model/print/photo-reading.js';
import type {
  Problem,
  ProofHooks,
  SingleProblem,
  SolveHooks,
} from '../model/design/solve-problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result/result.js';
import {standingOf} from '../model/result/visible-seams.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/garment/symmetries.js';
import {checkHooks, checkReadable, requestOf} from './requests/call-checks.js';
import {
  drapeTexts,
  garmentTexts,
  mirrorTexts,
  problemTexts,
  type HooksOf,
  type NamedDrapeHooks,
  type NamedPrepareHooks,
  type NamedProofHooks,
  type NamedSolveHooks,
  type Requests,
} from './requests/requests.js';
import {askingOptions, described, unsewnPrint} from './search/asked-parts.js';

/** Hooks for any request. Hooks for events that a request does not report are not called. */
export type QuestionHooks = SolveHooks & ProofHooks;

/** Hooks for requests about a garment alone. */
export interface GarmentHooks {
  readonly signal?: AbortSignal;
  /** Name of the garment in messages: the name of its file. */
  readonly name?: string;
}

/**
 * The solver, on whatever thread it runs. Arguments are copied, never transferred. A call never
 * stays pending: when its signal fires, it is rejected at once.
 */
export interface SolverService {
  /**
   * Aligns a print with a sewing pattern and deforms the pattern so that the print matches at its
   * seams. With several sizes or turns of the print, or with the effort `auto`, it solves several
   * times and takes the best answer.
   * @throws {SolverError} for bad input; the signal's reason, an `AbortError` by default, when it
   * fires; errors of hooks
   */
  solve(problem: Problem, hooks?: NamedSolveHooks): Promise<SolveResult>;

  /**
   * The garment in the form to be solved: checked and meshed, with its symmetries determined.
   * @throws {SolverError} as `solve` does
   */
  prepare(problem: Problem, hooks?: NamedPrepareHooks): Promise<MeshedPattern>;

  /**
   * Bound on alignments of the pieces as drafted. The proof runs until no more can be proven, which
   * may take minutes, or until the signal fires. Solves take precedence.
   * @throws {SolverError} as `solve` does
   */
  prove(problem: Problem, hooks?: NamedProofHooks): Promise<Proof>;

  /**
   * Measures one symmetry on a garment, even if the garment does not have it.
   * @throws {SolverError} for bad input, such as a piece that the garment does not have
   */
  mirror(
    garment: Garment | string,
    symmetry: Symmetry,
    hooks?: GarmentHooks,
  ): Promise<MeasuredSymmetry>;

  /**
   * The symmetries detected on a garment: those that `symmetry: 'auto'` would impose, if the group
   * permits.
   */
  symmetries(garment: Garment | string, hooks?: GarmentHooks): Promise<DetectedSymmetries>;

  /** A garment of any readable format as one document. @throws {SolverError} for bad input */
  garment(garment: Garment | string, hooks?: GarmentHooks): Promise<GarmentDocument>;

  /** A garment of any readable format as the text of a seamwise-garment/1 file. */
  convert(garment: Garment | string, hooks?: GarmentHooks): Promise<string>;

  /**
   * Drapes a solved garment: hangs it on a form and lets it settle.
   * @throws {SolverError} for bad input, such as a garment file without placements of its pieces
   */
  drape(
    result: SolveResult | string,
    settings?: DrapeSettings,
    hooks?: NamedDrapeHooks,
  ): Promise<Drape>;

  /**
   * Lays out the cutting lines of pieces on printed fabric, each in register with the print and on
   * a short length.
   * @throws {SolverError} if that is impossible, such as for a piece wider than the fabric
   */
  marker(problem: MarkerProblem, hooks?: MarkerHooks): Promise<MarkerAnswer>;

  /**
   * Reads lattice and group of a print from an image of its fabric.
   * @throws {SolverError} if none is found
   */
  photo(request: PhotoRequest, hooks?: PhotoHooks): Promise<PhotoReading>;

  /** Image of the print's cell, w1 to the right and w2 up, from all copies in an image. */
  photoTile(request: PhotoTileRequest, hooks?: PhotoHooks): Promise<PhotoPixels>;

  /**
   * Finds a coin, a card or a sheet in an image of fabric, which makes lengths known.
   * @throws {SolverError} if none is visible
   */
  photoObject(request: PhotoObjectRequest, hooks?: PhotoHooks): Promise<PhotoObject>;
}

/** The problem of one solve. @throws {SolverError} for invalid options */
async function singleOf(problem: Problem, called?: string): Promise<SingleProblem> {
  if (!askingOptions(problem)) return problem as SingleProblem;
  const {singleProblem} = await import('./search/asked-search.js');
  return singleProblem(problem, called);
}

/** The problem on its print after the wash. @throws {SolverError} for contradictory fabric */
async function withSewnPrint(problem: SingleProblem): Promise<SingleProblem> {
  const print = unsewnPrint(problem);
  if (!print) return problem;
  const {asSewn, checkDelivered} = await import('../model/print/as-sewn.js');
  checkDelivered(print);
  return {...problem, print: asSewn(print)};
}

/** A service that makes the requests; subclasses answer them. */
export abstract class TextService implements SolverService {
  /** Answers one request. @throws as `solve` does */
  abstract ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']>;

  async solve(problem: Problem, hooks: NamedSolveHooks = {}): Promise<SolveResult> {
    checkHooks('solve', hooks);
    hooks.signal?.throwIfAborted();
    checkReadable('solve', problem);
    if (!askingOptions(problem)) return this.#solveOnce(problem as SingleProblem, hooks);
    const {askedSearch, singleProblem} = await import('./search/asked-search.js');
    const search = askedSearch(problem, hooks.names?.options);
    if (!search) return this.#solveOnce(singleProblem(problem, hooks.names?.options), hooks);
    const {bestAnswer} = await import('./search/best-answer.js');
    return bestAnswer(
      {
        search,
        solve: (variant, seed, its) => this.#solveOnce({...search.problemAt(variant), seed}, its),
        standingOf: (result) => standingOf(result, search.weights),
      },
      hooks,
    );
  }

  async #solveOnce(problem: SingleProblem, hooks: NamedSolveHooks): Promise<SolveResult> {
    const {names} = hooks;
    const sewn = await withSewnPrint(problem);
    const result = await this.#ask('solve', () => problemTexts(sewn, names), hooks);
    return described(result, sewn);
  }

  async prepare(problem: Problem, hooks: NamedPrepareHooks = {}): Promise<MeshedPattern> {
    checkHooks('prepare', hooks);
    checkReadable('prepare', problem);
    const sewn = await withSewnPrint(await singleOf(problem, hooks.names?.options));
    return this.#ask('prepare', () => problemTexts(sewn, hooks.names), hooks);
  }

  async prove(problem: Problem, hooks: NamedProofHooks = {}): Promise<Proof> {
    checkHooks('prove', hooks);
    checkReadable('prove', problem);
    const sewn = await withSewnPrint(await singleOf(problem, hooks.names?.options));
    return this.#ask('prove', () => problemTexts(sewn, hooks.names), hooks);
  }

  mirror(
    garment: Garment | string,
    symmetry: Symmetry,
    hooks: GarmentHooks = {},
  ): Promise<MeasuredSymmetry> {
    return this.#ask('mirror', () => mirrorTexts(garment, symmetry, hooks.name), hooks);
  }

  symmetries(garment: Garment | string, hooks: GarmentHooks = {}): Promise<DetectedSymmetries> {
    return this.#ask('symmetries', () => garmentTexts(garment, hooks.name), hooks);
  }

  garment(garment: Garment | string, hooks: GarmentHooks = {}): Promise<GarmentDocument> {
    return this.#ask('garment', () => garmentTexts(garment, hooks.name), hooks);
  }

  convert(garment: Garment | string, hooks: GarmentHooks = {}): Promise<string> {
    return this.#ask('convert', () => garmentTexts(garment, hooks.name), hooks);
  }

  drape(
    result: SolveResult | string,
    settings: DrapeSettings = {},
    hooks: NamedDrapeHooks = {},
  ): Promise<Drape> {
    return this.#ask('drape', () => drapeTexts(result, settings, hooks.names), hooks);
  }

  marker(problem: MarkerProblem, hooks: MarkerHooks = {}): Promise<MarkerAnswer> {
    return this.#ask('marker', () => problem, hooks);
  }

  photo(request: PhotoRequest, hooks: PhotoHooks = {}): Promise<PhotoReading> {
    return this.#ask('photo', () => request, hooks);
  }

  photoTile(request: PhotoTileRequest, hooks: PhotoHooks = {}): Promise<PhotoPixels> {
    return this.#ask('photoTile', () => request, hooks);
  }

  photoObject(request: PhotoObjectRequest, hooks: PhotoHooks = {}): Promise<PhotoObject> {
    return this.#ask('photoObject', () => request, hooks);
  }

  /** A signal that has fired takes precedence over any error in a request. */
  async #ask<K extends keyof Requests>(
    kind: K,
    request: () => Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    checkHooks(kind, hooks);
    hooks.signal?.throwIfAborted();
    return this.ask(kind, requestOf(kind, request), hooks);
  }
}
