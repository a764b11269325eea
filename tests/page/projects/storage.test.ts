/** Storage of projects in a real browser, with one tab and with two. */
import type {Browser, BrowserContext, Page} from 'playwright-core';
import {afterAll, afterEach, beforeAll, describe, expect, it, vi} from 'vitest';

import {openBrowser, sourcesOf} from '../../support/page/browser.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

let browser: Browser | undefined;
let contexts: BrowserContext[] = [];
beforeAll(async () => {
  browser = await openBrowser();
});
afterEach(async () => {
  await Promise.all(contexts.map((context) => context.close()));
  contexts = [];
});
afterAll(() => browser?.close());

/** A browser without any stored data. */
async function newcomer(): Promise<BrowserContext> {
  if (!browser) throw new Error('The browser is not open yet.');
  const context = await browser.newContext();
  contexts.push(context);
  return context;
}

async function tab(context: BrowserContext): Promise<Page> {
  const page = await context.newPage();
  await page.goto(sourcesOf('storage'));
  await page.waitForFunction(() => 'Storing' in globalThis);
  return page;
}

const troubles = (page: Page) => page.evaluate(() => Storing.troubles);

/** Lengths in the database's store of long texts. */
const textLengths = (page: Page): Promise<number[]> =>
  page.evaluate(
    () =>
      new Promise<number[]>((resolve, reject) => {
        const open = indexedDB.open('seamwise');
        open.onerror = () => {
          reject(new Error('The database cannot be opened.'));
        };
        open.onsuccess = () => {
          const all = open.result.transaction('texts').objectStore('texts').getAll();
          all.onsuccess = () => {
            open.result.close();
            resolve((all.result as string[]).map(({length}) => length).sort((a, b) => a - b));
          };
        };
      }),
  );

describe('a project', () => {
  it('is there again after the page was loaded anew, with its thumbnail', async () => {
    const page = await tab(await newcomer());
    await page.evaluate(async () => {
      const thumbnail = new Blob(['picture'], {type: 'image/png'});
      await Storing.autosave.save('a', {name: 'Tee', state: {n: [1, null, 'x']}, thumbnail});
    });
    await page.reload();
    await page.waitForFunction(() => 'Storing' in globalThis);
    const kept = await page.evaluate(async () => {
      const project = await Storing.autosave.load('a');
      return {
        ...project,
        thumbnail: await project?.thumbnail?.text(),
        age: Date.now() - (project?.changed ?? 0),
      };
    });
    expect(kept).toMatchObject({
      id: 'a',
      name: 'Tee',
      state: {n: [1, null, 'x']},
      thumbnail: 'picture',
    });
    expect(kept.age).toBeGreaterThanOrEqual(0);
    expect(kept.age).toBeLessThan(120_000);
    expect(await troubles(page)).toEqual([]);
  });

  it('is undefined when it was never there, or was thrown away an hour ago', async () => {
    const page = await tab(await newcomer());
    const found = await page.evaluate(async () => {
      const {autosave} = Storing;
      await autosave.save('a', {name: 'Tee', state: 1});
      await autosave.change('a', {deleted: Date.now() - 3_600_000});
      await autosave.tidy();
      return [await autosave.load('a'), await autosave.load('b'), await autosave.list()];
    });
    expect(found).toEqual([undefined, undefined, []]);
  });

  it('is as it was saved last, however soon that came after the time before', async () => {
    const page = await tab(await newcomer());
    const state = await page.evaluate(async () => {
      const {autosave} = Storing;
      const long = 'x'.repeat(3_000_000); // slow to save
      await Promise.all([
        autosave.save('a', {name: 'Tee', state: long}),
        autosave.save('a', {name: 'Tee', state: 'last'}),
      ]);
      return (await autosave.load('a'))?.state;
    });
    expect(state).toBe('last');
  });
});

it('lists all projects, the one that was changed last first', async () => {
  const page = await tab(await newcomer());
  const names = await page.evaluate(async () => {
    const {autosave} = Storing;
    for (let k = 0; k < 30; k++) {
      await autosave.save(`p${k}`, {name: `Project ${k}`, state: 'y'.repeat(5000 + k)});
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    return (await autosave.list()).map(({name}) => name);
  });
  expect(names).toEqual(Array.from({length: 30}, (_, k) => `Project ${29 - k}`));
});

describe('the list', () => {
  it('keeps a title and a picture over later saves, and lets a title go again', async () => {
    const page = await tab(await newcomer());
    const records = await page.evaluate(async () => {
      const {autosave} = Storing;
      await autosave.save('a', {name: 'Tee', state: 1});
      await autosave.change('a', {title: 'For Ada', thumbnail: new Blob(['picture'])});
      await autosave.save('a', {name: 'Tee, L', state: 2});
      const [kept] = await autosave.list();
      await autosave.change('a', {title: undefined});
      const [untitled] = await autosave.list();
      return [kept?.title, kept?.name, await kept?.thumbnail?.text(), untitled?.title];
    });
    expect(records).toEqual(['For Ada', 'Tee, L', 'picture', undefined]);
  });

  it('holds what was thrown away for ten minutes, and a draft for a day', async () => {
    const context = await newcomer();
    const page = await tab(context);
    await page.clock.install();
    const listed = () =>
      page.evaluate(async () => {
        await Storing.autosave.tidy();
        return (await Storing.autosave.list()).map(({id}) => id).sort();
      });
    await page.evaluate(async () => {
      const {autosave} = Storing;
      await autosave.save('kept', {name: 'Kept', state: 1});
      await autosave.save('draft', {name: 'Draft', state: 1, isDraft: true});
      for (const id of ['deleted', 'restored']) {
        await autosave.save(id, {name: id, state: 1});
        await autosave.change(id, {deleted: Date.now()});
      }
      await autosave.change('restored', {deleted: undefined});
    });
    await page.clock.fastForward('09:00');
    expect(await listed()).toEqual(['deleted', 'draft', 'kept', 'restored']);
    await page.clock.fastForward('02:00');
    expect(await listed()).toEqual(['draft', 'kept', 'restored']);
    expect(await page.evaluate(() => Storing.autosave.load('deleted'))).toBeUndefined();
    await page.clock.fastForward('24:00:00');
    expect(await listed()).toEqual(['kept', 'restored']);
  });

  it('tells another tab of a change', async () => {
    const context = await newcomer();
    const [first, second] = [await tab(context), await tab(context)];
    const heard = second.evaluate(
      () =>
        new Promise((resolve) => {
          Storing.autosave.subscribe((renamed) => {
            if (renamed) resolve(renamed);
          });
        }),
    );
    await first.evaluate(async () => {
      await Storing.autosave.save('a', {name: 'Tee', state: 1});
      await Storing.autosave.change('a', {title: 'For Ada'});
    });
    expect(await heard).toEqual({id: 'a', title: 'For Ada'});
  });

  it('holds what was kept before there were titles', async () => {
    const page = await tab(await newcomer());
    await page.evaluate(async () => {
      await Storing.autosave.save('b', {name: 'b', state: 1}); // creates the database
      await new Promise<void>((resolve) => {
        const open = indexedDB.open('seamwise', 1);
        open.onsuccess = () => {
          const stores = ['projects', 'states', 'texts'];
          const transaction = open.result.transaction(stores, 'readwrite');
          const put = (store: string, value: unknown, key?: string) =>
            transaction.objectStore(store).put(value, key);
          put('projects', {id: 'old', name: 'tee-m.json', changed: 5, texts: ['hash']});
          put('states', {garment: {'seamwise-text': 'hash'}}, 'old');
          put('texts', 'long', 'hash');
          transaction.oncomplete = () => {
            open.result.close();
            resolve();
          };
        };
      });
    });
    const old = await page.evaluate(() => Storing.autosave.load('old'));
    expect(old).toEqual({id: 'old', name: 'tee-m.json', changed: 5, state: {garment: 'long'}});
    const ids = await page.evaluate(async () => (await Storing.autosave.list()).map(({id}) => id));
    expect(ids).toEqual(['b', 'old']);
  });
});

describe('a long text', () => {
  it('is stored once for all steps and projects that hold it, and comes back to all', async () => {
    const page = await tab(await newcomer());
    const same = await page.evaluate(async () => {
      const {autosave} = Storing;
      const text = JSON.stringify({panels: 'z'.repeat(100_000)});
      const steps = Array.from({length: 100}, (_, turn) => ({garment: {text}, turn}));
      await autosave.save('a', {name: 'A', state: steps});
      await autosave.save('b', {name: 'B', state: {steps}});
      const a = (await autosave.load('a'))?.state;
      const b = (await autosave.load('b'))?.state;
      return (
        JSON.stringify(a) === JSON.stringify(steps) && JSON.stringify(b) === JSON.stringify({steps})
      );
    });
    expect(same).toBe(true);
    expect(await textLengths(page)).toHaveLength(1);
  });

  it('goes with the last project that holds it', async () => {
    const page = await tab(await newcomer());
    const save = (id: string, length: number) =>
      page.evaluate(
        async ([to, size]) => Storing.autosave.save(to, {name: to, state: ['t'.repeat(size)]}),
        [id, length] as const,
      );
    await save('a', 4000);
    await save('b', 4000);
    await save('a', 6000);
    expect(await textLengths(page)).toEqual([4000, 6000]);
    await page.evaluate(async () => {
      await Storing.autosave.change('b', {deleted: 0});
      await Storing.autosave.tidy();
    });
    expect(await textLengths(page)).toEqual([6000]);
  });
});

describe('two tabs', () => {
  it('do not work on the same project: the second gets a copy', async () => {
    const context = await newcomer();
    const [first, second] = [await tab(context), await tab(context)];
    const own = await first.evaluate(async () => {
      await Storing.autosave.save('a', {name: 'Tee', state: 's'.repeat(2000)});
      return Storing.autosave.claim('a');
    });
    expect(own).toEqual({id: 'a', isCopy: false});
    const copy = await second.evaluate(() => Storing.autosave.claim('a'));
    expect(copy.isCopy).toBe(true);
    expect(copy.id).not.toBe('a');
    const states = await second.evaluate(async (id) => {
      await Storing.autosave.save(id, {name: 'Tee', state: 'changed'});
      return [(await Storing.autosave.load('a'))?.state, (await Storing.autosave.load(id))?.state];
    }, copy.id);
    expect(states).toEqual(['s'.repeat(2000), 'changed']);
  });

  it('copy what was stored', async () => {
    const context = await newcomer();
    const [first, second] = [await tab(context), await tab(context)];
    await first.evaluate(async () => {
      await Storing.autosave.save('a', {name: 'Tee', state: {text: 's'.repeat(2000)}});
      await Storing.autosave.claim('a');
    });
    const copy = await second.evaluate(async () =>
      Storing.autosave.load((await Storing.autosave.claim('a')).id),
    );
    expect(copy).toMatchObject({name: 'Tee', state: {text: 's'.repeat(2000)}});
  });

  it('work on a project one after the other', async () => {
    const context = await newcomer();
    const [first, second] = [await tab(context), await tab(context)];
    await first.evaluate(() => Storing.autosave.claim('a'));
    await first.evaluate(() => Storing.autosave.claim('b'));
    expect(await second.evaluate(() => Storing.autosave.claim('a'))).toEqual({
      id: 'a',
      isCopy: false,
    });
    await first.close();
    expect(await second.evaluate(() => Storing.autosave.claim('b'))).toEqual({
      id: 'b',
      isCopy: false,
    });
  });

  it('are not two when one is loaded anew', async () => {
    const page = await tab(await newcomer());
    await page.evaluate(() => Storing.autosave.claim('a'));
    await page.reload();
    await page.waitForFunction(() => 'Storing' in globalThis);
    expect(await page.evaluate(() => Storing.autosave.claim('a'))).toEqual({
      id: 'a',
      isCopy: false,
    });
  });
});

describe('what goes wrong', () => {
  it('is reported when the disk is full, and what was kept before stays', async () => {
    const context = await newcomer();
    const page = await tab(context);
    const session = await context.newCDPSession(page);
    const {origin} = new URL(page.url());
    await session.send('Storage.overrideQuotaForOrigin', {origin, quotaSize: 1_000_000});
    await page.evaluate(() => Storing.autosave.save('a', {name: 'Tee', state: 'small'}));
    const [saved, state] = await page.evaluate(async () => {
      // incompressible data
      const bytes = Array.from({length: 40}, () => crypto.getRandomValues(new Uint8Array(60_000)));
      const state = bytes.map((some) => some.join());
      const done = await Storing.autosave.save('a', {name: 'Tee', state});
      return [done, (await Storing.autosave.load('a'))?.state] as const;
    });
    expect(saved).toBe(false);
    expect(await troubles(page)).toEqual(['full']);
    expect(state).toHaveLength(40); // kept in the tab's memory
    await page.reload();
    await page.waitForFunction(() => 'Storing' in globalThis);
    expect((await page.evaluate(() => Storing.autosave.load('a')))?.state).toBe('small');
  });

  it('is reported where the browser keeps nothing; the tab then keeps it as long as it lives', async () => {
    const context = await newcomer();
    await context.addInitScript(() => {
      Object.defineProperty(globalThis, 'indexedDB', {value: undefined});
    });
    const page = await tab(context);
    const answers = await page.evaluate(async () => [
      await Storing.autosave.save('a', {name: 'Tee', state: 1}),
      (await Storing.autosave.list()).map(({id}) => id),
    ]);
    expect(answers).toEqual([false, ['a']]);
    expect(await troubles(page)).toEqual(['unavailable']);
  });

  it('is reported when a state cannot be kept, and the next one can', async () => {
    const page = await tab(await newcomer());
    const saved = await page.evaluate(async () => [
      await Storing.autosave.save('a', {name: 'Tee', state: [() => 1]}),
      await Storing.autosave.save('a', {name: 'Tee', state: [1]}),
    ]);
    expect(saved).toEqual([false, true]);
    expect(await troubles(page)).toEqual(['failed']);
  });
});
