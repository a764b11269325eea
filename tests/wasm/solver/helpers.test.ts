/** Helping threads, and their end in the middle of a search, must not change the result. */
import {execFile} from 'node:child_process';
import {EventEmitter, once} from 'node:events';
import {readFile} from 'node:fs/promises';
import {promisify} from 'node:util';
import {Worker} from 'node:worker_threads';

import {afterEach, expect, it} from 'vitest';

import {localAnswerer} from '@/solver/answer-table.js';
import {ownThread, type Pace} from '@/solver/answers/slices.js';
import {problemTexts, type Requests} from '@/solver/requests/requests.js';
import {Helpers} from '@/solver/threads/helpers.js';
import {
  protocolVersion,
  type FromThread,
  type StartThread,
  type ToThread,
} from '@/solver/threads/thread.js';
import {isThorough} from '../../support/level.js';
import {sample} from '../../support/garments/samples.js';

const wasmBinary = await readFile(
  new URL('../../../web/src/solver/module/seamwise.wasm', import.meta.url),
);
const script = new URL('../../../dist/node/helper-thread.js', import.meta.url);
const print = {group: 'p31m', w1: [10, 0], w2: [5, 8.660254037844386]} as const;
const garment = sample(isThorough ? 'hoodie' : 'tee');
const problem = problemTexts({garment, print, symmetry: 'none'});

/**
 * A thread that continues its share after the first slice only after a cancel, and sends `pong` by
 * then. Each slice begins after `setImmediate`.
 */
const haltingThread = `
  const {parentPort} = require('node:worker_threads');
  const {abort} = AbortController.prototype;
  const next = globalThis.setImmediate;
  const held = [];
  let isCancelled = false;
  let pauses = 0;
  globalThis.setImmediate = (callback) => {
    if (isCancelled || ++pauses === 1) return next(callback);
    held.push(callback);
    parentPort.postMessage({kind: 'pong'});
  };
  AbortController.prototype.abort = function (reason) {
    isCancelled = true;
    abort.call(this, reason);
    for (const callback of held.splice(0)) next(callback);
  };
  import(${JSON.stringify(script.href)});
`;

/** Threads start and get requests without delay. */
const delays = {start: 0, lend: 0, end: 50};

interface Heard {
  readonly thread: Worker;
  readonly sent: ToThread<Requests>[];
  readonly received: FromThread[];
  isLost: boolean;
}
let heard: Heard[] = [];
/** Emits `news` after each message from a thread, and after its end. */
let news = new EventEmitter();

/** Threads whose messages are recorded. @param sent  called after each message to a thread */
function overheard(
  sent: (message: ToThread<Requests>, thread: Worker) => void = () => undefined,
  begin = () => new Worker(script),
): StartThread<Requests> {
  return (owner) => {
    const thread = begin();
    const all: Heard = {thread, sent: [], received: [], isLost: false};
    heard.push(all);
    thread.on('message', (message: FromThread) => {
      all.received.push(message);
      owner.receive(message);
      news.emit('news');
    });
    thread.on('exit', () => {
      all.isLost = true;
      owner.lost('');
      news.emit('news');
    });
    return {
      post: (message) => {
        all.sent.push(message);
        thread.postMessage(message);
        sent(message, thread);
      },
      end: () => void thread.terminate(),
    };
  };
}

const kinds = (all: readonly {readonly kind: string}[], kind: string): number =>
  all.filter((message) => message.kind === kind).length;

/** Waits for the threads, without an additional time limit. */
async function until(isSo: () => boolean): Promise<void> {
  while (!isSo()) await once(news, 'news');
}

/** Returns whether a thread has answered all its requests, or never will. */
const hasAnswered = ({sent, received, isLost}: Heard): boolean =>
  isLost || kinds(sent, 'request') === kinds(received, 'done') + kinds(received, 'failed');

/**
 * The solver's thread waits for the others after each millisecond of work, so that they certainly
 * take part.
 */
const inTurn: Pace = {
  slice: 1,
  pause: async () => {
    await ownThread.pause();
    await until(() => heard.every(hasAnswered));
  },
};

/** Result of a solver without memory of earlier solves, without its times. */
async function solved(
  helpers: Helpers | undefined,
  most: number,
  pace = ownThread,
): Promise<string> {
  const answerer = localAnswerer({sources: {seamwise: () => wasmBinary}, pace}, helpers);
  const result = await answerer.answer('solve', problem, {helpers: most});
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return JSON.stringify({...result, metrics: {...result.metrics, milliseconds}});
}

const alone = await solved(undefined, 0);

afterEach(async () => {
  await Promise.all(heard.map(({thread}) => thread.terminate()));
  heard = [];
  news = new EventEmitter();
});

it.each([1, 3])('gives the same bytes where %d threads take part', async (most) => {
  expect(await solved(new Helpers(overheard(), delays), most, inTurn)).toBe(alone);
  expect(heard).toHaveLength(most);
  for (const {received} of heard) expect(kinds(received, 'done')).toBeGreaterThan(0);
});

it('gives the same bytes whoever is first', async () => {
  expect(await solved(new Helpers(overheard(), delays), 3)).toBe(alone);
});

it('gives the same bytes when threads are killed in the middle of their shares', async () => {
  const start = overheard((message, thread) => {
    if (message.kind !== 'request') return;
    // a thread answers pings between two slices of its share
    let pings = 3;
    const ping = () => {
      if (pings-- > 0) thread.postMessage({kind: 'ping'});
      else void thread.terminate();
    };
    thread.on('message', ({kind}: FromThread) => {
      if (kind === 'pong') ping();
    });
    ping();
  });
  expect(await solved(new Helpers(start, delays), 3, inTurn)).toBe(alone);
  expect(heard.map(({isLost}) => isLost)).toEqual([true, true, true]); // none replaces a broken one
});

it('gives the same bytes when threads never answer, or cannot be started', async () => {
  const silent: StartThread<Requests> = () => ({post: () => undefined, end: () => undefined});
  expect(await solved(new Helpers(silent, delays), 3)).toBe(alone);
  const none: StartThread<Requests> = () => {
    throw new Error('no threads here');
  };
  expect(await solved(new Helpers(none, delays), 3)).toBe(alone);
});

it('does without threads that may be of another version', async () => {
  const old: StartThread<Requests> = (owner) => {
    queueMicrotask(() => {
      owner.receive({kind: 'ready', version: `not ${protocolVersion}`});
    });
    return overheard()(owner);
  };
  expect(await solved(new Helpers(old, delays), 1)).toBe(alone);
  expect(heard.flatMap(({received}) => received)).not.toContainEqual(
    expect.objectContaining({kind: 'done'}),
  );
});

it('keeps no program from ending with a thread that waits to be asked', async () => {
  const program = `
    const waiting = setTimeout(() => undefined, 90_000);
    const receive = ({kind}) => {
      console.log(kind);
      clearTimeout(waiting);
    };
    import('${new URL('../../../dist/node/thread.js', import.meta.url).href}').then(({thread}) =>
      thread({receive, lost: () => undefined}),
    );`;
  const {stdout} = await promisify(execFile)(process.execPath, ['-e', program], {timeout: 100_000});
  expect(stdout).toBe('ready\n');
});

it('starts no thread for what is found soon', async () => {
  const helpers = new Helpers(overheard(), {...delays, start: Infinity});
  expect(await solved(helpers, 3)).toBe(alone);
  expect(heard).toEqual([]);
});

it('cancels the share that a thread is at, and ends the thread when nobody needs it', async () => {
  const halting = overheard(undefined, () => new Worker(haltingThread, {eval: true}));
  const isHalted = ({received}: Heard) => kinds(received, 'pong') > 0;
  const pause = async () => {
    await ownThread.pause();
    await until(() => heard.every(isHalted));
  };
  const sources = {seamwise: () => wasmBinary};
  const answerer = localAnswerer({sources, pace: {slice: 1, pause}}, new Helpers(halting, delays));
  const abort = new AbortController();
  const onProgress = () => {
    if (heard.some(isHalted)) abort.abort('enough');
  };
  const hooks = {signal: abort.signal, onProgress, helpers: 1};
  await expect(answerer.answer('solve', problem, hooks)).rejects.toBe('enough');
  const [helper] = heard;
  if (!helper) throw new Error('No thread was started.');
  await until(() => hasAnswered(helper));
  const answers = helper.received.slice(2); // follow `ready` and `pong`
  expect(answers.length).toBeGreaterThan(0);
  for (const answer of answers)
    expect(answer).toMatchObject({kind: 'failed', failure: {code: 'cancelled'}});
  await until(() => helper.isLost);
});
