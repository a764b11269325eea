/** The time for which malicious files block a page. */
import {expect, it} from 'vitest';

import {useElementPage, type ElementPage} from '../support/page/element-page.js';
import {print, strips, useCarelessHost} from '../support/page/hostile.js';
import {png} from '../support/image/raw-png.js';
import {twoStrips} from '../support/garments/samples.js';

const openPage = useElementPage('');
const hostUrl = useCarelessHost();

/** Limit beyond the time to draw a harmless garment. [ms] */
const longestPause = 500;

declare global {
  /** The longest time for which the page was blocked. [ms] */
  var pause: number;
}

function watch(): void {
  globalThis.pause = 0;
  let before = performance.now();
  setInterval(() => {
    const now = performance.now();
    globalThis.pause = Math.max(globalThis.pause, now - before);
    before = now;
  }, 20);
}

/** The longest time for which the page is blocked while an element is solved and drawn. [ms] */
const pauseWith = (
  {page}: ElementPage,
  given: {readonly garment: unknown; readonly print: unknown},
): Promise<number> =>
  page.evaluate(async ({garment, print}) => {
    document.body.replaceChildren();
    const element = document.createElement('seamwise-garment');
    Object.assign(element, {garment, print, loading: 'eager'});
    await new Promise((resolve) => setTimeout(resolve, 100));
    globalThis.pause = 0;
    document.body.append(element);
    await element.solve().catch(() => undefined);
    const poster = element.shadowRoot?.querySelector<HTMLElement>('[part=poster]');
    for (let k = 0; k < 100 && element.state === 'ready' && !poster?.hidden; k++) {
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    await new Promise((resolve) => setTimeout(resolve, 300));
    return globalThis.pause;
  }, given);

/** The same with harmless files. [ms] */
async function usualPause(open: ElementPage, image?: string): Promise<number> {
  const given = {
    garment: twoStrips(),
    print: image === undefined ? 'prints/p4m.json' : {...print, image, colourways: undefined},
  };
  const pauses: number[] = [];
  for (let k = 0; k < 3; k++) pauses.push(await pauseWith(open, given));
  return Math.max(...pauses);
}

it('is short for garments', async () => {
  const open = await openPage({before: watch});
  const usual = await usualPause(open);
  const files: Record<string, string> = {
    deep: `${'['.repeat(1e6)}${']'.repeat(1e6)}`,
    far: JSON.stringify(twoStrips()).replaceAll('10', '1e300'),
    many: JSON.stringify(strips(Array.from({length: 10_000}, (_, k) => `piece ${k}`))),
  };
  for (const [name, body] of Object.entries(files)) {
    await open.answer(`garments/${name}.json`, (route) =>
      route.fulfill({contentType: 'application/json', body}),
    );
  }
  for (const garment of [
    ...[`${hostUrl()}/large.json`, `${hostUrl()}/endless.json`],
    ...Object.keys(files).map((name) => `garments/${name}.json`),
  ]) {
    const pause = await pauseWith(open, {garment, print: 'prints/p4m.json'});
    expect.soft(pause, garment).toBeLessThan(usual + longestPause);
  }
});

it('is short for pictures', async () => {
  const open = await openPage({before: watch});
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="1000000000" height="1000000000"
    viewBox="0 0 10 10"><script>while (true);</script><rect width="5" height="5"/></svg>`;
  const files: readonly (readonly [name: string, contentType: string, body: Buffer])[] = [
    ['largest.png', 'image/png', png(4096, 4096)], // the largest possible texture
    ['too-large.png', 'image/png', png(20_000, 20_000)],
    ['wide.png', 'image/png', png(20_000, 3000)],
    ['large.svg', 'image/svg+xml', Buffer.from(svg)],
  ];
  for (const [name, contentType, body] of files) {
    await open.answer(`prints/${name}`, (route) => route.fulfill({contentType, body}));
  }
  const [largest = '', ...others] = files.map(([name]) => `${open.page.url()}prints/${name}`);
  const usual = await usualPause(open, largest);
  for (const image of others) {
    const pause = await pauseWith(open, {
      garment: twoStrips(),
      print: {...print, image, colourways: undefined},
    });
    expect.soft(pause, image).toBeLessThan(usual + longestPause);
  }
});
