// `npm run pictures`: takes the screenshots docs/page.png and docs/lens.png of the current page.
// Needs Chromium.
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {chromium} from 'playwright-core';
import {build, preview} from 'vite';

import {chromiumPath} from './chromium.mjs';
import {root} from './shell.mjs';

const configFile = `${root}/vite.config.ts`;
const outDir = mkdtempSync(join(tmpdir(), 'seamwise-pictures-'));
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

/** The page with a sample, after its alignment, its messages and its searches. */
async function opened(style, colorScheme) {
  const page = await browser.newPage({
    ...{viewport: {width: 1440, height: 900}, colorScheme, reducedMotion: 'reduce', locale: 'en'},
    serviceWorkers: 'block',
  });
  await page.goto(`http://localhost:${server.httpServer.address().port}/`);
  const aligned = () => page.getByText(/^Aligned in/).waitFor({timeout: 120_000});
  await aligned();
  await page.getByLabel('Garment', {exact: true}).selectOption(style);
  await page.waitForFunction(
    (wanted) =>
      globalThis.document.querySelector('seamwise-page').workbench.history.design?.garment.sample
        ?.style === wanted,
    style,
  );
  await aligned();
  const accept = page.getByRole('button', {name: 'Accept all symmetries', exact: true});
  if (await accept.isVisible()) {
    await accept.click();
    await accept.waitFor({state: 'detached'});
    await aligned();
  }
  return page;
}

/**
 * Selects a seam by its name, and returns to the headline; the pointer does not hover over
 * anything.
 */
async function select(page, name) {
  const seams = page.getByRole('table', {name: 'Seams', exact: true});
  await seams.getByRole('row', {name}).first().click();
  await page.mouse.move(1250, 600);
  await page.mouse.wheel(0, -20000);
  await page.mouse.move(720, 890);
}

async function picture(page, name) {
  await page.waitForTimeout(3000); // waits for prints at full resolution
  await page.screenshot({path: `${root}/docs/${name}.png`});
  await page.close();
}

try {
  const page = await opened('princess-dress', 'light');
  await select(page, /^Front princess seam above the bust, left/);
  await picture(page, 'page');
  const lens = await opened('princess-dress', 'dark');
  await select(lens, /^Side seam below the waist, right/);
  await lens.getByRole('button', {name: 'Enlarge', exact: true}).click();
  await lens.locator('sw-lens sw-wipe-handle').locator('input').fill('35');
  await picture(lens, 'lens');
} finally {
  await browser.close();
  await server.close();
  rmSync(outDir, {recursive: true});
}
