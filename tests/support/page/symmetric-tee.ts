import type {Page} from 'playwright-core';
import {expect} from 'vitest';

import {askedSymmetries} from '@/model/design/design.js';
import {designOf} from './design.js';
import {button, showSample, solved} from './page.js';

/**
 * A page with a tee whose front and back are symmetric in themselves, and whose sleeves are a pair.
 */
export async function symmetricTee(openPage: () => Promise<Page>): Promise<Page> {
  const page = await openPage();
  await showSample(page, 'tee');
  await button(page, 'Accept all symmetries').click();
  await expect.poll(async () => askedSymmetries(await designOf(page)).length).toBe(3);
  await solved(page);
  return page;
}
