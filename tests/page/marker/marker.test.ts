/** The fabric layout on the page: packing, moving, turning, pinning, and messages. */
import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import type {LayPlan} from '@/model/result/marker-plan.js';
import {barriers} from '../../support/page/barriers.js';
import {button, saved, savedCut, smallest, solved, usePage} from '../../support/page/page.js';
import {
  bought,
  layoutOf,
  facts,
  laid,
  layTwice,
  pane,
  panel,
  rowOf,
  said,
  status,
} from '../../support/page/marker.js';
import {symmetricTee} from '../../support/page/symmetric-tee.js';

const openPage = usePage();

/** The announced position of the selected piece, without the distance it moved. */
const lies = async (page: Page): Promise<string | undefined> =>
  (await status(page))?.replace(/ \(moved .*\)$/, '');

const openLayout = async (options: Parameters<typeof openPage>[0] = {}): Promise<Page> =>
  layoutOf(await openPage({query: smallest, ...options}));

it(
  'lays the pieces in their print, says what there is to buy, and marks what is picked everywhere',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    await expect.poll(() => pane(page).locator('.piece').count()).toBe(4);
    await expect.poll(() => facts(page)).toMatch(/long, \d+ % used/);
    await expect.poll(() => facts(page)).toMatch(/Proven shortest|At best/);
    await expect.poll(() => facts(page)).toMatch(/The print costs/);
    await expect.poll(() => panel(page).locator('.widths tbody tr').count()).toBe(6);
    const place = /\d+(st|nd|rd|th) repeat from the left, \d+(st|nd|rd|th) from the start/;
    await expect.poll(() => rowOf(page, 'Back').textContent()).toMatch(place);
    await pane(page).locator('.piece', {hasText: 'Back'}).click();
    await expect
      .poll(() => status(page))
      .toMatch(/^Back: \d+(st|nd|rd|th) repeat from the left, [\d.]+ cm from the start/);
    const picked = () =>
      page.evaluate(() => {
        const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
        const selected = workbench?.selection.selected;
        const pattern = workbench?.solving.pattern;
        return selected?.kind === 'piece' ? pattern?.pieces[selected.piece]?.name : undefined;
      });
    await expect.poll(picked).toBe('back');
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const front =
        workbench?.solving.pattern?.pieces.findIndex(({name}) => name === 'front') ?? -1;
      workbench?.selection.select({kind: 'piece', piece: front});
    });
    await expect.poll(() => status(page)).toMatch(/^Front: /);
  },
);

it(
  'moves, turns and pins a piece by keys, and takes all of that back',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    await rowOf(page, 'Front').focus();
    await expect.poll(() => status(page)).toMatch(/^Front: /);
    const first = await status(page);
    await page.keyboard.press('ArrowUp');
    await expect.poll(() => status(page)).not.toBe(first);
    const second = await lies(page);
    await expect.poll(() => facts(page)).toContain('Moved by hand');
    await expect
      .poll(() => button(page, 'Undo').getAttribute('title'))
      .toBe('Undo: move on the fabric');
    await page.keyboard.press('r');
    await expect.poll(() => status(page)).toMatch(/turned 180°/);
    await page.keyboard.press('p');
    await expect.poll(() => status(page)).toMatch(/pinned$/);
    await expect
      .poll(() => rowOf(page, 'Front').getByRole('button').getAttribute('aria-pressed'))
      .toBe('true');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await expect.poll(() => status(page)).toBe(second);
    await page.keyboard.press('Control+z');
    await expect.poll(() => status(page)).toBe(first);
    await page.keyboard.press('Control+Shift+z');
    await expect.poll(() => status(page)).toBe(second);
  },
);

/** Returns whether the piece is in the visible part of the fabric. */
const isSeen = (page: Page, name: string): Promise<boolean> =>
  pane(page)
    .locator('.piece', {hasText: name})
    .locator('.line')
    .evaluate((line) => {
      const view = line.closest('.application')?.getBoundingClientRect();
      const {top, bottom, left, right} = line.getBoundingClientRect();
      const isWithin = (low: number, high: number, from = 0, to = 0): boolean =>
        (low >= from - 1 && high <= to + 1) || (low <= from && high >= to);
      return (
        isWithin(top, bottom, view?.top, view?.bottom) &&
        isWithin(left, right, view?.left, view?.right)
      );
    });

it(
  'tells how far a piece goes that finds no nearer place, and keeps it in sight',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout({viewport: {width: 1280, height: 600}});
    await rowOf(page, 'Front').focus();
    for (let k = 0; k < 4; k++) await page.keyboard.press('+');
    const where = String.raw`repeat from the left, [\d.]+ cm from the start`;
    await page.keyboard.press('ArrowUp');
    await expect
      .poll(() => status(page))
      .toMatch(
        new RegExp(`^Front: .* ${where} \\(moved [\\d.]+ cm, since nearer places are taken\\)$`),
      );
    await expect.poll(() => isSeen(page, 'Front')).toBe(true);
    // there is free room beyond all other pieces
    await page.keyboard.press('ArrowUp');
    await expect.poll(() => status(page)).toMatch(new RegExp(`^Front: .* ${where}$`));
    await expect.poll(() => isSeen(page, 'Front')).toBe(true);
    await page.keyboard.press('n');
    await expect.poll(() => status(page)).toMatch(/^Back: /);
    await expect.poll(() => isSeen(page, 'Back')).toBe(true);
  },
);

it(
  'turns what is pinned about where it lies, or leaves it there and says so',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    const start = async (): Promise<number> =>
      Number(/([\d.]+) cm from the start/.exec((await status(page)) ?? '')?.[1]);
    await rowOf(page, 'Front').focus();
    await page.keyboard.press('p');
    await expect.poll(() => status(page)).toMatch(/pinned$/);
    const before = await status(page);
    await page.keyboard.press('r');
    // the others are too close to it
    await expect
      .poll(() => status(page))
      .toMatch(/^Front cannot turn here: there is no free place for it within [\d.]+ cm\.$/);
    await rowOf(page, 'Back').focus();
    await rowOf(page, 'Front').focus();
    await expect.poll(() => status(page)).toBe(before);
    // there is free room beyond all other pieces
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    await expect.poll(() => status(page)).not.toBe(before);
    await expect.poll(start).toBeGreaterThan(60);
    const from = await start();
    await page.keyboard.press('r');
    await expect.poll(() => status(page)).toMatch(/turned 180°, pinned$/);
    expect(Math.abs((await start()) - from)).toBeLessThan(12);
  },
);

it('tells what pins cost apart from what the print does', {tags: ['thorough']}, async () => {
  const page = await openLayout();
  const cost = async (): Promise<string | undefined> =>
    /The print costs [\d.]+ cm/.exec(await facts(page))?.[0];
  await expect.poll(cost).toBeDefined();
  const before = await cost();
  await rowOf(page, 'Front').focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('p');
  await pane(page).getByRole('button', {name: 'Pack the rest'}).click();
  await laid(page);
  await expect.poll(() => facts(page)).toMatch(/Your pins cost [\d.]+ cm more/);
  await expect.poll(cost).toBe(before);
  const plan = JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;
  expect(plan.lengthCm).toBeGreaterThan(plan.unpinnedLengthCm ?? Infinity);
});

it(
  'lists its keys, and none of the pattern, which it takes the place of',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    const keys = page.locator('sw-key-map [popover]');
    await pane(page).locator('.application').focus();
    await page.keyboard.press('?');
    await keys.waitFor();
    const all = await keys.innerText();
    for (const [key, meaning] of [
      ['←  →  ↑  ↓', 'Move the piece to the next free place'],
      ['Alt ←  →  ↑  ↓', 'The same, even onto other pieces'],
      ['R', 'Turn'],
      ['P', 'Pin'],
      ['Delete', 'Remove from the fabric'],
      ['A', 'Pack the rest'],
      ['X', 'Mark a flaw'],
      ['Shift X', 'Add a flaw'],
      [
        'Shift ←  →  ↑  ↓',
        'Make the chosen flaw larger or smaller; arrows alone move it, Delete removes it',
      ],
      ['Shift N', 'Piece before'],
    ] as const) {
      const shown = keys.locator('dt', {hasText: new RegExp(`^${key}$`)});
      await expect.poll(() => shown.count(), {message: key}).toBe(1);
      await expect
        .poll(() => shown.locator('xpath=following-sibling::dd[1]').innerText())
        .toBe(meaning);
    }
    expect(all).not.toContain('Hold to see it without matching');
  },
);

it(
  'leads from a print of unknown size to where that is entered',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const print = workbench?.history.design?.print;
      if (print) workbench.history.change({print: {...print, unscaled: true}});
    });
    await expect.poll(() => said(page)).toMatch(/^The size of this print is unknown/);
    await pane(page).getByRole('button', {name: 'Enter its size'}).click();
    const width = page.locator('sw-repeat-fields').getByLabel('Repeat width (cm)');
    await expect.poll(() => width.evaluate((field) => field.matches(':focus'))).toBe(true);
    await page.keyboard.type('12');
    await page.keyboard.press('Enter');
    await laid(page);
  },
);

it('leaves what is pinned where it is when it packs the rest', {tags: ['thorough']}, async () => {
  const page = await openLayout();
  await rowOf(page, 'Back').focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('p');
  await expect.poll(() => status(page)).toMatch(/pinned$/);
  const place = await status(page);
  const pack = pane(page).getByRole('button', {name: 'Pack the rest'});
  await pack.click();
  await laid(page);
  await expect.poll(() => status(page)).toBe(place);
  await expect.poll(() => facts(page)).not.toContain('Moved by hand');
  await expect.poll(() => panel(page).locator('.error').count()).toBe(0);
  await expect.poll(() => button(page, 'Undo').getAttribute('title')).toBe('Undo: packing');
  await button(page, 'Undo').click();
  await expect.poll(() => facts(page)).toContain('Moved by hand');
});

it(
  'lets a piece be dragged: to the nearest free place, or with Alt on others, which is said',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    const dragged = async (to: string): Promise<void> => {
      const [from, onto] = await Promise.all(
        ['Front', to].map((name) => pane(page).locator('.piece', {hasText: name}).boundingBox()),
      );
      if (!from || !onto) throw new Error('There is no such piece.');
      await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2);
      await page.mouse.down();
      await page.mouse.move(onto.x + onto.width / 2, onto.y + onto.height / 2, {steps: 6});
    };
    const dots = () => pane(page).locator('.dots').last().getAttribute('d');
    await dragged('Back');
    await expect.poll(dots).toMatch(/^M/);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await expect.poll(() => pane(page).locator('.dots').count()).toBe(0);
    await expect.poll(() => button(page, 'Undo').getAttribute('title')).not.toContain('cloth');
    await dragged('Back');
    await page.mouse.up();
    await expect.poll(() => said(page)).toMatch(/^Front: /);
    await expect.poll(() => panel(page).locator('.error').count()).toBe(0);
    await page.keyboard.down('Alt');
    await dragged('Back');
    await expect.poll(() => said(page)).toMatch(/^Front overlaps .*Back/);
    await page.mouse.up();
    await page.keyboard.up('Alt');
    await expect
      .poll(() => panel(page).locator('.pieces').innerText())
      .toContain('Back overlaps Front');
    await expect.poll(() => bought(page)).toMatch(/^\d pieces cannot be cut where they lie$/);
    await expect.poll(() => pane(page).locator('.piece.bad', {hasText: 'Front'}).count()).toBe(1);
    await expect.poll(() => pane(page).locator('.piece.bad', {hasText: 'Back'}).count()).toBe(1);
  },
);

it('keeps pieces off a flaw that is drawn, until it is removed', {tags: ['thorough']}, async () => {
  const page = await openLayout();
  const places = () => panel(page).locator('.pieces').innerText();
  const before = await places();
  await pane(page).getByRole('button', {name: 'Mark a flaw'}).click();
  await expect.poll(() => said(page)).toMatch(/^Drag a box over the flaw/);
  const front = await pane(page).locator('.piece', {hasText: 'Front'}).boundingBox();
  if (!front) throw new Error('The front is not there.');
  const [x, y] = [front.x + front.width / 2, front.y + front.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 20, {steps: 3});
  await page.mouse.up();
  await expect.poll(() => panel(page).locator('.flaws li').count()).toBe(1);
  await laid(page);
  await expect.poll(places).not.toBe(before);
  await expect.poll(() => panel(page).locator('.error').count()).toBe(0);
  await panel(page)
    .getByRole('button', {name: /^Remove: Flaw 1/})
    .click();
  await expect.poll(() => panel(page).locator('.flaws li').count()).toBe(0);
});

it(
  'cuts as many garments as are asked for, with the allowances of cutting files',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    const allowances = () => panel(page).locator('.allowances').innerText();
    await expect.poll(allowances).toMatch(/^Seam allowance 1 cm, hems 3 cm/);
    const before = await bought(page);
    await layTwice(page);
    await expect.poll(() => rowOf(page, 'Front 2').count()).toBe(1);
    expect(await bought(page)).not.toBe(before);
    await panel(page).getByRole('button', {name: 'Change'}).click();
    const hem = panel(page).getByLabel('Hem (cm)');
    await hem.fill('5');
    await hem.press('Enter');
    await expect.poll(allowances).toMatch(/^Seam allowance 1 cm, hems 5 cm/);
    await laid(page);
    await page.keyboard.press('Control+Shift+S');
    const dialog = page.locator('sw-cut-dialog').getByRole('dialog');
    await expect.poll(() => dialog.getByLabel('Hem (cm)').inputValue()).toBe('5');
    await dialog.getByLabel('Seam allowance (cm)').fill('2');
    await dialog.getByLabel('Seam allowance (cm)').press('Enter');
    await savedCut(page, 'SVG');
    await expect.poll(allowances).toMatch(/^Seam allowance 2 cm, hems 5 cm/);
    await laid(page);
    await expect.poll(() => button(page, 'Undo').getAttribute('title')).toBe('Undo: cloth');
    await button(page, 'Undo').click();
    await expect.poll(allowances).toMatch(/^Seam allowance 1 cm, hems 5 cm/);
  },
);

it('takes a piece off the cloth, until it is packed again', {tags: ['thorough']}, async () => {
  const page = await openLayout();
  await rowOf(page, 'Sleeve left').focus();
  await page.keyboard.press('Delete');
  await expect.poll(() => pane(page).locator('.piece').count()).toBe(3);
  await expect
    .poll(() => status(page))
    .toBe('Sleeve left is off the fabric; Pack again brings it back.');
  await expect.poll(() => rowOf(page, 'Sleeve left').textContent()).toMatch(/not on the fabric/);
  // the length to buy is still unknown
  await expect.poll(() => bought(page)).toBe('1 piece does not lie yet');
  await expect.poll(() => facts(page)).toMatch(/^The others take [\d.]+ cm, \d+ % used/);
  expect(await facts(page)).not.toMatch(/Proven|At best/);
  const plan = JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;
  expect(plan).toMatchObject({proven: false, boundCm: 0, unplaced: [{piece: 'sleeve_left'}]});
  const svg = await saved(page, 'Save fabric layout (SVG)');
  expect(svg).toContain('of the placed pieces');
  expect(svg).not.toMatch(/>(Buy|proven)/);
  for (const name of ['Front', 'Back', 'Sleeve right']) {
    await rowOf(page, name).focus();
    await page.keyboard.press('Delete');
  }
  await expect.poll(() => bought(page)).toBe('4 pieces do not lie yet');
  await expect
    .poll(() => button(page, 'Undo').getAttribute('title'))
    .toBe('Undo: remove from the fabric');
  await pane(page).getByRole('button', {name: 'Pack again'}).click();
  await laid(page);
  await expect.poll(() => pane(page).locator('.piece').count()).toBe(4);
});

it(
  'says that the plan is of the design before, and lays the new one',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      workbench?.prefer({solveAsIGo: false});
      const print = workbench?.history.design?.print;
      if (print)
        workbench.history.change({
          print: {...print, size: {...print.size, width: 1.1 * print.size.width}},
        });
    });
    await expect
      .poll(() => said(page))
      .toBe('The design has changed: this is the layout from before.');
    await expect.poll(() => pane(page).locator('.stage.stale').count()).toBe(1);
    await expect
      .poll(() => pane(page).getByRole('button', {name: 'Pack again'}).isDisabled())
      .toBe(true);
    await button(page, 'Match print').click();
    await laid(page);
    await expect.poll(() => pane(page).locator('.stage.stale').count()).toBe(0);
    // results for the earlier design are reused
    await button(page, 'Undo').click();
    await expect.poll(() => said(page)).not.toMatch(/changed/);
  },
);

it(
  'says of fabric that is too narrow which piece is too wide, and remembers what the fabric is like',
  {tags: ['thorough']},
  async () => {
    const page = await openLayout();
    const width = panel(page).locator('select.width');
    await width.selectOption('150');
    await laid(page);
    await width.selectOption('other');
    const own = panel(page).getByLabel('Fabric width (cm)');
    await own.fill('30');
    await own.press('Enter');
    await expect.poll(() => said(page), {timeout: 30_000}).toMatch(/wide/);
    await expect.poll(() => pane(page).getByRole('alert').count()).toBe(1);
    await expect.poll(() => pane(page).locator('.piece').count()).toBe(0);
    await button(page, 'Undo').click();
    await expect.poll(() => bought(page)).toMatch(/^Buy \d/);
    await expect.poll(() => width.inputValue()).toBe('150');
    await page.locator('sw-editor .views').getByRole('button', {name: 'Pattern'}).click();
    await page.reload();
    await solved(page);
    await page.locator('sw-editor .views').getByRole('button', {name: 'Fabric layout'}).click();
    await expect.poll(() => width.inputValue()).toBe('150');
  },
);

it('gives the plan away as it lies, and nothing while pieces lie on each other', async () => {
  const page = await openLayout();
  const plan = JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;
  expect(plan).toMatchObject({format: 'seamwise-layplan/1', widthCm: 140});
  expect(plan.placements).toHaveLength(4);
  await rowOf(page, 'Front').focus();
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => facts(page)).toContain('Moved by hand');
  const moved = JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;
  const of = ({placements}: LayPlan) => placements.find(({piece}) => piece === 'front');
  expect(of(moved)?.angle).toBe(of(plan)?.angle);
  expect(of(moved)?.translation[1]).toBeGreaterThan(of(plan)?.translation[1] ?? Infinity);
  expect(moved.lengthCm).toBeCloseTo(
    Math.max(...moved.placements.flatMap(({cut}) => cut.map(([, y]) => y))),
    6,
  );
});

it.each([
  ['light', 1280],
  ['dark', 390],
] as const)(
  'keeps nobody out in %s, %i pixels wide',
  {tags: ['thorough']},
  async (colorScheme, width) => {
    const page = await openLayout({colorScheme, viewport: {width, height: 800}});
    await rowOf(page, 'Front').focus();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('p');
    await expect.poll(() => status(page)).toMatch(/pinned$/);
    expect(await barriers(page, ['minor', 'moderate', 'serious', 'critical'])).toEqual([]);
  },
);

it(
  'says why nothing is laid where the print cannot keep what is asked of it, and leads out',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const print = workbench?.history.design?.print;
      if (print) workbench.history.change({print: {...print, group: 'p2'}});
    });
    await page.locator('sw-editor .views').getByRole('button', {name: 'Fabric layout'}).click();
    const why = panel(page).getByRole('alert');
    await why.filter({hasText: 'p2 has neither mirrors nor glides'}).waitFor();
    await expect.poll(() => said(page)).toBe('Not matched');
    await button(page, 'Remove what the print cannot keep').click();
    await laid(page);
    await expect.poll(() => why.count()).toBe(0);
  },
);
