/** Answers requests of another thread. */
import {failureOf, SolverError, type Failure} from '../../model/base/failure.js';
import {shown} from '../../model/base/read.js';
import {Answerer, type AnswerTable} from '../answers/answerer.js';
import {internalError} from '../answers/failures.js';
import type {Modules, WasmSources} from '../module/shared-module.js';
import type {HooksOf, KindOf, RequestKinds} from '../requests/requests.js';
import {
  protocolVersion,
  type FromThread,
  type ModuleSource,
  type RequestMessage,
  type ToThread,
} from './thread.js';

/** Sends a message to the requesting thread, and transfers buffers to it. */
type PostMessage = (message: FromThread, transfer: ArrayBuffer[]) => void;

/**
 * Answers requests of another thread. Work is done in slices, so that a cancellation takes effect
 * between two of them.
 * @returns the receiver for all messages of the other thread
 */
export function serve<R extends RequestKinds, Ms extends Modules>(
  table: AnswerTable<R, Ms>,
  post: PostMessage,
): (message: ToThread<R>) => void {
  const jobs = new Map<number, AbortController>();
  let answerer = new Answerer(table);

  const answer = async (message: RequestMessage<R>): Promise<void> => {
    const {job, name, request} = message;
    if (!isKnown(message, table.requests)) {
      post({kind: 'failed', job, failure: failureOf(unknownRequest(name))}, []);
      return;
    }
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
      // typed by the requesting thread
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
    if (!isMessage(message)) return;
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

/** Returns false for what other scripts post to the same worker. */
function isMessage(value: unknown): boolean {
  if (typeof value !== 'object' || value === null) return false;
  const {kind, sources, job} = value as Readonly<Record<string, unknown>>;
  if (kind === 'modules') return isSources(sources);
  return kind !== 'request' || Number.isFinite(job);
}

/** Returns whether the request is one of the table, with a list of names as its hooks. */
const isKnown = (message: {readonly name: unknown; readonly hooks: unknown}, requests: object) =>
  typeof message.name === 'string' &&
  Object.hasOwn(requests, message.name) &&
  isListOfText(message.hooks);

const isListOfText = (value: unknown): boolean =>
  Array.isArray(value) &&
  !value.includes(undefined) &&
  value.every((entry) => typeof entry === 'string');

const isSources = (value: unknown): boolean =>
  typeof value === 'object' &&
  value !== null &&
  Object.values(value).every(
    (source: unknown) => typeof source === 'string' || source instanceof WebAssembly.Module,
  );

const unknownRequest = (name: unknown): SolverError =>
  new SolverError({
    code: 'internal',
    message: `The solver has no request ${shown(name)}; load page and worker from one version.`,
  });

/** Sources of modules, typed by the requesting thread. */
function sourcesOf<Ms extends Modules>(
  sources: Readonly<Record<string, ModuleSource>>,
): WasmSources<Ms> {
  const entries = Object.entries(sources).map(([name, source]) => [name, () => source] as const);
  return Object.fromEntries(entries) as WasmSources<Ms>;
}

/**
 * A failure as plain data. Errors other than those of the input and of cancellation are internal
 * ones of this thread.
 */
function toFailure(error: unknown, signal: AbortSignal): Failure {
  const known = error instanceof SolverError ? error : unexpected(error, signal);
  return failureOf(known);
}

function unexpected(error: unknown, signal: AbortSignal): SolverError {
  if (error !== signal.reason) return internalError('The solver broke', error);
  return new SolverError({code: 'cancelled', message: 'The job was cancelled.'});
}

/** The buffers of all typed arrays in a value, each once, to be transferred instead of copied. */
function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (value instanceof ArrayBuffer) found.add(value);
  else if (ArrayBuffer.isView(value)) buffersOf(value.buffer, found);
  else if (typeof value === 'object' && value !== null) {
    for (const part of Object.values(value)) buffersOf(part, found);
  }
  return found;
}
