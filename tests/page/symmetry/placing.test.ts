/** Dragging prints under symmetry, and the offers for impossible alignments. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {mirrors} from '@/model/print/mirror-images.js';
import {printOf, type Design} from '@/model/design/design.js';
import type {Alignment, Point} from '@/model/geometry/vectors.js';
import type {Workbench} from '@/workbench/workbench.js';
import type {PatternPane} from '@/editor/pattern/pattern-pane.js';
import {barriers} from '../../support/page/barriers.js';
import {designOf} from '../../support/page/design.js';
import {clickSeam, middleOfPiece, seamOf} from '../../support/page/pattern.js';
import {button, progress, solved, usePage} from '../../support/page/page.js';
import {symmetricTee} from '../../support/page/symmetric-tee.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

type Changes = Pick<Design, 'symmetry'> & {
  readonly options?: Design['options'];
  readonly print?: Partial<Design['print']>;
};

/** Changes the design as a file would. */
const change = (page: Page, {options, print, ...more}: Partial<Changes>): Promise<void> =>
  page.evaluate(
    ([own, of, rest]) => {
      const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
      const {workbench} = element ?? {};
      if (!workbench?.history.design) return;
      const {design} = workbench.history;
      workbench.history.change({
        ...rest,
        options: {...design.options, ...own},
        print: {...design.print, ...of},
      });
    },
    [options, print, more] as const,
  );

/** The alignment of a piece, and its own reflection or the one onto its twin. */
const lying = (
  page: Page,
  name: string,
): Promise<{readonly alignment: Alignment; readonly map: Alignment | undefined}> =>
  page.evaluate((wanted) => {
    const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
    const result = element?.workbench.solving.result;
    const number = result?.pieces.findIndex((piece) => piece.name === wanted) ?? -1;
    const alignment = result?.pieces[number]?.alignment;
    if (!alignment) throw new Error(`${wanted} lies nowhere.`);
    const own = result.symmetries.find((one) =>
      one.kind === 'piece' ? one.piece === number : one.pieces[0] === number,
    );
    return {alignment, map: own?.map};
  }, name);

async function drag(page: Page, piece: string, [dx, dy]: Point): Promise<void> {
  const [x, y] = await middleOfPiece(page, piece);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, {steps: 6});
  await page.mouse.up();
}

const pinsOf = async (page: Page): Promise<NonNullable<Design['options']['pins']>> =>
  (await designOf(page)).options.pins ?? {};

it('slides a symmetric piece along its axis, and clicks it over to the next mirror line', async () => {
  const page = await symmetricTee(openPage);
  await button(page, 'Move print').click();
  const print = printOf((await designOf(page)).print);
  const before = await lying(page, 'front');
  await drag(page, 'front', [3, 40]);
  await solved(page);
  const along = await lying(page, 'front');
  expect(along.alignment.translation[0]).toBeCloseTo(before.alignment.translation[0], 6);
  expect(along.alignment.translation[1]).toBeLessThan(before.alignment.translation[1] - 1);
  const pins = await pinsOf(page);
  expect(Object.keys(pins)).toEqual(['front']);
  expect(pins.front && mirrors(print, along.map ?? along.alignment, pins.front, pins.front)).toBe(
    true,
  );
  await page.getByRole('application', {name: 'Pattern'}).focus();
  await page.keyboard.press('ArrowRight');
  await solved(page);
  const over = await lying(page, 'front');
  const spacing = over.alignment.translation[0] - along.alignment.translation[0];
  expect(spacing).toBeGreaterThan(1);
  expect(mirrors(print, over.map ?? over.alignment, over.alignment, over.alignment)).toBe(true);
  await page.locator('sw-pattern [data-sign="pin"]').waitFor();
});

it(
  'has the image of a pair follow, and the newest of two drags count',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    await button(page, 'Move print').click();
    await drag(page, 'sleeve_left', [20, 12]);
    await solved(page);
    expect(Object.keys(await pinsOf(page))).toEqual(['sleeve_left']);
    await drag(page, 'sleeve_right', [-15, 9]);
    await solved(page);
    expect(Object.keys(await pinsOf(page))).toEqual(['sleeve_right']);
    await button(page, 'Unpin Sleeve right').click();
    await solved(page);
    expect(await pinsOf(page)).toEqual({});
  },
);

it('centres a motif on the edge that is chosen', {tags: ['thorough']}, async () => {
  const page = await symmetricTee(openPage);
  const {seam, side} = await seamOf(page, 'Underarm, left', 'sleeve_left');
  await clickSeam(page, seam, side);
  await button(page, 'Move print').click();
  await button(page, 'Centre a motif').click();
  await solved(page);
  const {sleeve_left: pin, ...others} = await pinsOf(page);
  expect(others).toEqual({});
  const edge = await page.locator('sw-pattern').evaluate(
    ({workbench}: PatternPane, [one, of]) => {
      const {piece, vertices} = workbench.sheet.scenes?.now.seams[one]?.[of] ?? {
        piece: -1,
        vertices: [],
      };
      return vertices.map((v) => workbench.solving.pattern?.pieces[piece]?.rest[v] ?? [NaN, NaN]);
    },
    [seam, side] as const,
  );
  const [x = NaN, y = NaN] = pin?.translation ?? [];
  const off = edge.map(([px, py]) => Math.hypot(x - px, y - py));
  const nearest = off.indexOf(Math.min(...off));
  expect(Math.min(...off)).toBeLessThan(1.5);
  expect(Math.abs(nearest - (edge.length - 1) / 2)).toBeLessThan(2);
});

it(
  'takes a stored pin to the nearest place that keeps the symmetry, as part of the same step',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    const {alignment} = await lying(page, 'front');
    const [x, y] = alignment.translation;
    const wanted = {...alignment, translation: [x + 0.4, y] as const};
    await change(page, {options: {pins: {front: wanted}}});
    await solved(page);
    expect((await pinsOf(page)).front?.translation[0]).toBeCloseTo(x, 6);
    // a larger print has its mirror lines elsewhere
    await change(page, {print: {size: {width: 13, height: 10, angleDeg: 90}}});
    await solved(page);
    await button(page, 'Undo').click();
    await button(page, 'Undo').click();
    expect(await pinsOf(page)).toEqual({});
  },
);

it('takes a pin along when a symmetry is asked for later', {tags: ['thorough']}, async () => {
  const page = await symmetricTee(openPage);
  const {symmetry} = await designOf(page);
  const {alignment} = await lying(page, 'front');
  const [x, y] = alignment.translation;
  await change(page, {symmetry: 'none'});
  await change(page, {
    options: {pins: {front: {...alignment, translation: [x + 0.4, y] as const}}},
  });
  await solved(page);
  expect((await pinsOf(page)).front?.translation[0]).toBeCloseTo(x + 0.4, 6);
  await change(page, {symmetry});
  await page.getByText('moved to the nearest place').waitFor();
  await solved(page);
  expect((await pinsOf(page)).front?.translation[0]).toBeCloseTo(x, 5);
});

it(
  'offers ways out where the pins of a pair contradict each other',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    const pins = {
      sleeve_left: {angle: 0, translation: [0, 0]},
      sleeve_right: {angle: 0, translation: [1, 2]},
    } as const;
    await change(page, {options: {pins}});
    const ways = page.getByRole('group', {name: 'Ways out'});
    await ways
      .getByRole('button', {name: 'Make Sleeve right the mirror image of Sleeve left'})
      .waitFor();
    expect(await barriers(page)).toEqual([]);
    await expect
      .poll(() => ways.getByRole('button').allInnerTexts())
      .toEqual([
        'Make Sleeve right the mirror image of Sleeve left',
        'Unpin Sleeve left',
        'Unpin Sleeve right',
        'Drop the symmetry: Sleeve left, Sleeve right',
      ]);
    await ways
      .getByRole('button', {name: 'Make Sleeve right the mirror image of Sleeve left'})
      .click();
    await solved(page);
    expect((await pinsOf(page)).sleeve_left).toEqual(pins.sleeve_left);
    await button(page, 'Undo').click();
    await ways.getByRole('button', {name: 'Unpin Sleeve left'}).click();
    await solved(page);
    expect(Object.keys(await pinsOf(page))).toEqual(['sleeve_right']);
  },
);

it(
  'offers ways out where grain and symmetry do not go together',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    await change(page, {print: {turnDeg: 110}});
    const ways = page.getByRole('group', {name: 'Ways out'});
    await ways
      .getByRole('button', {name: /^Turn the print by -20°|^Turn the print by −20°/})
      .click();
    await solved(page);
    expect((await designOf(page)).print.turnDeg).toBeCloseTo(90, 6);
    await button(page, 'Undo').click();
    await ways
      .getByRole('button', {name: /^Allow any angle for .*$/})
      .first()
      .waitFor();
    await ways
      .getByRole('button', {name: /^Drop the symmetry: /})
      .first()
      .waitFor();
  },
);

it('offers to leave out what the print cannot keep', {tags: ['thorough']}, async () => {
  const page = await symmetricTee(openPage);
  await change(page, {print: {group: 'p2'}});
  await page.getByText('This print has no mirrors').first().waitFor();
  await button(page, 'Remove what the print cannot keep').click();
  await solved(page);
  expect((await designOf(page)).symmetry).toBe('none');
  await expect.poll(() => progress(page).innerText()).toMatch(/^Matched in/);
});
