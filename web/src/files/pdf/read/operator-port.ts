/** A channel between pdf.js and its parser in one thread. */

/** A part of a page's operators, in order. */
export interface OperatorList {
  readonly fnArray: ArrayLike<number>;
  readonly argsArray: ArrayLike<unknown>;
}

interface Message {
  readonly chunk?: Partial<OperatorList>;
}

type Listener = (event: {readonly data: unknown}) => void;

/**
 * Delivers messages to both ends without copies. Operators are passed to `onOperators` as the parser
 * finds them, instead of being collected: a page may have millions.
 */
export class OperatorPort {
  /** Receives the operators of the page that is read. */
  onOperators: ((list: OperatorList) => void) | undefined;
  readonly #listeners = new Set<Listener>();

  postMessage(message: Message): void {
    const {fnArray, argsArray} = message.chunk ?? {};
    const isList = fnArray !== undefined && argsArray !== undefined;
    const data = isList
      ? {...message, chunk: {...message.chunk, fnArray: [], argsArray: [], length: 0}}
      : message;
    // the parser empties its lists after this call
    if (isList) this.onOperators?.({fnArray, argsArray});
    queueMicrotask(() => {
      for (const listener of this.#listeners) listener({data});
    });
  }

  addEventListener(_: 'message', listener: Listener, options?: AddEventListenerOptions): void {
    this.#listeners.add(listener);
    options?.signal?.addEventListener('abort', () => {
      this.#listeners.delete(listener);
    });
  }

  removeEventListener(_: 'message', listener: Listener): void {
    this.#listeners.delete(listener);
  }
}
