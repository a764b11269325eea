/** The shop, as used by a customer, by its workshop and by an attacker. */
import {execFile} from 'node:child_process';
import {readFile} from 'node:fs/promises';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {promisify} from 'node:util';

import type {Locator, Page} from 'playwright-core';
import {order, readStoredDesign, resultText, sha256Of} from 'seamwise/node';
import {beforeAll, expect, it} from 'vitest';

import type {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {barriers} from '../support/page/barriers.js';
import {bytesOf} from '../support/page/browser.js';
import {samples, solved, useChromium, useExamples} from '../support/package/examples.js';

const {copy, serve} = useExamples();
const open = useChromium();
const policy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; " +
  "img-src 'self'; connect-src 'self'; form-action 'self'";
let folder: string;
let shop: string;

beforeAll(async () => {
  folder = await copy('shop');
  shop = await serve(folder, ['server.mjs', '--port', '0', '--samples', samples]);
});

const garment = (page: Page): Locator => page.locator('#product seamwise-garment');
const price = (page: Page): Locator => page.locator('#price');
const readSample = (path: string): Promise<Uint8Array> => readFile(join(samples, path));

/** A layout takes seconds, and several times that on a busy machine. */
const patient = {timeout: 60_000};

/** Waits for the price. */
async function priceTold(page: Page): Promise<string> {
  await expect.poll(() => price(page).textContent(), patient).toMatch(/^€/);
  return (await price(page).textContent()) ?? '';
}

/** The design that the page would sell, and the sha256 of the result on display. */
const shown = async (page: Page): Promise<{readonly design: string; readonly sha256: string}> => {
  const {value, result} = await garment(page).evaluate((element: SeamwiseGarment) => ({
    value: element.value,
    result: element.result,
  }));
  if (!result) throw new Error('The page shows no result.');
  return {design: value, sha256: sha256Of(resultText(result))};
};

/** Waits until the element has a new answer. */
async function solvedAnew(page: Page, before: string): Promise<void> {
  await page.waitForFunction((old) => {
    const element = document.querySelector<SeamwiseGarment>('#product seamwise-garment');
    return element?.state === 'ready' && element.value !== old;
  }, before);
}

it('sells what was chosen, gives it back, and has the workshop cut the same bytes', async () => {
  const page = await open(shop);
  const refused: string[] = [];
  page.on('response', (response) => {
    const headers = response.headers();
    const isRight =
      response.ok() || response.status() === 303
        ? headers['content-security-policy'] === policy
        : false;
    const isIsolated = 'cross-origin-opener-policy' in headers;
    if (!isRight || isIsolated) refused.push(`${response.status()} ${response.url()}`);
  });
  await page.getByRole('link', {name: 'Tee'}).click();
  await page.getByText('XS', {exact: true}).click();
  await page.getByText('Snow crystal', {exact: true}).click();
  await page.locator('.colours[data-print="p6m"]').getByText('Mist').click();
  await page.getByRole('status').filter({hasText: 'The print meets'}).waitFor();
  await solved(page);
  await page.getByRole('button', {name: 'Place the print yourself'}).click();
  const before = await shown(page);
  await dragPrint(page);
  await solvedAnew(page, before.design);
  const sold = await shown(page);
  expect(sold.sha256).not.toBe(before.sha256);
  const cost = await priceTold(page);
  await page.getByRole('button', {name: 'Add to cart'}).click(patient);
  await page.waitForURL(/\/cart\//, patient);
  await page.reload();
  expect(await page.locator('.total').textContent()).toContain(cost);
  const line = page.locator('.line');
  expect(await line.textContent()).toContain('Snow crystal, Mist');
  expect(await line.textContent()).toMatch(/The print meets at \d+ of \d+ visible seams\./);
  const width = await line
    .getByRole('img', {name: 'Its pieces in the print'})
    .evaluate((image: HTMLImageElement) => image.naturalWidth);
  expect(width).toBe(480);

  const cart = page.url();
  await page.getByRole('link', {name: 'Tee, XS', exact: true}).click();
  await solved(page);
  const restored = await shown(page);
  expect(restored).toEqual({...sold, design: restored.design});
  expect(JSON.parse(restored.design)).toEqual(JSON.parse(sold.design));
  expect(await page.getByRole('radio', {name: 'XS', exact: true}).isChecked()).toBe(true);
  expect(await page.getByRole('radio', {name: 'Snow crystal'}).isChecked()).toBe(true);

  await page.goto(cart);
  const download = page.waitForEvent('download');
  await page.getByRole('button', {name: /^Order file for the workshop/}).click();
  const cut = (await bytesOf(await download)).toString();
  expect(sha256Of(cut)).toBe(sold.sha256);
  const address = await page.getByRole('link', {name: /^Design/}).getAttribute('href');
  const stored = new URL(address ?? '', shop).href;
  const design = await (await fetch(stored)).text();
  const {reproduced, text} = await order(design, {read: readSample});
  expect({reproduced, sha256: sha256Of(text)}).toEqual({reproduced: true, sha256: sold.sha256});
  const program = join(folder, 'node_modules/seamwise/dist/cli/main.js');
  const words = [program, 'order', stored, '--out', 'cut.json', '--json'];
  const {stdout} = await promisify(execFile)(process.execPath, words, {cwd: folder});
  expect(JSON.parse(stdout)).toMatchObject({reproduced: true});
  expect(sha256Of(await readFile(join(folder, 'cut.json')))).toBe(sold.sha256);
  expect(refused).toEqual([]);
});

/** Drags from the middle of the first drawn piece. */
async function dragPrint(page: Page): Promise<void> {
  const pane = garment(page).locator('sw-pattern');
  await pane.getByRole('button', {name: 'Show all'}).waitFor();
  await garment(page).locator('[part=poster]').waitFor({state: 'hidden'});
  const box = await pane.boundingBox();
  if (!box) throw new Error('The pattern is not shown.');
  const [x, y] = [box.x + 0.35 * box.width, box.y + 0.5 * box.height];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 14, y - 9, {steps: 4});
  await page.mouse.up();
}

it(
  'shows the garment as it is worn, its pieces when asked, and the worn one again in another print',
  {tags: ['thorough']},
  async () => {
    const page = await open(`${shop}garment/tee`);
    const worn = garment(page).locator('sw-drape-pane');
    const poster = garment(page).locator('[part=poster]');
    await poster.waitFor({state: 'hidden'});
    expect(await worn.isVisible()).toBe(true);
    await page.getByRole('button', {name: 'Show the pieces'}).click();
    await garment(page).locator('sw-drawing').waitFor();
    await poster.waitFor({state: 'hidden'});
    expect(await worn.count()).toBe(0);
    await page.getByRole('button', {name: 'Place the print yourself'}).click();
    await garment(page).locator('sw-place-bar').waitFor();
    await page.getByRole('button', {name: 'Place the print yourself'}).click();
    await worn.waitFor();
    await poster.waitFor({state: 'hidden'});
    await page.getByText('Snow crystal', {exact: true}).click();
    await solved(page);
    expect(await poster.isVisible()).toBe(false);
  },
);

it(
  'asks for the fabric that it cuts, in steps of 5 cm, as soon as that is known',
  {tags: ['thorough']},
  async () => {
    const page = await open(`${shop}garment/tee`);
    const length = page.locator('#length');
    const said = /^Cut from (\d\.\d\d) m of fabric, 140 cm wide\.$/;
    const centimetres = async (): Promise<number> =>
      (await garment(page).evaluate((element: SeamwiseGarment) => element.clothLengthCm)) ?? 0;
    const sold = async (): Promise<number> => {
      await expect.poll(() => length.textContent(), patient).toMatch(said);
      const metres = Number(said.exec((await length.textContent()) ?? '')?.[1]);
      expect(100 * metres).toBeCloseTo(5 * Math.ceil((await centimetres()) / 5), 6);
      await expect.poll(() => price(page).textContent()).toBe(`€${(34 * metres).toFixed(2)}`);
      return centimetres();
    };
    const first = await sold();
    const withdrawal = await price(page).evaluateHandle((element) => ({
      done: new Promise<void>((resolve) => {
        new MutationObserver(() => {
          if (element.textContent === '…') resolve();
        }).observe(element, {childList: true});
      }),
    }));
    await page.getByText('XL', {exact: true}).click();
    await withdrawal.evaluate(({done}) => done);
    expect(await sold()).toBeGreaterThan(first);
  },
);

it('can be walked by keys alone', {tags: ['thorough']}, async () => {
  const page = await open(shop);
  const focused = (): Promise<string> =>
    page.evaluate(() => {
      let at = document.activeElement;
      while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
      if (at instanceof HTMLInputElement && at.type === 'radio') return `${at.name} ${at.value}`;
      return at?.getAttribute('aria-label') ?? at?.textContent.trim() ?? '';
    });
  const tabTo = async (wanted: RegExp): Promise<void> => {
    const passed: string[] = [];
    while (!wanted.test(passed.at(-1) ?? '')) {
      if (passed.length > 60) throw new Error(`${String(wanted)} is not among ${passed.join()}`);
      await page.keyboard.press('Tab');
      passed.push(await focused());
    }
  };
  await tabTo(/^Skip/);
  await page.keyboard.press('Enter');
  await tabTo(/Six-gore skirt/);
  await page.keyboard.press('Enter');
  await page.waitForURL(/six-gore/);
  await tabTo(/^size m$/);
  await page.keyboard.press('ArrowLeft');
  expect(await focused()).toBe('size s');
  await tabTo(/^print cmm$/);
  await page.keyboard.press('ArrowRight');
  await tabTo(/^colourway-ditsy/);
  await page.keyboard.press('ArrowRight');
  await solved(page);
  await page.keyboard.press('Shift+Tab');
  while (!(await focused()).startsWith('Place the print')) await page.keyboard.press('Shift+Tab');
  const before = await shown(page);
  await page.keyboard.press('Space');
  await garment(page).locator('sw-place-bar').waitFor();
  while ((await focused()) !== 'Repeat width (cm)') await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('ArrowRight');
  await solvedAnew(page, before.design);
  const {print, garment: chosen} = readStoredDesign((await shown(page)).design, 'design');
  expect(chosen.size).toBe('s');
  expect(print).toMatchObject({colourway: 'Blush', url: `${shop}prints/ditsy.json`});
  expect(print.size?.width).toBeGreaterThan(7); // the size in the file
  await tabTo(/^Add to cart$/);
  await page.keyboard.press('Enter');
  await page.waitForURL(/\/cart\//, patient);
  await tabTo(/^Six-gore skirt, S$/);
  await page.keyboard.press('Enter');
  await page.waitForURL(/line=/);
});

it.each(['light', 'dark'] as const)(
  'keeps nobody out, in %s colours',
  {tags: ['thorough']},
  async (colorScheme) => {
    const page = await open(shop, {colorScheme});
    const all = ['minor', 'moderate', 'serious', 'critical'] as const;
    expect(await barriers(page, all)).toEqual([]);
    await page.goto(`${shop}garment/tee`);
    await solved(page);
    expect(await barriers(page, all)).toEqual([]);
    await page.getByRole('button', {name: 'Place the print yourself'}).click();
    await garment(page).locator('sw-place-bar').waitFor();
    expect(await barriers(page, all)).toEqual([]);
    await page.getByRole('button', {name: 'Add to cart'}).click(patient);
    await page.waitForURL(/\/cart\//, patient);
    expect(await barriers(page, all)).toEqual([]);
  },
);

it('keeps what was chosen before its script came', async () => {
  const page = await open(shop);
  let deliver: (() => void) | undefined;
  const chosen = new Promise<void>((resolve) => (deliver = resolve));
  await page.route('**/shop.js', async (route) => {
    await chosen;
    await route.continue();
  });
  await page.goto(`${shop}garment/tee`, {waitUntil: 'commit'});
  await page.getByText('L', {exact: true}).click();
  await page.getByText('Snow crystal', {exact: true}).click();
  deliver?.();
  await page.waitForURL(/size=l/);
  await solved(page);
  const {garment: worn, print} = readStoredDesign((await shown(page)).design, 'design');
  expect(worn.size).toBe('l');
  expect(print.url).toContain(new URL(page.url()).searchParams.get('print'));
});

it(
  'adds to the cart what is still being solved, as soon as it is there',
  {tags: ['thorough']},
  async () => {
    const page = await open(shop);
    let deliver: (() => void) | undefined;
    const pressed = new Promise<void>((resolve) => (deliver = resolve));
    await page.route('**/garments/tee-xs.json', async (route) => {
      await pressed;
      await route.continue();
    });
    await page.goto(`${shop}garment/tee?size=xs&print=check`);
    await page.getByRole('button', {name: 'Add to cart'}).click(patient);
    deliver?.();
    await page.waitForURL(/\/cart\//, patient);
    expect(await page.locator('.line').textContent()).toContain('Tee, XS');
  },
);

it('says in words what is wrong, and tries again when asked', async () => {
  const page = await open(shop, {maySay: /404/});
  await page.route('**/prints/p4m.json', (route) => route.fulfill({status: 404}));
  await page.goto(`${shop}garment/tee`);
  const problem = page
    .getByRole('alert')
    .filter({hasText: 'We could not fetch the pattern or its print.'});
  await problem.waitFor();
  expect(await barriers(page, ['minor', 'moderate', 'serious', 'critical'])).toEqual([]);
  await page.unroute('**/prints/p4m.json');
  await problem.getByRole('button', {name: 'Try again'}).click();
  await solved(page);
  await problem.waitFor({state: 'hidden'});
});

it('says what the element told before its script came', {tags: ['thorough']}, async () => {
  const told = async (page: Page, what: (element: SeamwiseGarment) => boolean): Promise<void> => {
    let deliver: (() => void) | undefined;
    const isTold = new Promise<void>((resolve) => (deliver = resolve));
    await page.route('**/shop.js', async (route) => {
      await isTold;
      await route.continue();
    });
    await page.goto(`${shop}garment/tee`, {waitUntil: 'commit'});
    await expect.poll(() => garment(page).evaluate(what), patient).toBe(true);
    deliver?.();
  };
  const solvedEarly = await open(shop);
  await told(solvedEarly, ({clothLengthCm}) => (clothLengthCm ?? 0) > 0);
  await priceTold(solvedEarly);
  await solvedEarly.getByText(/^The print meets \d+ % better/).waitFor();
  const failedEarly = await open(shop, {maySay: /404/});
  await failedEarly.route('**/prints/p4m.json', (route) => route.fulfill({status: 404}));
  await told(failedEarly, ({state}) => state === 'error');
  await failedEarly.getByRole('alert').filter({hasText: 'We could not fetch'}).waitFor();
});

it('takes no design but one of its own', {tags: ['thorough']}, async () => {
  const page = await open(`${shop}garment/tee`);
  await solved(page);
  const {design} = await shown(page);
  const own = readStoredDesign(design, 'design');
  const post = (text: string): Promise<Response> =>
    fetch(`${shop}cart`, {
      ...{method: 'POST', redirect: 'manual', body: new URLSearchParams({design: text})},
    });
  expect((await post(design)).status).toBe(303);
  const {garment: pattern, print} = own;
  const size = {width: 400, height: 400, angleDeg: 90};
  const wrong: readonly object[] = [
    {...own, garment: {...pattern, url: 'http://example.org/garments/tee-m.json'}},
    {...own, garment: {...pattern, url: '/garments/../../etc/passwd'}},
    {...own, garment: {...pattern, url: '/garments/hoodie-m.json'}},
    {...own, garment: {...pattern, url: 'file:///etc/passwd'}},
    {...own, garment: {...pattern, size: 'xl'}},
    {...own, garment: {...pattern, sha256: '0'.repeat(64)}},
    {...own, print: {...print, url: '/prints/p1.json'}},
    {...own, print: {...print, colourway: 'Gold'}},
    {...own, print: {...print, group: 'p1'}},
    {...own, print: {...print, size}},
    {...own, options: {...own.options, maxChangeCm: 5}},
    {...own, method: 'paper'},
    {...own, alignments: {front: 'anywhere'}},
    {...own, alignments: {}},
    {...own, alignments: {...own.alignments, cape: own.alignments.front}},
    {...own, options: {...own.options, pins: {cape: own.alignments.front}}},
    {...own, seed: 2},
    {...own, solver: '0.0.1'},
  ];
  for (const text of ['', '{}', '<script>', ...wrong.map((one) => JSON.stringify(one))]) {
    const answer = await post(text);
    expect(`${answer.status} ${text}`).toBe(`400 ${text}`);
    expect(answer.headers.get('content-security-policy')).toBe(policy);
    expect(await answer.text()).not.toContain('<script>');
  }
});

it('solves one order after the other, and refuses more of a customer than one waits for', async () => {
  const {Workshop, Busy} = (await import(pathToFileURL(join(folder, 'workshop.mjs')).href)) as {
    Workshop: new () => {run<T>(customer: string, work: () => Promise<T>): Promise<T>};
    Busy: new () => Error;
  };
  const workshop = new Workshop();
  const log: string[] = [];
  const order = (name: string) => async (): Promise<string> => {
    log.push(`begin ${name}`);
    await Promise.resolve();
    log.push(`end ${name}`);
    if (name === '1') throw new Error('broken');
    return name;
  };
  const all = Array.from({length: 6}, (_, k) => workshop.run('a', order(String(k))));
  const other = workshop.run('b', order('other'));
  const ends = await Promise.allSettled([...all, other]);
  expect(ends.map(({status}) => status)).toEqual([
    'fulfilled',
    'rejected',
    'fulfilled',
    'fulfilled',
    'fulfilled',
    'rejected',
    'fulfilled',
  ]);
  expect(ends[5]).toMatchObject({reason: expect.any(Busy) as unknown});
  const names = ['0', '1', '2', '3', '4', 'other'];
  expect(log).toEqual(names.flatMap((name) => [`begin ${name}`, `end ${name}`]));
  expect(await workshop.run('a', order('later'))).toBe('later');
});

it('keeps a thousand carts in little memory, and forgets the oldest when there are too many', async () => {
  const {Carts} = (await import(pathToFileURL(join(folder, 'carts.mjs')).href)) as {
    Carts: new () => {
      put(id: string | null, line: string | null, what: object): string;
      lines(id: string): ReadonlyMap<string, {readonly design: string}> | undefined;
      remove(id: string, line: string): void;
    };
  };
  const carts = new Carts();
  const before = process.memoryUsage().heapUsed;
  const ids = Array.from({length: 1000}, (_, k) =>
    carts.put(null, null, {design: `${String(k)} `.padEnd(59_000, 'x')}),
  );
  expect(process.memoryUsage().heapUsed - before).toBeLessThan(80e6);
  const [first = '', second = ''] = ids;
  const last = ids.at(-1) ?? '';
  expect(carts.lines(first)).toBeUndefined(); // 59 MB exceed the limit for all designs
  expect(carts.lines(last)?.size).toBe(1);
  const [line = ''] = carts.lines(last)?.keys() ?? [];
  expect(carts.put(last, line, {design: 'y'})).toBe(last);
  expect([...(carts.lines(last)?.values() ?? [])]).toEqual([{design: 'y'}]);
  carts.remove(last, line);
  expect(carts.lines(last)?.size).toBe(0);
  expect(carts.put(second, 'none', {design: 'z'})).not.toBe(second);
});

it('has its own price, and no other files than its own', {tags: ['thorough']}, async () => {
  const page = await open(`${shop}garment/tee`);
  await solved(page);
  const told = await priceTold(page);
  const cents = Math.round(100 * Number(told.slice(1)));
  const {design} = await shown(page);
  const post = (fields: Record<string, string>): Promise<Response> =>
    fetch(`${shop}cart`, {
      ...{method: 'POST', redirect: 'manual', body: new URLSearchParams(fields)},
    });
  const cheap = await post({design, cents: '1'});
  expect(cheap.status).toBe(400);
  expect(await cheap.text()).toContain(`m of fabric and costs ${told}, which is not what you were`);
  const other = {...(JSON.parse(design) as object), result: '0'.repeat(64)};
  const unlike = await post({design: JSON.stringify(other), cents: String(cents)});
  expect(await unlike.text()).toContain('This is not what our pages show');
  const taken = await post({design, cents: String(cents)});
  expect(taken.status).toBe(303);
  const cart = await fetch(new URL(taken.headers.get('location') ?? '', shop));
  expect(await cart.text()).toContain(`<strong>${told}</strong>`);
  // the length equals that of the package used directly
  const read = (url: string): Promise<Uint8Array> => readSample(new URL(url).pathname);
  const {plan} = await order(design, {read, cloth: {widthCm: 140, selvedgeCm: 0}});
  expect(cents).toBe(170 * Math.ceil((plan?.lengthCm ?? 0) / 5));
  for (const path of [
    'server.mjs',
    'seamwise/..%2f..%2fpackage.json',
    'garments/p1.json',
    'cart/0',
  ]) {
    const refused = await fetch(`${shop}${path}`);
    expect(`${refused.status} ${path}`).toBe(`404 ${path}`);
    expect(refused.headers.get('content-security-policy')).toBe(policy);
  }
  const marked = await fetch(`${shop}garment/tee?cart="><script>&size="><script>`);
  expect(await marked.text()).not.toContain('"><script>');
});
