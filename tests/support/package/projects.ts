/** Projects with bundlers and frameworks from the registry, as docs/frameworks.md describes them. */
import {execFile} from 'node:child_process';
import {cp, mkdir, mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {promisify} from 'node:util';

import type {Page} from 'playwright-core';
import {afterAll, beforeAll, vi} from 'vitest';

import {serveFiles} from '../page/browser.js';
import {samples, solved, useChromium} from './examples.js';
import {packed, type Packed} from './packed.js';

const run = promisify(execFile);
/** Policy that allows the site's own files and WebAssembly only. */
export const ownFiles = "default-src 'self' 'wasm-unsafe-eval'";

export const isOnline = await fetch('https://registry.npmjs.org/-/ping', {
  signal: AbortSignal.timeout(10_000),
}).then(
  ({ok}) => ok,
  () => false,
);

/** Text of the guide. */
export const guide = await readFile(
  new URL('../../../docs/frameworks.md', import.meta.url),
  'utf8',
);

/** Tests set another NODE_ENV, which would select builds for developers. */
const env = {...process.env, NODE_ENV: undefined};
export const inShell = (folder: string, line: string) =>
  run('sh', ['-c', line], {cwd: folder, env, maxBuffer: 1e8});

interface Projects {
  /** A folder with the package, three, other packages and these files; samples are in `places`. */
  readonly projectWith: (
    packages: readonly string[],
    files: Readonly<Record<string, string>>,
    places?: readonly string[],
  ) => Promise<string>;
  /** Waits on a page for an answer and a drape, which needs another module. */
  readonly worksAt: (url: string, maySay?: RegExp) => Promise<Page>;
  /** Serves a folder, and waits on its page for both. */
  readonly works: (site: string, policy?: string, maySay?: RegExp) => Promise<void>;
}

export function useProjects(): Projects {
  vi.setConfig({testTimeout: 600_000, hookTimeout: 300_000}); // a registry and a busy machine are slow
  const open = useChromium();
  let all: Packed;
  const folders: string[] = [];

  beforeAll(async () => {
    all = await packed();
  });
  afterAll(async () => {
    await Promise.all(folders.map((folder) => rm(folder, {recursive: true, force: true})));
    await all.remove();
  });

  const worksAt: Projects['worksAt'] = async (url, maySay) => {
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
    return page;
  };
  return {
    worksAt,
    projectWith: async (packages, files, places = ['public', 'assets']) => {
      const folder = await mkdtemp(join(tmpdir(), 'seamwise-project-'));
      folders.push(folder);
      const own = {'package.json': '{"name": "shop", "private": true, "type": "module"}', ...files};
      for (const [name, text] of Object.entries(own)) {
        await mkdir(dirname(join(folder, name)), {recursive: true});
        await writeFile(join(folder, name), text);
      }
      const words = ['install', '--no-audit', '--no-fund', all.tarball, 'three', ...packages];
      await run('npm', words, {cwd: folder});
      for (const part of ['garments', 'prints', 'icon.svg']) {
        for (const place of places) {
          await mkdir(join(folder, place), {recursive: true});
          await cp(join(samples, part), join(folder, place, part), {recursive: true});
        }
      }
      return folder;
    },
    works: async (site, policy = ownFiles, maySay) => {
      const {url, close} = await serveFiles(site, policy);
      await worksAt(url, maySay);
      await close();
    },
  };
}
