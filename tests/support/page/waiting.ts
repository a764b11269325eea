/** Waits of browser tests: for frames, events and workers, never for a time. */
import type {Page} from 'playwright-core';
import {expect} from 'vitest';

/** Waits until the page has drawn frames; after two, its observers have reported. */
export const frames = (page: Page, count = 2): Promise<void> =>
  page.evaluate(async (left) => {
    for (let k = 0; k < left; k++) await new Promise(requestAnimationFrame);
  }, count);

/**
 * Waits until the page has drawn, and until the test has been notified of every request sent by
 * then.
 */
export async function caughtUp(page: Page): Promise<void> {
  await frames(page, 3);
  // the response arrives after all earlier requests
  await page.evaluate(async () => (await fetch(location.href)).text());
}

/** Waits until the page itself has this number of workers; their helpers end with them. */
export async function workersLeft(page: Page, count: number): Promise<void> {
  const atHand = (): Promise<number> =>
    page.evaluate(() => (globalThis as unknown as {workersAtHand: Set<Worker>}).workersAtHand.size);
  await expect.poll(atHand, {timeout: 30_000}).toBe(count);
}
