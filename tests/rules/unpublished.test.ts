/**
 * The package's name is not registered yet: anyone who registers it could run code on the machines
 * of users who follow a text that installs it by name.
 */
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

const root = fileURLToPath(new URL('../..', import.meta.url));

/**
 * Commands that would request the package from a registry: npx without --no, an install of its bare
 * name, or a version range.
 */
const asking =
  /\bnpx (?:-y |--yes )?seamwise\b|\b(?:npm (?:i|install|add)|yarn add|pnpm add) (?:\S+ )*seamwise(?=[\s@`'"]|$)(?!@file:)|"seamwise": "[\^~\d]|(?:unpkg|jsdelivr|esm\.sh)[^\s]*seamwise/;

it('is named in texts, examples and messages by its file only', () => {
  const files = ['docs', 'web/examples', 'web/src'].flatMap((folder) =>
    readdirSync(join(root, folder), {recursive: true, withFileTypes: true})
      .filter((entry) => entry.isFile() && /\.(md|ts|mjs|js|json|html)$/.test(entry.name))
      .map((entry) => join(entry.parentPath, entry.name)),
  );
  const offences = [join(root, 'README.md'), ...files].filter((file) =>
    asking.test(readFileSync(file, 'utf8')),
  );
  expect(offences).toEqual([]);
});

it.each([
  ['npx seamwise order x.json', true],
  ['npx seamwise@0.0.7 order x.json', true],
  ['npx --no seamwise order x.json', false],
  ['npm install seamwise three', true],
  ['npm install three seamwise', true],
  ['npm install ./seamwise-0.1.0.tgz three', false],
  ['npm install seamwise-0.1.0@file:seamwise-0.1.0.tgz', false],
  ['"seamwise": "^0.1.0"', true],
  ['"seamwise": "file:seamwise-0.1.0.tgz"', false],
])('%s: asks a registry %s', (words, asks) => {
  expect(asking.test(words)).toBe(asks);
});
