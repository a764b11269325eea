/** Cutting sheets: the dialog's preview and the files. */
import type {Locator, Page} from 'playwright-core';
import {readGarment, type GarmentCodeSpecification, type SolveResult} from 'seamwise/node';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {cutSheet} from '@/cutting/lay-sheet.js';
import {sheetDxf} from '@/cutting/out/sheet-dxf.js';
import {decidedOf, printOf} from '@/model/design/design.js';
import {garmentTitle, panelMarks} from '@/model/garment/panel-marks.js';
import {barriers} from '../../support/page/barriers.js';
import {designOf} from '../../support/page/design.js';
import {choose, jsonFile, squares} from '../../support/page/files.js';
import {saved, savedCut, solved, usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const dialogOf = (page: Page): Locator => page.locator('sw-cut-dialog').getByRole('dialog');

async function squaresShown(page: Page): Promise<void> {
  await solved(page);
  await choose(page, 'My pattern', jsonFile('squares.json', squares(40)));
  await page.waitForFunction(() => document.title.startsWith('squares'));
  await solved(page);
}

const pagesIn = (pdf: string): number => pdf.match(/\/Type\/Page\//g)?.length ?? 0;

it(
  'tells how many pages a PDF will have, on any paper, and makes as many',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await squaresShown(page);
    await page.keyboard.press('Control+Shift+S');
    const dialog = dialogOf(page);
    const caption = dialog.locator('figcaption');
    for (const [paper, size] of [
      ['a4', /29\.7 cm/],
      ['a0', /84\.1 cm/],
    ] as const) {
      await dialog.getByLabel('Paper').selectOption(paper);
      await caption.filter({hasText: size}).waitFor();
      const told = Number.parseInt((await caption.textContent()) ?? '', 10);
      // an image of each page, before any is created
      await expect.poll(() => dialog.locator('.map .page').count()).toBe(told);
      const pdf = await savedCut(page, 'PDF');
      expect(pdf.startsWith('%PDF-')).toBe(true);
      expect(pagesIn(pdf)).toBe(told);
      await page.keyboard.press('Control+Shift+S');
    }
    expect(await barriers(page)).toEqual([]);
  },
);

it('writes in its worker what Node writes of the same answer', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await squaresShown(page);
  const result = JSON.parse(await saved(page, 'Save result')) as SolveResult;
  const dxf = await savedCut(page, 'DXF');
  const design = await designOf(page);
  const garment = await readGarment(design.garment.text);
  const sheet = cutSheet(
    result,
    printOf(design.print),
    {...garmentTitle(garment, 'squares.json'), panels: panelMarks(garment, decidedOf(design))},
    {allowanceCm: 1, hemCm: 3, units: 'cm', locale: 'en'},
  );
  expect(dxf).toBe(sheetDxf(sheet));
});

it(
  'shows what it will save: waits for the answer, and follows the next one',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await squaresShown(page);
    await page.keyboard.press('Control+Shift+S');
    const dialog = dialogOf(page);
    const [caption, save] = [dialog.locator('figcaption'), dialog.getByText('Save PDF')];
    await caption.filter({hasText: /page/}).waitFor();
    const drawn = dialog.locator('.map .pieces');
    const before = await drawn.getAttribute('d');
    const open = (side: number): Promise<void> =>
      page.locator('seamwise-page').evaluate(
        async (element, text) => {
          const {workbench} = element as SeamwisePage;
          workbench.prefer({solveAsIGo: false});
          await workbench.open({name: 'others.json', text});
        },
        JSON.stringify(squares(side)),
      );
    await open(60);
    await caption
      .filter({hasText: 'Match the print first; then the pattern can be cut.'})
      .waitFor();
    await expect
      .poll(async () => [await save.isDisabled(), await drawn.count()])
      .toEqual([true, 0]);
    await page.locator('seamwise-page').evaluate((element) => {
      (element as SeamwisePage).workbench.solving.align();
    });
    await dialog.getByText('The match has changed; this is the new one.').waitFor();
    await caption.filter({hasText: /page/}).waitFor();
    await expect.poll(() => save.isDisabled()).toBe(false);
    await expect.poll(() => drawn.getAttribute('d')).not.toBe(before);
    await page.keyboard.press('Escape');

    // opened before there is an answer, it waits for one
    await open(50);
    await page.keyboard.press('Control+Shift+S');
    await caption.filter({hasText: 'There is no answer to cut'}).waitFor();
  },
);

it('says that the pattern has its own allowances', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await squaresShown(page);
  const garment = squares(40) as GarmentCodeSpecification;
  for (const panel of Object.values(garment.pattern.panels)) {
    for (const edge of panel.edges) Object.assign(edge, {allowance: 1.5});
  }
  const own = {...garment, format: 'seamwise-garment/1'};
  await choose(page, 'My pattern', jsonFile('own.json', own));
  await page.waitForFunction(() => document.title.startsWith('own'));
  await solved(page);
  await page.keyboard.press('Control+Shift+S');
  await dialogOf(page)
    .getByText('The pattern has its own allowances on all edges.', {exact: true})
    .waitFor();
});

it('shows the pieces in their print on the map, and forgets what was changed and not saved', async () => {
  const page = await openPage();
  await squaresShown(page);
  await page.keyboard.press('Control+Shift+S');
  const dialog = dialogOf(page);
  const inPrint = () => dialog.locator('.map path.print').count();
  await expect.poll(inPrint).toBe(2);
  await expect.poll(() => dialog.locator('.map pattern').count()).toBe(2);
  await dialog.getByText('Pale', {exact: true}).click();
  await expect.poll(inPrint).toBe(4); // each beneath a layer of white
  await dialog.getByText('Lines only', {exact: true}).click();
  await expect.poll(inPrint).toBe(0);
  const hem = dialog.getByLabel('Hem (cm)');
  await hem.fill('6');
  await hem.press('Enter');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+Shift+S');
  await expect.poll(() => hem.inputValue()).toBe('3');
});

it(
  'proposes the paper of its user, and remembers what was saved',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await squaresShown(page);
    const paper = dialogOf(page).getByLabel('Paper');
    const opened = async (): Promise<string> => {
      await page.keyboard.press('Control+Shift+S');
      await paper.waitFor(); // a closed dialog keeps its fields
      return paper.inputValue();
    };
    expect(await opened()).toBe('a4');
    await page.keyboard.press('Escape');
    await page.locator('seamwise-page').evaluate((element) => {
      (element as SeamwisePage).workbench.prefer({units: 'inch'});
    });
    expect(await opened()).toBe('letter');
    await paper.selectOption('projector');
    await savedCut(page, 'PDF');
    expect(await opened()).toBe('projector');
  },
);

it(
  'says of a print of unknown size nothing but that, and leads to where it is entered',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await squaresShown(page);
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const print = workbench?.history.design?.print;
      if (print) workbench.history.change({print: {...print, unscaled: true}});
    });
    await solved(page);
    await page.keyboard.press('Control+Shift+S');
    const dialog = dialogOf(page);
    const save = dialog.getByRole('button', {name: 'Save PDF'});
    await expect
      .poll(() => dialog.locator('figcaption').innerText())
      .toMatch(/^The size of this print is unknown: .*\s+Enter its size$/);
    await expect.poll(() => save.isDisabled()).toBe(true);
    // neither another file type nor another paper changes that
    await dialog.getByLabel('Paper').selectOption('a0');
    await expect.poll(() => dialog.getByText(/unknown/).count()).toBe(1);
    await expect.poll(() => dialog.getByText(/Laying the pieces out/).count()).toBe(0);
    expect(await barriers(page)).toEqual([]);
    await dialog.getByRole('button', {name: 'Enter its size'}).click();
    await expect.poll(() => dialog.isVisible()).toBe(false);
    const width = page.locator('sw-repeat-fields').getByLabel('Repeat width (cm)');
    await expect.poll(() => width.evaluate((field) => field.matches(':focus'))).toBe(true);
    await page.keyboard.type('12');
    await page.keyboard.press('Enter');
    await solved(page);
    await page.keyboard.press('Control+Shift+S');
    await expect.poll(() => save.isEnabled()).toBe(true);
    await expect.poll(() => dialog.locator('figcaption').innerText()).toMatch(/page/);
  },
);
