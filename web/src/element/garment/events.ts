/** What the element tells the page, and what it can be called. */
import type {DrapeStage} from '../../model/drape.js';
import type {Failure} from '../../model/failure.js';
import type {Progress} from '../../model/problem.js';
import type {Metrics} from '../../model/result.js';
import type {StoredDesign} from '../../model/stored-design.js';

/** `stale`: what is shown is not the answer to what is asked; nothing is under way. */
export type GarmentState = 'idle' | 'loading' | 'solving' | 'ready' | 'stale' | 'error';

export interface DesignFile {
  readonly name: string;
  /** Null for what was given as an object. */
  readonly url: string | null;
}

/** The details of the events; all are plain data. */
export interface GarmentEvents {
  /** Garment and print have been read. */
  readonly load: {readonly garment: DesignFile; readonly print: DesignFile};
  readonly progress: Progress;
  readonly error: Failure;
  /** The user is dragging something, and this is what it is so far. */
  readonly input: {readonly design: StoredDesign | null};
  /** The user has changed the design, and the answer is there. Null when it cannot be stored. */
  readonly change: {readonly design: StoredDesign | null};
  /** How far a worn garment has been draped; what people should know once it has settled, one sentence each. */
  readonly drape: {
    readonly stage: DrapeStage;
    readonly fraction: number;
    readonly settled: boolean;
    readonly notes: readonly string[];
  };
  /** The answer has been laid on cloth; what people should know of that, one sentence each. [cm] */
  readonly cloth: {
    readonly widthCm: number;
    readonly lengthCm: number;
    /** Whether no layout is shorter with the print starting where it does. */
    readonly proven: boolean;
    readonly notes: readonly string[];
  };
  readonly solve: {readonly metrics: Metrics; readonly milliseconds: number};
  /** The user has picked a piece, by its name, or a seam, by its number, on one of its pieces. */
  readonly select: {
    readonly kind: 'none' | 'piece' | 'seam';
    readonly piece: string | null;
    readonly seam: number | null;
  };
}

/** These are what the user does, and what comes of it: whoever is around the element hears them, too. */
export const bubbling: ReadonlySet<keyof GarmentEvents> = new Set([
  'change',
  'input',
  'solve',
  'select',
] as const);

type OwnEventMap = {readonly [Type in keyof GarmentEvents]: CustomEvent<GarmentEvents[Type]>};

export type SeamwiseGarmentEventMap = Omit<HTMLElementEventMap, keyof OwnEventMap> & OwnEventMap;
