/** The page's current design, read from the page itself. */
import type {Page} from 'playwright-core';

import type {SeamwisePage} from '@/app/page.js';
import type {Design} from '@/model/design/design.js';

export const designOf = (page: Page): Promise<Design> =>
  page.locator('seamwise-page').evaluate((element) => {
    const {design} = (element as SeamwisePage).workbench.history;
    if (!design) throw new Error('The page has no design yet.');
    return design;
  });
