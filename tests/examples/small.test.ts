/** The small examples: in Node, with Vite, and with a script tag. */
import {execFile} from 'node:child_process';
import {cp, readFile} from 'node:fs/promises';
import {join} from 'node:path';
import {promisify} from 'node:util';

import {resultText, solve} from 'seamwise/node';
import {expect, it, onTestFinished} from 'vitest';

import {serveFiles} from '../support/page/browser.js';
import {samples, solved, useChromium, useExamples} from '../support/package/examples.js';

const run = promisify(execFile);
const {copy, serve} = useExamples();
// messages of Vite and Lit for developers
const open = useChromium(/^\[vite\] connect(ing|ed)|^Lit is in dev mode/);

it('solves in Node, and writes the result', async () => {
  const folder = await copy('node');
  const files = ['garments/tee-s.json', 'prints/p4m.json'].map((path) => join(samples, path));
  const {stdout} = await run(process.execPath, ['solve.mjs', ...files, 'out.json'], {cwd: folder});
  expect(stdout).toMatch(/^mismatch [\d.]+ cm², by chance [\d.]+ cm²\n$/);
  const [garment = '', print = ''] = await Promise.all(files.map((file) => readFile(file, 'utf8')));
  const expected = resultText(await solve({garment, print}));
  expect(await readFile(join(folder, 'out.json'), 'utf8')).toBe(expected);
});

/** Runs Vite in the example's folder, under the policy of its settings. */
async function vite(folder: string, words: readonly string[]): Promise<string> {
  return serve(folder, [join(folder, 'node_modules/vite/bin/vite.js'), ...words, '--port', '0']);
}

it('works with Vite, served to its developer and built', {tags: ['thorough']}, async () => {
  const folder = await copy('vite', ['three', 'vite']);
  await cp(samples, join(folder, 'public'), {recursive: true});
  await solved(await open(await vite(folder, ['dev'])));
  const program = join(folder, 'node_modules/vite/bin/vite.js');
  await run(process.execPath, [program, 'build'], {cwd: folder, env: {PATH: process.env.PATH}});
  await solved(await open(await vite(folder, ['preview'])));
});

it('works by a script tag alone', async () => {
  const folder = await copy('script-tag');
  await cp(samples, join(folder, 'samples'), {recursive: true});
  const {url, close} = await serveFiles(folder, "default-src 'self' 'wasm-unsafe-eval'");
  onTestFinished(close); // the page keeps loading, so it is closed first
  await solved(await open(url));
});
