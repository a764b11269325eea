/** The page itself in a real browser, as built and served for users. */
import type {Browser, BrowserContextOptions, Locator, Page} from 'playwright-core';
import {afterAll, afterEach, beforeAll, expect, inject} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {bytesOf, openBrowser} from './browser.js';

export interface PageOptions extends BrowserContextOptions {
  /** End of the address: `?garment=...`, `#...`. */
  readonly query?: string;
  /** Page whose context, and so whose storage, is shared. */
  readonly beside?: Page;
  /** Simulates a first visit; by default the introduction is off. */
  readonly isFirst?: boolean;
  /** Console messages to accept, where a test breaks something on purpose. */
  readonly maySay?: RegExp;
}

/** Opens the page for one test file. Any message on its console fails the test. */
export function usePage(): (options?: PageOptions) => Promise<Page> {
  let browser: Browser;
  const said: string[] = [];
  const opened: Page[] = [];

  beforeAll(async () => {
    browser = await openBrowser();
  });
  afterEach(async () => {
    await Promise.all(opened.splice(0).map((page) => page.context().close()));
    expect(said.splice(0)).toEqual([]);
  });
  afterAll(() => browser.close());

  return async ({query = '', beside, isFirst = false, maySay, ...context} = {}) => {
    const page = await (
      beside?.context() ??
      (await browser.newContext({
        viewport: {width: 1440, height: 900},
        serviceWorkers: 'block', // only tests of the offline page need one
        ...context,
      }))
    ).newPage();
    opened.push(page);
    if (!isFirst) {
      await page.addInitScript(() => {
        try {
          localStorage.setItem('seamwise.introduction', '');
        } catch {
          // no storage, no introduction
        }
      });
    }
    const hear = (text: string): void => {
      // Software rendering is slow to return pixels, and logs it. The blocked service worker is
      // logged, too.
      const isExpected = /GPU stall|Service Worker registration blocked/.test(text);
      if (!isExpected && !maySay?.test(text)) said.push(text);
    };
    page.on('console', (message) => {
      hear(message.text());
    });
    page.on('pageerror', (error) => {
      hear(error.message);
    });
    await page.goto(`${inject('page')}${query}`);
    return page;
  };
}

export const button = (page: Page, name: string): Locator =>
  page.getByRole('button', {name, exact: true});

/** The button that cancels a running solve. */
export const cancelButton = (page: Page): Locator => page.locator('sw-editor .solving button');

export const progress = (page: Page): Locator => page.getByRole('status', {name: 'Progress'});

/** Waits until the component that draws this element has rendered the workbench's state. */
export const drawn = (shown: Locator): Promise<void> =>
  shown.evaluate(async (element) => {
    const {host} = element.getRootNode() as ShadowRoot;
    await (host as Element & {readonly updateComplete: Promise<unknown>}).updateComplete;
  });

/** Waits for the final answer to the current problem. */
export const solved = (page: Page): Promise<void> =>
  progress(page)
    .filter({hasText: /^Aligned in/})
    .waitFor({timeout: 60_000});

/** Shows one of the samples, by its name in public/samples.json. */
export async function showSample(page: Page, style: string): Promise<void> {
  await page.getByLabel('Garment', {exact: true}).selectOption(style);
  await page.waitForFunction((wanted) => {
    const shown = document.querySelector<SeamwisePage>('seamwise-page');
    return shown?.workbench.history.design?.garment.sample?.style === wanted;
  }, style);
  await solved(page);
}

/** Text of the file that a button of the menu saves. */
export async function saved(page: Page, name: string): Promise<string> {
  if (!(await button(page, name).isVisible())) await button(page, 'Save …').click();
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, name).click()]);
  return (await bytesOf(download)).toString();
}

/**
 * Text of the file that the cutting dialog saves; the dialog keeps the file type for the next time.
 */
export async function savedCut(page: Page, file: 'PDF' | 'SVG' | 'DXF' | 'HP-GL'): Promise<string> {
  const dialog = page.locator('sw-cut-dialog').getByRole('dialog');
  if (!(await dialog.isVisible())) {
    await button(page, 'Save …').click();
    await button(page, 'Cut …').click();
  }
  await dialog.getByRole('button', {name: file, exact: true}).click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    dialog.getByRole('button', {name: `Save ${file}`}).click(),
  ]);
  return (await bytesOf(download)).toString('latin1');
}
