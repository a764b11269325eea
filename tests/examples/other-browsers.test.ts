/** The element in the installed Firefox and WebKit, in the example with a script tag. */
import {cp, readFile} from 'node:fs/promises';
import {join} from 'node:path';

import {order, type StoredDesign} from 'seamwise/node';
import {expect, it} from 'vitest';

import {serveFiles} from '../support/page/browser.js';
import {samples, useExamples} from '../support/package/examples.js';
import {missingOf, otherBrowsers} from '../support/package/other-browsers.js';

const {copy} = useExamples();

/** Solves, draws and returns the outcome. */
const trial = `(async () => {
  const garment = document.querySelector('seamwise-garment');
  await customElements.whenDefined('seamwise-garment');
  await garment.solve();
  const isReady = garment.matches(':state(ready)');
  let picture;
  while (!(picture = await garment.toBlob({width: 300}).catch(() => undefined))) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  const bitmap = await createImageBitmap(picture);
  const canvas = document.createElement('canvas');
  Object.assign(canvas, {width: bitmap.width, height: bitmap.height});
  const context = canvas.getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
  return JSON.stringify({
    ...{isReady, type: picture.type, width: canvas.width, colours: new Set(pixels).size},
    design: garment.getDesign(),
  });
})()`;

interface Told {
  readonly colours: number;
  readonly design: StoredDesign;
}

for (const browser of otherBrowsers) {
  const missing = missingOf(browser);
  const note = missing.length > 0 ? ` (not tried, for want of ${missing.join(' and ')})` : '';
  it.skipIf(missing.length > 0)(`solves and draws in ${browser.name}${note}`, async () => {
    const folder = await copy('script-tag');
    await cp(samples, join(folder, 'samples'), {recursive: true});
    const {url, close} = await serveFiles(folder, "default-src 'self' 'wasm-unsafe-eval'");
    const page = await browser.open(url);
    try {
      const told = JSON.parse(await page.evaluate(trial)) as Told;
      expect(told).toMatchObject({isReady: true, type: 'image/png', width: 300});
      expect(told.colours).toBeGreaterThan(20); // a blank image has one colour
      // browsers compute sines differently, but the ordered bytes are equal
      const read = (sample: string) => readFile(join(folder, new URL(sample).pathname));
      expect(await order(told.design, {read})).toMatchObject({reproduced: true});
    } finally {
      await page.close();
      await close();
    }
  });
}
