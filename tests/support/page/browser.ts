/** A real browser for tests, and servers for the page's variants. */
import type {AddressInfo} from 'node:net';
import {join} from 'node:path';
import {buffer} from 'node:stream/consumers';
import {fileURLToPath} from 'node:url';

import {
  chromium,
  type Browser,
  type BrowserContext,
  type BrowserServer,
  type Download,
} from 'playwright-core';
import {createServer, preview, type InlineConfig} from 'vite';
import {inject} from 'vitest';

import {chromiumPath} from '../../../web/setup/chromium.mjs';
import {count} from '../../../web/setup/counts.mjs';

const project = fileURLToPath(new URL('../../..', import.meta.url));

/** Policy of a strict host: no other origins, no inline script, no eval, no blob. */
export const strictPolicy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
].join('; ');

/** A folder served on its own port. */
export interface Served {
  /** Ends with a slash. */
  readonly url: string;
  readonly close: () => Promise<void>;
}

/** Starts the browser that all test files share. */
export async function launchBrowser(): Promise<BrowserServer> {
  const executablePath = chromiumPath();
  if (executablePath === null) {
    throw new Error('There is no Chromium; install it, or set CHROME_PATH.');
  }
  // Chromium refuses to run as root inside its sandbox; software rendering draws WebGL.
  const asRoot = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  count('browser start');
  return chromium.launchServer({executablePath, args: [...asRoot, '--enable-unsafe-swiftshader']});
}

/** Connects to the browser. Closing the connection closes the contexts it opened. */
export async function openBrowser(): Promise<Browser> {
  const browser = await chromium.connect(inject('browser'));
  const newContext = browser.newContext.bind(browser);
  browser.newContext = async (options) => {
    const context = await newContext(options);
    await watchWorkers(context);
    return context;
  };
  return browser;
}

/**
 * Counts the solves that pages request from their workers, most of a test's cost, and the current
 * workers: Playwright misses the end of some.
 */
async function watchWorkers(context: BrowserContext): Promise<void> {
  await context.exposeBinding('countSolve', () => {
    count('page solve');
  });
  await context.addInitScript(() => {
    if (typeof Worker === 'undefined') return;
    const {countSolve} = globalThis as unknown as {countSolve: () => Promise<void>};
    const methodOf = (name: 'postMessage' | 'terminate') =>
      Object.getOwnPropertyDescriptor(Worker.prototype, name)?.value as (
        ...words: unknown[]
      ) => void;
    const [post, terminate] = [methodOf('postMessage'), methodOf('terminate')];
    const workersAtHand = new Set<Worker>();
    const ended = new WeakSet<Worker>();
    Object.assign(globalThis, {workersAtHand});
    Worker.prototype.postMessage = function (this: Worker, ...words: unknown[]) {
      if (!ended.has(this)) workersAtHand.add(this);
      if ((words[0] as {name?: unknown} | undefined)?.name === 'solve') void countSolve();
      post.apply(this, words);
    };
    Worker.prototype.terminate = function (this: Worker) {
      workersAtHand.delete(this);
      ended.add(this);
      terminate.call(this);
    };
  });
}

/** The file that a page saves. */
export const bytesOf = async (download: Download): Promise<Buffer> =>
  buffer(await download.createReadStream());

/** The address of a page of tests/support/pages, served from its sources. */
export function sourcesOf(name: 'loader' | 'solver' | 'storage' | 'viewer'): string {
  const url = inject('sources')[name];
  if (url === undefined) throw new Error(`Nothing serves tests/support/pages/${name}.`);
  return url;
}

/**
 * Serves the sources in `folder`, and their imports from the project, by Vite's development server.
 */
export async function serveFolder(folder: string): Promise<Served> {
  const server = await createServer({
    ...settings(folder),
    server: {port: 0, hmr: false, watch: null, fs: {allow: [project]}},
    optimizeDeps: {noDiscovery: true},
  });
  await server.listen();
  return {url: addressOf(server.httpServer), close: () => server.close()};
}

/**
 * Serves a page of tests/support/pages as built for production, under a content security policy: a strict
 * one by default.
 */
export const serveBuilt = (name: 'element' | 'solver', policy = strictPolicy): Promise<Served> =>
  serveFiles(join(project, 'build/fixtures', name), policy);

/** Serves a folder unchanged, under the same policy. */
export async function serveFiles(outDir: string, policy = strictPolicy): Promise<Served> {
  const server = await preview({
    ...settings(project),
    appType: 'mpa',
    build: {outDir},
    preview: {port: 0, headers: {'Content-Security-Policy': policy}},
  });
  return {url: addressOf(server.httpServer), close: () => server.close()};
}

function settings(root: string): InlineConfig {
  return {root, configFile: false, logLevel: 'warn', publicDir: false};
}

export function addressOf(server: {address(): string | AddressInfo | null} | null): string {
  const address = server?.address();
  if (typeof address !== 'object' || address === null) throw new Error('The server has no port.');
  return `http://localhost:${address.port}/`;
}
