// Opens samples in the page, and takes pictures of them.
import {chromium} from 'playwright-core';
import {build, preview} from 'vite';

import {chromiumPath} from '../chromium.mjs';
import {root} from '../shell.mjs';

const configFile = `${root}/vite.config.ts`;

/**
 * Builds the current page into a folder, serves it, and opens a browser.
 * @param outDir  an empty folder
 * @returns a function that opens a sample, and one that ends both
 */
export async function usePage(outDir) {
  await build({configFile, logLevel: 'warn', build: {outDir}});
  const server = await preview({
    configFile,
    logLevel: 'warn',
    build: {outDir},
    preview: {port: 0, strictPort: false},
  });
  const asRoot = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: [...asRoot, '--enable-unsafe-swiftshader'],
  });

  /**
   * The page with a sample, after its alignment, its messages and its searches.
   * @param isSymmetric  accepts the symmetries that the page found
   */
  async function open({garment, print, isSymmetric = true, ...look}) {
    const {colorScheme = 'light', size: [width, height] = [1440, 900], ratio = 1} = look;
    const page = await browser.newPage({
      ...{viewport: {width, height}, deviceScaleFactor: ratio},
      ...{colorScheme, reducedMotion: 'reduce', locale: 'en', serviceWorkers: 'block'},
    });
    const files = `?garment=garments/${garment}-m.json&print=prints/${print}.json`;
    await page.goto(`http://localhost:${server.httpServer.address().port}/${files}`);
    await aligned(page);
    const views = page.locator('sw-editor .views');
    await views.getByText('Pattern', {exact: true}).click();
    const accept = page.getByRole('button', {name: 'Accept all symmetries', exact: true});
    if (isSymmetric && (await accept.isVisible())) {
      await accept.click();
      await accept.waitFor({state: 'detached'});
      await aligned(page);
    }
    await views.getByText('Both', {exact: true}).click();
    return page;
  }

  async function close() {
    await browser.close();
    await server.close();
  }

  return {open, close};
}

const aligned = (page) => page.getByText(/^Matched in/).waitFor({timeout: 120_000});

/** Waits until prints have been drawn at full resolution. */
export const sharp = (page) => page.waitForTimeout(3000);

/** Shows the drape, and waits until the fabric is at rest. */
export async function showDrape(page) {
  await page.locator('sw-editor .views').getByRole('button', {name: 'Garment'}).click();
  const progress = page.locator('.application:visible ~ progress');
  await progress.waitFor({state: 'visible'});
  await progress.waitFor({state: 'hidden', timeout: 240_000});
  await sharp(page);
}

/** The result of the page's design. */
export const resultOf = (page) =>
  page.evaluate(() => globalThis.document.querySelector('seamwise-page').workbench.solving.result);

/**
 * Takes a picture of the drape.
 * @param frame  x, y, width and height in heights of the view, from the middle of its upper edge
 * @param width  of the picture [px]
 * @returns WebP
 */
export async function drapePicture(page, [x, y, w, h], width, quality) {
  const stage = await page.locator('.application:visible .stage').boundingBox();
  const unit = stage.height;
  const clip = {
    ...{x: stage.x + stage.width / 2 + x * unit, y: stage.y + y * unit},
    ...{width: w * unit, height: h * unit},
  };
  const png = await page.screenshot({clip});
  const webp = await page.evaluate(
    async ([base64, across, grade]) => {
      const bytes = Uint8Array.from(globalThis.atob(base64), (char) => char.charCodeAt(0));
      const picture = await globalThis.createImageBitmap(new Blob([bytes]), {
        ...{resizeWidth: across, resizeQuality: 'high'},
      });
      const canvas = new globalThis.OffscreenCanvas(picture.width, picture.height);
      canvas.getContext('2d').drawImage(picture, 0, 0);
      const blob = await canvas.convertToBlob({type: 'image/webp', quality: grade});
      return String.fromCharCode(...new Uint8Array(await blob.arrayBuffer()));
    },
    [png.toString('base64'), width, quality],
  );
  return Buffer.from(webp, 'latin1');
}
