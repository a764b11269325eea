/** What is published, seen from outside: the tarball, installed in an empty folder. */
import {execFile} from 'node:child_process';
import {readFile} from 'node:fs/promises';
import {posix} from 'node:path';
import {promisify} from 'node:util';
import {gzipSync} from 'node:zlib';

import {publint} from 'publint';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {tool} from '../../web/setup/shell.mjs';
import {packed, type Packed} from '../support/packed.js';

const kilobyte = 1000;
/** Compressed as a whole, as the registry sends it; three is not in it. [bytes] */
const mostForPackage = 450 * kilobyte;
/** The scripts for pages without a bundler, three and Lit included, the solver's module not. [bytes] */
const mostForStandalone = 330 * kilobyte;

let all: Packed;
let remove: (() => Promise<void>) | undefined;

beforeAll(async () => {
  all = await packed();
  ({remove} = all);
});

afterAll(() => remove?.());

/** Names of the entries that are modules, as they are imported. */
const modules = (): readonly string[] =>
  Object.keys(all.manifest.exports)
    .filter((entry) => !/\.(json|wasm)$/.test(entry))
    .map((entry) => `seamwise${entry.slice(1)}`);

it('is a sound package, as publint sees it', async () => {
  const {buffer} = new Uint8Array(await readFile(all.tarball));
  const {messages} = await publint({pack: {tarball: buffer}, strict: true});
  expect(messages).toEqual([]);
});

it('has types that every resolver of ES modules finds', async () => {
  const [node, attw] = tool('@arethetypeswrong/cli', 'attw');
  const asked = ['--profile', 'esm-only', '--format', 'ascii', '--no-definitely-typed'];
  const data = ['--exclude-entrypoints', './seamwise.wasm']; // no module, so that it has no types
  const complaint = await promisify(execFile)(node, [attw, all.tarball, ...asked, ...data]).then(
    () => undefined,
    (error: unknown) => (error as {stdout: string}).stdout,
  );
  expect(complaint).toBeUndefined();
});

/** Imports, waits for what that may have begun, and tells what it has left: elements, globals, open handles. */
const trial = (entry: string): string => `
  const elements = [];
  globalThis.customElements = {get: () => undefined, define: (name) => elements.push(name)};
  const before = new Set(Object.getOwnPropertyNames(globalThis));
  const busy = process.getActiveResourcesInfo();
  await import('${entry}');
  await new Promise((resolve) => setTimeout(resolve, 50));
  const news = Object.getOwnPropertyNames(globalThis).filter((name) => !before.has(name));
  const left = process.getActiveResourcesInfo();
  console.log(JSON.stringify({elements, news, left: left.slice(busy.length)}));
`;

interface Traces {
  readonly elements: readonly string[];
  readonly news: readonly string[];
  readonly left: readonly string[];
}

it('does nothing when it is imported by Node, in whichever entry', async () => {
  const lit = JSON.parse((await all.node(trial('lit'))).output) as Traces;
  for (const entry of modules()) {
    const {output, complaints} = await all.node(trial(entry));
    expect(complaints, entry).toBe('');
    expect(output.trim().split('\n'), entry).toHaveLength(1);
    const {elements, news, left} = JSON.parse(output) as Traces;
    const own = news.filter((name) => !lit.news.includes(name));
    expect({elements, own, left}, entry).toEqual({elements: [], own: [], left: []});
  }
});

it('solves in Node, from where it is installed', async () => {
  const square = [
    [0, 0],
    [10, 0],
    [10, 10],
    [0, 10],
  ];
  const edges = square.map((_, k) => ({endpoints: [k, (k + 1) % 4]}));
  const panel = {vertices: square, edges};
  const seam = [
    {panel: 'a', edge: 1},
    {panel: 'b', edge: 3},
  ];
  const garment = {pattern: {panels: {a: panel, b: panel}, stitches: [seam]}};
  const print = {group: 'p1', w1: [5, 0], w2: [0, 5]};
  const {output} = await all.node(`
    import {solve} from 'seamwise/node';
    const {pieces} = await solve(${JSON.stringify({garment, print})});
    console.log(pieces.map(({name}) => name).join());
  `);
  expect(output).toBe('a,b\n');
});

it('hands out nothing but its entries', async () => {
  const {output} = await all.node(`
    for (const path of ['seamwise/nothing', 'seamwise/dist/index.js']) {
      await import(path).catch(({code}) => console.log(code));
    }
  `);
  expect(output.trim().split('\n')).toEqual(Array(2).fill('ERR_PACKAGE_PATH_NOT_EXPORTED'));
});

it('hands out the module of the solver as a file', async () => {
  const {output} = await all.node(`
    import {readFileSync} from 'node:fs';
    const bytes = readFileSync(new URL(import.meta.resolve('seamwise/seamwise.wasm')));
    console.log(WebAssembly.validate(bytes));
  `);
  expect(output).toBe('true\n');
});

const compressed = (wanted: (file: string) => boolean): number => {
  const chosen = [...all.files].filter(([file]) => wanted(file)).map(([, bytes]) => bytes);
  return gzipSync(Buffer.concat(chosen), {level: 9}).length;
};

const isStandalone = (file: string): boolean => file.startsWith('dist/standalone/');

it('is small', () => {
  const bytes = compressed((file) => !isStandalone(file));
  expect(bytes).toBeGreaterThan(200 * kilobyte); // the solver is in it
  expect(bytes).toBeLessThan(mostForPackage);
});

it('is not much larger for pages without a bundler', () => {
  const bytes = compressed((file) => isStandalone(file) && file.endsWith('.js'));
  expect(bytes).toBeGreaterThan(150 * kilobyte); // three is in it
  expect(bytes).toBeLessThan(mostForStandalone);
});

/** What a script or declaration refers to, by its path in the package. */
function references(file: string, bytes: Buffer): string[] {
  const code = bytes.toString('latin1');
  const isDeclaration = /\.d\.m?ts$/.test(file);
  const imports = [...code.matchAll(/(?:\bfrom|\bimport)\s*\(?\s*["'`](\.[^"'`]+)["'`]/g)];
  const places = [...code.matchAll(/\bnew URL\(["'`]([\w./-]+)["'`],\s*import\.meta\.url\)/g)];
  return [...imports, ...(isDeclaration ? [] : places)].map(([, target = '']) =>
    posix.join(
      posix.dirname(file),
      isDeclaration ? target.replace(/\.(m?)js$/, '.d.$1ts') : target,
    ),
  );
}

it('holds all that its entries lead to, and nothing else', () => {
  const entries = Object.values(all.manifest.exports).flatMap((entry) =>
    typeof entry === 'string' ? [entry] : Object.values(entry),
  );
  const reached = new Set<string>(['README.md']);
  const follow = (file: string): void => {
    if (reached.has(file)) return;
    reached.add(file);
    const bytes = all.files.get(file);
    if (bytes && /\.(js|mjs|ts|mts)$/.test(file)) references(file, bytes).forEach(follow);
  };
  for (const file of [...entries, ...Object.values(all.manifest.bin)])
    follow(posix.normalize(file));
  const missing = [...reached].filter((file) => !all.files.has(file));
  expect(missing).toEqual([]);
  // TypeScript leaves an empty script of a file that holds types alone
  const more = [...all.files].filter(
    ([file, bytes]) => !reached.has(file) && bytes.toString('latin1').trim() !== 'export {};',
  );
  expect(more.map(([file]) => file)).toEqual([]);
});

/** Each with what it is in the sentence "no file ...". */
const banned: Readonly<Record<string, RegExp>> = {
  'evaluates text': /\beval\(|\bnew Function\b/,
  'makes a worker of text': /new Blob\(\[[^\]]*\][^)]*(?:java|ecma)script/,
  'has a script in an address': /\bdata:(?:text|application)\/(?:java|ecma)script/,
  'names a host, but for the names of formats': /\bhttps?:\/\/(?!www\.w3\.org\/)[\w-]/,
};

it.each(Object.entries(banned))('has no file that %s', (_, pattern) => {
  const code = [...all.files].filter(([file]) => /\.(js|mjs)$/.test(file));
  const offences = code.filter(([, bytes]) => pattern.test(bytes.toString('latin1')));
  expect(offences.map(([file]) => file)).toEqual([]);
});

it('finds its worker as bundlers can see it', () => {
  const starts = [...all.files]
    .filter(([file]) => file.endsWith('.js') && !isStandalone(file))
    .flatMap(([, bytes]) => bytes.toString('latin1').match(/new Worker\(.*\)/g) ?? [])
    .filter((start) => start.includes('import.meta.url'));
  expect(starts).toEqual([
    "new Worker(new URL('./solver.worker.js', import.meta.url), { type: 'module' })",
  ]);
});
