/** Waits of browser tests: for a frame, a state or the end of a worker, never for a time. */
import type {JSHandle, Page, Worker} from 'playwright-core';
import {expect} from 'vitest';

/** Waits until the page has drawn frames, by two of which its observers have reported and its microtasks are done. */
export const frames = (page: Page, count = 2): Promise<void> =>
  page.evaluate(async (left) => {
    for (let k = 0; k < left; k++) await new Promise(requestAnimationFrame);
  }, count);

/** Waits for a state of the page that an object on it describes. */
export async function reached<T>(handle: JSHandle<T>, isReached: (state: T) => boolean) {
  await expect.poll(async () => isReached(await handle.evaluate((state) => state as T))).toBe(true);
}

/** Waits until the page has this number of workers that count. */
export async function workersLeft(
  page: Page,
  count: number,
  counts: (worker: Worker) => boolean = () => true,
): Promise<void> {
  await expect.poll(() => page.workers().filter(counts).length, {timeout: 30_000}).toBe(count);
}
