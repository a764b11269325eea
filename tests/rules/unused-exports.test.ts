import {readdirSync, readFileSync} from 'node:fs';
import {dirname, join, relative, sep} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Folders whose exports are checked; tests may import them, too. */
const checked = ['web/src', 'web/samples', 'web/setup', 'tests/support'];

/** Files that users import: entries of the package, and its integrations for frameworks. */
const entries = [
  'web/src/index.ts',
  'web/src/node/index.ts',
  'web/src/element/seamwise-garment.ts',
  'web/src/element/react.d.ts',
  'web/src/element/vue.d.ts',
];

const files = ['web', 'tests', 'docs/.vitepress']
  .flatMap((folder) => readdirSync(join(root, folder), {recursive: true, withFileTypes: true}))
  .filter((entry) => entry.isFile())
  .map((entry) => join(entry.parentPath, entry.name))
  .concat(readdirSync(root).map((name) => join(root, name))) // configurations
  .filter((file) => /\.m?[jt]s$/.test(file))
  .filter((file) => !file.includes(`${sep}module${sep}`) && !file.endsWith('.d.mts'));
const texts = new Map(files.map((file) => [file, readFileSync(file, 'utf8')]));

/** The path of an imported file; undefined for packages. */
function imported(from: string, path: string): string | undefined {
  const whole = path.startsWith('@/')
    ? join(root, 'web/src', path.slice(2))
    : path.startsWith('@samples/')
      ? join(root, 'web/samples', path.slice('@samples/'.length))
      : path.startsWith('.')
        ? join(dirname(from), path)
        : undefined;
  if (whole === undefined) return undefined;
  const typed = whole.replace(/\.js$/, '');
  return [whole, `${typed}.ts`, `${typed}.d.ts`].find((file) => texts.has(file));
}

/**
 * `Point as P, type Alignment` contains Point and Alignment; the destructuring `a: b` contains a.
 */
const namesIn = (list: string): string[] =>
  list
    .split(',')
    .map((name) => /^\s*(?:type\s+)?(\w+)/.exec(name)?.[1] ?? '')
    .filter((name) => name !== '');

/** Names that other files import, by file; `*` means all. */
const wanted = new Map(files.map((file) => [file, new Set<string>()]));
for (const [file, text] of texts) {
  const want = (path: string, names: readonly string[]): void => {
    const target = imported(file, path);
    for (const name of names) if (target !== undefined) wanted.get(target)?.add(name);
  };
  for (const [, list = '', path = ''] of text.matchAll(
    /(?:import|export)\s+(?:type\s+)?\{([^}]*)\}\s*from\s*'([^']+)'/g,
  )) {
    want(path, namesIn(list));
  }
  for (const [, path = ''] of text.matchAll(/(?:import|export)\s+(?:type\s+)?\*[^']*'([^']+)'/g)) {
    want(path, ['*']);
  }
  for (const [, list = '', path = ''] of text.matchAll(
    /\{([^}]*)\}\s*=\s*(?:await\s+)?import\('([^']+)'\)/g,
  )) {
    want(path, namesIn(list));
  }
  // dynamic imports may be destructured later, so any word of the file may be a name
  for (const [, path = ''] of text.matchAll(/\bimport\('([^']+)'\)/g)) {
    want(path, text.match(/\w+/g) ?? []);
  }
}

// scripts that Vite compiles to run them
for (const [file, text] of texts) {
  for (const [, path = ''] of text.matchAll(/\brunnerImport\(at\('([^']+)'\)/g)) {
    const target = imported(file, `./${path}`);
    if (target !== undefined) wanted.get(target)?.add('*');
  }
}

function exportsOf(text: string): string[] {
  const declared = text.matchAll(
    /^export\s+(?:declare\s+)?(?:abstract\s+)?(?:async\s+)?(?:class|interface|type|function\*?|const|let|enum)\s+(\w+)/gm,
  );
  const listed = text.matchAll(/^export\s+(?:type\s+)?\{([^}]*)\}/gm);
  return [
    ...[...declared].map(([, name = '']) => name),
    ...[...listed].flatMap(([, list = '']) =>
      list
        .split(',')
        .map((name) => /(\w+)\s*$/.exec(name)?.[1] ?? '')
        .filter((name) => name !== ''),
    ),
  ];
}

it('exports nothing that nobody imports', () => {
  const offences = [...texts].flatMap(([file, text]) => {
    const name = relative(root, file).split(sep).join('/');
    const names = wanted.get(file);
    const isOpen = entries.includes(name) || names?.has('*');
    if (isOpen || !checked.some((folder) => name.startsWith(`${folder}/`))) return [];
    return exportsOf(text)
      .filter((one) => !names?.has(one))
      .map((one) => `${name}: ${one}`);
  });
  expect(offences).toEqual([]);
});
