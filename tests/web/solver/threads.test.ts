/**
 * Requests to a test module, through all layers of requests to the solver; in Node, over a channel.
 */
import {beforeEach, expect, it, vi} from 'vitest';

import {oddValues} from '../../support/odd-values.js';
import {having} from '@/model/base/arguments.js';
import {SolverError} from '@/model/base/failure.js';
import {Answerer, type AnswerTable, type Queue} from '@/solver/answers/answerer.js';
import {workerBlocked} from '@/solver/answers/failures.js';
import type {ModuleLoader} from '@/solver/module/shared-module.js';
import {runInSlices} from '@/solver/answers/slices.js';
import {
  protocolVersion,
  type FromThread,
  type StartThread,
  type ToThread,
} from '@/solver/threads/thread.js';
import {serve} from '@/solver/threads/serve.js';
import {ThreadClient} from '@/solver/threads/thread-client.js';

/** Exports `half`, which halves a number, and `trap`, which traps. */
const halving = Uint8Array.of(
  ...[0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00],
  ...[0x01, 0x09, 0x02, 0x60, 0x01, 0x7c, 0x01, 0x7c, 0x60, 0x00, 0x00], // f64 -> f64, () -> ()
  ...[0x03, 0x03, 0x02, 0x00, 0x01],
  ...[0x07, 0x0f, 0x02, 0x04, 0x68, 0x61, 0x6c, 0x66, 0x00, 0x00],
  ...[0x04, 0x74, 0x72, 0x61, 0x70, 0x00, 0x01],
  ...[0x0a, 0x14, 0x02, 0x0e, 0x00, 0x20, 0x00, 0x44],
  ...[0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xe0, 0x3f, 0xa2, 0x0b], // times 0.5
  ...[0x03, 0x00, 0x00, 0x0b], // unreachable
);

interface Halving {
  half(value: number): number;
  trap(): void;
}

interface Numbers {
  readonly values: Float64Array;
}

type TestRequests = {
  halve: {request: Numbers; answer: Numbers; hooks: {onHalf?: (half: Numbers) => void}};
  /** Runs until it is cancelled. */
  wait: {request: object; answer: null; hooks: {onTurn?: (turn: number) => void}};
  refuse: {request: object; answer: null; hooks: object};
  trap: {request: object; answer: null; hooks: object};
  /** Needs the other module. */
  name: {request: object; answer: string; hooks: object};
};

type TestModules = {
  readonly halving: Halving;
  readonly other: {readonly name: string};
};

/** Instances created of the modules. */
let made: string[];
/** Answers and reports on the sender's side, after their transfer. */
let given: Numbers[];
let heard: FromThread[];
let threads: number;

beforeEach(() => {
  [made, given, heard, threads] = [[], [], [], 0];
});

function loader<M>(name: string, of: (exports: WebAssembly.Exports) => M): ModuleLoader<M> {
  const url = new URL(`data:application/wasm;base64,${Buffer.from(halving).toString('base64')}`);
  const create = async (compiled: WebAssembly.Module) => {
    made.push(name);
    return of((await WebAssembly.instantiate(compiled)).exports);
  };
  return {file: `${name}.wasm`, url, create};
}

const any = having<never>({});
const waits: Queue = {atOnce: 1};

const table: AnswerTable<TestRequests, TestModules> = {
  modules: {
    halving: loader('halving', (exports) => exports as unknown as Halving),
    other: loader('other', () => ({name: 'other'})),
  },
  checks: {halve: any, wait: any, refuse: any, trap: any, name: any},
  requests: {
    halve: {
      module: 'halving',
      transfers: ['answer', 'onHalf'],
      answer: (module, {values}, {hooks}) => {
        const halves = () => ({values: values.map((value) => module.half(value))});
        const [half, answer] = [halves(), halves()];
        given.push(half, answer);
        hooks.onHalf?.(half);
        return answer;
      },
    },
    wait: {
      module: 'halving',
      queue: waits,
      answer: async (_, __, {hooks, pace}) => {
        let turn = 0;
        const work = () => {
          hooks.onTurn?.(++turn);
          return true;
        };
        await runInSlices(work, pace, hooks.signal);
        return null;
      },
    },
    refuse: {
      module: 'halving',
      answer: () => {
        throw new SolverError({code: 'number', message: 'Not this one.'});
      },
    },
    trap: {
      module: 'halving',
      answer: (module) => {
        module.trap();
        return null;
      },
    },
    name: {module: 'other', answer: ({name}) => name},
  },
};

/**
 * A thread at the other end of a channel: transferred buffers leave the sender, copied ones stay.
 */
const channelThread: StartThread<TestRequests> = (owner) => {
  threads += 1;
  const {port1, port2} = new MessageChannel();
  const receive = serve(table, (message, transfer) => {
    port2.postMessage(message, transfer);
  });
  port2.onmessage = ({data}: MessageEvent<ToThread<TestRequests>>) => {
    receive(data);
  };
  port1.onmessage = ({data}: MessageEvent<FromThread>) => {
    heard.push(data);
    owner.receive(data);
  };
  return {
    post: (message, transfer = []) => {
      port1.postMessage(message, [...transfer]);
    },
    end: () => {
      port1.close();
    },
  };
};

const failure = (reason: string) => workerBlocked('channel', reason);
const clientOf = (start: StartThread<TestRequests>, patience = 5000) =>
  new ThreadClient({start, patience, failure});

/** Runs `use` with a client. */
async function withClient<T>(
  use: (client: ThreadClient<TestRequests>) => Promise<T>,
  start = channelThread,
  patience?: number,
): Promise<T> {
  const client = clientOf(start, patience);
  try {
    return await use(client);
  } finally {
    client.dispose();
  }
}

const request = (): Numbers => ({values: Float64Array.of(1, 2, 3)});
const halves = Float64Array.of(0.5, 1, 1.5);

it('takes copies of typed arrays, and gives away those that it answers and reports', async () => {
  const asked = request();
  const reported: Numbers[] = [];
  const answer = await withClient((client) =>
    client.ask('halve', asked, {onHalf: (half) => reported.push(half)}),
  );
  expect([...reported, answer]).toEqual([{values: halves}, {values: halves}]);
  expect(asked.values).toEqual(request().values);
  expect(given.map(({values}) => values.byteLength)).toEqual([0, 0]);
});

it('takes what is handed over, and only that', async () => {
  const asked = request();
  const transfer = [asked.values.buffer as ArrayBuffer];
  const answer = await withClient((client) => client.ask('halve', asked, {transfer}));
  expect(answer).toEqual({values: halves});
  expect(asked.values.byteLength).toBe(0);
});

it('tells nothing that nobody listens to', async () => {
  await withClient((client) => client.ask('halve', request(), {}));
  expect(heard.filter(({kind}) => kind === 'report')).toMatchObject([{hook: 'onBegin'}]);
});

it('loads a module when it is first needed, once', async () => {
  await withClient(async (client) => {
    await client.ask('halve', request(), {});
    await client.ask('halve', request(), {});
    expect(made).toEqual(['halving']);
    expect(await client.ask('name', {}, {})).toBe('other');
  });
  expect(made).toEqual(['halving', 'other']);
});

it('is cancelled at once, at work or in its queue, and goes on answering', async () => {
  await withClient(async (client) => {
    const controllers = [new AbortController(), new AbortController()] as const;
    const turned = new Promise((resolve) => {
      const hooks = {signal: controllers[0].signal, onTurn: resolve};
      client.ask('wait', {}, hooks).catch((reason: unknown) => ends.push(reason));
    });
    const ends: unknown[] = [];
    const waiting = client.ask('wait', {}, {signal: controllers[1].signal});
    await turned;
    controllers[1].abort('no turn');
    await expect(waiting).rejects.toBe('no turn');
    controllers[0].abort('enough');
    expect(await client.ask('halve', request(), {})).toEqual({values: halves});
    expect(ends).toEqual(['enough']);
    await client.ask('name', {}, {});
  });
  const failures = heard.filter((message) => message.kind === 'failed');
  expect(failures.map(({job, failure}) => [job, failure.code])).toEqual([
    [2, 'cancelled'],
    [1, 'cancelled'],
  ]);
  expect(threads).toBe(1);
});

it('passes on why it refuses, and what a listener throws', async () => {
  await withClient(async (client) => {
    const refused = client.ask('refuse', {}, {});
    await expect(refused).rejects.toMatchObject({name: 'SolverError', code: 'number'});
    const onHalf = () => {
      throw new Error('listener');
    };
    await expect(client.ask('halve', request(), {onHalf})).rejects.toThrow('listener');
    expect(await client.ask('halve', request(), {})).toEqual({values: halves});
  });
  expect([made, threads]).toEqual([['halving'], 1]);
});

it('rejects what can be no message, and hands over nothing with it', async () => {
  const asked = {...request(), odd: () => undefined};
  const transfer = [asked.values.buffer as ArrayBuffer];
  await withClient(async (client) => {
    await expect(client.ask('halve', asked, {transfer})).rejects.toThrow(
      'cannot be sent to the solver',
    );
    expect(await client.ask('halve', {values: asked.values}, {})).toEqual({values: halves});
  });
});

it('replaces a module that broke, and no other one', async () => {
  const answerer = new Answerer(table);
  expect(await answerer.answer('name', {}, {})).toBe('other');
  await expect(answerer.answer('trap', {}, {})).rejects.toMatchObject({
    ...{name: 'SolverError', code: 'internal', message: 'The solver broke: unreachable.'},
  });
  expect(await answerer.answer('halve', request(), {})).toEqual({values: halves});
  expect(await answerer.answer('name', {}, {})).toBe('other');
  expect(made).toEqual(['other', 'halving', 'halving']);
});

it('has another thread where a module broke', async () => {
  await withClient(async (client) => {
    await expect(client.ask('trap', {}, {})).rejects.toMatchObject({code: 'internal'});
    expect(await client.ask('halve', request(), {})).toEqual({values: halves});
  });
  expect(threads).toBe(2);
});

it('repeats what a silent thread has not begun, except what was handed over to it', async () => {
  let started = 0;
  const start: StartThread<TestRequests> = (owner) => {
    if (++started > 1) return channelThread(owner);
    setTimeout(() => {
      owner.receive({kind: 'ready', version: protocolVersion});
    });
    const pass = ({port1, port2}: MessageChannel, transfer: readonly ArrayBuffer[]) => {
      port1.postMessage(null, [...transfer]);
      port2.close();
    };
    return {
      post: (_, transfer = []) => {
        pass(new MessageChannel(), transfer);
      },
      end: () => undefined,
    };
  };
  await withClient(async (client) => {
    const controller = new AbortController();
    const given = client.ask('wait', {}, {signal: controller.signal});
    const copied = client.ask('halve', request(), {});
    const asked = request();
    const transfer = [asked.values.buffer as ArrayBuffer];
    const handedOver = client.ask('halve', asked, {transfer});
    setTimeout(() => {
      controller.abort('enough');
    }, 20);
    const [first, second, third] = await Promise.allSettled([given, copied, handedOver]);
    expect(first).toMatchObject({reason: 'enough'});
    expect(second).toMatchObject({value: {values: halves}});
    expect(third).toMatchObject({reason: {code: 'internal'}});
  }, start);
  expect(started).toBe(2);
});

it('leaves everything with its caller where no thread can be had', async () => {
  const silent: StartThread<TestRequests> = () => ({post: () => undefined, end: () => undefined});
  const asked = request();
  const transfer = [asked.values.buffer as ArrayBuffer];
  const ask = (client: ThreadClient<TestRequests>) => client.ask('halve', asked, {transfer});
  await expect(withClient(ask, silent, 60)).rejects.toMatchObject({code: 'worker-blocked'});
  expect(asked.values).toEqual(request().values);
});

it('ignores messages of other scripts, and rejects requests that it does not know', () => {
  const posted: FromThread[] = [];
  const receive = serve(table, (message) => {
    posted.push(message);
  }) as (message: unknown) => void;
  posted.length = 0; // the greeting
  const foreign = [undefined, null, 5, 'ping', [], {}, {kind: 5}, {kind: 'modules', sources: 5}];
  for (const message of [...foreign, {kind: 'request'}, {kind: 'cancel', job: {}}])
    receive(message);
  expect(posted).toEqual([]);
  const asked = {kind: 'request', name: 'halve', request: {}, hooks: [], helpers: 0};
  for (const odd of [{name: 'constructor'}, {name: null}, {hooks: 5}]) {
    receive({...asked, job: 3, ...odd});
    expect(posted.splice(0)).toMatchObject([{kind: 'failed', job: 3, failure: {code: 'internal'}}]);
  }
});

/** Returns whether a value can be sent to another thread. */
function isSendable(value: unknown): boolean {
  try {
    structuredClone(value);
    return true;
  } catch {
    return false;
  }
}

it('ends each job with an odd name, hooks or request', async () => {
  const ended: FromThread[] = [];
  const receive = serve(table, (message) => ended.push(message));
  const usual = {kind: 'request', name: 'halve', request: {values: [1]}, hooks: [], helpers: 0};
  let job = 0;
  for (const value of Object.values(oddValues()).filter(isSendable)) {
    for (const field of ['name', 'hooks', 'helpers', 'request']) {
      receive({...usual, job: ++job, [field]: value} as never);
    }
  }
  const isEnd = ({kind}: FromThread) => kind === 'done' || kind === 'failed';
  await vi.waitFor(() => {
    expect(ended.filter(isEnd)).toHaveLength(job);
  });
});
