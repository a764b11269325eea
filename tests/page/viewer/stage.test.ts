/** Many views of a document, each rendered as if it were alone. */
import {expect, it} from 'vitest';

import {decoded, type Pixels} from '@samples/prints/raster.js';
import {sceneOf} from '@/scene/scene.js';
import {plainPrint as print, squarePair} from '../../support/garments/two-squares.js';
import {
  canvases,
  colours,
  difference,
  frames,
  grid,
  openViews,
  pair,
  picture,
  sceneFor,
  tile,
  useManyViews,
} from '../../support/page/many-views.js';
import {compared, eventually, settled, setTile, show} from '../../support/page/viewer-page.js';

const opened = useManyViews();

it(
  'draws 24 views with one context, at most 4 in a frame, as each is drawn alone',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await openViews(page, grid);
    expect(await canvases(page)).toEqual({direct: 0, copied: 24});
    const {contexts, copies} = await page.evaluate(() => ({
      contexts: Seen.contexts.length,
      copies: [...Seen.copies.values()],
    }));
    expect(contexts).toBe(1);
    expect(Math.max(...copies)).toBe(4);
    expect(copies.reduce((sum, n) => sum + n)).toBeGreaterThanOrEqual(24);
    const together = await Promise.all(grid.map((box) => picture(page, box)));
    await page.evaluate(() => {
      for (const view of views.slice(1)) view.dispose();
    });
    const [first] = grid;
    for (const [k, shown] of together.entries()) {
      await page.evaluate((scene) => views[0]?.show(scene), sceneFor(k));
      await settled(page);
      expect(colours(shown)).toBeGreaterThan(20);
      expect(difference(shown, await picture(page, first ?? {width: 0, height: 0}))).toBeLessThan(
        2,
      );
    }
    expect(await canvases(page)).toEqual({direct: 1, copied: 0});
    expect(await page.evaluate(() => Seen.contexts.length)).toBe(1);
  },
);

it(
  'draws only what has changed, and lets nobody wait for the others',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await openViews(page, grid);
    const turns = await page.evaluate(async () => {
      Seen.copies.clear();
      views[3]?.panBy(5, 0);
      await new Promise(requestAnimationFrame);
      await new Promise(requestAnimationFrame);
      const one = [...Seen.copies.values()];
      // six restless views do not delay another one
      let count = 0;
      views[20]?.zoomBy(2);
      const canvas = document.querySelectorAll('canvas')[20];
      const before = canvas?.toDataURL();
      while (canvas?.toDataURL() === before && count < 20) {
        for (const view of views.slice(0, 6)) view.panBy(count % 2 ? 1 : -1, 0);
        await new Promise(requestAnimationFrame);
        count++;
      }
      return {one, count};
    });
    expect(turns.one).toEqual([1]);
    expect(turns.count).toBeLessThanOrEqual(3);
  },
);

it(
  'shows the renderer’s own canvas where a view is alone, and never an empty one in between',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await show(page, sceneFor(1));
    await setTile(page, tile.png);
    expect(await canvases(page)).toEqual({direct: 1, copied: 0});
    const area = {left: 300, top: 0, width: 900, height: 600};
    const alone = await picture(page, area);
    expect(colours(alone)).toBeGreaterThan(20);
    await page.evaluate((scene) => {
      Seen.hung.length = 0;
      globalThis.views = [Viewer.openView({width: 200, height: 150})];
      views[0]?.show(scene);
    }, sceneFor(2));
    await frames(page, 3);
    expect(await canvases(page)).toEqual({direct: 0, copied: 2});
    expect(difference(await picture(page, area), alone)).toBeLessThan(2);
    await page.evaluate(() => views[0]?.dispose());
    await frames(page, 3);
    expect(await canvases(page)).toEqual({direct: 1, copied: 0});
    expect(difference(await picture(page, area), alone)).toBe(0);
    expect(await page.evaluate(() => Seen.hung)).toEqual([true, true, true]);
  },
);

it('leaves the renderer’s own canvas where it is seen when one goes that showed it before, and gives it back', async () => {
  const page = await opened();
  await openViews(page, pair);
  const [first = {width: 0, height: 0}, second = {width: 0, height: 0}] = pair;
  const [one, other] = [await picture(page, first), await picture(page, second)];
  const turn = async (number: number, display: string): Promise<void> => {
    await page.evaluate(
      ([k, value]) => {
        const box = document.querySelectorAll<HTMLElement>('body > div')[k];
        if (box) box.style.display = value;
      },
      [number, display] as const,
    );
    await frames(page, 5);
  };
  await turn(1, 'none'); // the first view shows the renderer's canvas
  await turn(0, 'none');
  await turn(1, 'block'); // now the second one does
  await turn(1, 'none');
  await turn(0, 'block');
  expect(difference(await picture(page, first), one)).toBeLessThan(2);
  await turn(0, 'none');
  await turn(1, 'block');
  expect(difference(await picture(page, second), other)).toBeLessThan(2);
  await page.evaluate(() => views[0]?.dispose());
  await frames(page, 5);
  expect(difference(await picture(page, second), other)).toBeLessThan(2);
});

it('follows the size of a view, be it alone or one of several', {tags: ['thorough']}, async () => {
  const page = await opened();
  await openViews(page, pair);
  const resized = async (): Promise<Pixels> => {
    await page.evaluate(() => {
      const box = document.querySelector<HTMLElement>('body > div');
      if (box) Object.assign(box.style, {width: '500px', height: '400px', zIndex: '1'});
    });
    await frames(page, 3);
    return picture(page, {width: 500, height: 400});
  };
  const copied = await resized();
  await page.evaluate(() => {
    views[1]?.dispose();
    const box = document.querySelector<HTMLElement>('body > div');
    if (box) Object.assign(box.style, {width: '300px', height: '100px'});
  });
  await frames(page, 3);
  expect(difference(await resized(), copied)).toBeLessThan(2);
  expect(colours(copied)).toBeGreaterThan(20);
});

it(
  'waits with a view until it is in view, and gives its picture before',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await openViews(page, [...pair, {left: 0, top: 3000, width: 400, height: 300}]);
    await page.evaluate(() => {
      Seen.copies.clear();
      views[2]?.panBy(3, 0);
    });
    await frames(page, 3);
    const bytes = await page.evaluate(async () => {
      const blob = await views[2]?.toBlob(800);
      return [...new Uint8Array((await blob?.arrayBuffer()) ?? [])];
    });
    expect(colours(await decoded(Buffer.from(bytes)))).toBeGreaterThan(20);
    await frames(page, 3);
    expect(await page.evaluate(() => Seen.copies.size)).toBe(0);
    await page.evaluate(() => {
      scrollTo(0, 3000);
    });
    await eventually(() => page.evaluate(() => Seen.copies.size)).toBe(1);
  },
);

it('leaves what is shown as it was when a picture is made of a view', async () => {
  const page = await opened();
  await openViews(page, pair);
  const area = {width: 400, height: 150};
  const before = await picture(page, area);
  await page.evaluate(async () => {
    await views[1]?.toBlob(1000);
    for (const view of views) view.panBy(0, 0);
  });
  await frames(page, 3);
  expect(difference(await picture(page, area), before)).toBe(0);
});

it(
  'draws the strip of a seam beside a view that stays drawn directly',
  {tags: ['thorough']},
  async () => {
    const scene = sceneOf(squarePair(), print);
    const page = await opened();
    await show(page, {...sceneFor(1), seams: []});
    await setTile(page, tile.png);
    await page.evaluate(
      async ([shown, png]) => {
        const strip = Viewer.openStrip(200, 150);
        strip.show({scene: shown, seam: 0});
        strip.setTile(await Viewer.loadTile(png));
        await new Promise(requestAnimationFrame);
        await new Promise(requestAnimationFrame);
        strip.setCursor(0.5); // a frame that only draws the strip
      },
      [scene, tile.png] as const,
    );
    await settled(page);
    expect(await canvases(page)).toEqual({direct: 1, copied: 1});
    expect(colours(await picture(page, {width: 200, height: 150}))).toBeGreaterThan(5);
    for (const {points, wrong} of await compared(page, sceneFor(1), tile.pixels)) {
      expect(wrong).toEqual([]);
      expect(points).toBeGreaterThan(20);
    }
  },
);
