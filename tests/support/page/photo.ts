/** The photo dialog, which turns a photo into a print. */
import type {Locator, Page} from 'playwright-core';

import {button} from './page.js';

/** The time to read a photo depends on the load of the machine. */
export const patient = {timeout: 120_000};

export const dialogOf = (page: Page): Locator => page.locator('sw-photo').getByRole('dialog');

export async function openSheet(page: Page): Promise<Locator> {
  await button(page, 'Photo of your fabric').click();
  const dialog = dialogOf(page);
  await dialog.waitFor();
  return dialog;
}

export const give = (page: Page, buffer: Buffer, name = 'meadow.jpg'): Promise<void> =>
  page
    .locator('sw-photo input[type=file]')
    .first()
    .setInputFiles({name, mimeType: 'image/jpeg', buffer});

/** Drops or pastes a photo. */
export const bring = (
  page: Page,
  bytes: Buffer,
  name: string,
  kind: 'drop' | 'paste' = 'drop',
): Promise<void> =>
  dialogOf(page).evaluate(
    (dialog, {base64, called, by}) => {
      const binary = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const data = new DataTransfer();
      data.items.add(new File([binary], called, {type: 'image/jpeg'}));
      const how = {bubbles: true, composed: true, cancelable: true};
      dialog.dispatchEvent(
        by === 'drop'
          ? new DragEvent('drop', {...how, dataTransfer: data})
          : new ClipboardEvent('paste', {...how, clipboardData: data}),
      );
    },
    {base64: bytes.toString('base64'), called: name, by: kind},
  );

export const found = (dialog: Locator): Promise<string> =>
  dialog.getByText(/Found: /).innerText(patient);

/** Waits until the swatch shows the tile. */
export const tileMade = (dialog: Locator): Promise<void> =>
  dialog
    .locator('sw-photo-swatch image')
    .first()
    .waitFor({...patient, state: 'attached'});

export const use = (page: Page): Locator =>
  dialogOf(page).getByRole('button', {name: 'Use this print'});

/** Enters a length in the first measurement field. */
export async function measure(dialog: Locator, cm: number): Promise<void> {
  const field = dialog.getByLabel('measure (cm)').first();
  await field.fill(String(cm));
  await field.press('Enter');
}
