import {readFileSync} from 'node:fs';

import {describe, expect, it, vi} from 'vitest';

import {formatted, text, type Source} from '@/texts/base/message.js';
import {answer} from '@/texts/en/answer.js';
import {cutting} from '@/texts/en/cut.js';
import {drape} from '@/texts/en/drape.js';
import {importing} from '@/texts/en/import.js';
import {marker} from '@/texts/en/marker.js';
import {page} from '@/texts/en/page.js';
import {pattern} from '@/texts/en/pattern.js';
import {photo} from '@/texts/en/photo.js';
import {plan} from '@/texts/en/plan.js';
import {sheet} from '@/texts/en/sheet.js';
import {print} from '@/texts/en/print.js';
import {samples as sampleNames} from '@/texts/en/samples.js';
import {sew} from '@/texts/en/sew.js';
import {loadTexts, textsOf} from '@/texts/texts.js';
import {languages, preferencesFor} from '@/texts/preferences.js';
import type {Samples} from '@/workbench/samples.js';

const readJson = (path: string): unknown => JSON.parse(readFileSync(path, 'utf8'));
const samples = readJson('public/samples.json') as Samples;
const translations = languages.filter((language) => language !== 'en');

/** English texts by the names of their translations' files. */
const files = {
  ...{page, pattern, answer, print, samples: sampleNames},
  ...{cut: cutting, drape, import: importing, marker, photo, plan, sew, sheet},
};

/** Texts by their paths; a function is the text that it was made from. */
function textsBelow(value: unknown, path: string): readonly (readonly [string, string])[] {
  if (typeof value === 'string') return [[path, value]];
  if (typeof value === 'function') return [[path, (value as unknown as Source).text]];
  return Object.entries(value as object).flatMap(([name, one]) =>
    textsBelow(one, `${path}.${name}`),
  );
}

const placeholders = (words: string): readonly string[] => [
  ...new Set(
    [...words.matchAll(/\{(\w+)([,}])/g)].map(([, name = '', end]) =>
      end === ',' ? `${name}, a number` : name,
    ),
  ),
];

/** Names, and words that are the same in related languages. */
const alike = new Set([
  ...['Seamwise', 'Wolff et al. 2019', '{value} dpi', 'Ctrl', 'Enter', 'Zoom', 'Double', 'Jersey'],
  ...['Chiffon', 'Place', 'Name', 'Second point', 'Start'],
]);

/** Returns whether a text has to differ from language to language. */
const hasWords = (words: string): boolean =>
  !alike.has(words) && /\p{Ll}{3}/u.test(words.replaceAll(/\{[^}]*\}/g, ''));

/** A text with a number for each number, and a name for each other placeholder. */
const withNumber = (words: string, number: number, language: string): string =>
  formatted(words, (name) => (words.includes(`{${name},`) ? number : name), language);

describe.each(translations)('the translation into %s', (language) => {
  it.each(Object.entries(files))(
    'has the keys and placeholders of the English texts of %s',
    (file, english) => {
      const json = readJson(`web/src/texts/${language}/${file}.json`);
      const theirs = new Map(textsBelow(english, file));
      const ours = new Map(
        // the names of samples are in English in the samples themselves
        textsBelow(json, file).filter(([path]) => !path.startsWith('samples.')),
      );
      const shape = (texts: ReadonlyMap<string, string>) =>
        Object.fromEntries(
          [...texts].map(([path, words]) => [path, [...placeholders(words)].sort()]),
        );
      expect(shape(ours)).toEqual(shape(theirs));
      for (const [path, words] of ours) {
        expect(words, path).not.toBe('');
        for (const number of [0, 1, 2, 7003]) {
          expect(withNumber(words, number, language), path).not.toMatch(/[{}]/);
        }
        if (hasWords(words)) expect(words, path).not.toBe(theirs.get(path));
      }
    },
  );
});

describe('a text with placeholders', () => {
  it('takes its values in the order of the placeholders, or in the given one', () => {
    expect(text('{piece} of {garment}, {piece}')('front', 'tee')).toBe('front of tee, front');
    expect(text('{group}: {pieces}', 'pieces', 'group')('front', 'p4m')).toBe('p4m: front');
  });

  it('has forms for numbers', () => {
    const at = text('{n, selectordinal, one {#st} two {#nd} few {#rd} other {#th}}');
    expect([1, 2, 3, 4, 11, 12, 13, 21, 112].map((n) => at(n)).join()).toBe(
      '1st,2nd,3rd,4th,11th,12th,13th,21st,112th',
    );
    const pieces = '{count, plural, =0 {none} one {# piece of {all}} other {# of {all}}}';
    const filled = (count: number): string =>
      formatted(pieces, (name) => (name === 'count' ? count : 5));
    expect([0, 1, 2].map(filled)).toEqual(['none', '1 piece of 5', '2 of 5']);
  });

  it('keeps values as they are', () => {
    expect(text('Open {file}')('{file} $& #')).toBe('Open {file} $& #');
  });
});

describe.each(translations)('the texts in %s', (language) => {
  it('are English until they are loaded, and then their own', async () => {
    vi.resetModules(); // other tests may have loaded them
    const {loadTexts, textsOf} = await import('@/texts/texts.js');
    const {en} = await import('@/texts/en.js');
    expect(textsOf(language)).toBe(en);
    expect(await loadTexts(language)).toBe(true);
    expect(await loadTexts(language)).toBe(false);
    expect(textsOf(language)).not.toBe(en);
    expect(textsOf(language, {app: {undo: 'Oops'}}).app).toEqual({
      ...textsOf(language).app,
      undo: 'Oops',
    });
  });

  it('name every garment, print and colour that comes with the page', async () => {
    await loadTexts(language);
    const named = textsOf(language).samples;
    expect(Object.keys(named.garments)).toEqual(samples.garments.map(({style}) => style));
    expect(Object.keys(named.prints)).toEqual(samples.prints.map(({name}) => name));
    const colours = samples.prints.flatMap(({colourways}) => colourways.map(({name}) => name));
    expect(Object.keys(named.colourways).sort()).toEqual([...new Set(colours)].sort());
  });

  it('are those of whoever reads that language, in any country', () => {
    expect(preferencesFor(language).language).toBe(language);
    expect(preferencesFor(`${language}-CH`).language).toBe(language);
  });
});

it('speaks English to everybody else', () => {
  expect(preferencesFor('pt-BR').language).toBe('en');
});
