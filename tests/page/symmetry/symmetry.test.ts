/** Clicks that make a garment symmetric, on three samples, and their results. */
import type {Page} from 'playwright-core';
import type {SolveResult} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {violations} from '../../support/results/check-result.js';
import {button, saved, showSample, solved, usePage} from '../../support/page/page.js';
import {clickPiece, clickSeam, seamOf} from '../../support/page/pattern.js';
import {sampleOf} from '../../support/level.js';

const openPage = usePage();

const hint = (page: Page, text: RegExp): Promise<void> =>
  page.getByRole('status', {name: 'What to do next'}).filter({hasText: text}).waitFor();

type Line = readonly [seam: string, piece: string];

async function mirrorLines(page: Page, lines: readonly [Line, Line]): Promise<void> {
  await hint(page, /^Click two seam lines/);
  for (const [name, piece] of lines) {
    const {seam, side} = await seamOf(page, name, piece);
    await clickSeam(page, seam, side);
  }
  await hint(page, /The piece is symmetric; its halves differ by at most [\d.]+ mm/);
  await button(page, 'Accept').click();
}

async function mirrorPieces(page: Page, pieces: readonly [string, string]): Promise<void> {
  await hint(page, /^Click the first/);
  for (const piece of pieces) await clickPiece(page, piece);
  await hint(page, /The pieces are mirror images; they differ by at most [\d.]+ mm/);
  await button(page, 'Accept').click();
}

interface Clicks {
  readonly style: string;
  readonly lines: readonly (readonly [Line, Line])[];
  readonly pairs: readonly (readonly [string, string])[];
}

const garments: readonly Clicks[] = [
  {
    style: 'tee',
    lines: [
      [
        ['Side seam, left', 'front'],
        ['Side seam, right', 'front'],
      ],
      [
        ['Shoulder, left', 'back'],
        ['Shoulder, right', 'back'],
      ],
    ],
    pairs: [['sleeve_left', 'sleeve_right']],
  },
  {
    style: 'raglan',
    lines: [],
    pairs: [
      ['front_left', 'front_right'],
      ['back_left', 'back_right'],
      ['sleeve_front_left', 'sleeve_front_right'],
      ['sleeve_back_left', 'sleeve_back_right'],
    ],
  },
  {
    style: 'six-gore-skirt',
    lines: [
      [
        ['Front panel seam, left', 'centre_front'],
        ['Front panel seam, right', 'centre_front'],
      ],
    ],
    pairs: [
      ['side_front_left', 'side_front_right'],
      ['side_back_left', 'side_back_right'],
    ],
  },
];

describe.each(sampleOf(1, garments))('$style', ({style, lines, pairs}) => {
  it('keeps the symmetries that were clicked, in a result that can be sewn', async () => {
    const page = await openPage();
    await solved(page);
    await showSample(page, style);
    if (lines.length > 0) await button(page, 'Symmetric piece').click();
    for (const both of lines) await mirrorLines(page, both);
    await button(page, 'Symmetric pair').click();
    for (const pair of pairs) await mirrorPieces(page, pair);
    await solved(page);
    const result = JSON.parse(await saved(page, 'Save result')) as SolveResult;
    expect(result.symmetries.filter(({kind}) => kind === 'piece').length).toBe(lines.length);
    expect(result.symmetries.filter(({kind}) => kind === 'pair').length).toBe(pairs.length);
    expect(violations(result, {maxChangeCm: 1})).toEqual([]);
  });
});

it(
  'refuses at the place what does not mirror, and says by how much',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await showSample(page, 'raglan');
    await button(page, 'Symmetric pair').click();
    await clickPiece(page, 'front_left');
    await clickPiece(page, 'sleeve_front_left');
    await hint(page, /These are not mirror images: they differ by up to [\d.]+ mm/);
    await page.keyboard.press('Escape');
    await hint(page, /Now click the mirrored piece/);
  },
);

it(
  'goes one step back with every Escape, and leaves the tool at last',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await showSample(page, 'raglan');
    await button(page, 'Symmetric pair').click();
    await clickPiece(page, 'front_left');
    await hint(page, /Now click the mirrored piece/);
    await page.keyboard.press('Escape');
    await hint(page, /^Click the first/);
    await page.keyboard.press('Escape');
    await expect
      .poll(() => button(page, 'Symmetric pair').getAttribute('aria-pressed'))
      .toBe('false');
  },
);

it('makes a pair by keyboard alone', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  await page.getByRole('application', {name: 'Pattern'}).focus();
  await page.keyboard.press('p');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press(' ');
  await hint(page, /Now click the mirrored piece/);
});

it(
  'puts a tool away that a button began, by Escape on that button',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const tool = page.getByRole('toolbar').getByRole('button', {name: 'Symmetric piece'});
    await tool.click();
    await expect.poll(() => tool.getAttribute('aria-pressed')).toBe('true');
    await page.keyboard.press('Escape');
    await expect.poll(() => tool.getAttribute('aria-pressed')).toBe('false');
  },
);
