import type {Page} from 'playwright-core';
import {beforeEach, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {sceneOf, type PatternScene} from '@/scene/scene.js';
import {plainPrint as print, squarePiece} from '../../support/garments/two-squares.js';
import {eventually, settled, show, useViewer} from '../../support/page/viewer-page.js';

const openPage = useViewer();

/** A piece of 30 by 20 cm. */
function sheet(): PatternScene {
  const points: Point[] = [
    [0, 0],
    [30, 0],
    [30, 20],
    [0, 20],
  ];
  const piece = squarePiece('back_yoke', {rest: points, shape: points});
  return sceneOf({print, pieces: [piece], seams: [], symmetries: []}, print);
}

let page: Page;

const sheetPoint = (x: number, y: number): Promise<Point> =>
  page.evaluate(([px, py]) => Viewer.view.sheetPointAt(px, py), [x, y] as const);
const scale = (): Promise<number> => page.evaluate(() => Viewer.view.scale);

function expectClose(a: Point, b: Point): void {
  expect(a[0]).toBeCloseTo(b[0], 6);
  expect(a[1]).toBeCloseTo(b[1], 6);
}

beforeEach(async () => {
  page = await openPage();
  await show(page, sheet());
});

it('follows a drag, which is no click', async () => {
  await page.evaluate(() => {
    document.querySelector('main')?.addEventListener('click', () => (document.title = 'clicked'));
  });
  const grabbed = await sheetPoint(400, 300);
  await page.mouse.move(400, 300);
  await page.mouse.down();
  await page.mouse.move(430, 310);
  await page.mouse.move(460, 280);
  await page.mouse.up();
  expectClose(await sheetPoint(460, 280), grabbed);
  expect(await page.title()).not.toBe('clicked');
});

it('lets a click through, and does not move for it', {tags: ['thorough']}, async () => {
  await page.evaluate(() => {
    document.querySelector('main')?.addEventListener('click', () => (document.title = 'clicked'));
  });
  const before = await sheetPoint(400, 300);
  await page.mouse.move(400, 300);
  await page.mouse.down();
  await page.mouse.move(404, 303);
  await page.mouse.up();
  expectClose(await sheetPoint(400, 300), before);
  expect(await page.title()).toBe('clicked');
});

it('zooms by a wheel about the pointer', async () => {
  const [before, fit] = [await sheetPoint(250, 200), await scale()];
  await page.mouse.move(250, 200);
  await page.mouse.wheel(0, -200);
  await eventually(scale).toBeCloseTo(fit * 1.2 ** 2, 6);
  expectClose(await sheetPoint(250, 200), before);
});

it(
  'pans by two fingers on a trackpad, and zooms when they pinch',
  {tags: ['thorough']},
  async () => {
    const [before, fit] = [await sheetPoint(300, 300), await scale()];
    await page.mouse.move(300, 300);
    await page.mouse.wheel(12, 7);
    await eventually(async () => (await sheetPoint(288, 293))[0]).toBeCloseTo(before[0], 6);
    expect(await scale()).toBe(fit);
    await page.keyboard.down('Control');
    await page.mouse.wheel(0, -10);
    await eventually(scale).toBeCloseTo(fit * 1.01 ** 10, 6);
  },
);

it('follows two fingers on the screen', {tags: ['thorough']}, async () => {
  const touch = await page.context().newCDPSession(page);
  const fingers = (type: string, points: readonly Point[]): Promise<unknown> =>
    touch.send('Input.dispatchTouchEvent', {
      type: type as 'touchStart',
      touchPoints: points.map(([x, y], id) => ({x, y, id})),
    });
  const [left, right, fit] = [
    await sheetPoint(300, 300),
    await sheetPoint(400, 300),
    await scale(),
  ];
  await fingers('touchStart', [[300, 300]]);
  await fingers('touchStart', [
    [300, 300],
    [400, 300],
  ]);
  for (let k = 1; k <= 5; k++) {
    await fingers('touchMove', [
      [300 - 10 * k, 300 + 2 * k],
      [400 + 10 * k, 300 + 2 * k],
    ]);
  }
  await fingers('touchEnd', []);
  expect(await scale()).toBeCloseTo(2 * fit, 6);
  expectClose(await sheetPoint(250, 310), left);
  expectClose(await sheetPoint(450, 310), right);
});

it(
  'zooms by keys, shows everything again with 0, and leaves the arrows to the page',
  {tags: ['thorough']},
  async () => {
    const [before, fit] = [await sheetPoint(450, 300), await scale()];
    await page.locator('main').focus();
    await page.keyboard.press('+');
    expect(await scale()).toBeCloseTo(1.25 * fit, 9);
    await page.keyboard.press('ArrowLeft');
    expectClose(await sheetPoint(450, 300), before);
    await page.keyboard.press('0');
    expect(await scale()).toBe(fit);
    expectClose(await sheetPoint(450, 300), before);
  },
);

it(
  'moves nothing for a press that the page follows itself, and its drag is no click',
  {tags: ['thorough']},
  async () => {
    await page.evaluate(() => {
      document.querySelector('main')?.addEventListener('click', () => (document.title = 'clicked'));
      Viewer.takesPress = true;
    });
    const before = await sheetPoint(400, 300);
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(460, 280);
    await page.mouse.up();
    expectClose(await sheetPoint(400, 300), before);
    expect(await page.title()).not.toBe('clicked');
  },
);

it('comes back to where it was', {tags: ['thorough']}, async () => {
  await page.evaluate(() => {
    Viewer.view.zoomBy(3, [200, 100]);
  });
  const [state, moved] = [await page.evaluate(() => Viewer.view.state), await sheetPoint(70, 80)];
  await page.evaluate(() => {
    Viewer.view.fit();
  });
  await page.evaluate((old) => {
    Viewer.view.state = old;
  }, state);
  expectClose(await sheetPoint(70, 80), moved);
});

it(
  'stays fitted when the window changes, unless somebody has moved it',
  {tags: ['thorough']},
  async () => {
    const fit = await scale();
    await page.setViewportSize({width: 450, height: 600});
    await eventually(scale).toBeLessThan(0.6 * fit);
    await page.evaluate(() => {
      Viewer.view.zoomBy(3);
    });
    const [moved, middle] = [await scale(), await sheetPoint(225, 300)];
    await page.setViewportSize({width: 800, height: 500});
    await eventually(async () => (await sheetPoint(400, 250))[0]).toBeCloseTo(middle[0], 6);
    expect(await scale()).toBe(moved);
  },
);

it('draws only when something changes', {tags: ['thorough']}, async () => {
  await page.clock.install();
  await page.evaluate(() => {
    const original = requestAnimationFrame;
    document.title = '0';
    globalThis.requestAnimationFrame = (callback) => {
      document.title = String(Number(document.title) + 1);
      return original(callback);
    };
  });
  /** Frames requested at rest, including those that follow some time after a change. */
  const whileResting = async (): Promise<string> => {
    await page.evaluate(() => {
      document.title = '0';
    });
    await page.clock.fastForward(1000);
    await page.clock.fastForward(1000);
    return page.title();
  };
  await expect.poll(whileResting, {timeout: 20_000}).toBe('0');
  await page.evaluate(() => {
    for (let k = 0; k < 5; k++) Viewer.view.panBy(1, 0);
  });
  expect(await page.title()).toBe('1');
});

it(
  'names the piece, below it or, when that is off the screen, on it',
  {tags: ['thorough']},
  async () => {
    const name = page.getByText('back yoke');
    const below = await name.boundingBox();
    const foot = await page.evaluate(() => {
      const [, y = 0] = Viewer.scene?.pieces[0]?.offset ?? [];
      return Viewer.view.screenOf([0, y])[1];
    });
    expect(below?.y).toBeGreaterThan(foot);
    await page.evaluate(() => {
      Viewer.view.zoomBy(4, [450, 200]);
    });
    await settled(page);
    await name.waitFor({state: 'visible'});
    const on = await name.boundingBox();
    expect((on?.y ?? NaN) + (on?.height ?? NaN)).toBeLessThanOrEqual(600);
  },
);

it('leaves nothing behind when it is disposed of', {tags: ['thorough']}, async () => {
  await page.evaluate(() => {
    Viewer.view.dispose();
  });
  await expect.poll(() => page.locator('main > *').count()).toBe(0);
});
