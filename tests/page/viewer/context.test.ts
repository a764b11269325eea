/** The graphics context that all views of a document share: lost, restored, missing. */
import {expect, it} from 'vitest';

import {
  canvases,
  colours,
  difference,
  frames,
  grid,
  openViews,
  picture,
  sceneFor,
  useManyViews,
} from '../../support/page/many-views.js';
import {eventually} from '../../support/page/viewer-page.js';

declare global {
  var extension: WEBGL_lose_context | undefined;
}

const opened = useManyViews();

it('keeps the pictures while the context is lost, and draws them all again after', async () => {
  const page = await opened();
  await openViews(page, grid);
  const area = {width: 1200, height: 600};
  const before = await picture(page, area);
  const lose = (): Promise<void> =>
    page.evaluate(async () => {
      const [context] = Seen.contexts;
      globalThis.extension = context?.getExtension('WEBGL_lose_context') ?? undefined;
      extension?.loseContext();
      await new Promise((resolve) => {
        context?.canvas.addEventListener('webglcontextlost', resolve, {once: true});
      });
      for (const view of views) view.panBy(0, 0);
    });
  await lose();
  await frames(page, 3);
  expect(await page.evaluate(() => Seen.lost)).toEqual(grid.map(() => true));
  expect(difference(await picture(page, area), before)).toBe(0);
  expect(
    await page.evaluate(() =>
      views[0]?.toBlob().then(
        () => 'a picture',
        () => 'none',
      ),
    ),
  ).toBe('none');
  await page.evaluate(async () => {
    Seen.lost.length = 0;
    Seen.copies.clear();
    extension?.restoreContext();
    await new Promise((resolve) => {
      Seen.contexts[0]?.canvas.addEventListener('webglcontextrestored', resolve, {once: true});
    });
  });
  await frames(page, 12);
  const {lost, copies} = await page.evaluate(() => ({
    lost: Seen.lost,
    copies: [...Seen.copies.values()],
  }));
  expect(lost).toEqual(grid.map(() => false));
  expect(copies.reduce((sum, n) => sum + n)).toBe(24);
  expect(Math.max(...copies)).toBe(4);
  expect(difference(await picture(page, area), before)).toBe(0);
});

it(
  'frees all that a view had made, and the context after the last one',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    const memory = (): Promise<unknown> =>
      page.evaluate(() => {
        const screen = Viewer.openScreen();
        const {memory: used, programs} = screen.renderer.info;
        screen.dispose();
        return {...used, programs: programs?.length};
      });
    const nothing = {geometries: 0, textures: 0, programs: 0};
    expect(await memory()).toMatchObject(nothing);
    await openViews(page, grid);
    await page.evaluate(async () => {
      for (const view of views.slice(0, 3)) {
        view.setMovement({factor: 10});
        view.setOverlay({highlight: {seam: 0, side: 'a'}, cursors: [{piece: 0, point: [1, 1]}]});
      }
      await views[0]?.toBlob(500);
    });
    await frames(page, 3);
    expect(await memory()).not.toMatchObject(nothing);
    await page.evaluate(() => {
      for (const view of views) view.dispose();
    });
    expect(await memory()).toMatchObject(nothing);
    const alive = (): Promise<boolean[]> =>
      page.evaluate(() => Seen.contexts.map((context) => !context.isContextLost()));
    expect(await alive()).toEqual([true]);
    // an element that only moves keeps the context
    await page.evaluate(() => {
      globalThis.views = [Viewer.openView({width: 200, height: 150})];
    });
    expect(await alive()).toEqual([true]);
    await page.evaluate(() => views[0]?.dispose());
    expect(await canvases(page)).toEqual({direct: 0, copied: 0});
    await eventually(alive).toEqual([false]);
    await page.evaluate((scene) => {
      globalThis.views = [Viewer.openView({width: 200, height: 150})];
      views[0]?.show(scene);
    }, sceneFor(1));
    await frames(page, 3);
    expect(await alive()).toEqual([false, true]);
    expect(colours(await picture(page, {width: 200, height: 150}))).toBeGreaterThan(2);
  },
);

it('throws where there is no WebGL 2, and works once there is', async () => {
  const page = await opened();
  await page.clock.install();
  await page.evaluate(() => {
    Viewer.view.dispose();
  });
  await page.clock.fastForward(1500); // the context is kept for a while, for another view
  const answers = await page.evaluate(() => {
    const getContext: unknown = Reflect.get(HTMLCanvasElement.prototype, 'getContext');
    const {error} = console;
    const open = (): string => {
      try {
        Viewer.openView({width: 200, height: 150}).dispose();
        return 'a view';
      } catch (failure) {
        return failure instanceof Error ? 'an error' : String(failure);
      }
    };
    HTMLCanvasElement.prototype.getContext = () => null;
    console.error = () => undefined; // three.js also logs it
    const without = open();
    Object.assign(HTMLCanvasElement.prototype, {getContext});
    Object.assign(console, {error});
    return [without, open()];
  });
  expect(answers).toEqual(['an error', 'a view']);
});
