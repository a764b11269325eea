/** Names and grain of pieces, and the questions about a file without them. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {designOf} from '../../support/page/design.js';
import {choose, jsonFile} from '../../support/page/files.js';
import {clickPiece, middleOfPiece} from '../../support/page/pattern.js';
import {button, saved, savedCut, solved, usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const edges = [0, 1, 2, 3].map((k) => ({endpoints: [k, (k + 1) % 4]}));
const box = (width: number, height: number): number[][] => [
  [0, 0],
  [width, 0],
  [width, height],
  [0, height],
];

/**
 * A garment in GarmentCode's format: labels are parts of the body, no grain, and a sleeve on its
 * side.
 */
const garment = {
  pattern: {
    panels: {
      left_ftorso: {
        ...{label: 'body', vertices: box(24, 50), edges},
        ...{translation: [0, 80, 20], rotation: [0, 0, 0]},
      },
      left_btorso: {
        ...{label: 'body', vertices: box(24, 50), edges},
        ...{translation: [0, 80, -20], rotation: [0, 0, 0]},
      },
      left_sleeve_f: {
        ...{label: 'arm', vertices: box(40, 18), edges},
        ...{translation: [30, 120, 5], rotation: [0, 0, -30]},
      },
    },
    stitches: [
      [
        {panel: 'left_ftorso', edge: 1},
        {panel: 'left_btorso', edge: 3},
      ],
    ],
  },
  properties: {curvature_coords: 'relative', units_in_meter: 100},
};

async function opened(): Promise<Page> {
  const page = await openPage();
  await choose(page, 'My pattern', jsonFile('my_shirt_specification.json', garment));
  await page.getByRole('button', {name: 'Rename: Left front torso'}).waitFor({timeout: 30_000});
  await solved(page);
  return page;
}

const linesOf = async (page: Page): Promise<unknown> =>
  (await designOf(page)).options.grain?.pieces;

it(
  'calls pieces by their panels, lets them be renamed, and writes the name on what is cut',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    const row = page.getByRole('row').filter({hasText: 'Left back torso'}).first();
    await row.focus();
    await page.keyboard.press('F2');
    const field = page.getByRole('textbox', {name: 'Name of the piece: Left back torso'});
    await field.fill('Left front torso');
    await field.press('Enter');
    await page.getByText('Another piece is called Left front torso').waitFor();
    await field.fill('Rear');
    await field.press('Enter');
    expect((await designOf(page)).names).toEqual({left_btorso: 'Rear'});
    await page.getByText(/^Matched in/).waitFor(); // the answer is still valid
    expect(JSON.parse(await saved(page, 'Save project'))).toMatchObject({
      design: {names: {left_btorso: 'Rear'}},
    });
    const svg = await savedCut(page, 'SVG');
    expect(svg).toContain('<title>My shirt</title>');
    expect(svg).toContain('aria-label="Rear"');
    expect(svg.match(/>A<\/text>/g)).toHaveLength(2);

    await button(page, 'Rename: Rear').click();
    await page.keyboard.type('Nobody');
    await page.keyboard.press('Escape');
    expect((await designOf(page)).names).toEqual({left_btorso: 'Rear'});
    await button(page, 'Undo').click();
    expect((await designOf(page)).names).toBeUndefined();
    await button(page, 'Rename: Left back torso').waitFor();
  },
);

it(
  'asks once for the grain of a file without one, and takes its own proposals at a click',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    const card = page.getByRole('region', {name: 'Grain', exact: true});
    await card.getByText('The file has no grain lines.').waitFor();
    await button(page, 'Piece by piece').click();
    await card.getByRole('combobox', {name: 'Left back torso'}).selectOption('bias');
    // front and back mirror each other, and so do their grain lines
    const bias = {left_btorso: {angleDeg: 45}, left_ftorso: {angleDeg: 135}};
    expect(await linesOf(page)).toEqual(bias);
    await button(page, 'Take all proposals').click();
    expect(await linesOf(page)).toEqual({...bias, left_sleeve_f: {angleDeg: 180}});
    await card.waitFor({state: 'detached'});
    await solved(page);
    expect((await designOf(page)).options.grain?.default).toBe('on');
  },
);

it(
  'lays the grain line by two points or an edge, and turns a piece by 90 degrees',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await page.getByRole('combobox', {name: 'Grain: Left front torso'}).selectOption('line');
    const hint = page.getByRole('status', {name: 'What to do next'});
    await hint.getByText('Click an edge that the grain runs along').waitFor();
    await clickPiece(page, 'left_ftorso');
    await hint.getByText('Now click a second point').waitFor();
    const [x, y] = await middleOfPiece(page, 'left_ftorso');
    await page.mouse.click(x + 30, y);
    await expect.poll(() => linesOf(page)).toHaveProperty('left_ftorso.angleDeg');
    const pieces = (await linesOf(page)) as {left_ftorso: {angleDeg: number}};
    expect(Math.abs(Math.sin((pieces.left_ftorso.angleDeg * Math.PI) / 180))).toBeLessThan(0.1);
    await page.keyboard.press('Escape');

    await button(page, 'Turn by 90 degrees: Left back torso').click();
    expect(await linesOf(page)).toMatchObject({left_btorso: {lock: 'across'}});
    await page.getByText('Left back torso turned by 90 degrees.').waitFor();
    await page.getByRole('row').filter({hasText: 'Left back torso'}).first().press('r');
    expect(await linesOf(page)).toMatchObject({left_btorso: {lock: 'on'}});
  },
);
