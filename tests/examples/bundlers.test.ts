/** Bundlers that don't support workers and modules, set up as docs/frameworks.md describes. */
import {copyFile, cp, mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {rolldown} from 'rolldown';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {serveFiles} from '../support/page/browser.js';
import {packed, type Packed} from '../support/package/packed.js';
import {samples, solved, useChromium} from '../support/package/examples.js';

const open = useChromium();
/** Policy that allows the site's own files and WebAssembly only. */
const policy = "default-src 'self' 'wasm-unsafe-eval'";
let all: Packed;
let folder: string;

beforeAll(async () => {
  all = await packed();
  folder = await mkdtemp(join(tmpdir(), 'seamwise-bundled-'));
  await all.installIn(folder, ['three']);
  await writeFile(join(folder, 'main.js'), "import 'seamwise/element/auto';\n");
  const site = join(folder, 'site');
  const bundle = await rolldown({input: join(folder, 'main.js'), logLevel: 'silent'});
  await bundle.write({dir: site, format: 'esm'});
  await cp(join(samples, 'garments'), join(site, 'garments'), {recursive: true});
  await cp(join(samples, 'prints'), join(site, 'prints'), {recursive: true});
  await cp(join(samples, 'icon.svg'), join(site, 'icon.svg'));
  await writeFile(
    join(site, 'index.html'),
    `<!doctype html><link rel="icon" href="icon.svg" /><script type="module" src="main.js"></script>
     <seamwise-garment loading="eager" garment="garments/tee-m.json" print="prints/p4m.json"></seamwise-garment>`,
  );
}, 300_000);
afterAll(async () => {
  await rm(folder, {recursive: true, force: true});
  await all.remove();
});

it('says what is missing where a bundler has left the worker behind', async () => {
  const {url, close} = await serveFiles(join(folder, 'site'), policy);
  const page = await open(url, {maySay: /./});
  await page.locator('seamwise-garment:state(error)').waitFor({timeout: 60_000});
  const code = await page
    .locator('seamwise-garment')
    .evaluate((element) => (element as {error?: {code: string}}).error?.code);
  expect(code).toBe('no-wasm');
  await close();
});

it('works once the two files lie beside the bundle, as the guide says', async () => {
  const guide = await readFile(new URL('../../docs/frameworks.md', import.meta.url), 'utf8');
  const [, names = ''] =
    /const names = \[([^;]*)\];\nfor \(const name of names\)/.exec(guide) ?? [];
  for (const [, name = ''] of names.matchAll(/'([^']+)'/g)) {
    const {output} = await all.node(
      `console.log(new URL(import.meta.resolve('seamwise/standalone/${name}')).pathname)`,
    );
    await copyFile(output.trim(), join(folder, 'site', name));
  }
  const {url, close} = await serveFiles(join(folder, 'site'), policy);
  const page = await open(url);
  await solved(page);
  // a long search has helpers that run the same script
  const scripts = page.workers().map((worker) => worker.url().replace('#helper', ''));
  expect([...new Set(scripts)]).toEqual([`${url}solver.worker.js`]);
  await close();
});
