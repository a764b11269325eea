/** Who helps with a search, and whether they live to its end, must make no difference to what is found. */
import {execFile} from 'node:child_process';
import {readFile} from 'node:fs/promises';
import {promisify} from 'node:util';
import {Worker} from 'node:worker_threads';

import {afterEach, expect, it} from 'vitest';

import {localAnswerer} from '@/solver/answering.js';
import type {Requests} from '@/solver/requests/requests.js';
import {problemTexts} from '@/solver/requests/texts.js';
import {Helpers} from '@/solver/seamwise/helpers.js';
import {protocolVersion, type FromThread, type ToThread} from '@/solver/threads/protocol.js';
import type {StartThread} from '@/solver/threads/thread.js';
import {sample} from './garments.js';

const wasmBinary = await readFile(
  new URL('../../web/src/solver/module/seamwise.wasm', import.meta.url),
);
const script = new URL('../../dist/node/helper-thread.js', import.meta.url);
const print = {group: 'p31m', w1: [10, 0], w2: [5, 8.660254037844386]} as const;
const hoodie = problemTexts({garment: sample('hoodie'), print, symmetry: 'none'});

/** At once, for as long as it is worth. */
const delays = {start: 0, lend: 0, end: 50};

interface Heard {
  readonly thread: Worker;
  readonly sent: ToThread<Requests>[];
  readonly received: FromThread[];
}
let heard: Heard[] = [];

/** Threads that are overheard. @param sent hears what a thread is told, once it has been told */
function overheard(
  sent: (message: ToThread<Requests>, thread: Worker) => void = () => undefined,
): StartThread<Requests> {
  return (owner) => {
    const thread = new Worker(script);
    const all: Heard = {thread, sent: [], received: []};
    heard.push(all);
    thread.on('message', (message: FromThread) => {
      all.received.push(message);
      owner.receive(message);
    });
    thread.on('exit', () => {
      owner.lost('');
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

/** A solver that knows nothing of earlier solves, with all its result but the times. */
async function solved(helpers: Helpers | undefined, most: number): Promise<string> {
  const answerer = localAnswerer({sources: {seamwise: () => wasmBinary}}, helpers);
  const result = await answerer.answer('solve', hoodie, {helpers: most});
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return JSON.stringify({...result, metrics: {...result.metrics, milliseconds}});
}

const alone = await solved(undefined, 0);

afterEach(async () => {
  await Promise.all(heard.map(({thread}) => thread.terminate()));
  heard = [];
});

it.each([1, 3])('gives the same bytes with %d threads to help', {retry: 3}, async (most) => {
  expect(await solved(new Helpers(overheard(), delays), most)).toBe(alone);
  expect(heard).toHaveLength(most);
  const received = heard.flatMap((one) => one.received);
  expect(kinds(received, 'done')).toBeGreaterThan(0); // where other programs leave them any time
});

it('gives the same bytes when threads are killed in the middle of their shares', async () => {
  const start = overheard((message, thread) => {
    if (message.kind === 'request') setTimeout(() => void thread.terminate(), 30);
  });
  expect(await solved(new Helpers(start, delays), 3)).toBe(alone);
  expect(heard).toHaveLength(3); // none takes the place of one that broke
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
    setTimeout(() => {
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
    const waiting = setTimeout(() => undefined, 30_000);
    const receive = ({kind}) => {
      console.log(kind);
      clearTimeout(waiting);
    };
    import('${new URL('../../dist/node/thread.js', import.meta.url).href}').then(({thread}) =>
      thread({receive, lost: () => undefined}),
    );`;
  const {stdout} = await promisify(execFile)(process.execPath, ['-e', program], {timeout: 30_000});
  expect(stdout).toBe('ready\n');
});

it('starts no thread for what is found soon', async () => {
  const helpers = new Helpers(overheard(), {...delays, start: 60_000});
  expect(await solved(helpers, 3)).toBe(alone);
  expect(heard).toEqual([]);
});

it(
  'cancels what a thread is at within 100 ms, and ends it when nobody comes',
  {retry: 3},
  async () => {
    const abort = new AbortController();
    let cancelled = Infinity;
    const start = overheard((message) => {
      if (message.kind === 'cancel') cancelled = performance.now();
    });
    const sources = {seamwise: () => wasmBinary};
    const answerer = localAnswerer({sources}, new Helpers(start, delays));
    const onProgress = () => {
      const [helper] = heard;
      // it is at its share when it has come to know of it
      if (helper?.received.length)
        setTimeout(() => {
          abort.abort('enough');
        });
    };
    const hooks = {signal: abort.signal, onProgress, helpers: 1};
    const solve = answerer.answer('solve', hoodie, hooks);
    await expect(solve).rejects.toBe('enough');
    const [helper] = heard;
    if (!helper) throw new Error('Nobody has helped.');
    const failed = {kind: 'failed', failure: {code: 'cancelled'}};
    await expect.poll(() => helper.received.at(-1), {interval: 5}).toMatchObject(failed);
    expect(performance.now() - cancelled).toBeLessThan(100); // but for other programs that hold up the machine
    await expect.poll(() => helper.thread.threadId).toBe(-1); // it has ended
  },
);
