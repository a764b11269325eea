/**
 * Bundlers that are not part of this project, set up by the words of docs/frameworks.md. They are
 * installed from the registry; without it the tests are left out.
 */
import {execFile} from 'node:child_process';
import {cp, mkdir, mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {promisify} from 'node:util';

import {afterAll, beforeAll, expect, it, vi} from 'vitest';

import {serveFiles} from '../support/page/browser.js';
import {packed, type Packed} from '../support/package/packed.js';
import {samples, solved, useChromium} from '../support/package/examples.js';

vi.setConfig({testTimeout: 600_000, hookTimeout: 300_000}); // a registry and a busy machine are slow
const run = promisify(execFile);
const open = useChromium();
/** Policy that allows the site's own files and WebAssembly only. */
const policy = "default-src 'self' 'wasm-unsafe-eval'";

const isOnline = await fetch('https://registry.npmjs.org/-/ping', {
  signal: AbortSignal.timeout(10_000),
}).then(
  ({ok}) => ok,
  () => false,
);

let all: Packed;
let guide: string;
const folders: string[] = [];

beforeAll(async () => {
  all = await packed();
  guide = await readFile(new URL('../../docs/frameworks.md', import.meta.url), 'utf8');
});
afterAll(async () => {
  await Promise.all(folders.map((folder) => rm(folder, {recursive: true, force: true})));
  await all.remove();
});

/** Commands of the guide's shell examples that begin with these words. */
const commandsOf = (words: string): readonly string[] =>
  [...guide.matchAll(/^```sh\n([^]*?)^```$/gm)]
    .flatMap(([, code = '']) => code.trim().split('\n'))
    .filter((line) => line.startsWith(words));

/** A folder with the package, three and the bundler, and a page in `site`. */
async function projectWith(
  packages: readonly string[],
  files: Readonly<Record<string, string>>,
): Promise<string> {
  const folder = await mkdtemp(join(tmpdir(), 'seamwise-bundler-'));
  folders.push(folder);
  const page = `<!doctype html><link rel="icon" href="icon.svg" /><script type="module" src="./main.js"></script>
    <seamwise-garment loading="eager" garment="garments/tee-m.json" print="prints/p4m.json"></seamwise-garment>`;
  const own = {
    'package.json': '{"name": "shop", "private": true, "type": "module"}',
    'main.js': "import 'seamwise/element/auto';\n",
    'index.html': page,
    ...files,
  };
  for (const [name, text] of Object.entries(own)) await writeFile(join(folder, name), text);
  const installed = ['install', '--no-audit', '--no-fund', all.tarball, 'three', ...packages];
  await run('npm', installed, {cwd: folder});
  for (const part of ['garments', 'prints', 'icon.svg']) {
    for (const place of ['public', 'assets']) {
      await mkdir(join(folder, place), {recursive: true});
      await cp(join(samples, part), join(folder, place, part), {recursive: true});
    }
  }
  return folder;
}

/** Opens the site, and waits for an answer and a drape, which needs another module. */
async function works(site: string, allowed = policy, maySay?: RegExp): Promise<void> {
  const {url, close} = await serveFiles(site, allowed);
  const page = await open(url, maySay && {maySay});
  await solved(page);
  await page.locator('seamwise-garment').evaluate(
    (element) =>
      new Promise((resolve, reject) => {
        element.addEventListener('drape', resolve);
        element.addEventListener('error', reject);
        element.setAttribute('view', 'garment');
      }),
  );
  await close();
}

/** Tests set another NODE_ENV, which would select builds for developers. */
const env = {...process.env, NODE_ENV: undefined};
const inShell = (folder: string, line: string) => run('sh', ['-c', line], {cwd: folder, env});

it.runIf(isOnline)('works with webpack without any configuration', async () => {
  const folder = await projectWith(['webpack@5', 'webpack-cli@7'], {});
  await inShell(folder, 'npx webpack --mode production --entry ./main.js -o public');
  await cp(join(folder, 'index.html'), join(folder, 'public/index.html'));
  await works(join(folder, 'public'));
});

it.runIf(isOnline).each(['esbuild', 'rollup'])('works with %s by the guide', async (name) => {
  const [install = ''] = commandsOf('npm install --save-dev rollup');
  const folder = await projectWith(name === 'esbuild' ? ['esbuild'] : [], {});
  if (name === 'rollup') await inShell(folder, install);
  const lines = [...commandsOf(`npx ${name}`), ...commandsOf('cp node_modules/seamwise')];
  expect(lines).toHaveLength(2);
  for (const line of lines) await inShell(folder, line);
  await cp(join(folder, 'index.html'), join(folder, 'public/index.html'));
  await works(join(folder, 'public'));
});

it.runIf(isOnline)('works with Parcel by the guide', async () => {
  const [, setting = ''] = /^\| Parcel 2.*\| `(.*)` in/m.exec(guide) ?? [];
  const folder = await projectWith(['parcel@2'], {});
  await writeFile(join(folder, 'package.json'), `{"name": "shop", "private": true, ${setting}}`);
  const plain = (await readFile(join(folder, 'index.html'), 'utf8')).replace(/<link[^>]*>/, '');
  await writeFile(join(folder, 'index.html'), plain);
  await inShell(folder, 'npx parcel build index.html --dist-dir assets');
  // Parcel makes an inline import map, and the page has no icon
  await works(join(folder, 'assets'), `${policy} 'unsafe-inline'`, /status of 404/);
});

it.runIf(isOnline).each(['5', '6', '7'])('works with Vite %s by the guide', async (version) => {
  const [, setting = ''] = /^\| Vite 5, 6 and 7.*\| `(.*)` in/m.exec(guide) ?? [];
  const config = `export default {${setting}};\n`;
  const folder = await projectWith([`vite@${version}`], {'vite.config.js': config});
  await inShell(folder, 'npx vite build --base ./');
  await works(join(folder, 'dist'));
});
