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
  /** Simulates a first visit; by default the page shows the pattern, as left by a visit before. */
  readonly isFirst?: boolean;
  /**
   * Searches for better answers in idle time; by default the device saves data, and the page does
   * not: a slow test would have more idle time, and so more solves.
   */
  readonly searches?: boolean;
  /** Console messages to accept, where a test breaks something on purpose. */
  readonly maySay?: RegExp;
}

/** Query for the sample that is solved and draped soonest. */
export const smallest = '?garment=garments/tee-xs.json';

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

  return async (options = {}) => {
    const {query = '', beside, isFirst = false, searches = false, maySay, ...context} = options;
    const page = await (
      beside?.context() ??
      (await browser.newContext({
        viewport: {width: 1440, height: 900},
        reducedMotion: 'reduce', // software rendering draws a motion's frames slowly
        serviceWorkers: 'block', // only tests of the offline page need one
        ...context,
      }))
    ).newPage();
    opened.push(page);
    if (!searches) {
      await page.addInitScript(() => {
        Object.defineProperty(navigator, 'connection', {value: {saveData: true}});
      });
    }
    if (!isFirst) {
      await page.addInitScript(() => {
        try {
          localStorage.setItem('seamwise.introduction', '');
          if (localStorage.getItem('seamwise.view') === null)
            localStorage.setItem('seamwise.view', 'pattern');
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

/**
 * Clicks that button in the very task that shows it, as a fast solve ends within a frame.
 * @returns a function that waits for the click, and returns the progress that the same task shows
 */
export async function cancelNext(page: Page): Promise<() => Promise<string>> {
  const click = await cancelButton(page).evaluateHandle((cancel: HTMLButtonElement) => {
    const status = (cancel.getRootNode() as ShadowRoot).querySelector('sw-progress')?.shadowRoot;
    const shown = new Promise((resolve) => {
      new MutationObserver(resolve).observe(cancel, {attributeFilter: ['hidden']});
    });
    const clicked = async (): Promise<string> => {
      await shown;
      cancel.click();
      for (let k = 0; k < 100 && !status?.textContent.includes('Cancelled'); k++)
        await Promise.resolve();
      return status?.textContent.trim() ?? '';
    };
    return {progress: clicked()};
  });
  return () => click.evaluate(({progress}) => progress);
}

export const progress = (page: Page): Locator => page.getByRole('status', {name: 'Progress'});

/** Waits until the component that draws this element has rendered the workbench's state. */
export const drawn = (shown: Locator): Promise<void> =>
  shown.evaluate(async (element) => {
    const {host} = element.getRootNode() as ShadowRoot;
    await (host as Element & {readonly updateComplete: Promise<unknown>}).updateComplete;
  });

/** Waits for the page's first design, which would replace a file that is opened before. */
export async function begun(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
    return workbench !== undefined && workbench.solving.state.kind !== 'opening';
  });
}

/** Waits for the final answer to the current problem. */
export const solved = (page: Page): Promise<void> =>
  progress(page)
    .filter({hasText: /^Matched in/})
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
    await button(page, 'Cut pattern').click();
  }
  await dialog.getByRole('button', {name: file, exact: true}).click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    dialog.getByRole('button', {name: `Save ${file}`}).click(),
  ]);
  return (await bytesOf(download)).toString('latin1');
}
