/** The page without automatic solving, for tests that need no answer. */
import type {Page} from 'playwright-core';

import {designOf} from './design.js';
import type {PageOptions} from './page.js';
import {printRadio} from './prints.js';

/** Opens the page and turns automatic solving off. */
export async function quiet(
  open: (options?: PageOptions) => Promise<Page>,
  options: PageOptions = {},
): Promise<Page> {
  const page = await open({viewport: {width: 640, height: 480}, ...options});
  const live = page.getByRole('switch', {name: 'Match after each change', checked: true});
  await page.getByRole('switch', {name: 'Match after each change'}).waitFor();
  if ((await live.count()) > 0) await live.press('Space');
  return page;
}

export async function chooseGroup(page: Page, group: string): Promise<void> {
  await printRadio(page, group).press('Space');
  await printRadio(page, group)
    .and(page.getByRole('radio', {checked: true}))
    .waitFor();
}

export const groupOf = async (page: Page): Promise<string> => (await designOf(page)).print.group;

/** Reloads the page and waits until it is ready. */
export async function reloaded(page: Page): Promise<void> {
  await page.reload();
  await page.getByRole('radiogroup', {name: 'Symmetry of the print'}).waitFor();
}
