/** Requests to the solver: their kinds, content, answers and hooks. Documents are JSON texts. */
import {
  fabricNames,
  formSizes,
  type Drape,
  type DrapeHooks,
  type DrapeSettings,
} from '../../model/result/draped-garment.js';
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
import type {Problem, ProofHooks, SolveHooks} from '../../model/design/solve-problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../../model/result/result.js';
import type {
  DetectedSymmetries,
  MeasuredSymmetry,
  Symmetry,
} from '../../model/garment/symmetries.js';
import {SolverError} from '../../model/base/failure.js';
import {shown} from '../../model/base/read.js';
import type {Garment} from '../../model/garment/specification.js';
import {methods} from '../../model/result/method.js';

/** One kind of request: its data, its answer, and its hooks in between. */
export interface RequestKind {
  readonly request: object;
  readonly answer: unknown;
  /** Callbacks, each with one argument. */
  readonly hooks: object;
}

/** Kinds of requests, by name. */
export type RequestKinds = Readonly<Record<string, RequestKind>>;

export type KindOf<R> = keyof R & string;

/** Options of every request. */
interface RequestOptions {
  /** Fires when the answer is no longer needed. */
  readonly signal?: AbortSignal;
  /**
   * Buffers in the request that are transferred to another thread, so that the caller loses them.
   * All others are copied. On the caller's own thread neither happens, and the buffers are only
   * read.
   */
  readonly transfer?: readonly ArrayBuffer[];
  /** Called once, when the request starts. */
  readonly onBegin?: () => void;
  /** Number of threads that may help. Default: none. */
  readonly helpers?: number;
}

export type HooksOf<Q extends RequestKind> = Q['hooks'] & RequestOptions;

/** Greatest number of cores to use; more are better left to other programs. */
export const mostCores = 4;

/** Number of threads that may help each of `solving` simultaneous solves. */
export const helpersFor = (cores: number, solving = 1): number =>
  Math.max(0, Math.floor(Math.min(mostCores, cores) / solving) - 1);

/** All requests to the solver, by kind; `../answer-table.ts` defines the answers. */
export type Requests = {
  readonly solve: {request: ProblemTexts; answer: SolveResult; hooks: SolveHooks};
  readonly prepare: {request: ProblemTexts; answer: MeshedPattern; hooks: object};
  readonly prove: {request: ProblemTexts; answer: Proof; hooks: ProofHooks};
  readonly mirror: {request: MirrorTexts; answer: MeasuredSymmetry; hooks: object};
  readonly symmetries: {request: GarmentTexts; answer: DetectedSymmetries; hooks: object};
  readonly garment: {request: GarmentTexts; answer: GarmentDocument; hooks: object};
  readonly convert: {request: GarmentTexts; answer: string; hooks: object};
  readonly drape: {request: DrapeInputs; answer: Drape; hooks: DrapeHooks};
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

/** A problem as text: its files, and their names in messages. */
export interface ProblemTexts {
  readonly garment: string;
  readonly garmentName: string;
  readonly print: string;
  readonly printName: string;
  /** `auto`, `none` or JSON. */
  readonly symmetry: string;
  readonly symmetryName: string;
  /** JSON, or empty. */
  readonly options: string;
  readonly optionsName: string;
  readonly method: string;
  readonly seed: number;
}

/** Names of the parts of a problem in messages: file names, if there are any. */
export interface ProblemNames {
  readonly garment: string;
  readonly print: string;
  readonly symmetry: string;
  readonly options: string;
}

/** Hooks for programs that read files. */
export interface NamedSolveHooks extends SolveHooks {
  /** Names of the problem's parts in error messages: the names of their files. */
  readonly names?: Partial<ProblemNames>;
}

export interface NamedProofHooks extends ProofHooks, Pick<NamedSolveHooks, 'names'> {}

/** Hooks for requests that report nothing before their answer. */
export type NamedPrepareHooks = Pick<NamedSolveHooks, 'signal' | 'names'>;

/** A garment as text, and its name in messages. */
export interface GarmentTexts {
  readonly garment: string;
  readonly name: string;
}

/** A garment, and a symmetry file with one symmetry of it. */
export interface MirrorTexts extends GarmentTexts {
  readonly symmetries: string;
}

/** A result to drape, and its name in messages. */
export interface DrapeInputs {
  readonly result: string;
  readonly resultName: string;
  /** JSON, or empty. */
  readonly body: string;
  readonly bodyName: string;
  readonly fabric: string;
  /** May be empty. */
  readonly size: string;
  readonly effort: number;
  /** Positions of an earlier drape; empty without one. */
  readonly settled: Float64Array;
}

/** Hooks for programs that read files. */
export interface NamedDrapeHooks extends DrapeHooks {
  /** Names of the result and the body measurements in error messages: the names of their files. */
  readonly names?: {readonly result?: string; readonly body?: string};
}

export const plainNames: ProblemNames = {
  garment: 'garment',
  print: 'print',
  symmetry: 'symmetry',
  options: 'options',
};

/** Values of `symmetry` that are not documents. */
export const namedSymmetries: ReadonlySet<string> = new Set(['auto', 'none']);
const fields = ['garment', 'print', 'symmetry', 'method', 'options', 'seed'];

/** Rejects values that an untyped caller may pass instead of a problem. @throws {SolverError} */
export function checkProblem(problem: unknown): void {
  const wrong = (message: string) => new SolverError({code: 'options', message});
  if (typeof problem !== 'object' || problem === null) {
    throw wrong('The problem is missing: hand over an object with garment and print.');
  }
  const unknown = Object.keys(problem).find((field) => !fields.includes(field));
  if (unknown !== undefined) {
    throw wrong(`A problem has no field '${unknown}'; it has ${fields.join(', ')}.`);
  }
}

/**
 * Converts a problem to text.
 * @throws {SolverError} for values that the core cannot receive at all
 */
export function problemTexts(problem: Problem, given: Partial<ProblemNames> = {}): ProblemTexts {
  checkProblem(problem);
  const names = {...plainNames, ...given};
  const {method = 'best', seed = 1} = problem;
  if (!methods.includes(method)) {
    throw new SolverError({
      code: 'options',
      message: `method is ${shown(method)}, but must be one of ${methods.join(', ')}.`,
    });
  }
  if (!Number.isInteger(seed) || seed < 0 || seed > 0xffffffff) {
    throw new SolverError({
      code: 'options',
      message: `seed is ${shown(seed)}, but must be a whole number from 0 to 4294967295.`,
    });
  }
  const {symmetry = 'auto'} = problem;
  if (typeof symmetry === 'string' && /^\w+$/.test(symmetry) && !namedSymmetries.has(symmetry)) {
    throw new SolverError({
      code: 'symmetryMalformed',
      message: `symmetry is '${symmetry}', but must be 'auto', 'none' or the symmetries themselves.`,
    });
  }
  return {
    garment: jsonText(problem.garment, names.garment),
    garmentName: names.garment,
    print: jsonText(problem.print, names.print),
    printName: names.print,
    symmetry: jsonText(symmetry, names.symmetry),
    symmetryName: names.symmetry,
    options: problem.options === undefined ? '' : jsonText(problem.options, names.options),
    optionsName: names.options,
    method,
    seed,
  };
}

/**
 * Converts a garment and a symmetry to text.
 * @throws {SolverError} for values that the core cannot receive at all
 */
export function mirrorTexts(
  garment: Garment | string,
  symmetry: Symmetry,
  name?: string,
): MirrorTexts {
  const symmetries = jsonText({symmetries: [symmetry]}, plainNames.symmetry);
  return {...garmentTexts(garment, name), symmetries};
}

/**
 * Converts a garment to text.
 * @throws {SolverError} for values that the core cannot receive at all
 */
export function garmentTexts(garment: Garment | string, name = plainNames.garment): GarmentTexts {
  return {garment: jsonText(garment, name), name};
}

/**
 * Converts a value to JSON text; strings and bytes are taken as JSON text.
 * @throws {SolverError}
 */
export function jsonText(value: unknown, name: string): string {
  if (value === '')
    throw new SolverError({code: 'notJson', message: `${name} is empty; choose another file.`});
  if (typeof value === 'string') return value;
  if (ArrayBuffer.isView(value)) return new TextDecoder().decode(value);
  let text: string | undefined;
  try {
    text = JSON.stringify(value, (key, part: unknown) => finite(part, key, name));
  } catch (error) {
    if (error instanceof SolverError) throw error;
    throw new SolverError({
      code: 'notJson',
      message: `${name} cannot be written as JSON: ${firstLine(error)}.`,
    });
  }
  // JSON.stringify(undefined) is undefined, contrary to its declaration
  if (typeof text !== 'string') {
    throw new SolverError({
      code: 'notJson',
      message: `${name} is missing; hand over an object or JSON text.`,
    });
  }
  return text;
}

/** The first line of an error; engines draw circles of objects in others. */
const firstLine = (error: unknown): string =>
  (error instanceof Error ? error.message : String(error)).replace(/\s*\n[^]*/, '');

/** Rejects numbers that are not finite, which JSON would turn into null. @throws {SolverError} */
function finite(value: unknown, key: string, name: string): unknown {
  if (typeof value === 'number' && !Number.isFinite(value)) {
    throw new SolverError({
      code: 'number',
      message: `${name}: '${key}' is ${String(value)}, but must be a finite number.`,
    });
  }
  return value;
}

/**
 * Converts a result and settings to text.
 * @throws {SolverError} for values that the core cannot receive at all
 */
export function drapeTexts(
  result: SolveResult | string,
  settings: DrapeSettings = {},
  names: NamedDrapeHooks['names'] = {},
): DrapeInputs {
  const {fabric = 'poplin', size, body, effort = 1, from} = settings;
  const check = (name: string, value: unknown, known: readonly unknown[]) => {
    if (known.includes(value)) return;
    throw new SolverError({
      code: 'options',
      message: `${name} is ${shown(value)}, but must be one of ${known.join(', ')}.`,
    });
  };
  check('fabric', fabric, fabricNames);
  if (size !== undefined) check('size', size, formSizes);
  check('effort', effort, [1, 2, 4]);
  const {result: resultName = 'result', body: bodyName = 'body'} = names;
  return {
    result: jsonText(result, resultName),
    resultName,
    body: body === undefined ? '' : jsonText(body, bodyName),
    bodyName,
    fabric,
    size: size ?? '',
    effort,
    settled: from?.positions ?? new Float64Array(),
  };
}
