/** The first visit: a garment before and after, and three hints. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {askedSymmetries} from '@/model/design/design.js';
import {designOf} from '../../support/page/design.js';
import {button, solved, usePage} from '../../support/page/page.js';
import {frames} from '../../support/page/waiting.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();
const phone = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true};

const showsDraft = (page: Page): Promise<boolean> =>
  page.evaluate(
    () => document.querySelector<SeamwisePage>('seamwise-page')?.pattern?.showsDraft ?? false,
  );
const hint = (page: Page) => page.getByRole('note', {name: /^Hint/});
const dismiss = (page: Page) => hint(page).getByRole('button', {name: 'Dismiss'});
const stage = (page: Page) => page.locator('sw-pattern .stage').boundingBox();

/** Counts the frames that show the draft, from now until the answer. */
async function framesWithDraft(page: Page): Promise<number> {
  const seen = await page.evaluateHandle(() => {
    const seen = {drafts: 0};
    const look = (): void => {
      if (document.querySelector<SeamwisePage>('seamwise-page')?.pattern?.showsDraft) seen.drafts++;
      requestAnimationFrame(look);
    };
    look();
    return seen;
  });
  await solved(page);
  await frames(page);
  return seen.evaluate(({drafts}) => drafts);
}

/** Opens the page as on a first visit, and waits until the draft is shown. */
async function openDraft(): Promise<Page> {
  const page = await openPage({isFirst: true});
  await expect.poll(() => showsDraft(page), {timeout: 30_000, interval: 20}).toBe(true);
  return page;
}

it(
  'shows a symmetric garment as drafted and then as it meets, on the first visit and never again',
  {tags: ['thorough']},
  async () => {
    const page = await openDraft();
    const design = await designOf(page);
    const {garment} = design;
    expect(garment.sample?.style).toBe('princess-dress');
    expect(askedSymmetries(design).map(({kind}) => kind)).toEqual(
      expect.arrayContaining(['piece', 'pair']),
    );
    await solved(page);
    // the symmetries already apply
    await expect.poll(() => button(page, 'Accept all symmetries').count()).toBe(0);
    await expect.poll(() => showsDraft(page), {timeout: 30_000}).toBe(false);
    for (const again of [page, await openPage({beside: page, isFirst: true})]) {
      if (again === page) await page.reload();
      expect(await framesWithDraft(again)).toBe(0);
    }
  },
);

it(
  'is in the way of nobody: the first key or press shows the answer',
  {tags: ['thorough']},
  async () => {
    const page = await openDraft();
    await page.keyboard.press('Shift');
    expect(await showsDraft(page)).toBe(false);
    const other = await openDraft();
    await button(other, 'Move print').click();
    expect(await showsDraft(other)).toBe(false);
    await expect.poll(() => button(other, 'Move print').getAttribute('aria-pressed')).toBe('true');
  },
);

it('shows no draft to who wants no motion', {tags: ['thorough']}, async () => {
  const page = await openPage({isFirst: true, reducedMotion: 'reduce'});
  expect(await framesWithDraft(page)).toBe(0);
  expect((await designOf(page)).garment.sample?.style).toBe('princess-dress');
});

it('gives three hints, one at a time, that move nothing and do not come back', async () => {
  const page = await openPage({isFirst: true, ...phone});
  await solved(page);
  await hint(page).waitFor();
  const room = await stage(page);
  const [below, box] = [(room?.y ?? NaN) + (room?.height ?? NaN), await hint(page).boundingBox()];
  expect(box?.y).toBeGreaterThanOrEqual(below); // it covers no piece
  for (const words of [/another print/, /before and after/, /Press a seam/]) {
    await expect.poll(() => hint(page).textContent()).toMatch(words);
    const fits = await hint(page).evaluate(
      (note) => note.scrollHeight <= note.clientHeight && note.scrollWidth <= note.clientWidth,
    );
    expect(fits, `${words}`).toBe(true);
    await dismiss(page).tap();
    await hint(page).getByText(words).waitFor({state: 'hidden'});
    expect(await stage(page)).toEqual(room);
  }
  await expect.poll(() => hint(page).count()).toBe(0);
  const later = await openPage({beside: page, isFirst: true});
  await solved(later);
  await expect.poll(() => hint(later).count()).toBe(0);
});

it(
  'needs no hint for what somebody does by themselves, and remembers the others',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({isFirst: true});
    await solved(page);
    await hint(page).getByText('another print').waitFor();
    await button(page, 'Before and after').click();
    await button(page, 'Before and after').click();
    await page.getByRole('radio', {name: /^pmm,/}).press('Space');
    await hint(page).getByText('Press a seam').waitFor(); // the hint before it is done
    const later = await openPage({beside: page, isFirst: true});
    await solved(later);
    await hint(later).getByText('Press a seam').waitFor();
    await later.getByRole('application', {name: 'Pattern'}).press('1');
    await expect.poll(() => hint(later).count()).toBe(0);
  },
);
