/** Worker side: answers the worker's only request. */
import type {Failure} from '../../model/base/failure.js';

/**
 * Messages of a worker for one request: its answer or its error, and before that its own requests.
 */
export type Reply =
  | {readonly kind: 'answer'; readonly answer: unknown}
  | {readonly kind: 'failed'; readonly message: string; readonly reason?: Failure['reason']}
  | {readonly kind: 'request'; readonly request: unknown};

/** The used part of a worker's scope. */
interface Scope {
  onmessage: (event: MessageEvent<unknown>) => void;
  postMessage(reply: Reply): void;
}

const scope = globalThis as unknown as Scope;

const heard = (): Promise<unknown> =>
  new Promise((resolve) => {
    scope.onmessage = ({data}) => {
      resolve(data);
    };
  });

/** Sends a request to the page; one at a time. */
type Request = (request: unknown) => Promise<unknown>;

const request: Request = (request) => {
  const told = heard();
  scope.postMessage({kind: 'request', request});
  return told;
};

/**
 * Serves the request. Call it while the worker's script runs: messages before the first listener
 * are lost.
 */
export function serve(answerTo: (question: unknown, request: Request) => Promise<unknown>): void {
  const answered = heard().then((question) => answerTo(question, request));
  void answered.then(
    (answer) => {
      scope.postMessage({kind: 'answer', answer});
    },
    (error: unknown) => {
      const {message, reason} = error as Partial<Failure> & Error;
      scope.postMessage({kind: 'failed', message, ...(reason && {reason})});
    },
  );
}
