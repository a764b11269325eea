/** One kind of request: what it holds, what answers it, and what is told of it in between. */
export interface RequestKind {
  readonly request: object;
  readonly answer: unknown;
  /** Listeners, of one value each. */
  readonly hooks: object;
}

/** By their names. */
export type RequestKinds = Readonly<Record<string, RequestKind>>;

export type KindOf<R> = keyof R & string;

/** What comes with a request. */
interface RequestOptions {
  /** Fires when the answer is not wanted any more. */
  readonly signal?: AbortSignal;
  /**
   * Buffers in the request to hand over to another thread: its caller loses them. All others are copied. On the
   * caller's own thread neither happens, and who answers only reads them.
   */
  readonly transfer?: readonly ArrayBuffer[];
  /** Hears once that its turn has come. */
  readonly onBegin?: () => void;
  /** How many threads may help with it; none, unless said otherwise. */
  readonly helpers?: number;
}

export type HooksOf<Q extends RequestKind> = Q['hooks'] & RequestOptions;
