/** Download size of the page's first load, compressed as a host would send it. */
import {gzipSync} from 'node:zlib';

import type {Page, Request} from 'playwright-core';
import {expect, it} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {solved, usePage} from '../../support/page/page.js';

const openPage = usePage();

const kilobyte = 1000;
/**
 * Most bytes of the page's own code and of the solver, without the drawing library. They include
 * the view of the garment, 31 kB at most, and the lens's strip, 2.8 kB, which is preloaded where the answer takes longer.
 */
const most = {code: 169 * kilobyte, wasm: 226.5 * kilobyte};

async function sizeOf(url: string): Promise<readonly [file: string, bytes: number]> {
  const body = await (await fetch(url)).arrayBuffer();
  const file = new URL(url).pathname.split('/').at(-1) ?? '';
  return [file, gzipSync(new Uint8Array(body), {level: 9}).length];
}

/** Notes the time of the first answer, before any part of the page learns of it. [ms of the page] */
const noteAnswer = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const begin = (): void => {
      const workbench = document.querySelector<SeamwisePage>('seamwise-page')?.workbench;
      if (!workbench) {
        setTimeout(begin);
        return;
      }
      const look = (): void => {
        const isFirst = workbench.solving.state.kind === 'done' && !('answered' in globalThis);
        if (isFirst) Object.assign(globalThis, {answered: performance.now()});
      };
      workbench.subscribe(['solving'], look);
      look();
    };
    begin();
  });

it('comes with little code until the first answer is there', async () => {
  const page = await openPage({isFirst: true, query: 'samples.json', maySay: /404/});
  const requests: Request[] = [];
  page.on('request', (request) => {
    if (/\.(js|wasm)$/.test(request.url())) requests.push(request);
  });
  await noteAnswer(page);
  await page.goto(new URL('.', page.url()).href, {waitUntil: 'commit'});
  await solved(page);
  await page.waitForLoadState('networkidle'); // a request is listed once it is answered
  // by the page's own clock, as what comes with the answer begins within the same millisecond
  const {end, later} = await page.evaluate(() => {
    const end = (globalThis as unknown as {answered: number}).answered;
    const loaded = performance.getEntriesByType('resource');
    const names = (isLater: boolean): string[] =>
      loaded.filter((one) => one.startTime >= end === isLater).map(({name}) => name);
    const before = new Set(names(false));
    return {end, later: names(true).filter((name) => !before.has(name))};
  });
  expect(end).toBeGreaterThan(0);
  const urls = new Set(requests.map((one) => one.url()).filter((url) => !later.includes(url)));
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
