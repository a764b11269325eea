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
