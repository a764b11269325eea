/** Hosting the element as in docs/embedding.md: its code examples, in a browser. */
import {cp, mkdtemp, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import type {Browser} from 'playwright-core';
import {afterAll, beforeAll, describe, expect, it, vi} from 'vitest';

import type {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {openBrowser, serveFiles, type Served} from '../../support/page/browser.js';
import {rowsOf, snippetsIn, snippetWith} from '../../support/package/embedding.js';

vi.setConfig({testTimeout: 180_000});
const project = fileURLToPath(new URL('../../..', import.meta.url));
const elsewhere = 'https://cdn.example';

const policyIn = (snippet = ''): string => snippet.replace('Content-Security-Policy:', '').trim();
const [ownPolicy, trustedPolicy, crossPolicy] = snippetsIn('http').map(policyIn);
if (!ownPolicy || !trustedPolicy || !crossPolicy) {
  throw new Error('docs/embedding.md has not all policies.');
}

let browser: Browser;
let folder: string;
/** The second host. */
let other: Served;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'seamwise-host-'));
  const copies = [
    ['dist/standalone', 'own/seamwise'],
    ['dist/standalone', 'other/seamwise'],
    ['public/garments/tee-m.json', 'own/garments/tee-m.json'],
    ...['p4m.json', 'p4m.svg'].map((file) => [`public/prints/${file}`, `own/prints/${file}`]),
  ];
  for (const [from = '', to = ''] of copies) {
    await cp(join(project, from), join(folder, to), {recursive: true});
  }
  [browser, other] = await Promise.all([openBrowser(), serveFiles(join(folder, 'other'))]);
});

afterAll(async () => {
  await Promise.all([browser.close(), other.close()]);
  await rm(folder, {recursive: true});
});

interface Visit {
  readonly state: string;
  readonly codes: readonly string[];
  readonly sentences: readonly string[];
  /**
   * Paths of the workers' scripts, each once: a worker may have helpers that run the same script.
   */
  readonly workers: readonly string[];
  /** Errors and warnings of the browser's console. */
  readonly said: readonly string[];
}

/** Opens a new page with this markup, and waits for the element's final state. */
async function visit(policy: string, markup: string): Promise<Visit> {
  const there = (text: string): string => text.replaceAll(elsewhere, new URL(other.url).origin);
  const icon = '<link rel="icon" href="/prints/p4m.svg" />';
  await writeFile(
    join(folder, 'own/index.html'),
    there(`<!doctype html><html lang="en">${icon}${markup}`),
  );
  await writeFile(
    join(folder, 'own/seamwise-worker.js'),
    there(snippetWith('js', 'solver.worker.js')),
  );
  const served = await serveFiles(join(folder, 'own'), there(policy));
  const page = await browser.newPage();
  const said: string[] = [];
  const workers: string[] = [];
  page.on('console', (message) => {
    // software rendering is slow to return pixels
    if (!message.text().includes('GPU stall')) said.push(message.text());
  });
  page.on('worker', (worker) => workers.push(new URL(worker.url()).pathname));
  try {
    await page.addInitScript(() => {
      const [codes, sentences]: [string[], string[]] = [[], []];
      Object.assign(globalThis, {codes, sentences});
      addEventListener(
        'error',
        ({target, detail}: Event & {detail?: unknown}) => {
          const isElement = target instanceof Element && target.localName === 'seamwise-garment';
          if (!isElement) return;
          const {code, message} = detail as {code: string; message: string};
          codes.push(code);
          sentences.push(message);
        },
        true,
      );
    });
    await page.goto(served.url);
    const {state} = await page
      .locator('seamwise-garment')
      .evaluate(async (element: SeamwiseGarment) => {
        await customElements.whenDefined('seamwise-garment');
        await element.solve().catch(() => undefined);
        return {state: element.state};
      });
    if (state === 'ready') {
      await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    }
    const heard = await page.evaluate(() => {
      const {codes, sentences} = globalThis as unknown as Record<string, string[]>;
      return {codes: codes ?? [], sentences: sentences ?? []};
    });
    return {state, ...heard, workers: [...new Set(workers)], said};
  } finally {
    await page.close();
    await served.close();
  }
}

const own = snippetWith('html', 'src="/seamwise/seamwise.js"');
const cross = snippetWith('html', `src="${elsewhere}`);

describe('on its own host', () => {
  it(
    'solves in a worker and draws, under a policy that allows nothing else',
    {tags: ['thorough']},
    async () => {
      expect(await visit(ownPolicy, own)).toMatchObject({
        ...{state: 'ready', codes: [], said: []},
        workers: ['/seamwise/solver.worker.js'],
      });
    },
  );

  it.each([
    ["'wasm-unsafe-eval'", '', 'no-wasm', 'error'],
    ["worker-src 'self'", "worker-src 'none'", 'worker-blocked', 'ready'],
    ["connect-src 'self'", '', 'network', 'error'],
    ["img-src 'self'", '', 'not-an-image', 'ready'],
  ])('misses %s of the policy as it is said', async (directive, instead, code, state) => {
    const row = rowsOf('directive').find(([name]) => name === directive);
    expect(row?.[2]).toContain(code);
    const seen = await visit(ownPolicy.replace(directive, instead), own);
    expect([seen.state, [...new Set(seen.codes)]]).toEqual([state, [code]]);
  });
});

describe('where the page demands trusted types', () => {
  const demand = "require-trusted-types-for 'script'";

  it('solves in a worker and draws, under the names that are said', async () => {
    const directive = trustedPolicy.split('; ').find((one) => one.startsWith('trusted-types'));
    const seen = await visit(`${ownPolicy}; ${demand}; ${String(directive)}`, own);
    expect(seen).toMatchObject({
      ...{state: 'ready', codes: []},
      workers: ['/seamwise/solver.worker.js'],
    });
  });

  it(
    "says which name is missing where the worker may have none, and solves on the page's thread",
    {tags: ['thorough']},
    async () => {
      const seen = await visit(`${ownPolicy}; ${demand}; trusted-types lit-html`, own);
      expect(seen).toMatchObject({state: 'ready', codes: ['worker-blocked'], workers: []});
      expect(seen.sentences).toEqual([
        expect.stringMatching(
          /demands trusted types; let it allow ours: trusted-types seamwise lit-html\.$/,
        ),
      ]);
    },
  );
});

describe('with its scripts on another host', () => {
  it("has a worker by one line of the page's own", {tags: ['thorough']}, async () => {
    expect(await visit(crossPolicy, cross)).toMatchObject({
      ...{state: 'ready', codes: [], said: []},
      workers: ['/seamwise-worker.js'],
    });
  });

  it("solves on the page's thread without", {tags: ['thorough']}, async () => {
    const seen = await visit(crossPolicy, cross.replace(/worker-url=".*"/, ''));
    expect(seen).toMatchObject({state: 'ready', codes: ['worker-blocked'], workers: []});
  });
});
