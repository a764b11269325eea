import type {Drape, DrapeSettings} from '../model/drape.js';
import type {Garment} from '../model/garment.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/marker.js';
import type {
  PhotoHooks,
  PhotoObject,
  PhotoObjectRequest,
  PhotoPixels,
  PhotoReading,
  PhotoRequest,
  PhotoTileRequest,
} from '../model/photo.js';
import type {Problem, ProofHooks, SolveHooks} from '../model/problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import type {HooksOf} from './requests/kinds.js';
import type {Requests} from './requests/requests.js';
import {
  drapeTexts,
  garmentTexts,
  mirrorTexts,
  problemTexts,
  type NamedDrapeHooks,
  type NamedPrepareHooks,
  type NamedProofHooks,
  type NamedSolveHooks,
} from './requests/texts.js';

/** Hooks for any question; those for events that it never reports are not called. */
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

  /**
   * A solved garment as it is worn: hung on a form and left to settle.
   * @throws {SolverError} for bad input, such as a garment whose file does not say where its pieces hang
   */
  drape(
    result: SolveResult | string,
    settings?: DrapeSettings,
    hooks?: NamedDrapeHooks,
  ): Promise<Drape>;

  /**
   * Lays the cut lines of pieces on printed cloth, so that each has its part of the print and the cloth is short.
   * @throws {SolverError} where that cannot be, such as for a piece that is wider than the cloth
   */
  marker(problem: MarkerProblem, hooks?: MarkerHooks): Promise<MarkerAnswer>;

  /**
   * Reads lattice and group of a print off a picture of its cloth.
   * @throws {SolverError} where none is found
   */
  photo(request: PhotoRequest, hooks?: PhotoHooks): Promise<PhotoReading>;

  /** The print's cell, w1 to the right and w2 up, from all copies that a picture shows. */
  photoTile(request: PhotoTileRequest, hooks?: PhotoHooks): Promise<PhotoPixels>;

  /**
   * Where a coin, a card or a sheet lies on a picture of cloth, which makes lengths known.
   * @throws {SolverError} where none is seen
   */
  photoObject(request: PhotoObjectRequest, hooks?: PhotoHooks): Promise<PhotoObject>;
}

/** A service for whoever can answer requests: it makes the requests. */
export abstract class TextService implements SolverService {
  /** Answers one request. @throws as `solve` does */
  abstract ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']>;

  solve(problem: Problem, hooks: NamedSolveHooks = {}): Promise<SolveResult> {
    return this.#ask('solve', () => problemTexts(problem, hooks.names), hooks);
  }

  prepare(problem: Problem, hooks: NamedPrepareHooks = {}): Promise<MeshedPattern> {
    return this.#ask('prepare', () => problemTexts(problem, hooks.names), hooks);
  }

  prove(problem: Problem, hooks: NamedProofHooks = {}): Promise<Proof> {
    return this.#ask('prove', () => problemTexts(problem, hooks.names), hooks);
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

  /** A signal that has fired goes before anything that is wrong with a request. */
  async #ask<K extends keyof Requests>(
    kind: K,
    request: () => Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    hooks.signal?.throwIfAborted();
    return this.ask(kind, request(), hooks);
  }
}
