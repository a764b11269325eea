import type {Drape, DrapeHooks} from '../../model/result/draped-garment.js';
import type {GarmentDocument} from '../../model/garment/garment-document.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../../model/result/marker-search.js';
import type {
  PhotoHooks,
  PhotoObject,
  PhotoObjectRequest,
  PhotoPixels,
  PhotoReading,
  PhotoRequest,
  PhotoTileRequest,
} from '../../model/print/photo-reading.js';
import type {ProofHooks, SolveHooks} from '../../model/design/solve-problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../../model/result/result.js';
import type {DetectedSymmetries, MeasuredSymmetry} from '../../model/garment/symmetries.js';
import type {DrapeTexts, GarmentTexts, MirrorTexts, ProblemTexts} from './texts.js';

/** All requests to the solver, by kind; `../answering.ts` defines the answers. */
export type Requests = {
  readonly solve: {request: ProblemTexts; answer: SolveResult; hooks: SolveHooks};
  readonly prepare: {request: ProblemTexts; answer: MeshedPattern; hooks: object};
  readonly prove: {request: ProblemTexts; answer: Proof; hooks: ProofHooks};
  readonly mirror: {request: MirrorTexts; answer: MeasuredSymmetry; hooks: object};
  readonly symmetries: {request: GarmentTexts; answer: DetectedSymmetries; hooks: object};
  readonly garment: {request: GarmentTexts; answer: GarmentDocument; hooks: object};
  readonly convert: {request: GarmentTexts; answer: string; hooks: object};
  readonly drape: {request: DrapeTexts; answer: Drape; hooks: DrapeHooks};
  readonly marker: {request: MarkerProblem; answer: MarkerAnswer; hooks: MarkerHooks};
  readonly photo: {request: PhotoRequest; answer: PhotoReading; hooks: PhotoHooks};
  readonly photoTile: {request: PhotoTileRequest; answer: PhotoPixels; hooks: PhotoHooks};
  readonly photoObject: {request: PhotoObjectRequest; answer: PhotoObject; hooks: PhotoHooks};
  /**
   * A share of another thread's search: the order from `Solver.lend`, and the answer for
   * `Solver.take`.
   */
  readonly share: {request: {readonly order: Float64Array}; answer: Float64Array; hooks: object};
  /** Memory of the module: its size, and the part in use. [bytes] */
  readonly memory: {
    request: object;
    answer: {readonly heap: number; readonly live: number};
    hooks: object;
  };
};
