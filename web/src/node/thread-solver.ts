/** The solver on this thread, with modules from the package. */
import {readFile} from 'node:fs/promises';
import {availableParallelism} from 'node:os';
import {isMainThread} from 'node:worker_threads';

import {localAnswerer} from '../solver/answer-table.js';
import {helpersFor, type HooksOf, type Requests} from '../solver/requests/requests.js';
import {Helpers} from '../solver/threads/helpers.js';
import {TextService} from '../solver/service.js';
import {thread} from './thread.js';

/**
 * Number of helper threads; none in a program's own threads, such as those of a batch, since all
 * cores are then in use.
 */
const most = isMainThread ? helpersFor(availableParallelism()) : 0;

const wasmFile = (name: string) =>
  readFile(new URL(`../solver/module/${name}.wasm`, import.meta.url));

export class ThreadSolver extends TextService {
  readonly #answerer = localAnswerer(
    {
      sources: {
        seamwise: () => wasmFile('seamwise'),
        drape: () => wasmFile('drape'),
        marker: () => wasmFile('marker'),
        photo: () => wasmFile('photo'),
      },
    },
    new Helpers(thread),
  );

  ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    return this.#answerer.answer(kind, request, {...hooks, helpers: most});
  }
}
