/** Cancelling the analysis of a photo of a camera's full resolution. */
import {it, vi} from 'vitest';

import {useLargePhoto} from '../../support/page/large-photo.js';
import {solved, usePage} from '../../support/page/page.js';
import {openSheet, patient} from '../../support/page/photo.js';

vi.setConfig({testTimeout: 300_000}); // a busy machine is slow at everything

const openPage = usePage();
const giveLarge = useLargePhoto();

it(
  'is given up by Cancel, as often as wanted, and the sheet answers',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const dialog = await openSheet(page);
    await giveLarge(page);
    for (let k = 0; k < 3; k++) {
      const cancel = dialog.getByRole('button', {name: 'Cancel'});
      await cancel.waitFor(patient);
      await cancel.click();
      await cancel.waitFor({state: 'detached'});
      await dialog.getByText('Stopped.').waitFor();
      await dialog.getByRole('button', {name: 'Draw the repeat by hand'}).click();
      await dialog.locator('sw-photo-work').getByRole('button', {name: 'Cancel'}).click();
      if (k < 2) await dialog.getByRole('button', {name: 'Look again'}).click();
    }
  },
);
