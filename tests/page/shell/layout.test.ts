/** The page's layout: visible parts on screens of every width, and fixed positions. */
import type {Locator, Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {PatternPane} from '@/editor/pattern/pattern-pane.js';
import {sampleOf} from '../../support/level.js';
import {designOf} from '../../support/page/design.js';
import {button, solved, usePage} from '../../support/page/page.js';
import {printRadio} from '../../support/page/prints.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const phone = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true};

const box = async (
  found: Locator,
): Promise<{x: number; y: number; width: number; height: number}> => {
  const shown = await found.boundingBox();
  if (!shown) throw new Error('It is not to be seen.');
  return shown;
};

const heightOfHead = async (page: Page): Promise<number> =>
  (await box(page.locator('sw-editor header').first())).height;

it(
  'keeps the garment in sight on a phone, whatever is chosen below it',
  {tags: ['thorough']},
  async () => {
    const page = await openPage(phone);
    await solved(page);
    const stage = page.locator('sw-pattern .stage');
    const sheets = page.getByRole('navigation', {name: 'Panels'});
    for (const [name, what] of [
      ['Pattern', page.getByLabel('Outlines may change by (mm)')],
      ['Seams', page.getByRole('group', {name: 'Close-up of a seam'})],
      ['Seams', page.getByRole('table', {name: 'Seams', exact: true})],
      ['Seams', page.getByRole('table', {name: 'Pieces', exact: true})],
      ['Fabric', button(page, 'My fabric')],
    ] as const) {
      const tab = sheets.getByRole('button', {name, exact: true});
      if ((await tab.getAttribute('aria-expanded')) !== 'true') await tab.tap();
      await what.scrollIntoViewIfNeeded();
      await expect.poll(() => what.isVisible(), {message: name}).toBe(true);
      const [{y, height}, below] = [
        await box(stage),
        await box(page.locator('sw-editor .workbench > .side')),
      ];
      expect(y, name).toBeGreaterThanOrEqual(0);
      expect(height, name).toBeGreaterThan(200);
      expect(below.y, name).toBeGreaterThanOrEqual(y + height);
      expect(await page.evaluate(() => document.documentElement.scrollHeight), name).toBe(844);
    }
    await sheets.getByRole('button', {name: 'Fabric'}).tap();
    // no panel is open
    await expect.poll(async () => (await box(stage)).height).toBeGreaterThan(440);
  },
);

it(
  'gives a finger something to meet, and fields that no phone zooms into',
  {tags: ['thorough']},
  async () => {
    const page = await openPage(phone);
    await solved(page);
    await page.locator('sw-seam-table tbody tr').first().waitFor({state: 'attached'});
    const small = async (): Promise<readonly string[]> =>
      page.evaluate(() => {
        const found: string[] = [];
        const visit = (root: Document | ShadowRoot): void => {
          for (const element of root.querySelectorAll('*')) {
            if (element.shadowRoot) visit(element.shadowRoot);
            if (!element.matches('button, select, input:is([type=number], [type=text])')) continue;
            const {width, height} = element.getBoundingClientRect();
            if (width === 0 || getComputedStyle(element).visibility === 'hidden') continue;
            const text = Number.parseFloat(getComputedStyle(element).fontSize);
            const isField = !element.matches('button');
            if (Math.min(width, height) < 43.5 || (isField && text < 16))
              found.push(
                `${element.getAttribute('aria-label') ?? element.textContent.trim()} ${width} ${height} ${text}`,
              );
          }
        };
        visit(document);
        return found;
      });
    for (const name of ['Pattern', 'Seams', 'Fabric']) {
      await page
        .getByRole('navigation', {name: 'Panels'})
        .getByRole('button', {name, exact: true})
        .tap();
      expect(await small(), name).toEqual([]);
    }
  },
);

it(
  'speaks of taps to who has a finger, and of clicks to who has a mouse',
  {tags: ['thorough']},
  async () => {
    for (const [options, word] of [
      [phone, 'Tap'],
      [{}, 'Click'],
    ] as const) {
      const page = await openPage(options);
      await solved(page);
      await button(page, 'Symmetric pair').click();
      await page
        .getByRole('status', {name: 'What to do next'})
        .filter({hasText: new RegExp(`^${word} the first`)})
        .waitFor();
    }
  },
);

it.each(sampleOf(2, [820, 1280, 1366, 1440]))('has one row at its head at %d px', async (width) => {
  const page = await openPage({viewport: {width, height: 800}});
  await solved(page);
  expect(await heightOfHead(page)).toBeLessThan(52);
  for (const name of ['Garment', 'Pattern', 'Both', 'Fabric layout'])
    expect(await button(page, name).innerText(), name).toBe(name);
});

it('says what the next step back takes back', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  await button(page, 'Woven shirt').click();
  await expect.poll(() => button(page, 'Undo').getAttribute('title')).toBe('Undo: greatest change');
  await page.getByLabel('Turn (degrees)').fill('15');
  await page.getByLabel('Turn (degrees)').press('Enter');
  await expect
    .poll(() => button(page, 'Undo').getAttribute('title'))
    .toBe('Undo: turn of the print');
  await button(page, 'Undo').click();
  await expect.poll(() => button(page, 'Undo').getAttribute('title')).toBe('Undo: greatest change');
  await expect
    .poll(() => button(page, 'Redo').getAttribute('title'))
    .toBe('Redo: turn of the print');
});

const designWith = async (page: Page, group: string): Promise<void> => {
  await expect.poll(async () => (await designOf(page)).print.group).toBe(group);
};

/** Positions of the pieces on the sheet, whichever part of it is shown. */
const places = (page: Page): Promise<unknown> =>
  page
    .locator('sw-pattern')
    .evaluate(({workbench}: PatternPane) =>
      workbench.sheet.scenes?.now.pieces.map(({offset}) => offset),
    );

it(
  'leaves pieces where they lie when the window or a panel changes, or a print is chosen',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const before = await places(page);
    await button(page, 'Enlarge').click();
    await page.setViewportSize({width: 700, height: 1000});
    await page.setViewportSize({width: 1900, height: 700});
    await printRadio(page, 'p4m').click();
    await solved(page);
    expect(await places(page)).toEqual(before);
  },
);

it('moves nothing on the page while another print is fitted', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  // records every position of the parts in all frames from now on
  await page.locator('sw-editor').evaluate((editor) => {
    const seen = new Set<string>();
    Reflect.set(globalThis, 'seen', seen);
    const look = (): void => {
      for (const name of ['sw-lens', 'sw-seam-table', 'sw-pattern', 'sw-progress', '.solving']) {
        const part = editor.shadowRoot?.querySelector(name)?.getBoundingClientRect();
        seen.add(`${name} ${part?.x} ${part?.y} ${name === 'sw-pattern' ? part?.height : ''}`);
      }
      requestAnimationFrame(look);
    };
    look();
  });
  for (const name of ['pmm', 'p6m']) {
    await printRadio(page, name).click();
    await designWith(page, name);
    await solved(page);
  }
  const seen = await page.evaluate(() => [...(Reflect.get(globalThis, 'seen') as Set<string>)]);
  expect(seen.length, seen.join('; ')).toBe(5);
});

it('leaves no gap below the figures once there is less to say', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  const part = page.locator('sw-headline');
  await part.getByText(/\d+ of \d+ visible seams match/).waitFor();
  const before = await box(part);
  await printRadio(page, 'p4m').click();
  await solved(page);
  expect((await box(part)).height).toBeGreaterThanOrEqual(before.height - 1);
  await expect
    .poll(() =>
      part.evaluate((element) => {
        const last = element.shadowRoot?.lastElementChild?.getBoundingClientRect();
        return element.getBoundingClientRect().bottom - (last?.bottom ?? NaN);
      }),
    )
    .toBeLessThan(24);
});

it('shows nothing but the cloth when asked, and all again', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  const name = page.locator('sw-pattern .stage span').filter({hasText: /^Front lower$/});
  await expect.poll(() => name.isVisible()).toBe(true);
  await button(page, 'Fabric only').click();
  await name.waitFor({state: 'hidden'});
  await page.getByRole('application', {name: 'Pattern'}).press('c');
  await name.waitFor();
});
