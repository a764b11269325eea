/** Plain English in comments and docs, measured. */
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** A sentence or noun phrase does not begin with these words; `from` and others name parameters. */
const fragment =
  /^(?:what|whatever|where|wherever|how|whether|who|whom|whoever|which|that|of|as|by|else|so|in|on|to|with|without|beside|among|before|after|until|while|but|or|and)\b/i;

/** Programs and data do none of these. */
const spoken =
  /\b(?:tell(?:s|ing)?|told|says?|said|saying|asks?|asked|asking|hears?|heard|lies|lay|stands|stood|gives? up|minds?|heeds?|wishes|somebody|nobody|whoever)\b/gi;

function files(folder: string, extension: RegExp): string[] {
  return readdirSync(join(root, folder), {recursive: true, withFileTypes: true})
    .filter((entry) => entry.isFile() && extension.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name));
}

/** Comments of a source file; consecutive lines are one. */
function comments(source: string): string[] {
  const pattern =
    /\/\*\*?([\s\S]*?)\*\/|(?:^|\n)[ \t]*\/\/(?!\/?<)[^\n]*(?:\n[ \t]*\/\/[^\n]*)*|\/\/\/<[^\n]*/g;
  return [...source.matchAll(pattern)]
    .map(([text]) =>
      text
        .replaceAll(/^\s*(?:\/\*\*?|\*\/|\*|\/\/[/!]?<?)\s?|\*\/$/gm, '')
        .replaceAll(/\s+/g, ' ')
        .replace(/^@\w+ (?:\{[^}]*\} )?/, '')
        .trim(),
    )
    .filter((text) => /[a-z] [a-z]/i.test(text) && !/^(?:eslint|prettier|clang|NOLINT)/.test(text));
}

const countOf = (texts: readonly string[], pattern: RegExp): number =>
  texts.reduce((sum, text) => sum + (text.match(pattern)?.length ?? 0), 0);

/** @returns spoken words among a thousand */
const spokenShare = (texts: readonly string[]): number =>
  (1000 * countOf(texts, spoken)) / countOf(texts, /[a-z][a-z'’-]*/gi);

it('comments are sentences, imperatives or noun phrases about what programs do', () => {
  const sources = ['wasm', 'web', 'tests'].flatMap((folder) =>
    files(folder, /(?<!\.d)\.(?:ts|mts|mjs|cpp|h)$/),
  );
  const all = sources.flatMap((file) => comments(readFileSync(file, 'utf8')));
  expect(all.length).toBeGreaterThan(10_000);
  const fragments = all.filter((text) => fragment.test(text));
  expect(fragments.length / all.length, fragments.slice(0, 5).join('\n')).toBeLessThan(0.06);
  expect(spokenShare(all)).toBeLessThan(1.5);
});

it('docs use the same plain words', () => {
  const texts = ['README.md', 'CONTRIBUTING.md', ...files('docs', /\.md$/)].map((file) =>
    readFileSync(join(file.startsWith(root) ? '' : root, file), 'utf8').replaceAll(
      /```[\s\S]*?```/g,
      '',
    ),
  );
  expect(texts.length).toBeGreaterThan(10);
  expect(spokenShare(texts)).toBeLessThan(1);
});

it.each([
  ['/** What is told. */', true],
  ['/** Returns the mismatch. */', false],
  ['// Whether pieces meet\n', true],
])('%s: begins without a subject %s', (source, begins) => {
  expect(comments(source).map((text) => fragment.test(text))).toEqual([begins]);
});
