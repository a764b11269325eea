import {readdirSync, readFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Words in the last column of the glossary's tables. */
function bannedWords(): string[] {
  const rows = readFileSync(join(root, 'docs/glossary.md'), 'utf8').matchAll(/^\|.*\|(.*)\|$/gm);
  return [...rows]
    .flatMap(([, last = '']) => last.split(','))
    .map((word) => word.trim())
    .filter((word) => /^[a-z]+$/.test(word) && word !== 'not');
}

function sources(folder: string, extension: RegExp): string[] {
  return readdirSync(join(root, folder), {recursive: true, withFileTypes: true})
    .filter((entry) => entry.isFile() && extension.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name));
}

/**
 * Names that a file declares for others: types, functions, constants, public methods and
 * properties.
 */
function declared(file: string): string[] {
  const text = readFileSync(file, 'utf8');
  const pattern = file.endsWith('.h')
    ? /\b(?:class|struct|enum class|using)\s+(\w+)|\b(\w+)\s*\([^;{}]*\)\s*(?:const\s*)?(?:override\s*)?[;{]/g
    : /\bexport\s+(?:default\s+)?(?:abstract\s+)?(?:async\s+)?(?:class|interface|type|function|const|enum)\s+(\w+)|^ {2}(?:readonly |get |set |async |static )*(\w+)\??[:(]/gm;
  return [...text.matchAll(pattern)].map(([, first, second]) => first ?? second ?? '');
}

/** "WorkbenchElement" and "workbench_element" contain the words workbench and element. */
const wordsOf = (name: string): string[] =>
  name.split(/[_.-]|(?<=[a-z])(?=[A-Z])/).map((word) => word.toLowerCase());

it('names nothing by a word that the glossary replaces', () => {
  const banned = bannedWords();
  expect(banned).toContain('desk');
  const files = [...sources('wasm/src', /\.h$/), ...sources('web/src', /\.ts$/)];
  const offences = files.flatMap((file) =>
    [basename(file), ...declared(file)]
      .filter((name) => wordsOf(name).some((word) => banned.includes(word)))
      .map((name) => `${file.slice(root.length)}: ${name}`),
  );
  expect(offences).toEqual([]);
});
