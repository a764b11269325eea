import {failureOf, SolverError, type Failure} from '../../model/failure.js';
import {Answerer} from '../answers/answerer.js';
import {internalError} from '../answers/broken.js';
import type {Modules, WasmSources} from '../answers/shared-module.js';
import type {AnswerTable} from '../answers/table.js';
import type {HooksOf, KindOf, RequestKinds} from '../requests/kinds.js';
import {buffersOf} from './buffers.js';
import {
  protocolVersion,
  type FromThread,
  type ModuleSource,
  type RequestMessage,
  type ToThread,
} from './protocol.js';

/** Tells the thread that asks, and hands over what is to be transferred. */
type PostMessage = (message: FromThread, transfer: ArrayBuffer[]) => void;

/**
 * Answers requests of another thread: work is done in slices, so that a cancel is seen between any two.
 * @returns what is to be given all that the other thread says
 */
export function serve<R extends RequestKinds, Ms extends Modules>(
  table: AnswerTable<R, Ms>,
  post: PostMessage,
): (message: ToThread<R>) => void {
  const jobs = new Map<number, AbortController>();
  let answerer = new Answerer(table);

  const answer = async (message: RequestMessage<R>): Promise<void> => {
    const {job, name, request} = message;
    const transfers: readonly PropertyKey[] = table.requests[name].transfers ?? [];
    const send = (part: string, told: FromThread, value: unknown) => {
      post(told, transfers.includes(part) ? [...buffersOf(value)] : []);
    };
    const controller = new AbortController();
    jobs.set(job, controller);
    const {signal} = controller;
    const listener = (hook: string) => (value: unknown) => {
      send(hook, {kind: 'report', job, hook, value}, value);
    };
    const listeners = Object.fromEntries(message.hooks.map((hook) => [hook, listener(hook)]));
    try {
      // as the asking thread has typed them
      const hooks = {...listeners, signal, helpers: message.helpers} as HooksOf<R[KindOf<R>]>;
      const value = await answerer.answer(name, request, hooks);
      send('answer', {kind: 'done', job, answer: value}, value);
    } catch (error) {
      post({kind: 'failed', job, failure: toFailure(error, signal)}, []);
    } finally {
      jobs.delete(job);
    }
  };

  post({kind: 'ready', version: protocolVersion}, []);
  return (message) => {
    switch (message.kind) {
      case 'modules':
        answerer = new Answerer(table, {sources: sourcesOf<Ms>(message.sources)});
        break;
      case 'ping':
        post({kind: 'pong'}, []);
        break;
      case 'cancel':
        jobs.get(message.job)?.abort();
        break;
      case 'request':
        void answer(message);
        break;
      default:
        message satisfies never;
    }
  };
}

/** As the asking thread has typed them. */
function sourcesOf<Ms extends Modules>(
  sources: Readonly<Record<string, ModuleSource>>,
): WasmSources<Ms> {
  const entries = Object.entries(sources).map(([name, source]) => [name, () => source] as const);
  return Object.fromEntries(entries) as WasmSources<Ms>;
}

/** As plain data; whatever is neither the caller's fault nor wish is the answering thread's own. */
function toFailure(error: unknown, signal: AbortSignal): Failure {
  const known = error instanceof SolverError ? error : unexpected(error, signal);
  return failureOf(known);
}

function unexpected(error: unknown, signal: AbortSignal): SolverError {
  if (error !== signal.reason) return internalError('The solver broke', error);
  return new SolverError({code: 'cancelled', message: 'The job was cancelled.'});
}
