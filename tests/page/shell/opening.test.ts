/** The page after opening, and a user's first actions. */
import {expect, it} from 'vitest';

import {button, cancelNext, saved, smallest, solved, usePage} from '../../support/page/page.js';
import {printRadio} from '../../support/page/prints.js';

const openPage = usePage();

it(
  'shows a sample garment, and its live answer without being asked',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await page.getByRole('application', {name: 'Pattern'}).waitFor();
    await solved(page);
    const result = page.getByRole('status', {name: 'Result', exact: true});
    await expect
      .poll(() => result.textContent())
      .toMatch(/\d+ of \d+ visible seams match\s+The print \w+ at the .+\./);
  },
);

it('names all that tests and screen readers rely on', async () => {
  const page = await openPage();
  await solved(page);
  for (const name of [
    ...['Undo', 'Redo', 'My pattern', 'My fabric', 'Save …'],
    ...['Cut pattern', 'Garment', 'Pattern', 'Both', 'Fabric layout'],
    ...['Symmetric piece', 'Symmetric pair', 'Move print', 'Accept all symmetries'],
  ]) {
    await expect.poll(() => button(page, name).count(), {message: name}).toBe(1);
  }
  // no buttons for actions that are automatic or already over
  for (const name of ['Match print', 'Cancel'])
    await expect.poll(() => button(page, name).count(), {message: name}).toBe(0);
  await button(page, 'Save …').click();
  for (const name of ['Save project', 'Save result', 'Save picture', 'Copy link'])
    await expect.poll(() => button(page, name).count(), {message: name}).toBe(1);
  await page.keyboard.press('Escape');
  for (const name of ['Pieces', 'Seams'])
    await expect
      .poll(() => page.getByRole('table', {name, exact: true}).count(), {message: name})
      .toBe(1);
  for (const name of ['Repeat width (cm)', 'Repeat height (cm)', 'Outlines may change by (mm)'])
    await expect
      .poll(() => page.getByRole('spinbutton', {name, exact: true}).count(), {message: name})
      .toBe(1);
  await expect
    .poll(() => page.getByRole('radiogroup', {name: 'Symmetry of the print'}).count())
    .toBe(1);
});

it('cancels in the same task, and aligns again when asked', async () => {
  const page = await openPage({query: smallest});
  await solved(page);
  const cancelled = await cancelNext(page);
  await page.getByLabel('Garment', {exact: true}).selectOption('princess-dress');
  expect(await cancelled()).toMatch(/^Cancelled/);
  await button(page, 'Match print').click();
  await solved(page);
});

it(
  'gives one final answer to three quick changes, that of the last',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    for (const name of ['pgg', 'cm', 'p6m']) await printRadio(page, name).click();
    await solved(page);
    const result = JSON.parse(await saved(page, 'Save result')) as {print: {group: string}};
    expect(result.print.group).toBe('p6m');
  },
);

it(
  'undoes to the start and redoes to the end, with identical answers',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const results = [await saved(page, 'Save result')];
    await button(page, 'Accept all symmetries').click();
    await solved(page);
    results.push(await saved(page, 'Save result'));
    await printRadio(page, 'cmm').click();
    await solved(page);
    results.push(await saved(page, 'Save result'));
    for (const k of [1, 0]) {
      await button(page, 'Undo').click();
      await solved(page);
      expect((await saved(page, 'Save result')) === results[k]).toBe(true);
    }
    await expect.poll(() => button(page, 'Undo').isDisabled()).toBe(true);
    for (const k of [1, 2]) {
      await button(page, 'Redo').click();
      await solved(page);
      expect((await saved(page, 'Save result')) === results[k]).toBe(true);
    }
    await expect.poll(() => button(page, 'Redo').isDisabled()).toBe(true);
  },
);
