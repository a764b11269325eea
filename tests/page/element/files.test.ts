/**
 * Files that are missing, late, too large or invalid: one event, one message, and the element still
 * works.
 */
import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import {sample, tee, useElementPage, type ElementPage} from '../../support/page/element-page.js';
import {frames} from '../../support/page/waiting.js';

const openPage = useElementPage();

/** Waits for the error of the element's next load, and returns it with the error of a solve. */
const failing = ({run}: ElementPage) =>
  run(async (element) => {
    const told: {code: string; message: string}[] = [];
    element.addEventListener('error', ({detail}) => {
      told.push(structuredClone(detail));
    });
    element.print = 'prints/p4m.json?again';
    const code = await element.solve().then(
      () => 'solved',
      (error: unknown) => (error as {code: string}).code,
    );
    await element.updateComplete;
    const shown = element.shadowRoot?.querySelector('[part=message]')?.textContent;
    const poster = element.shadowRoot?.querySelector<HTMLElement>('[part=poster]')?.hidden;
    const states = [element.state, element.error?.code, element.matches(':state(error)'), poster];
    return {told, code, shown, states};
  });

const network = /Failed to load resource/;

it.each([
  ['not-found', 404],
  ['network', 500],
])('says %s where a host answers %i', {tags: ['thorough']}, async (code, status) => {
  const open = await openPage({maySay: network});
  await open.answer('garments/tee-m.json', (route) => route.fulfill({status}));
  await open.put(tee);
  const seen = await failing(open);
  expect(seen.code).toBe(code);
  expect(seen.told.map((one) => one.code)).toEqual([code]);
  expect(seen.shown).toContain('garments/tee-m.json');
  expect(seen.states).toEqual(['error', code, true, false]);
});

it(
  'says network where there is no host, and recovers with the next garment',
  {tags: ['thorough']},
  async () => {
    const open = await openPage({maySay: network});
    await open.answer('garments/tee-m.json', (route) => route.abort());
    await open.put(tee);
    expect((await failing(open)).code).toBe('network');
    const state = await open.run(async (element) => {
      element.size = 'l';
      await element.solve();
      return [element.state, element.error];
    });
    expect(state).toEqual(['ready', undefined]);
  },
);

it('gives up after half a minute', async () => {
  const open = await openPage();
  await open.page.clock.install();
  await open.answer('garments/tee-m.json', () => new Promise(() => undefined));
  await open.put(tee.replace('print=', 'data-print=')); // nothing loads without a print
  const failed = failing(open).then(({code}) => code);
  await expect.poll(() => open.asked).toContain('garments/tee-m.json');
  await open.page.clock.fastForward(31_000);
  expect(await failed).toBe('timeout');
});

it('shows hostile names as the text that they are', {tags: ['thorough']}, async () => {
  const open = await openPage();
  const name = '<img src=x onerror=alert(1)><style>*{display:none}</style>';
  const print = {...(JSON.parse(sample('prints/p4m.json')) as object), title: name};
  await open.answer('prints/p4m.json', (route) => route.fulfill({json: print}));
  await open.put(tee.replace('alt="A tee"', 'mode="place"'));
  const seen = await open.run(async (element) => {
    element.alt = '<script>alert(2)</script>';
    element.prints = [{url: 'prints/p4m.json', title: '"><b>bold</b>'}];
    const told = new Promise<string>((resolve) => {
      element.addEventListener('load', ({detail}) => {
        resolve(detail.print.name);
      });
    });
    element.size = 'l';
    await element.solve();
    const loaded = await told;
    return loaded;
  });
  expect(seen).toBe(name);
  const bar = open.page.locator('seamwise-garment sw-place-bar');
  await expect.poll(() => bar.locator('.prints span').textContent()).toBe('"><b>bold</b>');
  await expect.poll(() => bar.locator('b').count()).toBe(0);
});

it.each([
  ['notAPrint', 'a picture in the place of a print', 'image/png', '\u0089PNG'],
  ['notAPrint', 'a print without a lattice', 'application/json', '{"group":"p4m"}'],
])('says %s for %s', async (code, _, contentType, body) => {
  const open = await openPage();
  await open.answer('prints/p4m.json?again', (route) => route.fulfill({contentType, body}));
  await open.put(tee);
  expect((await failing(open)).code).toBe(code);
});

it(
  'refuses a picture of too many pixels before it is decoded, and solves all the same',
  {tags: ['thorough']},
  async () => {
    const open = await openPage();
    const head = Buffer.alloc(33);
    head.write('\u0089PNG\r\n\u001a\n', 'latin1');
    head.writeUInt32BE(30_000, 16);
    head.writeUInt32BE(100, 20);
    const print = {...(JSON.parse(sample('prints/p4m.json')) as object), image: 'huge.png'};
    await open.answer('prints/p4m.json', (route) => route.fulfill({json: print}));
    await open.answer('prints/huge.png', (route) =>
      route.fulfill({contentType: 'image/png', body: head}),
    );
    await open.page.evaluate(() => {
      const told = new Promise((resolve) => {
        const hear = ({detail}: Event & {detail?: {code: string}}): void => {
          resolve(detail?.code);
        };
        document.addEventListener('error', hear, true); // precedes the element
      });
      Object.assign(globalThis, {told});
    });
    await open.put(tee);
    const seen = await open.run(async (element) => {
      await element.solve();
      return [await (globalThis as unknown as {told: Promise<string>}).told, element.state];
    });
    expect(seen).toEqual(['too-large', 'ready']);
  },
);

it('says once in the editor what is wrong with a picture, which several of its parts show', async () => {
  const open = await openPage();
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg"><image href="https://a.example/b.png"/></svg>';
  await open.answer('prints/p4m.svg', (route) =>
    route.fulfill({contentType: 'image/svg+xml', body: svg}),
  );
  await open.page.evaluate(() => {
    const told: string[] = [];
    Object.assign(globalThis, {told});
    const hear = ({detail}: Event & {detail?: {code: string; message: string}}): void => {
      told.push(`${detail?.code ?? ''}: ${detail?.message ?? ''}`);
    };
    document.addEventListener('error', hear, true);
  });
  await open.put(tee.replace('alt=', 'mode="edit" alt='));
  await open.page.locator('seamwise-garment sw-lens-strip canvas').first().waitFor();
  await open.page.locator('seamwise-garment .notice').waitFor();
  await open.run((element) => element.toBlob({width: 50})); // waits for images or their errors
  await frames(open.page);
  const told = await open.page.evaluate(() => (globalThis as unknown as {told: string[]}).told);
  expect(told).toEqual([
    expect.stringMatching(/^not-an-image: .*p4m.svg links to other pictures.*\.$/),
  ]);
});

/**
 * Solves an element from the start. @returns the codes of all errors, the outcome, and whether its
 * poster is hidden
 */
function solvedFromStart(page: Page, markup: string): Promise<unknown[]> {
  return page.evaluate(async (text) => {
    const codes: string[] = [];
    document.addEventListener(
      'error',
      (event) => codes.push((event as Event as CustomEvent<{code: string}>).detail.code),
      true,
    );
    document.body.innerHTML = text;
    const element = document.querySelector('seamwise-garment');
    const result = await element?.solve();
    while (codes.length === 0) await new Promise(requestAnimationFrame);
    for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
    const poster = element?.shadowRoot?.querySelector<HTMLElement>('[part=poster]');
    return [codes, typeof result?.metrics.fit, element?.state, poster?.hidden];
  }, markup);
}

it('solves where nothing can be drawn, and keeps its poster', async () => {
  const open = await openPage({
    before: () => {
      HTMLCanvasElement.prototype.getContext = () => null;
    },
    maySay: /WebGL/,
  });
  await open.put('<p></p>');
  const markup = tee.replace('></', '><p slot="poster">A picture</p></');
  const seen = await solvedFromStart(open.page, markup);
  expect(seen).toEqual([['no-webgl'], 'number', 'ready', false]);
});

it('goes on in the page where a worker is refused, and says so once', async () => {
  const open = await openPage({maySay: /./});
  await open.put('<p></p>');
  const markup = tee.replace('alt=', 'worker-url="nowhere.js" alt=');
  const seen = await solvedFromStart(open.page, markup);
  expect(seen.slice(0, 3)).toEqual([['worker-blocked'], 'number', 'ready']);
});

it('says no-wasm where the module is missing', async () => {
  const open = await openPage({maySay: /./});
  await open.put(tee.replace('alt=', 'wasm-url="nowhere.wasm" alt='));
  const seen = await failing(open);
  expect(seen.code).toBe('no-wasm');
  expect(seen.shown).toMatch(/nowhere\.wasm is answered with HTTP 404; .*\.$/);
});
