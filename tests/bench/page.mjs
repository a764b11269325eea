// The page's download size and the time of a cold start until the final answer.
import {mkdtemp, readdir, readFile, rm} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {gzipSync} from 'node:zlib';

import {chromium} from 'playwright-core';
import {preview} from 'vite';

import {build} from '../../web/setup/build.mjs';
import {chromiumPath} from '../../web/setup/chromium.mjs';
import {must, root, tool} from '../../web/setup/shell.mjs';
import {ensureSystem, forBrowserTests} from '../../web/setup/system.mjs';
import {median} from './numbers.mjs';

const openings = 3;
const configFile = join(root, 'vite.config.ts');

/**
 * Measures compressed sizes as a host would send them [bytes] and the time of a cold start [ms].
 */
export async function measurePage({say}) {
  say('page');
  await ensureSystem(forBrowserTests);
  await build('scripts');
  const outDir = await mkdtemp(join(tmpdir(), 'seamwise-bench-page-'));
  try {
    const [node, vite] = tool('vite');
    await must(node, [vite, 'build', '--config', configFile, '--outDir', outDir]);
    return {...(await onServer(outDir)), pdfReader: await pdfReaderIn(outDir)};
  } finally {
    await rm(outDir, {recursive: true});
  }
}

/** Compressed size of the reader of PDF, which is loaded with the first PDF. [bytes] */
async function pdfReaderIn(outDir) {
  const folder = join(outDir, 'assets');
  const names = (await readdir(folder)).filter((name) =>
    /^(?:pdf|pdf\.worker|read-pdf)-.*\.js$/.test(name),
  );
  const files = await Promise.all(names.map((name) => readFile(join(folder, name))));
  return files.reduce((sum, file) => sum + gzipSync(file, {level: 9}).length, 0);
}

async function onServer(outDir) {
  const settings = {configFile, logLevel: 'warn', build: {outDir}};
  const server = await preview({...settings, preview: {port: 0, strictPort: false}});
  const asRoot = process.getuid?.() === 0 ? ['--no-sandbox'] : []; // the sandbox fails as root
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: [...asRoot, '--enable-unsafe-swiftshader'],
  });
  try {
    const url = `http://localhost:${server.httpServer.address().port}/`;
    const times = [];
    let files = [];
    for (let k = 0; k < openings; k++) {
      const opened = await coldOpening(browser, url);
      times.push(opened.milliseconds);
      files = opened.files;
    }
    const sizes = await Promise.all(files.map(sizeOf));
    const bytes = (wanted) =>
      sizes.reduce((sum, [file, size]) => sum + (wanted.test(file) ? size : 0), 0);
    return {
      code: bytes(/^(?!three-).*\.js$/),
      drawingLibrary: bytes(/^three-.*\.js$/),
      wasm: bytes(/\.wasm$/),
      opening: median(times),
      openings: times,
    };
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Opens the page without any cache and waits for the final answer. */
async function coldOpening(browser, url) {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}});
  try {
    const page = await context.newPage();
    const files = new Set();
    page.on('request', (request) => {
      if (/\.(js|wasm)$/.test(request.url())) files.add(request.url());
    });
    const started = performance.now();
    await page.goto(url);
    const progress = page.getByRole('status', {name: 'Progress'});
    await progress.filter({hasText: /^Matched in/}).waitFor({timeout: 120_000});
    return {milliseconds: performance.now() - started, files: [...files]};
  } finally {
    await context.close();
  }
}

async function sizeOf(url) {
  const body = await (await fetch(url)).arrayBuffer();
  const file = new URL(url).pathname.split('/').at(-1);
  return [file, gzipSync(new Uint8Array(body), {level: 9}).length];
}
