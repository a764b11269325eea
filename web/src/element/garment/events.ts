/** Events, states and details of the element. */
import type {DrapeStage} from '../../model/result/draped-garment.js';
import type {Failure} from '../../model/base/failure.js';
import type {Progress} from '../../model/design/solve-problem.js';
import type {Metrics} from '../../model/result/result.js';
import type {StoredDesign} from '../../model/documents/stored-design.js';

/** `stale`: the shown result does not match the request, and nothing is running. */
export type GarmentState = 'idle' | 'loading' | 'solving' | 'ready' | 'stale' | 'error';

export interface DesignFile {
  readonly name: string;
  /** Null for a file given as an object. */
  readonly url: string | null;
}

/** Details of the events; all are plain data. */
export interface GarmentEvents {
  /** The garment and the print have been read. */
  readonly load: {readonly garment: DesignFile; readonly print: DesignFile};
  readonly progress: Progress;
  readonly error: Failure;
  /** The user is dragging; this is the design so far. */
  readonly input: {readonly design: StoredDesign | null};
  /**
   * The user has changed the design, and the answer is there. Null if the design cannot be stored.
   */
  readonly change: {readonly design: StoredDesign | null};
  /** Progress of a drape; once it has settled, notes for the user, one sentence each. */
  readonly drape: {
    readonly stage: DrapeStage;
    readonly fraction: number;
    readonly settled: boolean;
    readonly notes: readonly string[];
  };
  /** The layout of the answer is ready; notes for the user, one sentence each. [cm] */
  readonly cloth: {
    readonly widthCm: number;
    readonly lengthCm: number;
    /** True if no layout is shorter with the same start of the print. */
    readonly proven: boolean;
    readonly notes: readonly string[];
  };
  readonly solve: {readonly metrics: Metrics; readonly milliseconds: number};
  /** The user has selected a piece, by its name, or a seam, by its number, on one of its pieces. */
  readonly select: {
    readonly kind: 'none' | 'piece' | 'seam';
    readonly piece: string | null;
    readonly seam: number | null;
  };
}

/** Events of user actions and their results; they bubble to the element's ancestors. */
export const bubbling: ReadonlySet<keyof GarmentEvents> = new Set([
  'change',
  'input',
  'solve',
  'select',
] as const);

type OwnEventMap = {readonly [Type in keyof GarmentEvents]: CustomEvent<GarmentEvents[Type]>};

export type SeamwiseGarmentEventMap = Omit<HTMLElementEventMap, keyof OwnEventMap> & OwnEventMap;
