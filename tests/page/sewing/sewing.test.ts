/** A garment without seams, sewn by keys alone and by clicks. */
import {readFileSync} from 'node:fs';

import type {Locator, Page} from 'playwright-core';
import type {GarmentCodeSpecification, StitchEnd} from 'seamwise/node';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import type {PatternPane} from '@/editor/pattern/pattern-pane.js';
import type {GarmentDocument} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';
import {barriers} from '../../support/page/barriers.js';
import {choose, jsonFile} from '../../support/page/files.js';
import {button, smallest, solved, usePage} from '../../support/page/page.js';
import {shirtSpecification} from '../../support/garments/shirts.js';

vi.setConfig({testTimeout: 300_000}); // a busy machine is slow at everything

const openPage = usePage();

type Tee = GarmentCodeSpecification & {readonly seams?: unknown};
const tee = JSON.parse(readFileSync('public/garments/tee-m.json', 'utf8')) as Tee;
const {stitches = [], panels} = tee.pattern;
const names = Object.keys(panels);
const stripped = {...tee, seams: [], pattern: {...tee.pattern, stitches: []}};
/** The garment without seams, as before sewing by hand. */
const plain = {...tee, seams: []};

const pattern = (page: Page): Locator => page.getByRole('application', {name: 'Pattern'});
const hint = (page: Page): Locator => page.getByRole('status', {name: 'What to do next'});
const says = (page: Page, text: RegExp): Promise<void> =>
  hint(page).filter({hasText: text}).waitFor({timeout: 60_000});

/** Leaves the questions that a garment without seams begins with. */
async function byHand(page: Page): Promise<void> {
  await page.getByRole('button', {name: 'Suggest seams', pressed: true}).click();
  await says(page, /^(Choose|Tap) an edge/);
}

const garmentOf = (page: Page): Promise<GarmentDocument> =>
  page.locator('seamwise-page').evaluate((element) => {
    const {garment} = (element as SeamwisePage).workbench.solving;
    if (!garment) throw new Error('There is no garment.');
    return garment;
  });

/** Mismatch of the answer to the current problem. */
async function fitOf(page: Page): Promise<number> {
  await page.waitForFunction(
    () =>
      document.querySelector<SeamwisePage>('seamwise-page')?.workbench.solving.state.kind ===
      'done',
    undefined,
    {timeout: 120_000},
  );
  return page
    .locator('seamwise-page')
    .evaluate((element) => (element as SeamwisePage).workbench.solving.result?.metrics.fit ?? NaN);
}

const nameOf = ({panel, edge}: StitchEnd): string => `${panel} ${edge}`;

/** Pairs of sewn edges, in either order. */
const seamsOf = ({pieces, seams}: GarmentDocument): readonly string[] =>
  seams
    .map(({a, b, sameDirection}) => {
      const [one, other] = [a, b].map(({piece, edge}) => `${pieces[piece]?.name ?? ''} ${edge}`);
      return `${[one, other].sort().join(' - ')}${sameDirection ? ', same way' : ''}`;
    })
    .sort();
const wanted = stitches
  .map(([a, b, way]) => `${[nameOf(a), nameOf(b)].sort().join(' - ')}${way ? ', same way' : ''}`)
  .sort();

/** The number of an edge in the order of the Tab key. */
const orderOf = ({panel, edge}: StitchEnd): number =>
  names
    .slice(0, names.indexOf(panel))
    .reduce((sum, name) => sum + (panels[name]?.edges.length ?? 0), edge);

async function tab(page: Page, from: number, to: number): Promise<void> {
  for (let k = from; k < to; k++) await page.keyboard.press('Tab');
  for (let k = to; k < from; k++) await page.keyboard.press('Shift+Tab');
}

it(
  'is sewn by keys alone, and fits as the one whose seams it had',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({query: smallest});
    await solved(page);
    await choose(page, 'My pattern', jsonFile('tee.json', stripped));
    await byHand(page);
    await expect.poll(() => button(page, 'Sew').getAttribute('aria-pressed')).toBe('true');
    await pattern(page).focus();
    await page.keyboard.press('Tab');
    await says(page, /^Hem of Front, 56 cm/);
    await expect.poll(() => pattern(page).getAttribute('aria-activedescendant')).toBe('edge-0-0');
    let present = 0;
    const count: number[] = [];
    for (const [a, b] of stitches) {
      const {pieces, seams} = await garmentOf(page);
      count.push(seams.length);
      const isSewn = seams.some(({a: {piece, edge}, b: end}) =>
        [{piece, edge}, end].some(
          (one) => `${pieces[one.piece]?.name ?? ''} ${one.edge}` === nameOf(a),
        ),
      );
      if (isSewn) continue; // sewn as a mirror image
      await tab(page, present, orderOf(a));
      await page.keyboard.press('Enter');
      await says(page, /Now choose the edge to sew it to/);
      await tab(page, orderOf(a), orderOf(b));
      await says(page, /: press Enter\.$/);
      await page.keyboard.press('Enter');
      await says(page, /Sewn to/);
      present = orderOf(a);
    }
    expect(seamsOf(await garmentOf(page))).toEqual(wanted);
    expect(new Set(count).size).toBeLessThan(stitches.length); // mirror images were sewn with them
    await page.getByText('20 of 26 edges sewn, 0 open').waitFor();
    const fit = await fitOf(page);

    await page.keyboard.press('u');
    expect((await garmentOf(page)).seams.length).toBeLessThan(stitches.length);
    await expect.poll(() => button(page, 'Redo').getAttribute('title')).toBe('Redo: seams');
    await page.keyboard.press('Control+Shift+z');
    await expect.poll(async () => seamsOf(await garmentOf(page))).toEqual(wanted);

    await choose(page, 'My pattern', jsonFile('tee-sewn.json', plain));
    await expect.poll(async () => (await garmentOf(page)).seams.length).toBe(stitches.length);
    const sewn = await fitOf(page);
    expect(Math.abs(fit - sewn)).toBeLessThan(0.02 * sewn);
  },
);

/** A point on an edge of a piece on the screen. */
async function placeOn(page: Page, name: string, edge: number, share = 0.5): Promise<Point> {
  const at = await page.locator('sw-pattern').evaluate(
    (pane: PatternPane, [wantedName, number, part]): Point | null => {
      const piece = pane.workbench.sheet.scenes?.now.pieces.find((one) => one.name === wantedName);
      const stage = pane.shadowRoot?.querySelector('.stage')?.getBoundingClientRect();
      const numbers = piece?.outline.flatMap((v, k) => (piece.edges?.[k] === number ? [v] : []));
      const middle = piece?.points[numbers?.[Math.round(part * (numbers.length - 1))] ?? -1];
      if (!pane.view || !piece || !middle || !stage) return null;
      const [x, y] = pane.view.screenOf([middle[0] + piece.offset[0], middle[1] + piece.offset[1]]);
      return [stage.left + x, stage.top + y];
    },
    [name, edge, share] as const,
  );
  if (!at) throw new Error(`Edge ${edge} of ${name} is not on the screen.`);
  return at;
}

async function click(page: Page, name: string, edge: number, keys: 'Shift'[] = []): Promise<void> {
  const [x, y] = await placeOn(page, name, edge);
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.click(x, y);
  for (const key of keys) await page.keyboard.up(key);
}

it('is sewn by clicks, several edges as one side, split, left open and taken apart', async () => {
  const page = await openPage({query: smallest});
  await solved(page);
  await choose(page, 'My pattern', jsonFile('tee.json', stripped));
  await byHand(page);
  expect(await barriers(page)).toEqual([]);

  await click(page, 'front', 3);
  await says(page, /^Shoulder left of Front/);
  await click(page, 'back', 5);
  await says(page, /^Shoulder left of Front.*Sewn to shoulder left of Back/);
  await page.getByText('4 of 26 edges sewn').waitFor(); // the other shoulder was sewn with it
  await button(page, 'Turn').click();
  await expect
    .poll(async () => (await garmentOf(page)).seams.map(({sameDirection}) => sameDirection))
    .toEqual([true, true]);
  await button(page, 'Unpick').click();
  await page.getByText('0 of 26 edges sewn').waitFor();

  await click(page, 'front', 0);
  await button(page, 'Stays open').click();
  await page.getByText('0 of 26 edges sewn, 1 open').waitFor();

  await click(page, 'sleeve_left', 2);
  await click(page, 'sleeve_left', 3, ['Shift']);
  await says(page, /^2 edges from cap back of Sleeve left/);
  await click(page, 'front', 2);
  await says(page, /longer.*gathered/);
  expect(await barriers(page)).toEqual([]);
  await button(page, 'Yes').click();
  const {seams, pieces} = await garmentOf(page);
  expect(seams.length).toBe(4); // both sleeves, of two edges each
  expect(pieces[0]?.outline.length).toBe(10);
  await page.keyboard.press('Control+z');
  await page.getByText('0 of 26 edges sewn, 1 open').waitFor();

  await click(page, 'back', 0);
  const [from, to] = [await placeOn(page, 'back', 0, 1), await placeOn(page, 'back', 0, 0.4)];
  await page.mouse.move(from[0], from[1]);
  await page.mouse.down();
  await page.mouse.move(to[0], to[1], {steps: 4});
  await page.mouse.up();
  await says(page, /^Hem 1 of Back, 2[012][.\d]* cm/);
  await page.getByText('0 of 27 edges sewn, 1 open').waitFor();
  await page.keyboard.press('Control+z');
  await page.getByText('0 of 26 edges sewn, 1 open').waitFor();

  await page.getByTitle('Suggest seams (Q)').click();
  await says(page, /\?/);
  await button(page, 'Yes').click();
  await expect.poll(async () => (await garmentOf(page)).seams.length).toBeGreaterThan(0);
  await button(page, 'No').first().click();
  expect(await barriers(page)).toEqual([]);
});

/** Positions of all pieces on the screen. */
const places = (page: Page): Promise<readonly string[]> =>
  page.locator('sw-pattern').evaluate((pane: PatternPane) => {
    const stage = pane.shadowRoot?.querySelector('.stage')?.getBoundingClientRect();
    const pieces = pane.workbench.sheet.scenes?.now.pieces ?? [];
    return pieces.map(({name, offset: [x, y]}) => {
      const [left = NaN, top = NaN] = pane.view?.screenOf([x, y]) ?? [];
      return `${name} ${Math.round(left + (stage?.left ?? NaN))} ${Math.round(top + (stage?.top ?? NaN))}`;
    });
  });

const sides = async (page: Page): Promise<readonly string[]> => seamsOf(await garmentOf(page));

it('sets sleeves in by keys alone, without a piece that moves', {tags: ['thorough']}, async () => {
  const page = await openPage({query: smallest});
  await solved(page);
  await choose(page, 'My pattern', jsonFile('shirt.json', shirtSpecification()));
  await byHand(page);
  await page.locator('sw-pattern').evaluate((pane: PatternPane) => pane.updateComplete);
  const before = await places(page);

  // keys also work while a button has the focus
  await button(page, 'Undo').focus();
  await page.keyboard.press('q');
  await says(page, /\?/);
  await page.keyboard.press('a');
  await expect
    .poll(() => sides(page))
    .toEqual([...['back 1 - front 7', 'back 3 - front 5', 'back 5 - front 3', 'back 7 - front 1']]);
  await says(page, /\?/);
  await page.keyboard.press('q');

  // a hem has no candidates, and a key for another answer does not sew it
  await pattern(page).focus();
  await page.keyboard.press('Tab');
  await says(page, /^Bottom of Front.*No similar edge found/);
  expect(await places(page)).toEqual(before);
  await page.keyboard.press('h');
  await page.getByText('8 of 24 edges sewn, 1 open').waitFor();

  // armholes first: Shift extends the selection over the shoulder
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await says(page, /^Right.*of Front, 25/);
  await page.keyboard.press('Shift+ArrowRight');
  await says(page, /of Front with .*of Back, 50\.\d cm/);
  await page.keyboard.press('Enter');
  await says(page, /Shift ← → joins edges/);
  await page.keyboard.press('ArrowDown'); // Back
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await says(page, /Sew to top of Sleeve, .*press Enter/i);
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await sides(page)).length).toBe(6);
  expect(await sides(page)).toEqual(
    expect.arrayContaining(['front 2 - sleeve 3', 'back 6 - sleeve 2']),
  );
  expect(await places(page)).toEqual(before);
  await page.keyboard.press('u');
  await expect.poll(async () => (await sides(page)).length).toBe(4);

  // cap first, with the front armhole alone: a question suggests the back one as well
  await pattern(page).focus();
  await page.keyboard.press('Tab');
  for (let k = 0; k < 2; k++) await page.keyboard.press('ArrowDown');
  for (let k = 0; k < 2; k++) await page.keyboard.press('ArrowRight');
  await says(page, /^Top of Sleeve.*Best match: .* with .*Press 1 to sew/);
  await page.keyboard.press('Enter');
  for (let k = 0; k < 2; k++) await page.keyboard.press('ArrowUp');
  for (let k = 0; k < 2; k++) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await says(page, /longer.*gathered.*Is it .* instead/);
  await page.keyboard.press('m');
  await expect.poll(async () => (await sides(page)).length).toBe(6);
  expect(await sides(page)).toEqual(
    expect.arrayContaining(['front 2 - sleeve 3', 'back 6 - sleeve 2']),
  );
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');

  // the other sleeve, by its best match; its own underarm closes each
  await page.keyboard.press('Escape');
  await page.keyboard.press('q');
  await says(page, /\?/);
  for (let k = 0; k < 3; k++) {
    await page.keyboard.press('y');
    await expect.poll(async () => (await sides(page)).length).toBeGreaterThan(6 + k);
  }
  expect(await sides(page)).toEqual(
    expect.arrayContaining(['sleeve 1 - sleeve 4', 'sleeve 2 1 - sleeve 2 4']),
  );
  expect(await places(page)).toEqual(before);
});

it('tells who has a finger what to tap', {tags: ['thorough']}, async () => {
  const page = await openPage({
    viewport: {width: 390, height: 844},
    hasTouch: true,
    isMobile: true,
  });
  await solved(page);
  const panels = page.getByRole('navigation', {name: 'Panels'});
  await panels.getByRole('button', {name: 'Pattern', exact: true}).click();
  await choose(page, 'My pattern', jsonFile('tee.json', stripped));
  await byHand(page);
});
