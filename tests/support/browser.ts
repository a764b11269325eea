/** A real browser for tests, and the page served to it in the ways that there are. */
import {mkdtemp, rm} from 'node:fs/promises';
import type {AddressInfo} from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {chromium, type Browser} from 'playwright-core';
import {build, createServer, preview, type InlineConfig} from 'vite';

import {chromiumPath} from '../../web/setup/chromium.mjs';

const project = fileURLToPath(new URL('../..', import.meta.url));

/** What a careful host allows: nothing from elsewhere, no inline script, no eval, no blob. */
export const strictPolicy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
].join('; ');

/** A folder on a port of its own. */
export interface Served {
  /** Ends with a slash. */
  readonly url: string;
  readonly close: () => Promise<void>;
}

export async function openBrowser(): Promise<Browser> {
  const executablePath = chromiumPath();
  if (executablePath === null) {
    throw new Error('There is no Chromium; install it, or set CHROME_PATH.');
  }
  // Chromium refuses to run as root inside its sandbox; WebGL is drawn in software.
  const asRoot = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  return chromium.launch({executablePath, args: [...asRoot, '--enable-unsafe-swiftshader']});
}

/** The sources in `folder`, and whatever of the project they import, by Vite's development server. */
export async function serveSources(folder: string): Promise<Served> {
  const server = await createServer({
    ...settings(folder),
    server: {port: 0, hmr: false, watch: null, fs: {allow: [project]}},
    optimizeDeps: {noDiscovery: true},
  });
  await server.listen();
  return {url: addressOf(server.httpServer), close: () => server.close()};
}

/** The same, as Vite builds it for production, under a content security policy: a strict one by itself. */
export async function serveBuilt(folder: string, policy = strictPolicy): Promise<Served> {
  const outDir = await mkdtemp(join(tmpdir(), 'seamwise-page-'));
  await build({...settings(folder), base: './', build: {outDir, emptyOutDir: true}});
  const {url, close} = await serveFiles(outDir, policy);
  return {
    url,
    close: async () => {
      await close();
      await rm(outDir, {recursive: true});
    },
  };
}

/** A folder as it is, under the same policy. */
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

function addressOf(server: {address(): string | AddressInfo | null} | null): string {
  const address = server?.address();
  if (typeof address !== 'object' || address === null) throw new Error('The server has no port.');
  return `http://localhost:${address.port}/`;
}
