/** Fetches files from the web within limits of time and size, in browsers and in Node. */

/** Outcome of a fetch; the caller words the message for a failure. */
type Fetched =
  | {readonly kind: 'read'; readonly parts: Uint8Array<ArrayBuffer>[]; readonly type: string}
  | {readonly kind: 'refused'; readonly status: number}
  | {readonly kind: 'late'}
  | {readonly kind: 'tooLarge'}
  | {readonly kind: 'failed'; readonly cause: unknown};

interface FetchLimits {
  readonly signal?: AbortSignal | undefined;
  /** Limit for the whole file. [ms] */
  readonly timeoutMs: number;
  readonly mostBytes: number;
}

/** Fetches a file. @throws the signal's reason when the signal fires */
export async function fetchedBy(
  request: (signal: AbortSignal) => Promise<Response>,
  {signal, timeoutMs, mostBytes}: FetchLimits,
): Promise<Fetched> {
  signal?.throwIfAborted();
  const late = new AbortController();
  const clock = setTimeout(() => {
    late.abort();
  }, timeoutMs);
  try {
    const either = signal ? AbortSignal.any([signal, late.signal]) : late.signal;
    const response = await request(either);
    if (!response.ok) {
      void response.body?.cancel().catch(() => undefined);
      return {kind: 'refused', status: response.status};
    }
    const stated = Number(response.headers.get('Content-Length') ?? 0);
    const parts = await partsOf(response.body, stated > mostBytes ? -1 : mostBytes);
    const type = response.headers.get('Content-Type') ?? '';
    return parts ? {kind: 'read', parts, type} : {kind: 'tooLarge'};
  } catch (cause) {
    signal?.throwIfAborted();
    return late.signal.aborted ? {kind: 'late'} : {kind: 'failed', cause};
  } finally {
    clearTimeout(clock);
  }
}

/**
 * Reads a whole stream. Returns undefined and leaves the rest unread when it exceeds `mostBytes`.
 */
export async function partsOf(
  stream: ReadableStream<Uint8Array<ArrayBuffer>> | null,
  mostBytes: number,
): Promise<Uint8Array<ArrayBuffer>[] | undefined> {
  const reader = stream?.getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  for (let length = 0; length <= mostBytes;) {
    const next = await reader?.read();
    if (!next || next.done) return parts;
    parts.push(next.value);
    length += next.value.length;
  }
  void reader?.cancel().catch(() => undefined);
  return undefined;
}
