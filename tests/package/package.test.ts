/** The published package from outside: its tarball, installed in an empty folder. */
import {execFile} from 'node:child_process';
import {mkdir, mkdtemp, readFile, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join, posix} from 'node:path';
import {promisify} from 'node:util';
import {gzipSync} from 'node:zlib';

import {publint} from 'publint';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {tool} from '../../web/setup/shell.mjs';
import {isThorough} from '../support/level.js';
import {packed, type Packed} from '../support/package/packed.js';

const kilobyte = 1000;
/**
 * Most bytes of the compressed package, as the registry sends it; three is not included. The fonts of
 * PDF files are 58 kB of it.
 */
const mostForPackage = 1430 * kilobyte;
/**
 * Most bytes of the scripts for pages without a bundler, with three and Lit, without the solver's
 * module. The fonts of PDF files, 58 kB, are fetched with the first PDF.
 */
const mostForStandalone = 695 * kilobyte;
/** Most bytes of the drape's module, which only pages with a draped garment fetch. */
const mostForDrape = 114 * kilobyte;
/** Most bytes of the layout's module, which is fetched only for layouts. */
const mostForMarker = 45 * kilobyte;
/** Most bytes of the module that reads prints from images, fetched when such an image is opened. */
const mostForPhoto = 72 * kilobyte;

let all: Packed;
let remove: (() => Promise<void>) | undefined;

beforeAll(async () => {
  all = await packed();
  ({remove} = all);
});

afterAll(() => remove?.());

it('lists in its guide all files that bundlers leave behind', async () => {
  const guide = await readFile(join(all.folder, 'docs/frameworks.md'), 'utf8');
  const [, names = ''] = /const names = \[([^;]*)\];/.exec(guide) ?? [];
  const shipped = [...all.files.keys()].flatMap(
    (file) => /^dist\/standalone\/(solver\..*\.js|.*\.wasm)$/.exec(file)?.[1] ?? [],
  );
  expect([...names.matchAll(/'([^']+)'/g)].map(([, name]) => name).sort()).toEqual(shipped.sort());
});

/** Import names of the entries that are modules. */
const modules = (): readonly string[] =>
  Object.keys(all.manifest.exports)
    .filter((entry) => !/\.(json|wasm)$|\*/.test(entry))
    .map((entry) => `seamwise${entry.slice(1)}`);

it('is a sound package, as publint sees it', async () => {
  const {buffer} = new Uint8Array(await readFile(all.tarball));
  const {messages} = await publint({pack: {tarball: buffer}, strict: true});
  expect(messages).toEqual([]);
});

it.runIf(isThorough)('has types that every resolver of ES modules finds', async () => {
  const [node, attw] = tool('@arethetypeswrong/cli', 'attw');
  const asked = ['--profile', 'esm-only', '--format', 'ascii', '--no-definitely-typed'];
  const modules = ['seamwise', 'drape', 'marker', 'photo'].map((name) => `./${name}.wasm`);
  const data = ['--exclude-entrypoints', ...modules]; // data files have no types
  const complaint = await promisify(execFile)(node, [attw, all.tarball, ...asked, ...data]).then(
    () => undefined,
    (error: unknown) => (error as {stdout: string}).stdout,
  );
  expect(complaint).toBeUndefined();
});

/**
 * Script that imports an entry, waits for its effects, and prints what is left: elements, globals,
 * open handles.
 */
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
  const bytes = compressed(
    (file) => file.startsWith('dist/') && !isStandalone(file) && !file.endsWith('.map'),
  );
  expect(bytes).toBeGreaterThan(200 * kilobyte); // it includes the solver
  expect(bytes).toBeLessThan(mostForPackage);
  const drape = compressed((file) => file === 'dist/solver/module/drape.wasm');
  expect(drape).toBeGreaterThan(50 * kilobyte);
  expect(drape).toBeLessThan(mostForDrape);
  const marker = compressed((file) => file === 'dist/solver/module/marker.wasm');
  expect(marker).toBeGreaterThan(10 * kilobyte);
  expect(marker).toBeLessThan(mostForMarker);
  const photo = compressed((file) => file === 'dist/solver/module/photo.wasm');
  expect(photo).toBeGreaterThan(10 * kilobyte);
  expect(photo).toBeLessThan(mostForPhoto);
});

it('is not much larger for pages without a bundler', () => {
  const bytes = compressed((file) => isStandalone(file) && file.endsWith('.js'));
  expect(bytes).toBeGreaterThan(150 * kilobyte); // it includes three
  expect(bytes).toBeLessThan(mostForStandalone);
});

/** Files to read, try or keep that are not part of the program. */
const besides =
  /^(LICENSE|(README|CHANGELOG|CONTRIBUTING)\.md|docs\/[\w-]+\.md|dist\/(standalone\/)?THIRD-PARTY-NOTICES\.md|web\/examples\/.*|public\/(garments|prints|schema)\/.*)$/;

it('has its licence, and those of all that is in it, beside whatever is passed on', () => {
  const text = (file: string): string => all.files.get(file)?.toString() ?? '';
  expect(all.manifest.license).toBe('MIT');
  expect(text('LICENSE')).toContain('Seamwise contributors');
  for (const file of ['dist/THIRD-PARTY-NOTICES.md', 'dist/standalone/THIRD-PARTY-NOTICES.md']) {
    for (const words of ['Seamwise contributors', 'three.js authors', 'Google LLC', 'noble']) {
      expect(text(file), file).toContain(words);
    }
    for (const words of ['Mozilla Public License', 'gitlab.com/libeigen', 'musl']) {
      expect(text(file), file).toContain(words);
    }
  }
});

it('brings one garment, one print and the schemas to try it with', async () => {
  const {output} = await all.node(`
    import {readFile} from 'node:fs/promises';
    import {order, solve} from 'seamwise/node';
    const at = (path) => new URL(import.meta.resolve('seamwise/samples/' + path));
    const [garment, print] = await Promise.all(
      ['garments/tee-m.json', 'prints/p4m.json'].map((path) => readFile(at(path), 'utf8')),
    );
    for (const {image} of JSON.parse(print).colourways) await readFile(at('prints/' + image));
    await readFile(at('schema/seamwise-design-1.schema.json'));
    console.log((await solve({garment, print})).pieces.length);
  `);
  expect(output).toBe('4\n');
});

it('has no link in its texts that leads to nothing, but to pictures', () => {
  const broken = [...all.files].flatMap(([file, bytes]) => {
    if (!file.endsWith('.md')) return [];
    return [...bytes.toString().matchAll(/\]\((?!https?:|#)([^)#]+)/g)]
      .map(([, link = '']) => posix.join(posix.dirname(file), link))
      .filter((link) => !/\.(png|svg|webp)$/.test(link))
      .filter(
        (link) => ![...all.files.keys()].some((one) => one === link || one.startsWith(`${link}/`)),
      );
  });
  expect(broken).toEqual([]);
});

it('shows its sources to debuggers', () => {
  const scripts = [...all.files.keys()].filter((file) =>
    /^dist\/(?!standalone|solver\/module|texts\/\w\w\/).*\.js$/.test(file),
  );
  const without = scripts.filter((file) => {
    const map = all.files.get(`${file}.map`)?.toString();
    return (
      map === undefined || !(JSON.parse(map) as {sourcesContent?: string[]}).sourcesContent?.[0]
    );
  });
  expect(without).toEqual([]);
});

/** TypeScript that uses the package, with the errors that it has to cause. */
const usage = `
  import {leaseSolver, SolverClient} from 'seamwise';
  import 'seamwise/element/auto';
  import {SeamwiseGarment} from 'seamwise/element';
  import {order, solve} from 'seamwise/node';
  import type {} from 'seamwise/react';
  import type {JSX} from 'react';
  export const used = [leaseSolver, order, solve];
  using client = new SolverClient();
  const element = document.createElement('seamwise-garment');
  element.mode = 'place';
  element.garment = null;
  // @ts-expect-error there is no such mode
  element.mode = 'plaice';
  new SeamwiseGarment().addEventListener('solve', ({detail}) => detail.metrics.fit);
  type Tag = JSX.IntrinsicElements['seamwise-garment'];
  export const tag: Tag = {
    ...{garment: '/tee.json', size: 'm', 'max-change-mm': 5, className: 'wide'},
    onchange: ({detail}) => detail.design?.seed,
  };
  // @ts-expect-error there is no such mode either
  export const wrong: Tag = {mode: 'plaice'};
`;
/** The part of React's types that the package's own types extend. */
const react = `
  export interface HTMLAttributes<T> {className?: string; onChange?: (event: T) => void}
  export type DetailedHTMLProps<E extends HTMLAttributes<T>, T> = E & {ref?: T};
  export namespace JSX {interface IntrinsicElements {a: object}}
`;

it('has types that need no others, no newer library, and no indulgence', async () => {
  const home = await mkdtemp(join(tmpdir(), 'seamwise-types-'));
  try {
    await all.installIn(home, ['three', '@types/three']);
    await mkdir(join(home, 'node_modules/react'));
    await writeFile(join(home, 'node_modules/react/index.d.ts'), react);
    await writeFile(join(home, 'use.ts'), usage);
    const [node, tsc] = tool('typescript', 'tsc');
    const compilerOptions = {
      ...{strict: true, noEmit: true, skipLibCheck: false, types: []},
      ...{target: 'es2022', lib: ['es2022', 'dom', 'dom.iterable']},
      ...{module: 'esnext', moduleResolution: 'bundler'},
    };
    const config = JSON.stringify({compilerOptions, files: ['use.ts']});
    await writeFile(join(home, 'tsconfig.json'), config);
    const complaints = await promisify(execFile)(node, [tsc], {cwd: home}).then(
      () => '',
      (error: unknown) => (error as {stdout: string}).stdout,
    );
    expect(complaints).toBe('');
  } finally {
    await rm(home, {recursive: true});
  }
});

/** Paths in the package that a script or declaration refers to. */
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
  const entries = Object.values(all.manifest.exports)
    .flatMap((entry) => (typeof entry === 'string' ? [entry] : Object.values(entry)))
    .filter((entry) => !entry.includes('*'));
  const reached = new Set<string>();
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
  // TypeScript writes an empty script for a file that contains only types
  const isEmpty = (file: string): boolean =>
    /^export \{\};\s*(\/\/# sourceMappingURL=.*)?$/.test(
      all.files.get(file)?.toString('latin1').trim() ?? '',
    );
  const more = [...all.files.keys()].filter((file) => {
    const script = file.replace(/\.map$/, '');
    return !reached.has(script) && !isEmpty(script) && !besides.test(file);
  });
  expect(more).toEqual([]);
});

/** Banned code by its phrase in the test titles "has no file that ...". */
const banned: Readonly<Record<string, RegExp>> = {
  'evaluates text': /\beval\(|\bnew Function\b/,
  'makes a worker of text': /new Blob\(\[[^\]]*\][^)]*(?:java|ecma)script/,
  'has a script in an address': /\bdata:(?:text|application)\/(?:java|ecma)script/,
  'names a host, but for the names of formats': /\bhttps?:\/\/(?!www\.(?:w3|inkscape)\.org\/)[\w-]/,
};

it.each(Object.entries(banned))('has no file that %s', (_, pattern) => {
  const code = [...all.files].filter(([file]) => /^dist\/.*\.(js|mjs)$/.test(file));
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
