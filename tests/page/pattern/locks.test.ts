/** Locked pieces and edges: by clicks, by keys, from the list of edges and from the table. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {PatternPane} from '@/editor/pattern/pattern-pane.js';
import type {Point} from '@/model/geometry/vectors.js';
import type {SolveOptions} from '@/model/design/options.js';
import type {SolveResult} from '@/model/result/result.js';
import {barriers} from '../../support/page/barriers.js';
import {designOf} from '../../support/page/design.js';
import {clickPiece, clickSeam, seamOf} from '../../support/page/pattern.js';
import {button, saved, showSample, solved, usePage} from '../../support/page/page.js';
import {symmetricTee} from '../../support/page/symmetric-tee.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const lockedOf = async (page: Page): Promise<SolveOptions['locked']> =>
  (await designOf(page)).options.locked;

/** Clicks in the middle of an edge of a piece, by its number in the file. */
async function clickEdge(page: Page, name: string, edge: number): Promise<void> {
  const at = await page.locator('sw-pattern').evaluate(
    (pane: PatternPane, [wanted, number]): Point | null => {
      const scene = pane.workbench.sheet.scenes?.now;
      const piece = scene?.pieces.find((one) => one.name === wanted);
      const stage = pane.shadowRoot?.querySelector('.stage')?.getBoundingClientRect();
      const numbers = piece?.outline.flatMap((v, k) => (piece.edges?.[k] === number ? [v] : []));
      const middle = piece?.points[numbers?.[Math.floor(numbers.length / 2)] ?? -1];
      if (!pane.view || !piece || !middle || !stage) return null;
      const [x, y] = pane.view.screenOf([middle[0] + piece.offset[0], middle[1] + piece.offset[1]]);
      return [stage.left + x, stage.top + y];
    },
    [name, edge] as const,
  );
  if (!at) throw new Error(`Edge ${edge} of ${name} is not on the screen.`);
  await page.mouse.click(at[0], at[1]);
}

/**
 * Greatest distance of a result's vertices on this edge of the file from their drafted positions.
 * [cm]
 */
async function movedAlong(page: Page, name: string, edge: number): Promise<number> {
  const result = JSON.parse(await saved(page, 'Save result')) as SolveResult;
  const edges = await page.locator('sw-pattern').evaluate((pane: PatternPane, wanted) => {
    const piece = pane.workbench.solving.pattern?.pieces.find((one) => one.name === wanted);
    return {outline: piece?.outline ?? [], edges: piece?.edges ?? []};
  }, name);
  const piece = result.pieces.find((one) => one.name === name);
  const moved = edges.outline.flatMap((v, k) => {
    const [from, to] = [piece?.rest[v], piece?.shape[v]];
    return edges.edges[k] === edge && from && to
      ? [Math.hypot(to[0] - from[0], to[1] - from[1])]
      : [];
  });
  expect(moved.length).toBeGreaterThan(0);
  return Math.max(...moved);
}

it(
  'keeps a hem that is clicked, lets it go with the next click, and undoes both',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await showSample(page, 'tee');
    await button(page, 'Keep as drafted').click();
    await clickEdge(page, 'front', 0);
    await expect.poll(() => lockedOf(page)).toEqual({front: [0]});
    await page.keyboard.press('k');
    await page.locator('sw-legend').getByText('Kept as drafted', {exact: true}).waitFor();
    await page.keyboard.press('k');
    await clickEdge(page, 'front', 0);
    await expect.poll(() => lockedOf(page)).toBeUndefined();
    await button(page, 'Undo').click();
    await expect.poll(() => lockedOf(page)).toEqual({front: [0]});
    await button(page, 'Undo').click();
    await expect.poll(() => lockedOf(page)).toBeUndefined();
  },
);

it(
  'keeps a sewn edge and its mirror image, and says so in both tables',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    await button(page, 'Keep as drafted').click();
    const {seam, side} = await seamOf(page, 'Side seam, left', 'front');
    await clickSeam(page, seam, side);
    const kept = page.getByRole('row').filter({hasText: 'kept on Front'});
    await expect.poll(() => kept.count()).toBe(2);
    const box = page.getByRole('checkbox', {name: 'Kept as drafted: Front'});
    await expect
      .poll(() => box.evaluate((input: HTMLInputElement) => input.indeterminate))
      .toBe(true);
    expect(await lockedOf(page)).toEqual({front: [1]});
    await solved(page);
    for (const edge of [1, 7]) expect(await movedAlong(page, 'front', edge)).toBeLessThan(0.02);
  },
);

it(
  'keeps a whole piece and its twin, from the picture or from the table',
  {tags: ['thorough']},
  async () => {
    const page = await symmetricTee(openPage);
    await button(page, 'Keep as drafted').click();
    await clickPiece(page, 'sleeve_left');
    await expect.poll(() => lockedOf(page)).toEqual({sleeve_left: true});
    const right = page.getByRole('checkbox', {name: 'Kept as drafted: Sleeve right'});
    await expect.poll(() => right.isChecked()).toBe(true);
    await right.click();
    await expect.poll(() => lockedOf(page)).toBeUndefined();
  },
);

it('keeps edges by keys alone', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await showSample(page, 'tee');
  await page.getByRole('application', {name: 'Pattern'}).focus();
  await page.keyboard.press('k');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press(' ');
  await expect.poll(async () => Object.values((await lockedOf(page)) ?? {})).toEqual([true]);
  await page.keyboard.press(' ');
  await expect.poll(() => lockedOf(page)).toBeUndefined();
  const edges = page.getByRole('button', {name: /^Edges of /});
  await edges.focus();
  await page.keyboard.press('Enter');
  await page
    .getByRole('checkbox', {name: /^Open edge/})
    .first()
    .press(' ');
  await expect.poll(async () => Object.values((await lockedOf(page)) ?? {}).flat().length).toBe(1);
  expect(await barriers(page)).toEqual([]);
  await page.keyboard.press('Escape');
  await expect
    .poll(() => button(page, 'Keep as drafted').getAttribute('aria-pressed'))
    .toBe('true');
});
