import {execFileSync} from 'node:child_process';
import {appendFileSync, existsSync, mkdirSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {hostname} from 'node:os';

import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {sha256Of} from '@/model/documents/result-text.js';
import {progressText} from '@/cli/batch/progress.js';
import {endlessJob, Shop, until, type JobLine} from '../../../support/cli/batch.js';
import {cases} from '../../../support/level.js';

let shop: Shop;
beforeAll(() => {
  shop = new Shop();
});
afterAll(() => {
  shop.remove();
});

const job: JobLine = {garment: 'strips-8.json', print: 'checks.json'};
/** `count` jobs that differ in their seed. */
const seeds = (count: number): JobLine[] =>
  Array.from({length: count}, (_, seed) => ({...job, seed}));

/** A job whose options are nested so deeply. */
const nested = (times: number): string =>
  JSON.stringify({...job, options: 0}).replace(
    '0',
    `${'{"a":'.repeat(times)}0${'}'.repeat(times)}`,
  );

describe('the result of a job', () => {
  const pins = {left: {angle: 0, translation: [1, 2]}};
  const pair = [{kind: 'pair', pieces: ['left', 'right']}];
  const cases: readonly [JobLine, string[]][] = [
    [{}, []],
    [{seed: 7, method: 'ws19', symmetry: 'none'}, ['--seed=7', '--method=ws19', '--symmetry=none']],
    [
      {options: {maxChangeCm: 0.5, pins}, symmetry: pair},
      ['--options=o.json', '--symmetry=s.json'],
    ],
  ];

  it('is, byte for byte, what align finds', async () => {
    shop.write('o.json', JSON.stringify({maxChangeCm: 0.5, pins}));
    shop.write('s.json', JSON.stringify({symmetries: pair}));
    shop.writeJobs(
      'equal.ndjson',
      cases.map(([fields], name) => ({...job, ...fields, name: `${name}`})),
    );
    expect(await shop.batchOn(2, 'equal.ndjson', 'equal')).toMatchObject({code: 0, err: ''});
    const done = shop.done('equal');
    for (const [k, [, flags]] of cases.entries()) {
      const words = ['strips-8.json', '--print', 'checks.json', ...flags];
      await shop.run('align', ...words, '--no-times', '--out', 'single.json');
      const {file, metrics} = done.find(({name}) => name === `${k}`) ?? {};
      expect(shop.read('equal', file ?? 'none')).toBe(shop.read('single.json'));
      const single = JSON.parse(shop.read('single.json')) as {metrics: object};
      expect({...metrics, milliseconds: expect.anything() as object}).toEqual(single.metrics);
    }
  });
});

it('takes every garment of a line in every size and print', async () => {
  const line = {
    garments: ['strips-{size}.json'],
    sizes: ['8', '10'],
    prints: ['checks.json', 'waves.json'],
  };
  shop.writeJobs('product.ndjson', [line]);
  const {code, out} = await shop.batchOn(2, 'product.ndjson', 'product', '--json');
  expect(code).toBe(0);
  expect(JSON.parse(out)).toMatchObject({out: 'product', done: 4, failed: 0, now: 4});
  const made = shop.done('product').map(({garment, print, size}) => `${size} ${garment} ${print}`);
  expect(made.sort()).toEqual([
    '10 strips-10.json checks.json',
    '10 strips-10.json waves.json',
    '8 strips-8.json checks.json',
    '8 strips-8.json waves.json',
  ]);
});

it('reports a job that stands in two lines twice, but solves it once', async () => {
  const again = {seed: 1, print: 'checks.json', garment: './strips-8.json', name: 'again'};
  shop.writeJobs('twice.ndjson', [job, job, again]);
  for (const now of [3, 0]) {
    const {out} = await shop.batch('twice.ndjson', 'twice', '--json');
    expect(JSON.parse(out)).toMatchObject({done: 3, now});
    const done = shop.done('twice');
    expect(done.map(({name}) => name)).toEqual([null, null, 'again']);
    expect(new Set(done.map(({key}) => key)).size).toBe(1);
    expect(shop.results('twice')).toHaveLength(1);
  }
});

it('solves again after the garment was changed', async () => {
  shop.write('changing.json', shop.read('strips-8.json'));
  shop.writeJobs('changing.ndjson', [{...job, garment: 'changing.json'}]);
  await shop.batch('changing.ndjson', 'changing');
  shop.write('changing.json', shop.read('strips-10.json'));
  const {out} = await shop.batch('changing.ndjson', 'changing', '--json');
  expect(JSON.parse(out)).toMatchObject({done: 1, now: 1});
  expect(shop.results('changing')).toHaveLength(2);
});

describe('what cannot be solved', () => {
  const wrong: readonly [line: string | JobLine, words: string][] = [
    ['{"garment":', 'line 1 of wrong.ndjson is no job: it is not JSON; correct it.'],
    ['[]', 'it is not an object'],
    ['{}', "'garment' must be given"],
    [{garment: 'strips-8.json'}, "'print' must be given"],
    [{...job, seeds: 3}, "there is no field 'seeds'"],
    [{...job, seed: -1}, "'seed' must be a whole number"],
    [{...job, method: 'x'}, "'method' must be one of best, paper, ws19"],
    [{...job, symmetry: 'x'}, "'symmetry' must be 'auto', 'none' or a list"],
    [{...job, options: []}, "'options' must be an object"],
    [{...job, garments: ['strips-8.json']}, "'garment' and 'garments' are both given"],
    [{...job, sizes: ['8', '10']}, "'garment' must be a name with {size} in it"],
    [{...job, garment: 'ftp://x/y'}, 'ftp://x/y is not on the web'],
    ['x'.repeat(1_100_000), 'it is too long'],
    [nested(20_000), 'it is nested too deep'],
  ];

  it('is a line of its own that says why, and not the end of the batch', async () => {
    const texts = wrong.map(([line]) => line);
    shop.writeJobs('wrong.ndjson', [...texts, '', '  ', job]);
    const {code, out, err} = await shop.batch('wrong.ndjson', 'wrong', '--json');
    expect({code, err}).toEqual({code: 1, err: ''});
    expect(JSON.parse(out)).toMatchObject({done: 1, failed: wrong.length});
    const failed = shop.done('wrong').filter(({status}) => status === 'failed');
    failed.sort((one, other) => (one.line ?? 0) - (other.line ?? 0));
    expect(failed.map(({line}) => line)).toEqual(wrong.map((_, k) => k + 1));
    for (const [k, {key, file, failure}] of failed.entries()) {
      expect({key, file, code: failure?.code}).toEqual({key: null, file: null, code: 'bad-line'});
      expect(failure?.message).toContain(wrong[k]?.[1]);
      expect(failure?.message).toMatch(
        new RegExp(`^line ${k + 1} of wrong.ndjson is no job: .*\\.$`),
      );
    }
  });

  it('is not tried again when the garment is at fault, but when a file was missing', async () => {
    const {pattern} = JSON.parse(shop.read('strips-8.json')) as {
      pattern: {panels: {left: {edges: object[]}}};
    };
    pattern.panels.left.edges.pop();
    shop.write('open.json', JSON.stringify({pattern}));
    const lines = ['open.json', 'late.json'].map((garment) => ({...job, garment, name: garment}));
    shop.writeJobs('failing.ndjson', lines);
    expect((await shop.batch('failing.ndjson', 'failing')).code).toBe(1);
    const [open, late] = shop.done('failing').sort((one) => (one.name === 'open.json' ? -1 : 1));
    expect(open?.failure).toMatchObject({code: 'outlineOpen', piece: 0, seam: null});
    expect(JSON.parse(shop.read('failing', open?.file ?? ''))).toEqual(open?.failure);
    expect(late).toMatchObject({key: null, line: 2, failure: {code: 'not-found'}, file: null});
    expect(late?.failure?.message).toMatch(/late\.json cannot be read: there is no such file/);

    shop.write('late.json', shop.read('strips-10.json'));
    const {code, out} = await shop.batch('failing.ndjson', 'failing', '--json');
    expect({code, ...(JSON.parse(out) as object)}).toMatchObject({
      code: 1,
      done: 1,
      failed: 1,
      now: 1,
    });
    expect(shop.done('failing').map(({name, status}) => `${name} ${status}`)).toEqual([
      'open.json failed',
      'late.json done',
    ]);
  });
});

it('mends a record that a crash has torn, or that somebody has lost', async () => {
  shop.writeJobs('torn.ndjson', seeds(12));
  await shop.batchOn(2, 'torn.ndjson', 'torn');
  const whole = shop.truth('torn');
  const lines = shop.read('torn', 'done.ndjson').split('\n');
  const [first = '', ...others] = lines.slice(3, -1);
  const broken = `${others.join('\n')}\n{"key":null}\nnonsense\n${first.slice(0, 50)}`;
  for (const record of [broken, `${lines.join('\n')}${first}`, '']) {
    shop.write('torn/done.ndjson', record);
    expect((await shop.batch('torn.ndjson', 'torn')).code).toBe(0);
    expect(shop.truth('torn')).toEqual(whole);
  }
  rmSync(shop.at('torn', shop.done('torn')[0]?.file ?? 'none'));
  const {out} = await shop.batch('torn.ndjson', 'torn', '--json');
  expect(JSON.parse(out)).toMatchObject({done: 12, now: 1});
  expect(shop.truth('torn')).toEqual(whole);
});

it('solves again what a broken disk has left empty or damaged, and puts a sha256 on record', async () => {
  shop.writeJobs('disk.ndjson', seeds(6));
  await shop.batch('disk.ndjson', 'disk');
  const whole = shop.truth('disk');
  const [empty, half] = shop.done('disk').map(({file}) => file ?? 'none');
  shop.write(`disk/${empty}`, '');
  shop.write(`disk/${half}`, shop.read('disk', half ?? '').slice(0, 99));
  shop.write('disk/done.ndjson', '');
  expect(await shop.batch('disk.ndjson', 'disk')).toMatchObject({code: 0, err: ''});
  expect(shop.truth('disk')).toEqual(whole);
  for (const {file, sha256} of shop.done('disk')) {
    expect(sha256).toBe(sha256Of(shop.read('disk', file ?? 'none')));
  }
});

it('finds on request which results are not those on record, and solves them again', async () => {
  shop.writeJobs('rot.ndjson', seeds(4));
  await shop.batch('rot.ndjson', 'rot');
  const whole = shop.truth('rot');
  const {file = ''} = shop.done('rot')[2] ?? {};
  shop.write(`rot/${file}`, shop.read('rot', file ?? '').replace('1', '2'));
  const {out} = await shop.batch('rot.ndjson', 'rot', '--json');
  expect(JSON.parse(out)).toMatchObject({now: 0}); // reading all of them would take long
  const checked = await shop.batch('rot.ndjson', 'rot', '--json', '--check');
  expect(checked.err).toBe(
    `note: rot/${file} is not what it was when it was written; it is solved again.\n`,
  );
  expect(JSON.parse(checked.out)).toMatchObject({done: 4, now: 1});
  expect(shop.truth('rot')).toEqual(whole);
});

it('ends a job that takes too long, records it, and tries it again on request only', async () => {
  // The thorough run has another job after the endless one, to which the time limit applies as
  // well.
  shop.writeJobs('before.ndjson', seeds(cases(3, 2)));
  await shop.batch('before.ndjson', 'endless');
  shop.writeJobs('endless.ndjson', [endlessJob, ...seeds(3)]);
  const limit = cases(1, 5);
  const words = ['batch', 'endless.ndjson', '--out', 'endless', '--workers', '1', '--json'];
  const tries = [
    [['--job-timeout', String(limit)], cases(1, 2), limit],
    [[], 0, limit],
    [['--job-timeout', '1', '--retry-timeouts'], 1, 1],
  ] as const;
  for (const [more, now, seconds] of tries) {
    const {code, out} = await shop.run(...words, ...more);
    expect(code).toBe(1);
    expect(JSON.parse(out)).toMatchObject({done: 3, failed: 1, now});
    const {failure, file} = shop.done('endless').find(({name}) => name === 'endless') ?? {};
    expect(failure).toMatchObject({code: 'timeout'});
    const message = `^The job was not done within ${seconds} s; .*--retry-timeouts\\.$`;
    expect(failure?.message).toMatch(new RegExp(message));
    expect(JSON.parse(shop.read('endless', file ?? ''))).toEqual(failure);
  }
});

it('does not wait for a pipe that nobody writes into', async () => {
  execFileSync('mkfifo', [shop.at('pipe.json')]);
  shop.writeJobs('pipe.ndjson', [{...job, garment: 'pipe.json'}]);
  expect((await shop.batch('pipe.ndjson', 'pipe')).code).toBe(1);
  expect(shop.done('pipe')[0]?.failure?.message).toMatch(/pipe\.json is a pipe, which can be read/);
});

describe('two batches', () => {
  it('do not get into one folder', async () => {
    shop.writeJobs('many.ndjson', seeds(5000));
    const words = ['batch', 'many.ndjson', '--out', 'locked'];
    const first = shop.start(words);
    await until(() => existsSync(shop.at('locked/batch.lock')), first);
    const second = await shop.run(...words);
    expect(second).toMatchObject({code: 2, out: ''});
    expect(second.err).toMatch(
      /^seamwise: another batch, process \d+ on .* is at work in locked; .*\n$/,
    );
    first.child.kill('SIGKILL');
    await first.end;
    expect(existsSync(shop.at('locked/batch.lock'))).toBe(true);
    shop.writeJobs('few.ndjson', seeds(3));
    expect((await shop.run('batch', 'few.ndjson', '--out', 'locked')).code).toBe(0);
    expect(readdirSync(shop.at('locked'))).toEqual(['done.ndjson', 'failures', 'results']);
  });

  it('are told apart on other machines, too, of which nobody can tell whether they still run', async () => {
    mkdirSync(shop.at('far'));
    const lock = (host: string) => JSON.stringify({host, process: 2 ** 22 + 1});
    shop.write('far/batch.lock', lock('elsewhere'));
    shop.writeJobs('few.ndjson', seeds(3));
    const {code, err} = await shop.batch('few.ndjson', 'far');
    expect({code, err}).toMatchObject({
      code: 2,
      err: expect.stringContaining('on elsewhere') as string,
    });
    expect(err).toContain('remove far/batch.lock');
    shop.write('far/batch.lock', lock(hostname())); // no process has that number
    expect((await shop.batch('few.ndjson', 'far')).code).toBe(0);
  });

  it('are not stopped by a damaged lock without a word about which file that is', async () => {
    mkdirSync(shop.at('torn-lock'));
    shop.write('torn-lock/batch.lock', '{"host":');
    shop.writeJobs('few.ndjson', seeds(3));
    const {code, err} = await shop.batch('few.ndjson', 'torn-lock');
    expect({code, err}).toEqual({
      code: 2,
      err: 'seamwise: torn-lock/batch.lock is damaged; if no other batch is at work in torn-lock, remove that file.\n',
    });
  });

  it('that find the same stale lock let one pass, or at most one', async () => {
    shop.writeJobs('few.ndjson', seeds(3));
    for (let round = 0; round < cases(1, 3); round++) {
      mkdirSync(shop.at('stale'), {recursive: true});
      shop.write('stale/batch.lock', JSON.stringify({host: hostname(), process: 2 ** 22 + 1}));
      const ends = await Promise.all([1, 2, 3].map(() => shop.batch('few.ndjson', 'stale')));
      expect(ends.every(({code}) => code === 0 || code === 2)).toBe(true);
      expect(ends.some(({code}) => code === 0)).toBe(true);
      expect(shop.done('stale')).toHaveLength(3);
      expect(existsSync(shop.at('stale/batch.lock'))).toBe(false);
    }
  });
});

it.each(['SIGINT', 'SIGTERM'] as const)(
  'ends in the middle of a job at %s, and goes on later',
  async (signal) => {
    const folder = `out-${signal}`;
    const jobs = seeds(40);
    shop.writeJobs('more.ndjson', jobs);
    // a batch that waited for all its jobs would never end
    shop.writeJobs('endless.ndjson', [...jobs.slice(0, 20), endlessJob, ...jobs.slice(20)]);
    const batch = shop.start(['batch', 'endless.ndjson', '--out', folder, '--workers', '1']);
    const hasResults = () =>
      existsSync(shop.at(folder, 'results')) && shop.results(folder).length > 5;
    await until(hasResults, batch);
    batch.child.kill(signal);
    const {code, err} = await batch.end;
    expect({code, err}).toEqual({
      code: 130,
      err: 'note: the batch was interrupted; the same command goes on from there.\n',
    });
    expect(shop.results(folder).filter((name) => name.endsWith('.tmp'))).toEqual([]);
    const before = shop.done(folder).length;
    expect(before).toBeGreaterThan(0);
    expect(before).toBeLessThan(40);
    const {out} = await shop.batch('more.ndjson', folder, '--json');
    expect(JSON.parse(out)).toMatchObject({done: 40, failed: 0, now: 40 - before});
    expect(new Set(shop.done(folder).map(({key}) => key)).size).toBe(40);
  },
);

describe('bad input exits with 2 and one sentence', () => {
  const cases: Record<string, readonly [words: string[], named: string]> = {
    'without a folder': [['few.ndjson'], '--out'],
    'without jobs': [['--out', 'o'], 'the file of jobs'],
    'with jobs that are not there': [['none.ndjson', '--out', 'o'], 'none.ndjson'],
    'with a folder for jobs': [['results', '--out', 'o'], 'results'],
    'with a file for a folder': [['few.ndjson', '--out', 'checks.json'], 'checks.json is a file'],
    'without workers': [['few.ndjson', '--out', 'o', '--workers', '0'], '--workers'],
    'with a time limit of a year': [
      ['few.ndjson', '--out', 'o', '--job-timeout', '31536000'],
      '--job-timeout is 31536000',
    ],
    'with work from nowhere': [['--work', '--out', 'o'], '--queue'],
    'with a queue that is none': [['few.ndjson', '--out', 'o', '--queue', 'x'], '--queue is'],
    'with a queue that does not answer': [
      ['few.ndjson', '--out', 'o', '--queue', 'redis://127.0.0.1:1'],
      'the Redis server at 127.0.0.1:1 cannot be used (ECONNREFUSED)',
    ],
  };

  it.each(Object.entries(cases))('%s', async (_, [words, named]) => {
    mkdirSync(shop.at('results'), {recursive: true});
    shop.writeJobs('few.ndjson', seeds(3));
    const {code, out, err} = await shop.run('batch', ...words);
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err.trimEnd().split('\n')).toHaveLength(1);
    expect(err).toContain(named);
  });
});

it('ends with a sentence when a result cannot be put on disk', async () => {
  shop.writeJobs('few.ndjson', seeds(3));
  await shop.batch('few.ndjson', 'full');
  const [name = ''] = shop.results('full');
  rmSync(shop.at('full/results', name));
  mkdirSync(shop.at('full/results', name)); // a folder blocks the file
  writeFileSync(shop.at('full/results', name, 'x'), '');
  shop.write('full/done.ndjson', '');
  const {code, err} = await shop.batch('few.ndjson', 'full');
  expect(code).not.toBe(0);
  expect(err.trimEnd().split('\n')).toHaveLength(1);
  expect(err).toContain(name);
});

it('takes a file with a mark before its first line, and one without a line break at its end', async () => {
  shop.write('marked.ndjson', `\ufeff${JSON.stringify(job)}\r\n`);
  appendFileSync(shop.at('marked.ndjson'), JSON.stringify({...job, seed: 2}));
  const {code, out} = await shop.batch('marked.ndjson', 'marked', '--json');
  expect(code).toBe(0);
  expect(JSON.parse(out)).toMatchObject({done: 2});
});

it('says how far it is, how fast, and how long it takes', () => {
  expect(progressText({done: 0, failed: 0, now: 0}, 10, 0)).toBe('0 of 10 jobs');
  expect(progressText({done: 30, failed: 2, now: 20}, 1032, 10)).toBe(
    '32 of 1032 jobs, 2 failed, 2.0 a second, 8 min 20 s left',
  );
  expect(progressText({done: 10, failed: 0, now: 10}, 100_010, 10)).toContain('27 h 46 min left');
});
