/**
 * A page with elements, as built for users and under a strict policy, and the files they refer to.
 */
import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

import type {Browser, BrowserContextOptions, Page, Route} from 'playwright-core';
import {afterAll, afterEach, beforeAll, expect, vi} from 'vitest';

import type {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {openBrowser, serveBuilt, strictPolicy, type Served} from './browser.js';

const policy = `${strictPolicy}; style-src 'self'; img-src 'self'`;

/** Text of a sample file. */
export const sample = (path: string): string =>
  readFileSync(new URL(`../../../public/${path}`, import.meta.url), 'utf8');

export const tee =
  '<seamwise-garment garment="garments/tee-{size}.json" size="m" print="prints/p4m.json" alt="A tee"></seamwise-garment>';

interface ElementPageOptions extends BrowserContextOptions {
  /** Console messages to accept, where a test breaks something on purpose. */
  readonly maySay?: RegExp;
  /** Runs before any script of the page. */
  readonly before?: () => void;
}

export interface ElementPage {
  readonly page: Page;
  /** Paths of the requested sample files. */
  readonly asked: string[];
  /** Overrides the response for a file. */
  readonly answer: (path: string, how: (route: Route) => Promise<void>) => Promise<void>;
  /** Puts markup into the page; `run` runs a function with its first element. */
  readonly put: (markup: string) => Promise<void>;
  readonly run: <T, Given = undefined>(
    work: (element: SeamwiseGarment, given: Given) => T | Promise<T>,
    given?: Given,
  ) => Promise<T>;
}

/**
 * Opens pages. Any message on the page's console fails the test, and so does every unhandled
 * rejection.
 * @param allowed  content security policy
 */
export function useElementPage(
  allowed = policy,
): (options?: ElementPageOptions) => Promise<ElementPage> {
  vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything
  let browser: Browser | undefined;
  let served: Served | undefined;
  const said: string[] = [];
  const pages: Page[] = [];
  beforeAll(async () => {
    [browser, served] = await Promise.all([openBrowser(), serveBuilt('element', allowed)]);
  });
  afterEach(async () => {
    await Promise.all(pages.splice(0).map((page) => page.context().close()));
    expect(said.splice(0)).toEqual([]);
  });
  afterAll(async () => {
    await browser?.close();
    await served?.close();
  });
  return async ({maySay, before, ...context} = {}) => {
    if (!browser || !served) throw new Error('The browser is not open yet.');
    const page = await (await browser.newContext({reducedMotion: 'reduce', ...context})).newPage();
    pages.push(page);
    const hear = (text: string): void => {
      // software rendering is slow to return pixels; a test's build contains Lit's development
      // version
      if (!/GPU stall|Lit is in dev mode/.test(text) && !maySay?.test(text)) said.push(text);
    };
    page.on('console', (message) => {
      hear(message.text());
    });
    page.on('pageerror', (error) => {
      hear(error.message);
    });
    const asked: string[] = [];
    await page.route(/\/(garments|prints)\//, async (route) => {
      const path = new URL(route.request().url()).pathname.slice(1);
      asked.push(path);
      await route.fulfill({
        path: fileURLToPath(new URL(`../../../public/${path}`, import.meta.url)),
      });
    });
    if (before) await page.addInitScript(before);
    await page.goto(served.url);
    await page.waitForFunction(() => customElements.get('seamwise-garment'), undefined, {
      timeout: 15_000,
    });
    return {
      page,
      asked,
      answer: async (path, how) => {
        await page.route(`**/${path}`, async (route) => {
          asked.push(path);
          await how(route);
        });
      },
      put: (markup) =>
        page.evaluate((html) => {
          document.body.innerHTML = html;
        }, markup),
      run: (work, given) =>
        page
          .locator('seamwise-garment')
          .first()
          .evaluate(work as never, given),
    };
  };
}
