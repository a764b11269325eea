/**
 * Download sizes of a page with an element, part by part as they load. With SEAMWISE_WRITE=1 they
 * are written to the table in docs/embedding.md.
 */
import {cp, mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

import type {Page} from 'playwright-core';
import {afterAll, beforeAll, expect, it, vi} from 'vitest';

import {openBrowser, serveFiles} from '../../support/page/browser.js';
import {snippetWith, textOf} from '../../support/package/embedding.js';
import {frames} from '../../support/page/waiting.js';

vi.setConfig({testTimeout: 180_000, hookTimeout: 180_000});
const project = fileURLToPath(new URL('../../..', import.meta.url));
const guide = join(project, 'docs/embedding.md');

/** Most kilobytes that a page without a bundler loads for a preview. */
const most = {scripts: 215, all: 440};

/** Sizes by the first column of the table. [kB] */
const sizes = new Map<string, number>();
/** Served folder with the script and its samples. */
let folder: string;
let browser: Awaited<ReturnType<typeof openBrowser>>;
let served: Awaited<ReturnType<typeof serveFiles>>;

/** Sizes of files that a worker has asked for are known some time after their answer is. */
async function inWorker({size}: Opened, module: RegExp): Promise<number> {
  await expect.poll(() => size(module)).toBeGreaterThan(0);
  return size(module);
}

interface Opened {
  readonly page: Page;
  /** Compressed size of the loaded files whose paths match. [kB] */
  readonly size: (pattern: RegExp) => Promise<number>;
}

/** Opens a page with the guide's element, far below the window. */
async function opened(url: string, attributes: string): Promise<Opened> {
  const page = await browser.newPage();
  const paths = new Set<string>();
  page.on('request', (request) => {
    const {pathname} = new URL(request.url());
    if (pathname.startsWith('/seamwise/')) paths.add(pathname);
  });
  const own = snippetWith('html', 'src="/seamwise/seamwise.js"');
  const tag = `${'<br>'.repeat(400)}<seamwise-garment ${attributes}`;
  const html = `<!doctype html><html lang="en">${own.replace('<seamwise-garment', tag)}`;
  await writeFile(join(folder, 'index.html'), html);
  await page.goto(url);
  await page.waitForFunction(() => customElements.get('seamwise-garment'));
  await frames(page); // the intersection observer has reported
  await page.waitForLoadState('networkidle');
  const size = async (pattern: RegExp): Promise<number> => {
    const all = [...paths].filter((path) => pattern.test(path));
    // the stored bytes: compression on the way depends on the host
    const bytes = await Promise.all(
      all.map(async (path) => gzipSync(await readFile(join(folder, path)), {level: 9}).length),
    );
    return bytes.reduce((sum, one) => sum + one, 0) / 1000;
  };
  return {page, size};
}

const script = /\.js$/;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'seamwise-sizes-'));
  for (const [from = '', to = ''] of [
    ['dist/standalone', 'seamwise'],
    ['public/garments/tee-m.json', 'garments/tee-m.json'],
    ...['p4m.json', 'p4m.svg'].map((file) => [`public/prints/${file}`, `prints/${file}`]),
  ]) {
    await cp(join(project, from), join(folder, to), {recursive: true});
  }
  const policy = "script-src 'self' 'wasm-unsafe-eval'";
  [browser, served] = await Promise.all([openBrowser(), serveFiles(folder, policy)]);

  const flat = await opened(served.url, '');
  sizes.set('modules at first', await flat.size(/\.wasm$/));
  sizes.set('the element', await flat.size(script));
  const element = flat.page.locator('seamwise-garment');
  await element.scrollIntoViewIfNeeded();
  await flat.page.locator('seamwise-garment:state(ready)').waitFor();
  await element.locator('[part=poster]').waitFor({state: 'hidden'});
  const scripts = await flat.size(script);
  sizes.set('scripts of a preview, with the element', scripts);
  sizes.set('of these, three', await flat.size(/three-/));
  sizes.set('seamwise.wasm', await flat.size(/\.wasm$/));
  await element.evaluate((one) => {
    one.setAttribute('mode', 'edit');
  });
  await flat.page.locator('seamwise-garment sw-piece-table table').waitFor(); // loads last
  sizes.set('scripts of mode="edit"', (await flat.size(script)) - scripts);

  const drape = await opened(served.url, 'view="garment"');
  await drape.page.evaluate(async () => {
    const one = document.querySelector('seamwise-garment');
    const isDraped = new Promise((resolve) => one?.addEventListener('drape', resolve));
    one?.scrollIntoView();
    await isDraped;
  });
  const flatOnly = /pattern-view-/; // a drape draws no pattern
  sizes.set(
    'scripts of a drape',
    (await drape.size(script)) - scripts + (await flat.size(flatOnly)),
  );
  sizes.set('drape.wasm', await inWorker(drape, /drape\.wasm$/));

  const laid = await opened(served.url, 'cloth-width="140"');
  await laid.page.evaluate(async () => {
    const one = document.querySelector('seamwise-garment');
    const isLaid = new Promise((resolve) => one?.addEventListener('cloth', resolve));
    one?.scrollIntoView();
    await isLaid;
  });
  sizes.set('scripts of a layout', (await laid.size(script)) - scripts);
  sizes.set('marker.wasm', await inWorker(laid, /marker\.wasm$/));
  if (process.env.SEAMWISE_WRITE) await writeTable();
});
afterAll(async () => {
  await Promise.all([browser.close(), served.close()]);
  await rm(folder, {recursive: true});
});

/** Rows of the table: the first column without backticks, the figure, and both as written. */
const rows = (): readonly {part: string; kilobytes: number; cells: string}[] =>
  [...textOf('Sizes').matchAll(/^(\| ([^|]+) \| )(\d+) \|/gm)].map(
    ([, cells = '', part = '', figure]) => ({
      ...{part: part.replaceAll('`', ''), kilobytes: Number(figure), cells},
    }),
  );

async function writeTable(): Promise<void> {
  let text = await readFile(guide, 'utf8');
  for (const {part, kilobytes, cells} of rows()) {
    const size = Math.round(sizes.get(part) ?? NaN);
    text = text.replace(`${cells}${kilobytes} |`, `${cells}${size} |`);
  }
  await writeFile(guide, text);
}

it('loads no module while the element is far below', {tags: ['thorough']}, () => {
  expect(sizes.get('modules at first')).toBe(0);
});

it('loads little for a preview without a bundler', {tags: ['thorough']}, () => {
  const scripts = sizes.get('scripts of a preview, with the element') ?? NaN;
  expect(scripts).toBeLessThan(most.scripts);
  expect(scripts + (sizes.get('seamwise.wasm') ?? NaN)).toBeLessThan(most.all);
});

it.skipIf(process.env.SEAMWISE_WRITE)(
  'loads for each part as much as the guide says',
  {tags: ['thorough']},
  () => {
    const said = rows();
    expect(said).toHaveLength(sizes.size - 1);
    for (const {part, kilobytes} of said) {
      const size = sizes.get(part) ?? NaN;
      expect(size, part).toBeGreaterThan(0.9 * kilobytes - 1);
      expect(size, part).toBeLessThan(1.1 * kilobytes + 1);
    }
  },
);
