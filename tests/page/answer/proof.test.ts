/** Proofs about an alignment that the page finds while it is idle. */
import {it} from 'vitest';

import {showSample, solved, usePage} from '../../support/page/page.js';

const openPage = usePage();

it('proves how good a placing is once it is shown', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  await showSample(page, 'shift-dress');
  await page.getByText('Details').click();
  await page.getByText('This is the best placement that was found.').waitFor({timeout: 60_000});
  await page
    .getByText(/^No other placement fits (better|more than \d+\s?% better)\.$/)
    .waitFor({timeout: 60_000});
});
