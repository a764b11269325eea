/** In a worker: answers the one question that it is made for. */
import type {Reply} from './reply.js';

/** What there is of a worker's scope. */
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

/** Asks whoever asked; one thing at a time. */
type Request = (request: unknown) => Promise<unknown>;

const request: Request = (request) => {
  const told = heard();
  scope.postMessage({kind: 'request', request});
  return told;
};

/** To be called while the worker's script runs: what is said before somebody listens is lost. */
export function serve(answerTo: (question: unknown, request: Request) => Promise<unknown>): void {
  const answered = heard().then((question) => answerTo(question, request));
  void answered.then(
    (answer) => {
      scope.postMessage({kind: 'answer', answer});
    },
    (error: unknown) => {
      scope.postMessage({kind: 'failed', message: (error as Error).message});
    },
  );
}
