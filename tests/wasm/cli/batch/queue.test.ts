/** A batch shared by several processes through a Redis server that the tests start. */
import {spawn, type ChildProcess} from 'node:child_process';
import {cpSync, existsSync, mkdirSync, readdirSync, symlinkSync} from 'node:fs';
import {createServer, type AddressInfo} from 'node:net';
import {dirname} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {Queue, QueueEvents} from 'bullmq';
import * as fc from 'fast-check';
import {Redis} from 'ioredis';
import {afterAll, beforeAll, describe, expect, it, type TestContext} from 'vitest';

import {has} from '../../../../web/setup/shell.mjs';
import {sha256Of} from '@/model/documents/result-text.js';
import {packageVersion} from '@/model/base/version.js';
import {Shop, until, type Started} from '../../../support/cli/batch.js';
import {cases} from '../../../support/level.js';

const project = fileURLToPath(new URL('../../../..', import.meta.url));
let shop: Shop;
let server: ChildProcess | undefined;
let port = 0;
beforeAll(() => {
  shop = new Shop();
});
afterAll(() => {
  shop.remove();
});

/** Starts programs for a test, and kills them at its end. */
const starter =
  ({onTestFinished}: TestContext) =>
  (...words: string[]): Started => {
    const one = shop.start(['batch', ...words]);
    onTestFinished(async () => {
      one.child.kill('SIGKILL');
      await one.end;
    });
    return one;
  };

async function freePort(): Promise<number> {
  const listener = createServer();
  await new Promise<void>((resolve) => listener.listen(0, '127.0.0.1', resolve));
  const free = (listener.address() as AddressInfo).port;
  await new Promise((resolve) => listener.close(resolve));
  return free;
}

const job = {garment: 'strips-8.json', print: 'checks.json'};
const seeds = (count: number) => Array.from({length: count}, (_, seed) => ({...job, seed}));
const count = (out: string) => (existsSync(shop.at(out, 'results')) ? shop.results(out).length : 0);

// these tests mostly wait for the time limits of the queue
describe.skipIf(!has('redis-server')).concurrent('a queue (needs redis-server)', () => {
  const queue = (database = 0) => `redis://127.0.0.1:${port}/${database}`;

  beforeAll(async () => {
    port = await freePort();
    const settings = [
      '--port',
      `${port}`,
      '--bind',
      '127.0.0.1',
      '--save',
      '',
      '--dir',
      shop.folder,
    ];
    server = spawn('redis-server', settings, {stdio: 'ignore'});
    const client = new Redis(port, '127.0.0.1', {
      retryStrategy: () => 50,
      maxRetriesPerRequest: null,
    });
    client.on('error', () => undefined);
    await client.ping();
    client.disconnect();
  });
  afterAll(async () => {
    const end = new Promise((resolve) => server?.once('exit', resolve));
    server?.kill();
    await end;
  });

  it('gives what a batch without one does', async () => {
    const wrong = {...job, garment: 'checks.json'};
    shop.writeJobs('jobs.ndjson', [...seeds(20), job, '{', {...job, garment: 'none.json'}, wrong]);
    await shop.batch('jobs.ndjson', 'clean');
    for (const now of [24, 2]) {
      const run = await shop.batch('jobs.ndjson', 'queued', '--queue', queue(), '--json');
      expect(run).toMatchObject({code: 1, err: ''});
      expect(JSON.parse(run.out)).toMatchObject({done: 21, failed: 3, now});
      expect(shop.truth('queued')).toEqual(shop.truth('clean'));
    }
  });

  it('keeps the batches of several folders apart', async (context) => {
    const start = starter(context);
    shop.writeJobs('apart.ndjson', seeds(10));
    const other = start('--work', '--out', 'other', '--queue', queue(), '--workers', '1');
    await until(() => existsSync(shop.at('other/queue-id')), other);
    expect((await shop.batch('apart.ndjson', 'apart', '--queue', queue())).code).toBe(0);
    expect(count('apart')).toBe(10);
    expect(count('other')).toBe(0);
  });

  it('lets workers go and come', async (context) => {
    const start = starter(context);
    const jobs = cases(60, 300);
    shop.writeJobs('away.ndjson', seeds(jobs));
    const lead = start(
      'away.ndjson',
      '--out',
      'away',
      '--queue',
      queue(),
      '--workers',
      '0',
      '--json',
    );
    const words = ['--work', '--out', 'away', '--queue', queue(), '--workers', '1'];
    const first = start(...words);
    await until(() => count('away') > 5, first);
    first.child.kill('SIGTERM');
    expect(await first.end).toEqual({code: 130, out: '', err: ''});
    expect(count('away')).toBeLessThan(jobs);
    start(...words);
    const {code, out, err} = await lead.end;
    expect({code, err}).toEqual({code: 0, err: ''});
    expect(JSON.parse(out)).toMatchObject({done: jobs, failed: 0, now: jobs});
  });

  it('loses nothing when its workers and its head are killed at random moments', async (context) => {
    const start = starter(context);
    const jobs = cases(60, 300);
    shop.writeJobs('many.ndjson', seeds(jobs));
    const place = ['--out', 'many', '--queue', queue(1)];
    const lead = () => start('many.ndjson', ...place, '--workers', '0', '--json');
    const work = () => start('--work', ...place, '--workers', '1');
    const moments = fc.sample(
      fc.record({
        victim: fc.integer({min: 0, max: 5}),
        milliseconds: fc.integer({min: 0, max: 120}),
      }),
      {seed: 3, numRuns: cases(2, 12)},
    );
    const [first, ...others] = [lead(), work(), work()];
    let head = first;
    const workers = others;
    for (const {victim, milliseconds} of moments) {
      const before = count('many');
      await until(() => count('many') > before || count('many') === jobs);
      await sleep(milliseconds);
      const one = victim === 0 ? head : workers[victim % 2];
      one?.child.kill('SIGKILL');
      await one?.end;
      if (victim === 0) head = lead();
      else workers[victim % 2] = work();
    }
    expect(count('many')).toBeLessThan(jobs); // all of them took part
    const {code, err} = await head.end;
    expect({code, err}).toEqual({code: 0, err: ''});
    await shop.batch('many.ndjson', 'many-clean');
    const keys = shop.done('many').map(({key}) => key);
    expect(keys).toHaveLength(jobs);
    expect(new Set(keys).size).toBe(jobs);
    const results = (out: string) =>
      shop.truth(out).files.filter((file) => !file.includes('.tmp '));
    expect(results('many')).toEqual(results('many-clean'));
    expect(shop.truth('many').lines).toEqual(shop.truth('many-clean').lines);
  });

  it('does nothing that a stranger has put there', async (context) => {
    const start = starter(context);
    shop.writeJobs('public.ndjson', seeds(1));
    const words = ['--out', 'public', '--queue', queue(3), '--workers', '1'];
    expect((await shop.run('batch', 'public.ndjson', ...words)).code).toBe(0);
    const id = shop.read('public', 'queue-id');
    const file = (path: string) => ({
      address: pathToFileURL(shop.at(path)).href,
      sha256: sha256Of(shop.read(path)),
    });
    const [garment, print] = [file('strips-8.json'), file('checks.json')];
    const genuine = {
      label: {name: null, garment: 'g', print: 'p', size: null},
      ...{garment: garment.address, print: print.address},
      ...{symmetry: 'auto', method: 'best', options: {}, seed: 9},
      ...{garmentSha256: garment.sha256, printSha256: print.sha256},
    };
    const strange = [
      {...genuine, key: '../../../outside'},
      {...genuine, key: '0'.repeat(64)},
      {...genuine, key: 7},
      {key: '1'.repeat(64)},
      null,
    ];
    start('--work', ...words);
    const place = new Queue(`seamwise-${packageVersion}-${id}`, {
      connection: {host: '127.0.0.1', port, db: 3},
    });
    const events = new QueueEvents(place.name, {connection: {host: '127.0.0.1', port, db: 3}});
    const outcomes: unknown[] = [];
    try {
      await events.waitUntilReady();
      // the queue removes a job as soon as it has ended, so the test listens to its event
      events.on('completed', ({returnvalue}) => outcomes.push(returnvalue));
      for (const data of strange) await place.add('solve', data);
      await until(() => outcomes.length === strange.length);
      for (const outcome of outcomes)
        expect(outcome).toMatchObject({
          failure: {
            code: 'bad-line',
            message: expect.stringMatching(/^What came from the queue is no job: /) as string,
          },
        });
    } finally {
      await Promise.all([place.close(), events.close()]);
    }
    expect(count('public')).toBe(1);
    expect(existsSync(shop.at('outside.json'))).toBe(false);
  });

  it('goes on when the server forgets everything', async (context) => {
    const start = starter(context);
    const jobs = cases(40, 200);
    shop.writeJobs('forgotten.ndjson', seeds(jobs));
    const batch = start(
      'forgotten.ndjson',
      '--out',
      'forgotten',
      '--queue',
      queue(2),
      '--workers',
      '1',
    );
    await until(() => count('forgotten') > 5, batch);
    const client = new Redis(queue(2));
    await client.flushdb();
    client.disconnect();
    expect(batch.child.exitCode).toBe(null);
    expect((await batch.end).code).toBe(0);
    expect(shop.done('forgotten')).toHaveLength(jobs);
  });
});

it('says which packages a queue needs where they are not installed', async () => {
  mkdirSync(shop.at('bare/node_modules/@noble'), {recursive: true});
  cpSync(`${project}dist`, shop.at('bare/dist'), {recursive: true});
  cpSync(`${project}package.json`, shop.at('bare/package.json'));
  for (const name of ['piscina', 'clipper2-ts', '@noble/hashes']) {
    mkdirSync(dirname(shop.at('bare/node_modules', name)), {recursive: true});
    symlinkSync(`${project}node_modules/${name}`, shop.at('bare/node_modules', name), 'junction');
  }
  shop.writeJobs('few.ndjson', seeds(2));
  const program = shop.at('bare/dist/cli/main.js');
  const words = ['batch', 'few.ndjson', '--out', 'bare-out'];
  const queued = await shop.start([...words, '--queue', 'redis://127.0.0.1:1'], program).end;
  expect(queued).toEqual({
    code: 2,
    out: '',
    err: 'seamwise: --queue needs two packages more; install them with: npm install bullmq ioredis.\n',
  });
  expect((await shop.start(words, program).end).code).toBe(0);
  expect(readdirSync(shop.at('bare-out'))).not.toContain('batch.lock');
});
