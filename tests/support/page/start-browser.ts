/** Shared start of all browser tests: builds their pages once and starts one browser. */
import {fileURLToPath} from 'node:url';

import {preview} from 'vite';
import type {TestProject} from 'vitest/node';

import {build} from '../../../web/setup/build.mjs';
import {addressOf, launchBrowser, serveFolder} from './browser.js';

declare module 'vitest' {
  interface ProvidedContext {
    /** Address of the browser. */
    readonly browser: string;
    /** Address of the page as users get it. */
    readonly page: string;
    /** Addresses of the folders of tests/support/pages, served from their sources. */
    readonly sources: Readonly<Record<string, string>>;
  }
}

const at = (path: string): string => fileURLToPath(new URL(`../../../${path}`, import.meta.url));
/** Folders of tests/support/pages with a page in each. */
const pages = ['loader', 'solver', 'storage', 'viewer'];

export default async function start(project: TestProject): Promise<() => Promise<void>> {
  await build('tarball', 'page', 'fixtures');
  const browser = await launchBrowser();
  const page = await preview({
    configFile: at('vite.config.ts'),
    logLevel: 'warn',
    preview: {port: 0, strictPort: false},
  });
  const sources = await Promise.all(
    pages.map((name) => serveFolder(at(`tests/support/pages/${name}`))),
  );
  project.provide('browser', browser.wsEndpoint());
  project.provide('page', addressOf(page.httpServer));
  project.provide(
    'sources',
    Object.fromEntries(pages.map((name, k) => [name, sources[k]?.url ?? ''])),
  );
  return async () => {
    await Promise.all([browser.close(), page.close(), ...sources.map(({close}) => close())]);
  };
}
