import {readFileSync} from 'node:fs';
import {createServer, type Server} from 'node:http';
import type {AddressInfo} from 'node:net';
import {fileURLToPath} from 'node:url';

import {
  designOf,
  marker,
  order,
  problemOfStored,
  readGarment,
  resultText,
  sha256Of,
  solve,
  type StoredDesign,
  type FiledDesign,
} from 'seamwise/node';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {checks, twoStrips} from '../../support/garments/samples.js';

const garment = `\ufeff${JSON.stringify(twoStrips())}\n`;
const print = JSON.stringify({...checks, colourways: [{name: 'Day', image: 'day.svg'}]});
const shelf = new Map([
  ['strips.json', garment],
  ['checks.json', print],
]);
const read = (url: string) => Promise.resolve(new TextEncoder().encode(shelf.get(url)));

const chosen: FiledDesign = {
  garment: {url: 'strips.json', sha256: sha256Of(garment)},
  print: {url: 'checks.json', sha256: sha256Of(print)},
  symmetry: 'auto',
  method: 'best',
  options: {},
  seed: 3,
};

/** The stored design of a customer's choice, as kept by a shop. */
async function sold(problem: FiledDesign = chosen): Promise<StoredDesign> {
  return designOf(
    problem,
    await solve(problemOfStored(problem, {garment: garment.slice(1), print})),
  );
}

describe('an order', () => {
  it.each<[string, Partial<FiledDesign>]>([
    ['as it was chosen', {}],
    ['without symmetry', {symmetry: 'none', method: 'ws19'}],
    ['with a symmetry of its own', {symmetry: [{kind: 'pair', pieces: ['left', 'right']}]}],
    ['with pins', {options: {pins: {left: {angle: 0, translation: [1, 2]}}, maxChangeCm: 0.5}}],
    [
      'with a print that was changed',
      {print: {...chosen.print, colourway: 'Day', turnDeg: 33, oneWay: true, group: 'p2'}},
    ],
  ])('gives the very bytes that were sold, %s', async (_, changes) => {
    const problem = {...chosen, ...changes};
    const design = await sold(problem);
    const answer = await order(JSON.stringify({format: 'seamwise-design/1', ...design}), {read});
    expect(answer).toMatchObject({reproduced: true, differenceCm: 0});
    expect(sha256Of(answer.text)).toBe(design.result);
    expect(answer.text).toBe(resultText(answer.result));
  });

  it('is laid on folded fabric as any other result', async () => {
    const design = await sold({...chosen, symmetry: [{kind: 'pair', pieces: ['left', 'right']}]});
    const cloth = {widthCm: 140, fold: true};
    const {plan, result} = await order(design, {read, cloth});
    const laid = await marker([{result, garment: await readGarment(garment)}], {
      ...cloth,
      print: checks,
    });
    expect(plan?.placements).toEqual(laid.placements);
    expect(plan?.foldCm).toBeGreaterThan(0);
  });

  it('is the same whatever its files are called', async () => {
    // a note names a file without units
    const {pattern} = twoStrips();
    const bare = JSON.stringify({pattern});
    const results = await Promise.all(
      ['a.json', 'b.json'].map((name) => solve({garment: bare, print}, {names: {garment: name}})),
    );
    expect(results[0]?.notes).not.toEqual(results[1]?.notes);
    const [one, other] = results.map(resultText);
    expect(one).toBe(other);
  });

  it('says so when the answer is another one than was sold, and how far apart they are', async () => {
    const design = await sold();
    const {left, ...others} = design.alignments;
    const [x = NaN, y = NaN] = left?.translation ?? [];
    const moved = (by: number) => ({
      ...design,
      result: '0'.repeat(64),
      alignments: {...others, left: {angle: left?.angle ?? NaN, translation: [x + by, y] as const}},
    });
    const near = await order(moved(0.25), {read});
    expect(near.reproduced).toBe(false);
    expect(near.differenceCm).toBeGreaterThan(0.01);
    expect(near.differenceCm).toBeLessThan(0.25 + 1e-9);
    expect(near.text.startsWith('{"reproduced":false,"format":"seamwise-result/1",')).toBe(true);
    const {reproduced, ...file} = JSON.parse(near.text) as Record<string, unknown>;
    expect(reproduced).toBe(false);
    expect(`${JSON.stringify(file)}\n`).toBe(resultText(near.result));
    const strange = await order({...moved(0), alignments: others}, {read});
    expect(strange.differenceCm).toBeNull();
  });

  it('does not count a shift by a whole repeat as a difference', async () => {
    const design = await sold();
    const alignments = Object.fromEntries(
      Object.entries(design.alignments).map(
        ([
          name,
          {
            angle,
            translation: [x, y],
          },
        ]) => {
          const along = [4 * Math.cos(angle), 4 * Math.sin(angle)] as const;
          return [name, {angle, translation: [x + along[0], y + along[1]] as const}];
        },
      ),
    );
    const {differenceCm} = await order({...design, alignments}, {read});
    expect(differenceCm).toBe(0);
  });

  it('is refused when a file is not the one that it was made with', async () => {
    const design = await sold();
    const other = (url: string) =>
      url === 'strips.json' ? Promise.resolve(new TextEncoder().encode(`${garment} `)) : read(url);
    await expect(order(design, {read: other, name: 'order 17'})).rejects.toThrow(
      /^strips\.json is not the file that order 17 was made with, .*; put the earlier file back, or /,
    );
  });

  it('is refused when the design is damaged', async () => {
    await expect(order('{}', {read})).rejects.toThrow('design is no design');
    await expect(order({...(await sold()), seed: -1}, {read})).rejects.toThrow("'seed'");
    await expect(order(undefined as never, {read})).rejects.toThrow("'design' must be");
  });

  it('ends when it is told to', async () => {
    const signal = AbortSignal.abort(new Error('enough'));
    await expect(order(await sold(), {read, signal})).rejects.toThrow('enough');
  });
});

describe('an order from the web', () => {
  let server: Server;
  let base = '';
  let redirection = '';
  beforeAll(async () => {
    server = createServer(({url = ''}, response) => {
      const name = url.split('/').at(-1) ?? '';
      if (name === 'silent.json') return; // never responds
      if (name === 'moved.json') {
        response.writeHead(302, {location: redirection}).end();
        return;
      }
      if (name === 'endless.json') {
        response.write('{');
        const chunk = Buffer.alloc(1_000_000, 32);
        const more = (): void => {
          while (!response.destroyed && response.write(chunk));
        };
        response.on('drain', more);
        more();
        return;
      }
      const content = shelf.get(name);
      response.statusCode = content === undefined ? 404 : 200;
      response.end(content);
    });
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    base = `http://127.0.0.1:${String((server.address() as AddressInfo).port)}/shop`;
  });
  afterAll(() => {
    server.closeAllConnections();
    server.close();
  });

  it('does not follow a redirection to another host', async () => {
    const asked: string[] = [];
    const inner = createServer((request, response) => {
      asked.push(request.url ?? '');
      response.end(garment);
    });
    await new Promise<void>((resolve) => inner.listen(0, '127.0.0.1', resolve));
    const secret = `http://127.0.0.1:${String((inner.address() as AddressInfo).port)}/secret`;
    redirection = secret;
    try {
      await expect(order(await from('moved.json'), {base})).rejects.toThrow(
        `${secret} lies outside of ${new URL(base).origin}, and only there may be read; `,
      );
      expect(asked).toEqual([]);
      const within = [new URL(base), new URL(secret)];
      expect(await order(await from('moved.json'), {base, within})).toMatchObject({
        reproduced: true,
      });
      redirection = '/strips.json';
      expect(await order(await from('moved.json'), {base})).toMatchObject({reproduced: true});
      redirection = '/moved.json';
      await expect(order(await from('moved.json'), {base})).rejects.toThrow('in circles');
    } finally {
      inner.close();
    }
  });

  const from = async (url: string): Promise<StoredDesign> => {
    const design = await sold();
    return {...design, garment: {...design.garment, url}};
  };

  it('fetches its files, relative to the base or by whole URLs', async () => {
    for (const url of ['strips.json', '/strips.json', `${base}/strips.json`]) {
      expect(await order(await from(url), {base})).toMatchObject({reproduced: true});
    }
  });

  it.each([
    ['missing.json', /missing\.json cannot be fetched: the server answered 404; /],
    ['silent.json', /silent\.json cannot be fetched: the server did not answer within 0\.5 s; /],
    ['endless.json', /endless\.json is larger than 20 MB, the limit for such a file; /],
    ['http://127.0.0.1:1/a.json', /a\.json lies outside of http:.*, and only there may be read; /],
    ['file:///etc/hostname', /^file:\/\/\/etc\/hostname is not on the web, but named from there; /],
  ])('names %s', async (url, words) => {
    const timeoutMs = url === 'silent.json' ? 500 : 30_000;
    await expect(order(await from(url), {base, timeoutMs})).rejects.toThrow(words);
  });

  it('can be called off while it waits', async () => {
    const signal = AbortSignal.timeout(200);
    await expect(order(await from('silent.json'), {base, signal})).rejects.toThrow('aborted');
  });
});

it('says so when nobody is there', async () => {
  const gone = 'http://127.0.0.1:1/a.json';
  const design = {...(await sold()), garment: {...chosen.garment, url: gone}};
  await expect(order(design, {base: gone})).rejects.toThrow(
    /a\.json cannot be fetched: .*; check the address/,
  );
});

describe('an order of a stranger', () => {
  it('is refused where nobody has said what it may read', async () => {
    const design = await sold();
    await expect(order(design)).rejects.toThrow(/^order\(\) reads what the design names: give it/);
  });

  it.each([
    'file:///etc/hostname',
    '/etc/hostname',
    '../../etc/hostname',
    '%2e%2e/%2e%2e/etc/hostname',
    'http://127.0.0.1:1/inside.json',
  ])('reads nothing outside of its base: %s', async (url) => {
    const design = {...(await sold()), garment: {...chosen.garment, url}};
    const base = fileURLToPath(new URL('.', import.meta.url));
    const failed = await order(design, {base}).catch((error: unknown) => String(error));
    expect(failed).toMatch(/ lies outside of .*tests\/wasm\/node\/, and only there may be read; /);
  });

  it('says once where reading is allowed, however often that is named', async () => {
    const design = {...(await sold()), garment: {...chosen.garment, url: '/etc/hostname'}};
    const base = new URL('.', import.meta.url);
    const within = [base, new URL('inner/', base), new URL(base)];
    const failed = await order(design, {base, within}).catch((error: unknown) => String(error));
    const folder = fileURLToPath(base);
    expect(failed).toContain(`/etc/hostname lies outside of ${folder}, and only there may be read`);
  });

  it('does not tell the sha256 of a file', async () => {
    const design = {...(await sold()), garment: {...chosen.garment, url: 'order.test.ts'}};
    const own = sha256Of(readFileSync(new URL(import.meta.url)));
    const base = new URL('.', import.meta.url);
    const failed = await order(design, {base}).catch((error: unknown) => String(error));
    expect(failed).toContain('order.test.ts is not the file that design was made with');
    expect(failed).not.toContain(own);
  });
});

it('names a file that is not there', async () => {
  const design = {...(await sold()), garment: {...chosen.garment, url: 'no/such.json'}};
  await expect(order(design, {base: '/tmp'})).rejects.toThrow(
    '/tmp/no/such.json cannot be read: there is no such file',
  );
});

it('solves a sample as the command line did, from the folder of the project', async () => {
  const publicFolder = new URL('../../../public/', import.meta.url);
  const file = (url: string) => ({url, sha256: sha256Of(readFileSync(new URL(url, publicFolder)))});
  const problem = {...chosen, garment: file('garments/tee-m.json'), print: file('prints/p4m.json')};
  const texts = {
    garment: readFileSync(new URL(problem.garment.url, publicFolder), 'utf8'),
    print: readFileSync(new URL(problem.print.url, publicFolder), 'utf8'),
  };
  const design = designOf(problem, await solve(problemOfStored(problem, texts)));
  expect(await order(design, {base: publicFolder})).toMatchObject({reproduced: true});
});
