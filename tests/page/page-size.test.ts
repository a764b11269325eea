/** How much the opening fetches, compressed as a host would send it. */
import {gzipSync} from 'node:zlib';

import {expect, it} from 'vitest';

import {solved, usePage} from '../support/page.js';

const openPage = usePage();

const kilobyte = 1000;
/** Of the page's own code and of the solver, without the drawing library. [bytes] */
const most = {code: 120 * kilobyte, wasm: 242 * kilobyte};

async function sizeOf(url: string): Promise<readonly [file: string, bytes: number]> {
  const body = await (await fetch(url)).arrayBuffer();
  const file = new URL(url).pathname.split('/').at(-1) ?? '';
  return [file, gzipSync(new Uint8Array(body), {level: 9}).length];
}

it('comes with little code until the first answer is there', async () => {
  const page = await openPage();
  const urls = new Set<string>();
  page.on('request', (request) => {
    if (/\.(js|wasm)$/.test(request.url())) urls.add(request.url());
  });
  await page.reload();
  await solved(page);
  const sizes = await Promise.all([...urls].map(sizeOf));
  const bytes = (wanted: RegExp): number =>
    sizes.reduce((sum, [file, size]) => sum + (wanted.test(file) ? size : 0), 0);
  const each = sizes.map(([file, size]) => `${file} ${(size / kilobyte).toFixed(1)} kB`).join(', ');
  const code = bytes(/^(?!three-).*\.js$/);
  const wasm = bytes(/\.wasm$/);
  expect(code, each).toBeGreaterThan(50 * kilobyte);
  expect(code, each).toBeLessThan(most.code);
  expect(wasm, each).toBeGreaterThan(100 * kilobyte);
  expect(wasm, each).toBeLessThan(most.wasm);
});
