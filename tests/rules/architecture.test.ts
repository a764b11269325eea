import {readdirSync, readFileSync} from 'node:fs';
import {dirname, extname, join, normalize, relative, sep} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Folders of wasm/src, from the bottom up: each may include the ones before it. */
const coreRooms = [
  'base',
  'geometry',
  'tuning',
  'numeric',
  'pattern',
  'wallpaper',
  'symmetry',
  'alignment/model',
  'alignment/icp',
  'alignment/baseline',
  'alignment/bound',
  'alignment/search',
  'seam',
  'mesh',
  'deform',
  'drape',
  'marker',
  'photo/base',
  'photo/lattice',
  'photo/fabric',
  'photo/symmetry',
  'photo/tile',
  'photo/steps',
  'problem',
  'methods',
  'solve',
  'io',
  'bindings',
];

/** Folders of web/src/model, from the bottom up: each may import the ones before it. */
const model = [
  'model/base',
  'model/geometry',
  'model/garment',
  'model/print',
  'model/result',
  'model/design',
  'model/documents',
] as const;

/** The folders of the model up to this one. */
const modelTo = (last: (typeof model)[number]): readonly string[] =>
  model.slice(0, model.indexOf(last) + 1);

/** Folders of web/src that each folder may import, besides itself. */
const webRooms: Readonly<Record<string, readonly string[]>> = {
  ...Object.fromEntries(model.map((room, k) => [room, model.slice(0, k)])),
  solver: modelTo('model/design'),
  image: modelTo('model/print'),
  layout: modelTo('model/result'),
  files: model, // file formats, read and written; no DOM: it runs in Node and in workers, too
  clicks: model,
  pairing: model,
  photo: [...model, 'image'], // the print on a photo
  scene: [...model, 'layout'], // no GL, no SVG, no DOM
  picture: [...model, 'files', 'image', 'layout', 'scene'],
  cutting: [...model, 'files', 'layout', 'scene', 'picture', 'texts'],
  paper: [...model, 'files', 'image', 'picture', 'cutting', 'texts'], // no DOM: files of pages in Node, too
  texts: [...model, 'scene'],
  marker: [
    ...model,
    ...['files', 'layout', 'scene', 'image', 'picture', 'cutting', 'paper', 'texts'],
  ], // no DOM
  remedies: [...model, 'scene'],
  viewer: [...model, 'image', 'scene'], // never the solver: views only read a result
  print: [...model, 'solver', 'image', 'photo', 'texts'], // an opened picture or file as a print
  sewing: [...model, 'clicks', 'pairing', 'scene', 'texts'], // no DOM
  workbench: [
    ...model,
    ...['solver', 'image', 'layout', 'clicks', 'photo', 'scene', 'picture', 'cutting'],
    ...['files', 'paper', 'marker', 'remedies', 'texts', 'print', 'sewing'],
  ],
  commands: [...model, 'clicks', 'viewer', 'texts', 'workbench'], // by key or by name
  editor: [
    ...model,
    ...['image', 'layout', 'clicks', 'photo', 'scene', 'cutting', 'marker'],
    ...['remedies', 'viewer', 'texts', 'print', 'workbench', 'commands'],
  ],
  element: [
    ...model,
    ...['solver', 'image', 'files', 'paper', 'cutting', 'marker', 'texts', 'workbench', 'editor'],
  ],
  app: [
    ...model,
    ...['solver', 'image', 'files', 'photo', 'cutting', 'paper', 'viewer', 'texts'],
    ...['print', 'workbench', 'commands', 'editor'],
  ],
  node: [
    ...model,
    'image',
    'files',
    'layout',
    'solver',
    'scene',
    'picture',
    'cutting',
    'paper',
    'marker',
    'pairing',
    'remedies',
    'texts', // printed sheets are in the user's language
  ],
  cli: [
    ...model,
    'image',
    'files',
    'layout',
    'scene',
    'picture',
    'cutting',
    'marker',
    'paper',
    'texts',
    'node',
  ],
  '': [...model, 'files', 'solver'], // index.ts, the entry of the package
};

function filesUnder(folder: string, extensions: readonly string[]): string[] {
  return readdirSync(join(root, folder), {recursive: true, withFileTypes: true})
    .filter((entry) => entry.isFile() && extensions.includes(extname(entry.name)))
    .map((entry) => join(entry.parentPath, entry.name));
}

/** Lists the dependencies of a file: the first group of every match of `pattern`. */
function references(file: string, pattern: RegExp): string[] {
  return [...readFileSync(file, 'utf8').matchAll(pattern)].map((match) => match[1] ?? '');
}

/** The room of a file in web/src: its first folder, in the model also the second. */
function roomOf(file: string): string {
  const top = topFolder(file);
  return top === 'model' ? dirname(file) : top;
}

/** Returns the first folder of a path; files directly in the source folder belong to ''. */
function topFolder(file: string): string {
  const [first = '', ...rest] = file.split('/');
  return rest.length > 0 ? first : '';
}

const coreFiles = filesUnder('wasm/src', ['.h', '.cpp']);
const webFiles = filesUnder('web/src', ['.ts', '.mts']);
const includes = /^\s*#\s*include\s+"([^"]+)"/gm;
const systemIncludes = /^\s*#\s*include\s+<([^>]+)>/gm;
const imports = /(?:\bfrom|\bimport)\s*\(?\s*'(\.[^']+)'/g;
const packages = /(?:\bfrom|\bimport)\s*\(?\s*'([^.'][^']*)'/g;

type Graph = ReadonlyMap<string, readonly string[]>;

/** Includes of every core file, relative to wasm/src. */
const coreGraph: Graph = new Map(
  coreFiles.map((file) => [inFolder('wasm/src', file), references(file, includes)]),
);

/** Imports of every web file, types included, relative to web/src. */
const webGraph: Graph = new Map(
  webFiles.map((file) => [
    stem(inFolder('web/src', file)),
    references(file, imports).map((path) =>
      stem(inFolder('web/src', normalize(join(dirname(file), path)))),
    ),
  ]),
);

function inFolder(folder: string, file: string): string {
  return relative(join(root, folder), file).split(sep).join('/');
}

function stem(file: string): string {
  return file.replace(/(\.d)?\.m?[jt]s$/, '');
}

/** Lists the cycles of a graph. `names` maps a file to its node: a folder or the file itself. */
function cycles(graph: Graph, names: (file: string) => string): string[] {
  const arrows = new Map<string, Set<string>>();
  for (const [file, targets] of graph) {
    const from = names(file);
    const all = arrows.get(from) ?? new Set();
    arrows.set(from, all);
    for (const target of targets) if (names(target) !== from) all.add(names(target));
  }
  const reaches = (from: string, to: string): boolean => {
    const seen = new Set<string>();
    const open = [...(arrows.get(from) ?? [])];
    for (let next = open.pop(); next !== undefined; next = open.pop()) {
      if (next === to) return true;
      if (seen.has(next)) continue;
      seen.add(next);
      open.push(...(arrows.get(next) ?? []));
    }
    return false;
  };
  return [...arrows.keys()].filter((name) => reaches(name, name));
}

it('lets the rooms of the core include only those below them', () => {
  const offences = [...coreGraph].flatMap(([file, headers]) => {
    const level = coreRooms.indexOf(dirname(file));
    return headers
      .filter((header) => !coreRooms.slice(0, level + 1).includes(dirname(header)))
      .map((header) => `${file} includes ${header}`);
  });
  expect(offences).toEqual([]);
});

it('lets the rooms of the web sources import only what they may', () => {
  const offences = [...webGraph].flatMap(([file, targets]) => {
    const own = roomOf(file);
    const allowed = [own, ...(webRooms[own] ?? [])];
    return targets
      .filter((target) => !allowed.includes(roomOf(target)))
      .map((target) => `${file} imports ${target}`);
  });
  expect(offences).toEqual([]);
});

/** Files that hand on what other rooms export: the entries of the package. */
const entries = ['index', 'node/exports', 'node/index', 'element/seamwise-garment', 'element/auto'];
const handedOn = /\bexport\s+(?:type\s+)?(?:\*(?:\s+as\s+\w+)?|\{[^}]*\})\s*from\s*'(\.[^']+)'/g;

it('hands nothing on from another room, but in the entries of the package', () => {
  const offences = webFiles.flatMap((file) => {
    const name = stem(inFolder('web/src', file));
    if (entries.includes(name)) return [];
    return references(file, handedOn)
      .map((path) => stem(inFolder('web/src', normalize(join(dirname(file), path)))))
      .filter((target) => roomOf(target) !== roomOf(name))
      .map((target) => `${name} hands on ${target}`);
  });
  expect(offences).toEqual([]);
});

it('knows every room, and has none that is empty', () => {
  expect([...new Set([...coreGraph.keys()].map(dirname))].sort()).toEqual([...coreRooms].sort());
  const web = [...new Set([...webGraph.keys()].map(roomOf))];
  expect(web.sort()).toEqual(Object.keys(webRooms).sort());
});

it('has no cycle: of files, of folders, of rooms', () => {
  for (const graph of [coreGraph, webGraph]) {
    expect(cycles(graph, (file) => file)).toEqual([]);
    expect(cycles(graph, dirname)).toEqual([]);
    expect(cycles(graph, topFolder)).toEqual([]);
  }
});

it('draws with WebGL in the viewer alone, and knows of no page below the workbench', () => {
  const using = (name: RegExp): string[] => [
    ...new Set(
      webFiles
        .filter((file) => references(file, packages).some((used) => name.test(used)))
        .map((file) => topFolder(inFolder('web/src', file))),
    ),
  ];
  expect(using(/^three/)).toEqual(['viewer']);
  expect(using(/^lit/).sort()).toEqual(['app', 'editor', 'element']);
});

it('keeps JavaScript, streams, clocks and true randomness out of the core', () => {
  const banned = /^(emscripten.*|iostream|chrono|ctime|time\.h|sys\/time\.h)$/;
  const offences = coreFiles
    .filter((file) => topFolder(inFolder('wasm/src', file)) !== 'bindings')
    .flatMap((file) => [
      ...references(file, systemIncludes).filter((header) => banned.test(header)),
      ...references(file, /\b(std::random_device|std::rand|srand)\b/g),
    ]);
  expect(offences).toEqual([]);
});

it('defines every type of the core once: of two that share a name, a linker takes either for both', () => {
  const places = new Map<string, string[]>();
  for (const file of coreFiles) {
    // Types without indentation belong to the namespace; unnamed namespaces are private to a file.
    const text = readFileSync(file, 'utf8').replace(
      /^namespace \{$[^]*?^\} {2}\/\/ namespace$/gm,
      '',
    );
    for (const [, name = ''] of text.matchAll(
      /^(?:struct|(?:enum )?class) (\w+)(?: (?:final|:) ?[^:{\n]*)? \{/gm,
    )) {
      places.set(name, [...(places.get(name) ?? []), file]);
    }
  }
  expect(places.size).toBeGreaterThan(100);
  expect([...places].filter(([, files]) => files.length > 1)).toEqual([]);
});

it('uses Node only where Node is meant to be', () => {
  const offences = webFiles
    .filter((file) => !['node', 'cli'].includes(topFolder(inFolder('web/src', file))))
    .flatMap((file) =>
      references(file, packages)
        .filter((name) => name.startsWith('node:'))
        .map((name) => `${relative(root, file)} imports ${name}`),
    );
  expect(offences).toEqual([]);
});

it('names every failure of the core in the JavaScript API, with the same number', async () => {
  const {failureCodes} = await import('@/model/base/failure.js');
  const header = readFileSync(join(root, 'wasm/src/base/outcome.h'), 'utf8');
  const declared = [...header.matchAll(/^\s*k(\w+) = (\d+),/gm)]
    .map(([, name = '', value]) => [name.charAt(0).toLowerCase() + name.slice(1), Number(value)])
    .filter(([name]) => name !== 'none');
  expect(Object.fromEntries(declared)).toEqual(failureCodes);
});

it('has other names for what fails outside the core', async () => {
  const {failureCodes, pageFailureCodes} = await import('@/model/base/failure.js');
  const names = [...Object.keys(failureCodes), ...pageFailureCodes];
  expect(new Set(names).size).toBe(names.length);
  expect(pageFailureCodes.filter((name) => !/^[a-z]+(-[a-z]+)*$/.test(name))).toEqual([]);
});
