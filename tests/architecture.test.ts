import {readdirSync, readFileSync} from 'node:fs';
import {dirname, extname, join, normalize, relative, sep} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

const root = fileURLToPath(new URL('..', import.meta.url));

/** What a folder of wasm/src may include, besides itself. Arrows run one way. */
const coreLayers: Readonly<Record<string, readonly string[]>> = below([
  ['geometry'],
  ['pattern', 'wallpaper'],
  ['symmetry'],
  ['alignment'],
  ['seam'],
  ['deform'],
  ['solve'],
  ['io'],
  ['bindings'],
]);

/** What a folder of web/src may import, besides itself. */
const webLayers: Readonly<Record<string, readonly string[]>> = {
  model: [],
  solver: ['model'],
  clicks: ['model'],
  picture: ['model'],
  viewer: ['model', 'clicks', 'picture'], // never the solver: views read a result
  remedies: ['model', 'picture'],
  element: ['model', 'solver', 'clicks', 'picture', 'viewer', 'remedies'],
  app: ['model', 'element', 'picture'],
  node: ['model', 'solver', 'picture', 'remedies'],
  cli: ['model', 'node', 'picture', 'remedies'],
  '': ['model', 'solver'], // index.ts, the entry of the package
};

/** Every layer may use all the layers before its own. */
function below(layers: readonly (readonly string[])[]): Record<string, readonly string[]> {
  return Object.fromEntries(
    layers.flatMap((layer, level) => layer.map((name) => [name, layers.slice(0, level).flat()])),
  );
}

function filesUnder(folder: string, extensions: readonly string[]): string[] {
  return readdirSync(join(root, folder), {recursive: true, withFileTypes: true})
    .filter((entry) => entry.isFile() && extensions.includes(extname(entry.name)))
    .map((entry) => join(entry.parentPath, entry.name));
}

/** Every dependency of a file, as found by `pattern`, whose first group is what is asked for. */
function references(file: string, pattern: RegExp): string[] {
  return [...readFileSync(file, 'utf8').matchAll(pattern)].map((match) => match[1] ?? '');
}

/** Files directly in the source folder count as the layer ''. */
function layerOf(file: string, folder: string): string {
  const parts = relative(join(root, folder), file).split(sep);
  return parts.length > 1 ? (parts[0] ?? '') : '';
}

const coreFiles = filesUnder('wasm/src', ['.h', '.cpp']);
const webFiles = filesUnder('web/src', ['.ts', '.mts']);
const includes = /^\s*#\s*include\s+"([^"]+)"/gm;
const systemIncludes = /^\s*#\s*include\s+<([^>]+)>/gm;
const imports = /(?:\bfrom|\bimport)\s*\(?\s*'(\.[^']+)'/g;
const packages = /(?:\bfrom|\bimport)\s*\(?\s*'([^.'][^']*)'/g;

it('lets the layers of the core depend only on those below them', () => {
  const offences = coreFiles.flatMap((file) => {
    const own = layerOf(file, 'wasm/src');
    const allowed = [own, ...(coreLayers[own] ?? [])];
    return references(file, includes)
      .filter((header) => !allowed.includes(header.split('/')[0] ?? ''))
      .map((header) => `${relative(root, file)} includes ${header}`);
  });
  expect(offences).toEqual([]);
});

it('knows every folder of the sources', () => {
  const unknown = [
    ...coreFiles.map((file) => layerOf(file, 'wasm/src')).filter((name) => !(name in coreLayers)),
    ...webFiles.map((file) => layerOf(file, 'web/src')).filter((name) => !(name in webLayers)),
  ];
  expect([...new Set(unknown)]).toEqual([]);
});

it('keeps JavaScript, streams, clocks and true randomness out of the core', () => {
  const banned = /^(emscripten.*|iostream|chrono|ctime|time\.h|sys\/time\.h)$/;
  const offences = coreFiles
    .filter((file) => layerOf(file, 'wasm/src') !== 'bindings')
    .flatMap((file) => [
      ...references(file, systemIncludes).filter((header) => banned.test(header)),
      ...references(file, /\b(std::random_device|std::rand|srand)\b/g),
    ]);
  expect(offences).toEqual([]);
});

it('lets the folders of the web sources import only what they may', () => {
  const offences = webFiles.flatMap((file) => {
    const own = layerOf(file, 'web/src');
    const allowed = [own, ...(webLayers[own] ?? [])];
    return references(file, imports)
      .map((path) => normalize(join(dirname(file), path)))
      .filter((target) => !allowed.includes(layerOf(target, 'web/src')))
      .map((target) => `${relative(root, file)} imports ${relative(root, target)}`);
  });
  expect(offences).toEqual([]);
});

it('uses Node only where Node is meant to be', () => {
  const offences = webFiles
    .filter((file) => !['node', 'cli'].includes(layerOf(file, 'web/src')))
    .flatMap((file) =>
      references(file, packages)
        .filter((name) => name.startsWith('node:'))
        .map((name) => `${relative(root, file)} imports ${name}`),
    );
  expect(offences).toEqual([]);
});

it('names every failure of the core in the JavaScript API, with the same number', async () => {
  const {failureCodes} = await import('@/model/failure.js');
  const header = readFileSync(join(root, 'wasm/src/base/outcome.h'), 'utf8');
  const declared = [...header.matchAll(/^\s*k(\w+) = (\d+),/gm)]
    .map(([, name = '', value]) => [name.charAt(0).toLowerCase() + name.slice(1), Number(value)])
    .filter(([name]) => name !== 'none');
  expect(Object.fromEntries(declared)).toEqual(failureCodes);
});

it('has other names for what fails outside the core', async () => {
  const {failureCodes, pageFailureCodes} = await import('@/model/failure.js');
  const names = [...Object.keys(failureCodes), ...pageFailureCodes];
  expect(new Set(names).size).toBe(names.length);
  expect(pageFailureCodes.filter((name) => !/^[a-z]+(-[a-z]+)*$/.test(name))).toEqual([]);
});
