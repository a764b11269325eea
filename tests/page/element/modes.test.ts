/** Modes of the element: preview, placing the print, full editor. */
import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {PatternPane} from '@/editor/pattern/pattern-pane.js';
import {frames} from '../../support/page/waiting.js';
import {tee, useElementPage} from '../../support/page/element-page.js';
import {sampleOf} from '../../support/level.js';

const openPage = useElementPage();

/** Role and name of the element in the accessibility tree. */
async function described(page: Page): Promise<readonly [string, string]> {
  const client = await page.context().newCDPSession(page);
  const {root} = await client.send('DOM.getDocument');
  const {nodeId} = await client.send('DOM.querySelector', {
    nodeId: root.nodeId,
    selector: 'seamwise-garment',
  });
  const {nodes} = await client.send('Accessibility.getPartialAXTree', {
    nodeId,
    fetchRelatives: false,
  });
  const [node] = nodes;
  return [String(node?.role?.value), String(node?.name?.value)];
}

it(
  'is a picture for who looks at it: no key and no wheel stops there, and no editor is loaded',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage();
    const scripts: string[] = [];
    page.on('request', (request) => {
      if (request.url().endsWith('.js')) scripts.push(request.url());
    });
    await put(`${tee}<div class="far"></div><button>after</button>`);
    await run(async (element) => {
      await element.solve();
    });
    await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    expect(await described(page)).toEqual(['image', 'A tee']);
    await page.mouse.move(200, 200);
    await page.mouse.wheel(0, 300);
    await page.waitForFunction(() => scrollY > 0);
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('after');
    expect(scripts.filter((url) => /editor|placing|parts/.test(url))).toEqual([]);
    await run((element) => {
      element.mode = 'edit';
    });
    await page.locator('seamwise-garment sw-editor').waitFor();
    expect(scripts.some((url) => url.includes('editor'))).toBe(true);
    expect(await described(page)).toEqual(['group', 'A tee']);
  },
);

it(
  'shows the symmetries that are kept by themselves as kept, and lets go of them',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage({viewport: {width: 1400, height: 900}});
    await put(tee.replace('alt=', 'mode="edit" alt='));
    const symmetryOf = (): Promise<unknown> =>
      run(async (element) => {
        await element.solve();
        return element.getDesign().symmetry;
      });
    expect(await symmetryOf()).toBe('auto');
    const panel = page.getByRole('region', {name: 'Symmetry'});
    const remove = panel.getByRole('button', {name: /^Remove/});
    const accept = panel.getByRole('button', {name: /^Accept/});
    await expect.poll(() => remove.count()).toBe(3);
    await expect.poll(() => accept.count()).toBe(0);
    await remove.first().click();
    expect(await symmetryOf()).toHaveLength(2);
    await expect.poll(() => accept.count()).toBe(1);
    await remove.first().click();
    await remove.first().click();
    expect(await symmetryOf()).toBe('none');
    await expect.poll(() => remove.count()).toBe(0);
    await run((element) => {
      element.print = 'prints/cm.json';
    });
    expect(await symmetryOf()).toBe('none');
    await run((element) => {
      element.value = null;
    });
    expect(await symmetryOf()).toBe('auto');
  },
);

it('lets the print be dragged inside a piece, and tells the page of it', async () => {
  const {put, page, run} = await openPage({viewport: {width: 900, height: 700}});
  await put(tee.replace('alt=', 'mode="place" alt='));
  await run(async (element) => {
    await element.solve();
  });
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  await run((element) => {
    const heard: string[] = [];
    for (const type of ['input', 'change', 'select', 'solve'] as const) {
      document.addEventListener(type, (event) => {
        heard.push(`${type} ${event instanceof CustomEvent}`);
        if (type === 'change')
          Object.assign(element, {design: (event as CustomEvent<object>).detail});
      });
    }
    Object.assign(element, {heard});
  });
  const at = await run((element) => {
    const pane = element.shadowRoot?.querySelector<PatternPane>('sw-pattern');
    const stage = pane?.shadowRoot?.querySelector('.stage')?.getBoundingClientRect();
    const piece = pane?.workbench.sheet.scenes?.now.pieces[0];
    if (!pane?.view || !stage || !piece) throw new Error('Nothing is drawn.');
    const [x, y] = pane.view.screenOf([piece.offset[0], piece.offset[1] + 20]);
    return [stage.left + x, stage.top + y] as const;
  });
  await page.clock.install();
  await page.mouse.move(...at);
  await page.mouse.down();
  /** Numbers of input and change events so far. */
  const told = (): Promise<readonly number[]> =>
    run((element) => {
      const {heard} = element as unknown as {heard: readonly string[]};
      return ['input', 'change'].map((type) => heard.filter((one) => one.startsWith(type)).length);
    });
  for (const k of [1, 2, 3]) {
    await page.mouse.move(at[0] + 4 * k, at[1] - 3 * k);
    await expect.poll(told, {timeout: 60_000}).toEqual([k, 0]);
    await page.clock.fastForward(k === 2 ? 1200 : 200); // longer than changes are grouped
  }
  await page.mouse.up();
  await expect.poll(told).toEqual([3, 1]);
  await page.waitForFunction(() => {
    const element = document.querySelector('seamwise-garment');
    return element !== null && 'design' in element && element.state === 'ready';
  });
  await page.clock.fastForward(1200);
  await frames(page);
  expect(await told()).toEqual([3, 1]);
  const seen = await run((element) => {
    const {heard, design} = element as unknown as {
      heard: readonly string[];
      design: {design: {options: {pins?: object}; alignments: object}};
    };
    const {options} = design.design;
    return {
      heard: [...new Set(heard)],
      pins: Object.keys(options.pins ?? {}),
      isSymmetric: element.result?.symmetries.some(
        (one) => one.kind === 'piece' && one.piece === 0,
      ),
      state: element.state,
    };
  });
  expect(seen).toEqual({
    heard: ['select true', 'solve true', 'input true', 'change true'],
    pins: ['front'],
    isSymmetric: true,
    state: 'ready',
  });
});

it('lets the print be scaled and exchanged, by keys as well', {tags: ['thorough']}, async () => {
  const {put, page, run} = await openPage({viewport: {width: 900, height: 700}});
  await put(tee.replace('alt=', 'mode="place" alt='));
  await run(async (element) => {
    element.prints = ['prints/p4m.json', {url: 'prints/cm.json', title: 'Tulips'}];
    await element.solve();
  });
  const slider = page.getByRole('slider', {name: 'Repeat width (cm)'});
  await slider.focus();
  /** Describes the next change event after `act`. */
  const changedBy = async (act: () => Promise<void>): Promise<string> => {
    await run((element) => {
      const next = new Promise<string>((resolve) => {
        element.addEventListener('change', () => {
          resolve(element.value);
        });
      });
      Object.assign(element, {next});
    });
    await act();
    return run((element) => (element as unknown as {next: Promise<string>}).next);
  };
  const scaled = await changedBy(() => page.keyboard.press('ArrowRight'));
  const {print} = JSON.parse(scaled) as {print: {size: {width: number}}};
  expect(print.size.width).toBeCloseTo(11.31, 1);
  const exchanged = await changedBy(() => page.getByRole('button', {name: 'Tulips'}).click());
  const other = JSON.parse(exchanged) as {print: {url: string; size?: object}};
  expect(other.print.url).toMatch(/prints\/cm\.json$/);
  expect(other.print.size).toBeUndefined();
  expect(await run((element) => element.print)).toMatch(/prints\/cm\.json$/);
});

it(
  'speaks the language around it, its own, or the words that it is given',
  {tags: ['thorough']},
  async () => {
    const {put, run, page} = await openPage();
    await put(`<div lang="de-AT">${tee.replace('alt="A tee"', 'mode="place"')}</div>`);
    await run(async (element) => {
      await element.solve();
    });
    await page.getByRole('slider', {name: 'Rapportbreite (cm)'}).waitFor();
    expect(await described(page)).toEqual(['group', 'Schnittmuster im Stoffmuster']);
    await run((element) => {
      element.locale = 'en';
      element.units = 'inch';
    });
    await page.getByRole('slider', {name: 'Repeat width (in)'}).waitFor();
    await run((element) => {
      element.messages = {garment: {scale: 'How large?', label: 'Yours'}};
    });
    await page.getByRole('slider', {name: 'How large?'}).waitFor();
    expect(await described(page)).toEqual(['group', 'Yours']);
  },
);

it('follows the language of the page, through a shadow root, too', async () => {
  const {put, run, page} = await openPage();
  await put('<main></main>');
  await page.evaluate(
    (markup) => {
      const root = document.querySelector('main')?.attachShadow({mode: 'open'});
      if (root) root.innerHTML = `<p>${markup}</p>`;
      document.documentElement.lang = 'de';
    },
    tee.replace('alt="A tee"', 'mode="place"'),
  );
  const slider = (name: string): Promise<void> => page.getByRole('slider', {name}).waitFor();
  await slider('Rapportbreite (cm)');
  await page.evaluate(() => {
    document.documentElement.lang = 'en';
  });
  await slider('Repeat width (cm)');
  await run((element) => element.parentElement?.setAttribute('lang', 'de'));
  await slider('Rapportbreite (cm)');
  await run((element) => {
    element.locale = 'en';
  });
  await slider('Repeat width (cm)');
});

it('leaves the wheel to the page while a print is placed, and zooms with ctrl', async () => {
  const {put, run, page} = await openPage({viewport: {width: 900, height: 700}});
  await put(`${tee.replace('alt=', 'mode="place" alt=')}<div class="far"></div>`);
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  const scale = (): Promise<number | undefined> =>
    run((element) => element.shadowRoot?.querySelector<PatternPane>('sw-pattern')?.view?.scale);
  await expect.poll(scale).toBeGreaterThan(1);
  const before = (await scale()) ?? 0;
  await page.mouse.move(300, 300);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -100);
  await page.keyboard.up('Control');
  await expect.poll(scale).toBeGreaterThan(before * 1.1);
  const zoomed = await scale();
  await page.mouse.wheel(0, 200);
  await page.waitForFunction(() => scrollY > 0);
  expect(await scale()).toBe(zoomed);
});

it.each(
  sampleOf(1, [
    ['its own', '', 700],
    ['that of its variable', '--sw-editor-height', 500],
    ['that of the page', 'height', 420],
  ]),
)('keeps in its editor to a height, where it is narrow, too: %s', async (_, property, height) => {
  const {put, run, page} = await openPage({viewport: {width: 820, height: 700}});
  await put(tee.replace('alt=', 'mode="edit" alt='));
  await run(
    (element, [name, px]) => {
      if (name) element.style.setProperty(name, px);
    },
    [property, `${height}px`] as const,
  );
  await page.locator('seamwise-garment sw-editor sw-piece-table').waitFor();
  const seen = await run((element) => {
    const root = element.shadowRoot;
    const stage = root?.querySelector('[part=stage]');
    const side = root?.querySelector('sw-editor')?.shadowRoot?.querySelector('.side');
    for (const part of [stage, side]) part?.scrollTo(0, 1e6);
    return {height: element.offsetHeight, scrolled: side?.scrollTop};
  });
  expect(seen.height).toBe(height);
  expect(seen.scrolled).toBeGreaterThan(100); // content below it can be reached
});

it('is as light or dark as what is around it', {tags: ['thorough']}, async () => {
  const {put, run, page} = await openPage({colorScheme: 'light'});
  await put(tee);
  await run(async (element) => {
    await element.solve();
  });
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  const brightness = () =>
    run(async (element) => {
      const picture = await createImageBitmap(await element.toBlob({width: 200}));
      const context = new OffscreenCanvas(4, 4).getContext('2d');
      context?.drawImage(picture, 0, 0);
      return context?.getImageData(1, 1, 1, 1).data[0] ?? -1;
    });
  await expect.poll(brightness).toBeGreaterThan(200);
  await run((element) => {
    element.classList.add('dark');
  });
  await expect.poll(brightness).toBeLessThan(60);
});

it(
  'shows the worn garment beside the pieces where a print is placed, and below them where that is narrow',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage({viewport: {width: 900, height: 700}});
    await put(tee.replace('alt=', 'mode="place" view="garment" alt='));
    await page.locator('seamwise-garment sw-place-bar').waitFor();
    await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    const boxes = async () => {
      const [flat, worn] = await Promise.all(
        ['sw-pattern', 'sw-drape-pane'].map((name) => page.locator(name).boundingBox()),
      );
      if (!flat || !worn) throw new Error('One of them has no place.');
      return {flat, worn};
    };
    const wide = await boxes();
    expect(wide.worn.x).toBeGreaterThanOrEqual(wide.flat.x + wide.flat.width);
    await page.setViewportSize({width: 390, height: 800});
    await expect.poll(async () => (await boxes()).worn.width).toBeGreaterThan(300);
    const {flat, worn} = await boxes();
    expect(worn.y).toBeGreaterThanOrEqual(flat.y + flat.height);
    await run((element) => {
      element.mode = 'preview';
    });
    await expect.poll(() => page.locator('sw-pattern').count()).toBe(0);
    await expect.poll(() => page.locator('sw-drape-pane').count()).toBe(1);
  },
);
