/**
 * Download sizes of a page with elements, as in docs/embedding.md: in and far from the viewport.
 */
import {cp, mkdtemp, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

import type {Response} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {openBrowser, serveFiles} from '../../support/page/browser.js';
import {snippetWith, textOf} from '../../support/package/embedding.js';
import {frames} from '../../support/page/waiting.js';

vi.setConfig({testTimeout: 180_000});
const project = fileURLToPath(new URL('../../..', import.meta.url));

/** The figure before these words. [kB] */
function said(words: string): number {
  const [, figure] =
    new RegExp(`(\\d+) ${words}`).exec(textOf('Sizes').replaceAll(/\s+/g, ' ')) ?? [];
  if (figure === undefined) throw new Error(`docs/embedding.md has no size '${words}'.`);
  return Number(figure);
}

it(
  'loads next to nothing while its element is far below, and as much as is said once it is near',
  {tags: ['thorough']},
  async () => {
    const folder = await mkdtemp(join(tmpdir(), 'seamwise-sizes-'));
    for (const [from = '', to = ''] of [
      ['dist/standalone', 'seamwise'],
      ['public/garments/tee-m.json', 'garments/tee-m.json'],
      ...['p4m.json', 'p4m.svg'].map((file) => [`public/prints/${file}`, `prints/${file}`]),
    ]) {
      await cp(join(project, from), join(folder, to), {recursive: true});
    }
    const own = snippetWith('html', 'src="/seamwise/seamwise.js"');
    const page = own.replace('<seamwise-garment', `${'<br>'.repeat(400)}<seamwise-garment`);
    await writeFile(join(folder, 'index.html'), `<!doctype html><html lang="en">${page}`);
    const policy = "script-src 'self' 'wasm-unsafe-eval'";
    const [browser, served] = await Promise.all([openBrowser(), serveFiles(folder, policy)]);
    try {
      const opened = await browser.newPage();
      const responses = new Map<string, Response>();
      opened.on('response', (response) => {
        const {pathname} = new URL(response.url());
        if (pathname.startsWith('/seamwise/')) responses.set(pathname, response);
      });
      /** Sizes of all scripts so far, and of the module. [kB] */
      const loaded = async (): Promise<{scripts: number; three: number; module: number}> => {
        const all = await Promise.all(
          // the stored bytes: compression on the way depends on the host
          [...responses].map(async ([path, response]) => {
            const body = await response.body();
            return [path, gzipSync(body, {level: 9}).length] as const;
          }),
        );
        const sum = (pattern: RegExp): number =>
          all.reduce((total, [path, size]) => total + (pattern.test(path) ? size : 0), 0) / 1000;
        return {scripts: sum(/\.js$/), three: sum(/three/), module: sum(/\.wasm$/)};
      };
      await opened.goto(served.url);
      await opened.waitForFunction(() => customElements.get('seamwise-garment'));
      await frames(opened); // the intersection observer has reported
      await opened.waitForLoadState('networkidle');
      const far = await loaded();
      expect(far.module).toBe(0);
      const isNear = (size: number, figure: number): void => {
        expect(size).toBeGreaterThan(0.85 * figure);
        expect(size).toBeLessThan(1.15 * figure);
      };
      isNear(far.scripts, said('for the element until it comes near'));
      const element = opened.locator('seamwise-garment');
      await element.scrollIntoViewIfNeeded();
      await opened.locator('seamwise-garment:state(ready)').waitFor();
      await element.locator('[part=poster]').waitFor({state: 'hidden'});
      const near = await loaded();
      isNear(near.scripts, said('with all that a preview needs'));
      isNear(near.three, said('of it three'));
      isNear(near.module, said("for the solver's module"));
      await element.evaluate((one) => {
        one.setAttribute('mode', 'edit');
      });
      await opened.locator('seamwise-garment sw-editor').waitFor();
      await opened.locator('seamwise-garment sw-piece-table table').waitFor(); // loads last
      isNear((await loaded()).scripts - near.scripts, said('more to place a print or to edit'));
    } finally {
      await Promise.all([browser.close(), served.close()]);
      await rm(folder, {recursive: true});
    }
  },
);
