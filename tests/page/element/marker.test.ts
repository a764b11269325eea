/** Fabric consumption of an element's garment. */
import type {Page} from 'playwright-core';
import {marker, readGarment} from 'seamwise/node';
import {expect, it} from 'vitest';

import {caughtUp} from '../../support/page/waiting.js';
import {sample, tee, useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();
/** A layout takes seconds, and several times that on a busy machine. */
const patient = {timeout: 60_000};
const onFabric = tee.replace('alt=', 'cloth-width="140" alt=');

interface Heard {
  readonly type: string;
  readonly detail: Readonly<Record<string, unknown>>;
}

/**
 * Records the element's events about fabric and errors from now on. @returns a function that
 * returns the records so far
 */
async function listening(page: Page): Promise<() => Promise<readonly Heard[]>> {
  const heard = await page.evaluateHandle(() => {
    const all: Heard[] = [];
    for (const type of ['cloth', 'error']) {
      const hear = (event: Event): void => {
        all.push({type, detail: (event as CustomEvent<Heard['detail']>).detail});
      };
      document.addEventListener(type, hear, true);
    }
    return all;
  });
  return () => heard.jsonValue();
}

declare global {
  /** Settles when a worker gets a request for a layout. */
  var laying: Promise<void>;
  var noteLaying: () => void;
}

/** Records the next request for a layout. */
function noteLaying(): void {
  const post = Reflect.get(Worker.prototype, 'postMessage') as (...given: unknown[]) => unknown;
  const note = (): void => {
    globalThis.laying = new Promise((resolve) => {
      Reflect.set(Worker.prototype, 'postMessage', function (this: unknown, ...given: unknown[]) {
        Reflect.apply(post, this, given);
        if ((given[0] as {name?: unknown}).name === 'marker') resolve();
      });
    });
  };
  globalThis.noteLaying = note;
  note();
}

/** Files of the layout module that are requested from now on. */
function markerFiles(page: Page): readonly string[] {
  const files: string[] = [];
  page.on('request', (request) => {
    const file = new URL(request.url()).pathname;
    if (/marker-layer|marker.*\.wasm$/.test(file)) files.push(file);
  });
  return files;
}

it(
  'tells what its answer takes of the fabric, as the package lays it',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage();
    const heard = await listening(page);
    await put(onFabric);
    await expect.poll(async () => (await heard()).length, patient).toBe(1);
    const {lengthCm, plan, result} = await run(async (element) => ({
      ...{lengthCm: element.clothLengthCm, plan: await element.layPlan(), result: element.result},
    }));
    if (!result) throw new Error('There is no result.');
    const garment = await readGarment(sample('garments/tee-m.json'));
    const {lengthCm: told, widthCm, proven, notes} = plan;
    expect(await heard()).toEqual([
      {type: 'cloth', detail: {widthCm, lengthCm: told, proven, notes}},
    ]);
    expect(lengthCm).toBe(told);
    const laid = await marker([{result, garment, options: {grain: {default: 'on'}}}], {widthCm});
    expect(plan).toEqual({...laid, cheaper: []}); // a shop offers its customer no other fabric
    expect(widthCm).toBe(140);
    expect(plan.placements).toHaveLength(result.pieces.length);
  },
);

it(
  'lays nothing, and loads nothing for it, where no width is given',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage();
    const files = markerFiles(page);
    await put(tee);
    await page.locator('seamwise-garment:state(ready)').waitFor();
    const refused = await run((element) =>
      element.layPlan().then(
        () => 'laid',
        (error: unknown) => (error as Error).message,
      ),
    );
    expect(refused).toMatch(/attribute 'cloth-width'/);
    await caughtUp(page);
    expect(files).toEqual([]);
    expect(await run((element) => element.clothLengthCm)).toBeNull();
    await run((element) => {
      element.clothWidth = 140;
    });
    await expect.poll(() => run((element) => element.clothLengthCm), patient).toBeGreaterThan(50);
    for (const part of [/marker-layer.*\.js$/, /marker.*\.wasm$/]) {
      expect(files.some((file) => part.test(file))).toBe(true);
    }
  },
);

it(
  'knows no length of another answer or fabric than what is shown',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage();
    const heard = await listening(page);
    await page.evaluate(noteLaying);
    await put(onFabric);
    // a single call, as the layout could end between separate ones
    const [plan, width] = await run(async (element) => {
      await element.solve();
      const waiting = element.layPlan();
      await laying; // the worker has its request
      element.print = 'prints/cm.json';
      element.clothWidth = 110;
      return [await waiting, element.clothWidth] as const;
    });
    expect([plan.widthCm, width, plan.print.group]).toEqual([110, 110, 'cm']);
    expect(await heard()).toMatchObject([
      {type: 'cloth', detail: {widthCm: 110, lengthCm: plan.lengthCm}},
    ]);
    const lengths = await run(async (element) => {
      const before = element.clothLengthCm;
      element.size = 's';
      const during = element.clothLengthCm;
      await element.solve();
      const solved = element.clothLengthCm;
      const {lengthCm} = await element.layPlan();
      return {before, during, solved, isKept: element.clothLengthCm === lengthCm};
    });
    expect(lengths).toEqual({before: plan.lengthCm, during: null, solved: null, isKept: true});
    const both = (await heard()).map(({detail}) => detail.lengthCm);
    expect(both).toHaveLength(2);
    expect(both[1]).toBeLessThan(plan.lengthCm);
  },
);

it('says what cannot be laid, and keeps the answer', async () => {
  const {page, put, run} = await openPage();
  const heard = await listening(page);
  await put(onFabric.replace('"140"', '"30"'));
  await expect.poll(async () => (await heard()).length, patient).toBe(1);
  const [{type, detail} = {type: '', detail: {}}] = await heard();
  expect([type, detail.code]).toEqual(['error', 'options']);
  expect(detail.message).toMatch(/wide/);
  const {state, lengthCm, refused} = await run(async (element) => {
    element.clothWidth = 1;
    const refused = await element.layPlan().catch((error: unknown) => (error as Error).message);
    return {state: element.state, lengthCm: element.clothLengthCm, refused};
  });
  expect([state, lengthCm]).toEqual(['ready', null]);
  expect(refused).toMatch(/selvedges of 1 cm/);
});

it(
  'lays outside the document for who waits, until they do no more',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage();
    await put(onFabric);
    await page.evaluate(noteLaying);
    const {length, aborted, cancelled} = await run(async (element) => {
      element.remove();
      const nameOf = (error: unknown): string => (error as Error).name;
      const {lengthCm} = await element.layPlan();
      element.clothWidth = 120;
      const aborting = new AbortController();
      noteLaying();
      const waits = element.layPlan({signal: aborting.signal}).then(() => 'laid', nameOf);
      await laying;
      aborting.abort();
      const aborted = await waits;
      element.clothWidth = 115;
      noteLaying();
      const other = element.layPlan().then(() => 'laid', nameOf);
      await laying;
      element.cancel();
      return {length: lengthCm, aborted, cancelled: await other};
    });
    expect(length).toBeGreaterThan(50);
    expect([aborted, cancelled]).toEqual(['AbortError', 'AbortError']);
    await expect.poll(() => page.locator('seamwise-garment').count()).toBe(0);
  },
);

it(
  'keeps nothing in the browser of what is said of the fabric in its editor',
  {tags: ['thorough']},
  async () => {
    const {page, put} = await openPage();
    await put(tee.replace('alt=', 'mode="edit" alt='));
    const editor = page.locator('seamwise-garment sw-editor');
    await editor.getByRole('button', {name: 'Fabric layout', exact: true}).click();
    const panel = page.locator('sw-marker-panel');
    const facts = () => panel.locator('.facts').innerText();
    await expect.poll(facts, patient).toMatch(/long/);
    await panel.locator('select.width').selectOption('115');
    await expect
      .poll(() => page.locator('sw-marker-pane .pane').getAttribute('data-state'), patient)
      .toBe('done');
    await expect.poll(() => panel.locator('select.width').inputValue()).toBe('115');
    expect(await page.evaluate(() => localStorage.length)).toBe(0);
  },
);
