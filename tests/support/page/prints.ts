/** Prints of the gallery. */
import type {Locator, Page} from 'playwright-core';

/** The button that chooses a group, or `stripes`. */
export const printRadio = (page: Page, group: string): Locator =>
  page.locator(`sw-print-gallery [role=radio]#${group}`);
