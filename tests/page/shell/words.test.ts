/** The core's English messages, on a page in another language. */
import {expect, it, vi} from 'vitest';

import {choose, jsonFile} from '../../support/page/files.js';
import {usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

it('says notes on a garment and faults of files in German, around the place in the file', async () => {
  const page = await openPage({
    ...{locale: 'de-DE', query: '?garment=/garments/gathered-skirt-m.json'},
  });
  await page.getByText(/^In .* angepasst$/).waitFor({timeout: 60_000});
  await page.getByText(/^Hinweise/).click();
  await page
    .getByText(/Eine Seite ist um mehr als ein Zehntel länger .*: Taille vorn, Taille hinten\./)
    .waitFor();

  await choose(page, 'Mein Schnitt', jsonFile('leer.json', {pattern: {}}));
  const alert = page.getByRole('alert');
  await alert
    .filter({hasText: /Die Datei ist kein lesbarer Schnitt.*Auf Englisch: leer\.json has no/})
    .waitFor();
  await choose(page, 'Mein Schnitt', jsonFile('ergebnis.json', {format: 'seamwise-result/1'}));
  await alert.filter({hasText: 'ergebnis.json ist ein Ergebnis ohne seinen Schnitt'}).waitFor();
  await expect.poll(() => page.getByText(/^In .* angepasst$/).count()).toBe(1);
});
